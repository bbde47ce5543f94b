//! What every BSDF has to keep, whatever it is: its directions follow its density, its weights are
//! what it scatters over that, it gives back no more than it gets, and light goes either way alike.

use glam::{DVec2, Vec3};

use super::facing::tests::{above, seen};
use super::*;
use crate::math::{chi_squared, random};
use crate::render::geometry::{Geometry, Owner, Ray, Shapes, Triangle};
use crate::render::lanes::LANES;
use crate::render::samplers::{Fours, Sampler};
use crate::render::textures::Colour;

/// One of each kind of surface, after the one that was last. The compiler asks for a new kind, and
/// the list below for all that it leads to.
fn next(last: Option<&Surface>) -> Option<Surface> {
    let Some(last) = last else {
        let gold = Conductor::Channels { n: [0.14, 0.43, 1.38], k: [3.697, 2.455, 1.914] };
        return Some(Surface::Conductor(gold));
    };
    match last {
        Surface::Conductor(_) => {
            Some(Surface::Dielectric(Dielectric { inside: 1.5, outside: 1.0 }))
        }
        Surface::Dielectric(_) => {
            let albedo = Colour::Plain(Rgb::new(0.9, 0.3, 0.1));
            Some(Surface::Diffuse(Diffuse { albedo }))
        }
        Surface::Diffuse(_) => {
            Some(Surface::Mirror(Mirror { reflectance: Colour::Plain(Rgb::grey(0.8)) }))
        }
        Surface::Mirror(_) => {
            // Of all that are no mixture.
            let mut plain: Vec<Surface> = next(None).into_iter().collect();
            while let Some(one) = plain.last().filter(|it| !matches!(it, Surface::Mirror(_))) {
                plain.extend(next(Some(one)));
            }
            let parts = [0.1_f32, 0.3, 0.4, 0.2].into_iter().zip(plain).collect();
            Some(Surface::Mixture(Mixture { parts }))
        }
        Surface::Mixture(_) => None,
    }
}

fn every() -> impl Iterator<Item = Surface> {
    std::iter::successors(next(None), |last| next(Some(last)))
}

fn numbers(place: u64) -> [f64; 4] {
    let [a, b] = random::unit_pair(random::at(8, 2 * place));
    let [c, d] = random::unit_pair(random::at(8, 2 * place + 1));
    [a, b, c, d]
}

const PARTS: [Part; 3] = [Part::All, Part::Scattering, Part::Specular];

/// Views from above, straight and grazing, with normals that agree and that do not.
fn views() -> impl Iterator<Item = Facing> {
    (0..12).map(|i| match i % 3 {
        0 => seen(above(i), Vec3::Z),
        1 => seen(above(i), Vec3::new(0.28, 0.0, 0.96)),
        _ => Facing { front: false, ..seen(above(i), Vec3::Z) },
    })
}

