//! Closed rooms whose radiance is a geometric series, and open ones of mirrors: however long light
//! is on its way, all of it is found, or as much as a depth lets through.

use glam::DVec3;
use scn::measure::statistics::agrees;
use scn::scene::{self, Depth, Integrator, Roulette, Sides};

use crate::by_hand::{Hand, at, splits};
use crate::tracer;

/// Inside a hollow sphere that shines and scatters.
fn enclosure(albedo: f64, integrator: Integrator) -> Hand {
    let hand = Hand::new(integrator).material("wall", albedo, 1.0);
    let mut hand = hand.sphere(DVec3::ZERO, 1.0, "wall");
    let scene::Material::Diffuse(wall) = &mut hand.scene.materials[0].value.value else {
        panic!("diffuse")
    };
    wall.emits = at(Sides::Both);
    hand.camera(DVec3::new(0.3, 0.1, 0.2), DVec3::X, 40.0)
}

/// Roulette begins where little of the series is left: what the test wants is whether it finds
/// that, and not the noise of a thousand reflections.
#[test]
fn a_shining_enclosure_has_its_radiance() {
    for (albedo, after, samples) in
        [(0.5, 4, 1024), (0.8, 15, 512), (0.99, 400, 128), (0.999, 4500, 32)]
    {
        for next_event in [true, false] {
            let hand = enclosure(
                albedo,
                tracer(|path| {
                    path.next_event.value.0 = next_event;
                    path.roulette = at(Roulette::Mean);
                    path.roulette_after = at(scene::Count(after));
                }),
            );
            let found = hand.samples(samples).estimate();
            let truth = 1.0 / (1.0 - albedo);
            let verdict = agrees(found.mean(), found.standard_error(), truth, 0.005 * truth);
            assert!(verdict.holds(), "{albedo}, next_event {next_event}: {verdict}");
        }
    }
}

#[test]
fn a_depth_leaves_out_the_rest_of_the_series() {
    for (albedo, depth) in [(0.8, 0), (0.8, 2), (0.99, 64), (0.999, 5000)] {
        for next_event in [true, false] {
            let found = enclosure(
                albedo,
                tracer(|path| {
                    path.next_event.value.0 = next_event;
                    path.roulette = at(Roulette::Off);
                    path.depth = at(Depth::Most(depth));
                }),
            );
            let found = f64::from(found.picture().pixels[0].g);
            let truth = (1.0 - albedo.powi(depth as i32 + 1)) / (1.0 - albedo);
            assert!((found / truth - 1.0).abs() < 1e-3, "{albedo}, {depth}: {found}, not {truth}");
        }
    }
}

/// A ray that comes to its depth leaves those that wait to be followed.
#[test]
fn a_depth_ends_each_of_several_rays_by_itself() {
    let (albedo, depth) = (0.8_f64, 3);
    for rays in [1, 2, 4] {
        let found = enclosure(
            albedo,
            tracer(|path| {
                path.next_event.value.0 = false;
                path.roulette = at(Roulette::Off);
                path.splits = at(splits(0, 2, rays));
                path.depth = at(Depth::Most(depth));
            }),
        );
        let found = f64::from(found.picture().pixels[0].g);
        let truth = (1.0 - albedo.powi(depth as i32 + 1)) / (1.0 - albedo);
        assert!((found / truth - 1.0).abs() < 1e-5, "{rays} rays: {found}, not {truth}");
    }
}

/// By the defaults: long before a thousand surfaces, roulette has begun to end paths that lose
/// next to nothing, and must not do so faster than light becomes weak.
#[test]
fn walls_that_give_nearly_all_light_back_are_not_too_dark() {
    let found = enclosure(0.999, tracer(|_| ())).samples(128).estimate();
    let (mean, error) = (found.mean(), found.standard_error());
    assert!((mean - 1000.0).abs() < 4.0 * error && error < 100.0, "{found:?}");
}

/// Two mirrors face each other under a sky of 1, and a ray goes from one to the other a little
/// further along, so many times, until it is past their edges.
fn hall(reflectance: f64, times: f64, integrator: Integrator) -> Hand {
    let slope = 100.0 / (2.0 * times);
    Hand::new(integrator)
        .mirror("mirror", reflectance)
        .quad(DVec3::Z, DVec3::X * 100.0, DVec3::Y, "mirror")
        .quad(DVec3::NEG_Z, DVec3::X * 100.0, DVec3::Y, "mirror")
        .background(1.0)
        .camera(DVec3::ZERO, DVec3::new(slope, 0.0, 1.0), 1e-6)
}

#[test]
fn between_mirrors_light_is_weakened_by_each_a_hundred_thousand_times() {
    let followed = || {
        let roulette = at(Roulette::Off);
        let Integrator::Direct(direct) = crate::by_hand::direct() else { panic!("direct") };
        let specular_depth = at(Depth::Most(1_000_000));
        [
            tracer(|path| {
                path.roulette = roulette;
                path.depth = specular_depth;
            }),
            Integrator::Direct(scene::Direct { roulette, specular_depth, ..direct }),
        ]
    };
    for (times, reflectance) in [(100, 0.97), (5000, 0.9995), (100_000, 1.0)] {
        for integrator in followed() {
            let truth = f64::powi(reflectance, times);
            let hand = hall(reflectance, f64::from(times), integrator);
            let found = f64::from(hand.picture().pixels[0].g);
            assert!((found / truth - 1.0).abs() < 3e-3, "{times}: {found}, not {truth}");
        }
    }
    // Roulette must end most of such paths, and weigh up the others by as much.
    let found = hall(1.0, 500.0, tracer(|_| ())).samples(256).estimate();
    let (mean, error) = (found.mean(), found.standard_error());
    assert!((mean - 1.0).abs() < 4.0 * error && error < 0.05, "{found:?}");
}

#[test]
fn a_closed_room_of_mirrors_is_full_of_the_light_of_its_lamp() {
    let room = |reflectance: f64, shine: f64| {
        let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
        let mut hand = Hand::new(tracer(|_| ())).mirror("mirror", reflectance);
        let scene::Material::Mirror(mirror) = &mut hand.scene.materials[0].value.value else {
            panic!("mirror")
        };
        mirror.emission.value.0 = scn::math::Spectrum::Constant(shine);
        mirror.emits = at(Sides::Both);
        for (normal, u, v) in [(x, y, z), (y, z, x), (z, x, y)] {
            hand = hand.quad(normal, u, v, "mirror").quad(-normal, u, v, "mirror");
        }
        hand.camera(DVec3::new(0.5, 0.4, -0.3), DVec3::new(-0.3, 0.2, 0.9), 60.0)
    };
    // Each way ends at the lamp: all of it is as bright as the lamp.
    let found = room(1.0, 0.0)
        .material("lamp", 0.0, 1.0)
        .sphere(DVec3::new(-0.4, -0.3, 0.1), 0.3, "lamp")
        .samples(1024)
        .estimate();
    let verdict = agrees(found.mean(), found.standard_error(), 1.0, 0.005);
    assert!(verdict.holds(), "{verdict}");
    // Walls that shine themselves: 1 + ρ + ρ² + …
    for (reflectance, samples) in [(0.5, 2048), (0.9, 4096)] {
        let found = room(reflectance, 1.0).samples(samples).estimate();
        let truth = 1.0 / (1.0 - reflectance);
        let verdict = agrees(found.mean(), found.standard_error(), truth, 0.02 * truth);
        assert!(verdict.holds(), "{reflectance}: {verdict}");
    }
}
