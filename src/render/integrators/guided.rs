//! Ways on from diffuse surfaces, by their own density and by that of photons.

use glam::Vec3;

use crate::render::guide::{Guide, Lobes};
use crate::render::lanes::LANES;
use crate::render::lights::Sites;
use crate::render::materials::{Lambert, Lamberts, Scattered, Ways};
use crate::render::samplers::Fours;

/// Gives diffuse surfaces where photons have landed their ways on, in place of those that they have.
/// Those that are not diffuse alone keep them.
pub(super) fn ways(
    guide: &Guide,
    (sites, lamberts): (&Sites, &Lamberts),
    fours: &Fours,
    ways: &mut Ways,
) {
    // First where all are: one search does not wait for the other.
    let mut leaves = [0; LANES];
    for lane in sites.lanes() {
        leaves[lane] = guide.leaf(sites.point(lane).position);
    }
    for lane in sites.lanes() {
        let place = sites.point(lane).position;
        let (lambert, chance) = lamberts.at(lane);
        if let Some(lobes) = guide.lobes(leaves[lane], place)
            && chance == 1.0
        {
            let (own, some) = ways.at(lane);
            let own = some.then_some(own);
            ways.put(lane, way(lobes, place, &lambert, own, fours.at(lane)));
        }
    }
}

/// A way on from a place, where `own` is that by the surface's own density, and `u` in [0, 1)⁴ what it
/// was chosen by: the third number chooses between it and the directions of photons.
///
/// What is found there is weighed by both densities together [Veach95]. The density that it keeps is
/// the surface's own, though: against lamps that are asked it counts by that, as these do.
fn way(
    lobes: &Lobes,
    place: Vec3,
    lambert: &Lambert,
    own: Option<Scattered>,
    u: [f64; 4],
) -> Option<Scattered> {
    let part = lobes.part();
    let choice = u[2] / f64::from(part);
    let way = if choice < 1.0 {
        let (way, some) = lambert.towards(lobes.sample(place, choice, [u[0], u[1]]));
        some.then_some(way)
    } else {
        own
    }?;
    let mixed = (1.0 - part) * way.pdf_w + part * lobes.pdf_w(place, way.wi);
    // A way that is taken more often brings as much less. More light than elsewhere is expected of
    // it, and roulette is not to end it for that.
    let less = way.pdf_w / mixed;
    Some(Scattered { weight: way.weight * less.max(1.0), squeeze: less.min(1.0), ..way })
}