#[test]
fn directions_follow_their_densities_and_weights_are_what_is_scattered() {
    const RINGS: usize = 6;
    const SECTORS: usize = 8;
    const COUNT: u64 = 20_000;
    for surface in every() {
        for facing in views().take(6) {
            let bsdf = surface.at(DVec2::ZERO, &facing);
            for part in PARTS {
                // About the shading normal; what is specular, or nothing, in a bin of its own.
                let (x, y) = facing.ns.any_orthonormal_pair();
                let bins = RINGS * SECTORS;
                let mut counts = vec![0; bins + 1];
                for i in 0..COUNT {
                    let way = bsdf.sample(part, numbers(i)).filter(|way| way.pdf_w > 0.0);
                    let Some(way) = way else {
                        counts[bins] += 1;
                        continue;
                    };
                    let told = bsdf.pdf_w(part, way.wi);
                    assert!((told / way.pdf_w - 1.0).abs() < 1e-4, "{surface:?}: {told}");
                    assert!(bsdf.faces(way.wi) && way.squeeze == 1.0);
                    let truth = bsdf.scattered(way.wi) / way.pdf_w;
                    let off = (way.weight - truth).to_array().map(f32::abs);
                    assert!(off.iter().all(|off| *off < 1e-4), "{surface:?}: {way:?}, {truth:?}");
                    let [u, v, w] = [x, y, facing.ns].map(|axis| way.wi.dot(axis));
                    let turn = v.atan2(u) / std::f32::consts::TAU + 0.5;
                    let ring = ((w * w * RINGS as f32) as usize).min(RINGS - 1);
                    let sector = ((turn * SECTORS as f32) as usize).min(SECTORS - 1);
                    counts[ring * SECTORS + sector] += 1;
                }
                // The same density over each bin, by many points of it.
                let mut expected = vec![0.0; bins + 1];
                let side = 40;
                for (bin, expected) in expected.iter_mut().take(bins).enumerate() {
                    let (ring, sector) = (bin / SECTORS, bin % SECTORS);
                    for point in 0..side * side {
                        let middle = |n: usize| (n as f32 + 0.5) / side as f32;
                        let square = (ring as f32 + middle(point / side)) / RINGS as f32;
                        let turn = (sector as f32 + middle(point % side)) / SECTORS as f32 - 0.5;
                        let (sin, cos) = (std::f32::consts::TAU * turn).sin_cos();
                        let (w, across) = (square.sqrt(), (1.0 - square).sqrt());
                        let wi = across * (cos * x + sin * y) + w * facing.ns;
                        if bsdf.faces(wi) {
                            // A step of the squared cosine is 2 cos θ times one of the cosine.
                            let area = std::f32::consts::TAU / (2.0 * w * bins as f32);
                            *expected += f64::from(bsdf.pdf_w(part, wi) * area);
                        }
                    }
                    *expected /= (side * side) as f64;
                }
                let sum: f64 = expected.iter().sum();
                assert!(sum < 1.0 + 1e-4, "{surface:?}: the density integrates to {sum}");
                expected[bins] = (1.0 - sum).max(0.0);
                let sum: f64 = expected.iter().sum();
                expected.iter_mut().for_each(|part| *part /= sum);
                if expected[bins] < 1e-4 {
                    // Rounding of the integral.
                    assert_eq!(counts[bins], 0, "{surface:?}");
                }
                chi_squared::assert_fits(&counts, &expected);
            }
        }
    }
}

/// The mean of the weights is all that the surface gives back of even light, part by part; and that
/// is one at most.
#[test]
fn no_surface_gives_back_more_than_it_gets() {
    const COUNT: u64 = 20_000;
    for surface in every() {
        for facing in views() {
            let bsdf = surface.at(DVec2::ZERO, &facing);
            let mean = |part: Part| {
                let ways = (0..COUNT).filter_map(|i| bsdf.sample(part, numbers(i)));
                let sum = ways.fold([0.0; 3], |sum: [f64; 3], way| {
                    let weight = way.weight.to_array().map(f64::from);
                    std::array::from_fn(|i| sum[i] + weight[i])
                });
                sum.map(|sum| sum / COUNT as f64)
            };
            let [all, scattered, specular] = PARTS.map(mean);
            let told = bsdf.specular().into_iter().flatten();
            let told = told.fold(Rgb::BLACK, |sum, way| sum + way.weight).to_array();
            for i in 0..3 {
                let sum = scattered[i] + specular[i];
                assert!((all[i] - sum).abs() < 0.02, "{surface:?}: {all:?}, not {sum}");
                assert!((specular[i] - f64::from(told[i])).abs() < 0.02, "{surface:?}: {told:?}");
                assert!(f64::from(told[i]) + scattered[i] < 1.0 + 1e-5, "{surface:?}: {all:?}");
            }
        }
    }
}

/// Helmholtz's reciprocity of what is scattered to all sides; of mirrors and glass, that light which
/// is sent back goes the same way in the same part.
#[test]
fn light_goes_either_way_alike() {
    for surface in every() {
        for i in 0..200 {
            let (a, b) = (above(i), above(i + 1000));
            let from = |wo: Vec3| surface.at(DVec2::ZERO, &seen(wo, Vec3::Z));
            let [one, other] =
                [from(a).scattered(b) / b.z, from(b).scattered(a) / a.z].map(Rgb::to_array);
            for (one, other) in one.into_iter().zip(other) {
                assert!((one - other).abs() <= 1e-5 * one.max(1e-3), "{surface:?}: {one} {other}");
            }
            for way in from(a).specular().into_iter().flatten() {
                // Where it grazes, rounding of directions is more than what is asked for.
                if a.z < 1e-2 {
                    continue;
                }
                let up = way.wi.z > 0.0;
                let normal = if up { Vec3::Z } else { Vec3::NEG_Z };
                let behind = Facing { wo: way.wi, ng: normal, ns: normal, front: up };
                let back = surface.at(DVec2::ZERO, &behind).specular();
                let same = back.into_iter().flatten().find(|back| back.event == way.event);
                let same = same.expect("a way back");
                assert!((same.wi - a).length() < 1e-3, "{surface:?}: {} {a}", same.wi);
                let off = (same.weight - way.weight).to_array().map(f32::abs);
                assert!(off.iter().all(|off| *off < 1e-3), "{surface:?}: {way:?} {same:?}");
                assert!((same.squeeze * way.squeeze - 1.0).abs() < 1e-5);
            }
        }
    }
}

