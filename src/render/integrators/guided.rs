//! Ways on from diffuse surfaces, by their own density and by that of photons.

use crate::render::guide::Guide;
use crate::render::lanes::LANES;
use crate::render::lights::Sites;
use crate::render::materials::{Lamberts, Scattered, Ways};
use crate::render::samplers::Fours;

/// By what the ways on from surfaces were chosen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chosen {
    /// With which chance by the surface's own density.
    pub own: f32,
    /// Whether it was.
    pub is_own: bool,
}

impl Chosen {
    /// Where no photons are asked.
    pub const OWN: Self = Self { own: 1.0, is_own: true };
}

/// Gives diffuse surfaces where photons have landed their ways on, in place of those that they have.
/// Those that are not diffuse alone keep them.
pub(super) fn ways(
    guide: &Guide,
    (sites, lamberts): (&Sites, &Lamberts),
    fours: &Fours,
    ways: &mut Ways,
    mut chosen: impl FnMut(usize, Chosen),
) {
    let leaves = guide.leaves(sites, sites.lanes().len());
    let mut guided = [0; LANES];
    let mut count = 0;
    for lane in sites.lanes() {
        let place = sites.point(lane).position;
        let (lambert, chance) = lamberts.at(lane);
        if chance < 1.0 {
            continue;
        }
        let Some(lobes) = guide.lobes(leaves[lane], place) else { continue };
        let (u, part) = (fours.at(lane), lobes.part());
        let is_led = is_led(part, u);
        if is_led {
            let choice = u[2] / f64::from(part);
            let (way, some) = lambert.towards(lobes.sample(place, choice, [u[0], u[1]]));
            ways.put(lane, some.then_some(way));
        }
        chosen(lane, Chosen { own: 1.0 - part, is_own: !is_led });
        guided[count] = lane as u32;
        count += 1;
    }
    let guided = &guided[..count];
    let densities = guide.pdf_w(guided, &leaves, (sites, ways));
    for lane in guided.iter().map(|&lane| lane as usize) {
        let (way, some) = ways.at(lane);
        let Some(lobes) = guide.lobes(leaves[lane], sites.point(lane).position) else { continue };
        ways.put(lane, some.then(|| weighed(&way, lobes.part(), densities[lane])));
    }
}

/// A way that is found by photons, which have this part of all and this density of its direction, and
/// by the surface's own density: weighed by both together [Veach95].
///
/// The density that it keeps is the surface's own, though: against lamps that are asked it counts by
/// that, as these do.
#[inline(always)]
fn weighed(way: &Scattered, part: f32, pdf_w: f32) -> Scattered {
    let mixed = (1.0 - part) * way.pdf_w + part * pdf_w;
    // A way that is taken more often brings as much less. More light than elsewhere is expected of
    // it, and roulette is not to end it for that.
    let less = way.pdf_w / mixed;
    Scattered { weight: way.weight * less.max(1.0), squeeze: less.min(1.0), ..*way }
}

