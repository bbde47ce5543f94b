//! Photons: light followed from lamps to what scatters it, by mirrors and glass.

use glam::Vec3;

use crate::math::random;
use crate::render::geometry::Geometry;
use crate::render::lights::Sources;
use crate::render::materials::{Material, Part};

/// Where a photon landed on a surface that scatters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::render) struct Photon {
    pub at: Vec3,
    /// The last place before it, on a mirror or on glass.
    pub from: Vec3,
}

/// Surfaces after which a photon is given up.
const LONGEST: usize = 64;

/// All places where the light of a photon, of that number, lands by way of mirrors and glass. If the
/// first surface that it meets is none of these there are none: its light is found otherwise.
pub(super) fn follow(
    geometry: &Geometry,
    materials: &[Material],
    sources: &Sources,
    number: u64,
) -> Vec<Photon> {
    let mut found = Vec::new();
    let photon = random::at(random::mix(PLACE), number);
    let numbers = |place: u64| {
        let [a, b] = random::unit_pair(random::at(photon, 2 * place));
        let [c, d] = random::unit_pair(random::at(photon, 2 * place + 1));
        [a, b, c, d]
    };
    let ([choice, ..], [a, b, c, d]) = (numbers(0), numbers(1));
    let Some(mut ray) = sources.ray(choice, [a, b], [c, d]) else { return found };
    let mut from = None;
    for surface in 0..LONGEST {
        let Some(hit) = geometry.closest(&ray) else { break };
        let bsdf = materials[hit.material as usize].at(&hit, -ray.direction);
        if let Some(from) = from.filter(|_| bsdf.scatters().is_some()) {
            found.push(Photon { at: hit.position, from });
        }
        let u = numbers(surface as u64 + 2);
        let Some(way) = bsdf.sample(Part::All, u) else { break };
        let is_specular = way.pdf_w == 0.0;
        if (surface == 0 && !is_specular) || u[3] >= f64::from(way.weight.largest()) {
            break;
        }
        from = is_specular.then_some(hit.position);
        ray = hit.point().ray(way.wi);
    }
    found
}

/// No sample of a picture begins there.
const PLACE: u64 = 0x9107_0115;

/// The lowest and the highest coordinates of where they landed.
pub(super) fn around(photons: &[Photon]) -> (Vec3, Vec3) {
    photons.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), photon| {
        (low.min(photon.at), high.max(photon.at))
    })
}