/// A hit on a triangle, with other normals and materials.
fn hits(count: usize, materials: &[Material]) -> Vec<(Hit, Vec3)> {
    let mut shapes = Shapes::new();
    let corners = [Vec3::NEG_ONE, Vec3::new(2.0, -1.0, -1.0), Vec3::new(-1.0, 2.0, -1.0)];
    let corners = corners.map(|corner| shapes.vertex(corner));
    shapes.triangle(Triangle { corners, normals: None, owner: Owner::default() });
    let ray = Ray::new(Vec3::new(-0.5, -0.5, 2.0), Vec3::NEG_Z);
    let hit = Geometry::build(shapes).closest(&ray).unwrap();
    let hit = |i: u64| {
        let (ns, wo) = (above(3 * i), above(3 * i + 1));
        let material = random::at(9, i) as u32 % materials.len() as u32;
        let side = if random::at(10, i).is_multiple_of(2) { 1.0 } else { -1.0 };
        (Hit { ns, material, ..hit }, side * wo)
    };
    (0..count as u64).map(hit).collect()
}

#[test]
fn many_surfaces_do_what_each_does_alone() {
    let table = vec![Rgb::ONE, Rgb::grey(0.5), Rgb::new(0.1, 0.25, 0.5)];
    let others = [
        Surface::Conductor(Conductor::Table(table)),
        Surface::Dielectric(Dielectric { inside: 1.0, outside: 1.33 }),
        Surface::Dielectric(Dielectric { inside: 1.5, outside: 1.5 }),
        Surface::Diffuse(Diffuse { albedo: Colour::Plain(Rgb::BLACK) }),
        Surface::Mixture(Mixture { parts: every().skip(3).take(1).map(|it| (1.0, it)).collect() }),
    ];
    let emission = Emission { radiance: Rgb::BLACK, both: false };
    let material = |surface| Material { surface, emission, before: 0, behind: None };
    let materials: Vec<Material> = every().chain(others).map(material).collect();
    let (mut many, mut lamberts, mut ways) =
        (Mingled::default(), Lamberts::default(), Ways::default());
    for count in [LANES, 1, 7, 8, 9, 100, LANES - 1] {
        let mut hits = hits(count, &materials);
        let of = |hit: &Hit| &materials[hit.material as usize];
        hits.sort_by_key(|(hit, _)| Any::rank(of(hit)));
        let mut fours = Fours::default();
        many.clear();
        for (lane, (hit, wo)) in hits.iter().enumerate() {
            let seen = many.push(of(hit), hit, *wo);
            let bsdf = of(hit).at(hit, *wo);
            assert_eq!(seen.is_specular, bsdf.is_specular());
            assert_eq!(seen.lambert.is_some(), bsdf.scatters().is_some());
            let lambert = seen.lambert.as_ref().map(|it| (it, many.chance(Part::All)));
            if let Some((lambert, chance)) = lambert {
                let wi = above(lane as u64);
                assert_eq!(chance * lambert.pdf_w(wi), bsdf.pdf_w(Part::All, wi));
                assert_eq!(lambert.scattered(wi), bsdf.scattered(wi));
            }
            lamberts.put(lane, lambert);
            fours.push(&mut Sampler::Independent.stream(3, count as u64, lane as u64));
        }
        fours.draw();
        many.ways(&materials, &lamberts, &fours, &mut ways);
        for (lane, (hit, wo)) in hits.iter().enumerate() {
            let (way, some) = ways.at(lane);
            let alone = of(hit).at(hit, *wo).sample(Part::All, fours.at(lane));
            assert_eq!(some.then_some(way), alone, "{:?}", of(hit).surface);
        }
    }
}