/// Whether the direction of a photon is chosen, which has this part of all, by the third number.
#[inline(always)]
fn is_led(part: f32, u: [f64; 4]) -> bool {
    u[2] / f64::from(part) < 1.0
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;
    use crate::math::{Rgb, random};
    use crate::render::geometry::{Geometry, Owner, Ray, Shapes, Triangle};
    use crate::render::guide::photons::Photon;
    use crate::render::lights::Site;
    use crate::render::materials::{
        Diffuse, Emission, Lambert, Material, Matter, OnlyDiffuse, Surface,
    };
    use crate::render::samplers::Sampler;
    use crate::render::textures::Colour;

    /// A place on a floor about the origin, with a shading normal so many degrees from +z.
    fn floor(albedo: Rgb, degrees: f32) -> (Site, Lambert) {
        let mut shapes = Shapes::new();
        let corners = [Vec3::NEG_ONE, Vec3::new(2.0, -1.0, -1.0), Vec3::new(-1.0, 2.0, -1.0)]
            .map(|corner| shapes.vertex(corner.with_z(0.0)));
        let (sin, cos) = degrees.to_radians().sin_cos();
        let normal = shapes.normal(Vec3::new(sin, 0.0, cos));
        shapes.triangle(Triangle { corners, normals: Some([normal; 3]), owner: Owner::default() });
        let down = Ray::new(Vec3::new(-0.3, -0.2, 2.0), Vec3::NEG_Z);
        let hit = Geometry::build(shapes).closest(&down).unwrap();
        let material = Material {
            surface: Surface::Diffuse(Diffuse { albedo: Colour::Plain(albedo) }),
            emission: Emission { radiance: Rgb::BLACK, both: false },
            before: 0,
            behind: None,
        };
        let lambert = OnlyDiffuse::at(&material, &hit, Vec3::Z);
        (Site { point: hit.point(), normal: lambert.side() }, lambert)
    }

    /// A guide of photons that came by places about `middle`, in a cube with sides of `spread`.
    fn guide(middle: Vec3, spread: f32, even: f32) -> Guide {
        let photon = |i| {
            let [a, b] = random::unit_pair(random::at(61, i));
            let [c, d] = random::unit_pair(random::at(62, i));
            let [e, _] = random::unit_pair(random::at(63, i));
            let within = Vec3::new(c as f32, d as f32, e as f32) - 0.5;
            let at = Vec3::new(-0.4 + 0.2 * a as f32, -0.3 + 0.2 * b as f32, 0.0);
            Photon { at, from: middle + spread * within }
        };
        let mut photons: Vec<Photon> = (0..32).map(photon).collect();
        Guide::of(&mut photons, even).unwrap()
    }

    /// As much of even light goes on as without a guide: the albedo, or, where the normals are an
    /// angle δ apart, (1 + cos δ)/2 of it. A fiftieth less would show.
    #[test]
    fn of_even_light_a_guide_takes_and_adds_nothing() {
        const COUNT: u64 = 1500 * LANES as u64;
        let up = Vec3::new(0.2, 0.1, 0.6);
        // Photons from above, from all around above and below, and none from above; many and few.
        let guides = [
            guide(up, 0.2, 1e-3),
            guide(up, 0.02, 1e6),
            guide(Vec3::ZERO, 1.5, 1e-3),
            guide(-up, 0.3, 1e-3),
        ];
        let surfaces =
            [(Rgb::ONE, 0.0), (Rgb::new(0.9, 0.5, 0.1), 0.0), (Rgb::grey(0.8), 25.0_f32)];
        let (mut sites, mut fours) = (Sites::default(), Fours::default());
        let (mut lamberts, mut found) = (Lamberts::default(), Ways::default());
        let mut asked = 0;
        for (nth, guide) in guides.iter().enumerate() {
            for (albedo, degrees) in surfaces {
                let (site, lambert) = floor(albedo, degrees);
                let (mut sum, mut squares) = ([0.0; 3], [0.0; 3]);
                for turn in 0..COUNT / LANES as u64 {
                    sites.clear();
                    fours.clear();
                    for lane in 0..LANES {
                        sites.push(&site);
                        lamberts.put(lane, Some((&lambert, 1.0)));
                        fours.push(&mut Sampler::Independent.stream(64, turn, lane as u64));
                    }
                    fours.draw();
                    found.by_cosine(LANES, &lamberts, &fours);
                    ways(guide, (&sites, &lamberts), &fours, &mut found, |_, _| asked += 1);
                    for lane in 0..LANES {
                        let (way, some) = found.at(lane);
                        if !some {
                            continue;
                        }
                        let weight = (way.weight * way.squeeze).to_array().map(f64::from);
                        for channel in 0..3 {
                            sum[channel] += weight[channel];
                            squares[channel] += weight[channel].powi(2);
                        }
                    }
                }
                assert_eq!(std::mem::take(&mut asked), COUNT, "{nth}: not guided");
                let kept = f64::from(0.5 * (1.0 + degrees.to_radians().cos()));
                for (channel, albedo) in albedo.to_array().into_iter().enumerate() {
                    let mean = sum[channel] / COUNT as f64;
                    let variance = squares[channel] / COUNT as f64 - mean.powi(2);
                    let error = (variance / COUNT as f64).sqrt();
                    let truth = kept * f64::from(albedo);
                    let told = format!("{nth}, {degrees}°: {mean} ± {error}, not {truth}");
                    assert!((mean - truth).abs() <= 4.0 * error, "{told}");
                    assert!(error < 0.004 * truth, "{told}");
                }
            }
        }
    }
}
