//! Many sites at once against each alone, to the bit.

use std::sync::Arc;

use glam::{DVec3, Mat3};

use super::super::{Centre, Directional, Lamp, Sky};
use super::*;
use crate::math::random;
use crate::render::geometry::{Owner, Shapes};
use crate::render::samplers::Sampler;

/// A square lamp of this size over the origin, which faces down.
fn lamp(size: f32, both: bool) -> (Geometry, Light) {
    let mut shapes = Shapes::new();
    let corner = |x: f32, z: f32| Vec3::new(x, 1.0, z) * Vec3::new(size, 1.0, size);
    let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    let corners = corners.map(|corner| shapes.vertex(corner));
    let surfaces = shapes.quad(corners, Owner::default()).to_vec();
    let geometry = Geometry::build(shapes);
    let centre = Centre::new(DVec3::Y, DVec3::NEG_Y, DVec3::ONE);
    let lamp = Lamp::new((Rgb::new(1.0, 2.0, 3.0), both), surfaces, &geometry, centre);
    (geometry, Light::Lamp(Box::new(lamp)))
}

/// On surfaces of all kinds of slopes, some of them in the plane of the lamp.
fn site(place: u64) -> Site {
    let three = |from: u64| {
        let [x, y] = random::unit_pair(random::at(31, 10 * place + from));
        let [z, _] = random::unit_pair(random::at(32, 10 * place + from));
        2.0 * Vec3::new(x as f32, y as f32, z as f32) - 1.0
    };
    let (mut position, ng) = (2.0 * three(0), three(1).normalize());
    if place.is_multiple_of(7) {
        position.y = 1.0;
    }
    let error = 1e-6 * three(2).abs();
    let point = Point { position, error, ng, ..Point::free(Vec3::ZERO) };
    // Some on no surface.
    let normal = if place.is_multiple_of(11) { Vec3::ZERO } else { ng };
    Site { point, normal }
}

/// A sky that is brighter on one side, over ground that is not black.
fn sky() -> Light {
    let turned = Mat3::from_rotation_x(0.3);
    let radiance = |w: Vec3| Rgb::new(0.1 + w.x.max(0.0), w.z, 1.0);
    let sky = Sky::new(turned, 20, radiance, Rgb::grey(0.1));
    Light::Surroundings(Surroundings { sight: Sight::Sky(Arc::new(sky)), asked: None })
}

#[test]
fn those_who_ask_together_get_what_each_would_get_alone() {
    let sun = Directional { to_light: Vec3::X, irradiance: Rgb::new(3.0, 2.0, 1.0) };
    let dark = Sight::Constant(Rgb::BLACK);
    let dark = Light::Surroundings(Surroundings { sight: dark, asked: None });
    for (size, both, others) in [
        (0.5, false, vec![]),
        (0.01, true, vec![]),
        (3.0, false, vec![]),
        (0.5, true, vec![lamp(0.5, true).1]),
        (0.5, true, vec![sky()]),
        (0.5, false, vec![Light::Directional(sun), sky(), dark]),
    ] {
        let (geometry, light) = lamp(size, both);
        let without = Lights::new(others.clone(), Vec::new(), Vec::new());
        let with = [vec![light], others].concat();
        agree(&geometry, &Lights::new(with, Vec::new(), Vec::new()));
        // Far ones alone are chosen in vectors.
        agree(&geometry, &without);
    }
}

/// Waves of every length, for what is left over of vectors too.
fn agree(geometry: &Geometry, lights: &Lights) {
    let (mut sites, mut fours) = (Sites::default(), Fours::default());
    let mut arrivals = Arrivals::default();
    for wave in 0..40 {
        let lanes = 1 + wave as usize * 13 % LANES;
        sites.clear();
        fours.clear();
        for lane in 0..lanes as u64 {
            sites.push(&site(1000 * wave + lane));
            fours.push(&mut Sampler::Independent.stream(3, wave, lane));
        }
        fours.draw();
        for asked in [None].into_iter().chain((0..lights.all.len()).map(Some)) {
            lights.sample_all(geometry, (&sites, &fours), asked, &mut arrivals);
            for lane in 0..lanes {
                let (site, u) = (site(1000 * wave + lane as u64), fours.at(lane));
                let chosen = match asked {
                    None => lights.choose(&site, u[2]),
                    Some(number) => Some((number, 1.0)),
                };
                let alone = chosen.and_then(|(number, pmf)| {
                    let arrival = lights.all[number].sample(geometry, &site, [u[0], u[1]])?;
                    Some((arrival, pmf))
                });
                let Some((alone, pmf)) = alone else {
                    assert!(arrivals.irradiance(lane).is_black());
                    continue;
                };
                assert_eq!(arrivals.irradiance(lane), alone.irradiance);
                assert_eq!(arrivals.wi(lane), alone.wi);
                assert_eq!(arrivals.density(lane), (alone.pdf_w, pmf));
                assert_eq!(arrivals.shadow(lane), alone.shadow);
            }
        }
    }
}
