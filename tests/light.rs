//! The light is right: scenes whose pictures are known by formula.

mod by_hand;

use std::f64::consts::PI;

use glam::{DVec3, dvec3};
use scn::measure::statistics::agrees;
use scn::scene::{AreaLights, Integrator, Preview, Step};

use by_hand::{Hand, bumpy_ball, direct, integrator};

/// A grey floor at the origin, seen from close by through a field of view so narrow that the
/// pixel shows one point. Small lamps may be near: the eye is within 0.12 of the floor.
fn floor(integrator: Integrator, normal: DVec3) -> Hand {
    let (u, v) = normal.normalize().any_orthonormal_pair();
    let eye = 0.1 * normal.normalize() + 0.05 * u + 0.03 * v;
    Hand::new(integrator)
        .material("grey", 0.5, 0.0)
        .material("lamp", 0.0, 1.0)
        .quad(DVec3::ZERO, 0.01 * u, 0.01 * v, "grey")
        .camera(eye, DVec3::ZERO, 1e-3)
}

/// Irradiance at the origin of [`floor`], from the radiance of a pixel.
fn irradiance(radiance: f64) -> f64 {
    radiance * PI / 0.5
}

#[test]
fn lambert_under_a_directional_light_is_exact() {
    for shadows in [true, false] {
        for (x, y) in [(0.0, 0.0), (0.3, -0.2), (2.0, 1.0), (30.0, 0.0)] {
            let direction = dvec3(x, y, -1.0);
            let cos = 1.0 / direction.length();
            let hand = floor(integrator(shadows, AreaLights::Random), DVec3::Z)
                .directional(direction, 3.0)
                .size(4, 4)
                .samples(4);
            let expected = 0.5 / PI * 3.0 * cos;
            for pixel in hand.picture().pixels {
                let error = f64::from(pixel.g) / expected - 1.0;
                assert!(error.abs() < 1e-5, "{direction}: {error}");
            }
        }
    }
}

#[test]
fn a_surface_is_lit_on_the_side_it_is_seen_from() {
    // The sun shines from above; seen from below the quad is dark, and so it is the other way.
    for (normal, sun, lit) in [(1.0, -1.0, true), (1.0, 1.0, false), (-1.0, -1.0, true)] {
        let v = DVec3::Y * normal;
        let hand = Hand::new(direct())
            .material("grey", 0.5, 0.0)
            .quad(DVec3::ZERO, DVec3::X, v, "grey")
            .directional(DVec3::Z * sun, 1.0)
            .camera(DVec3::Z * 3.0, DVec3::ZERO, 1.0);
        let expected = if lit { 0.5 / PI } else { 0.0 };
        assert!((f64::from(hand.picture().pixels[0].r) - expected).abs() < 1e-6);
    }
}

#[test]
fn a_lamp_shines_from_its_front_alone() {
    for (turn, seen) in [(1.0, 2.0), (-1.0, 0.0)] {
        let hand = Hand::new(direct())
            .material("lamp", 0.0, 2.0)
            .quad(DVec3::ZERO, DVec3::X, DVec3::Y * turn, "lamp")
            .camera(DVec3::Z * 3.0, DVec3::ZERO, 1.0);
        assert_eq!(hand.picture().pixels[0].b, seen);
    }
}

#[test]
fn the_lamp_at_its_centre_equals_its_formula() {
    for shadows in [true, false] {
        for centre in [dvec3(0.0, 0.0, 1.0), dvec3(0.7, -0.4, 0.9), dvec3(3.0, 2.0, 0.5)] {
            // A lamp of 0.2 × 0.3 that faces down.
            let hand = floor(integrator(shadows, AreaLights::Center), DVec3::Z).quad(
                centre,
                DVec3::Y * 0.1,
                DVec3::X * 0.15,
                "lamp",
            );
            let distance = centre.length();
            let cos = centre.z / distance;
            let expected = 0.06 * cos * cos / (distance * distance);
            let found = irradiance(f64::from(hand.picture().pixels[0].g));
            assert!((found / expected - 1.0).abs() < 1e-5, "{found} for {expected}");
        }
    }
}

#[test]
fn the_lamp_at_its_centre_lights_nothing_behind_it() {
    let hand = floor(integrator(true, AreaLights::Center), DVec3::Z).quad(
        dvec3(0.0, 0.5, 0.7),
        DVec3::X * 0.1,
        DVec3::Y * 0.1,
        "lamp",
    );
    assert_eq!(hand.picture().pixels[0].g, 0.0);
}

#[test]
fn triangles_of_one_lamp_shine_as_one() {
    // A mesh of two triangles shines from the middle of both, like the quad of the same corners.
    let at = |centre: DVec3| {
        floor(integrator(true, AreaLights::Center), DVec3::Z).quad(
            centre,
            DVec3::Y * 0.1,
            DVec3::X * 0.1,
            "lamp",
        )
    };
    let centre = dvec3(0.2, 0.3, 0.8);
    let one = at(centre).picture().pixels[0].g;
    let (u, v) = (DVec3::Y * 0.1, DVec3::X * 0.1);
    let corners = [centre - u - v, centre + u - v, centre + u + v, centre - u + v];
    let two = floor(integrator(true, AreaLights::Center), DVec3::Z)
        .triangle([corners[0], corners[1], corners[2]], "lamp")
        .triangle([corners[0], corners[2], corners[3]], "lamp")
        .picture();
    // As two objects they are two lamps, each with a centre of its own.
    let apart = two.pixels[0].g;
    assert!((one / apart - 1.0).abs() > 1e-4 && (one / apart - 1.0).abs() < 1e-2, "{one} {apart}");
}

#[test]
fn shadows_fall_where_they_should() {
    // A blocker between floor and sun, or lamp; without shadows it is as if it were not there.
    let blocked = |shadows: bool, area_lights: AreaLights| {
        floor(integrator(shadows, area_lights), DVec3::Z)
            .quad(dvec3(0.0, 0.0, 1.0), DVec3::X * 0.3, DVec3::Y * 0.3, "grey")
            .quad(dvec3(0.0, 0.0, 2.0), DVec3::Y * 0.1, DVec3::X * 0.1, "lamp")
            .directional(dvec3(0.0, 0.0, -1.0), 1.0)
            .samples(16)
    };
    for area_lights in [AreaLights::Center, AreaLights::Random] {
        assert_eq!(blocked(true, area_lights).picture().pixels[0].g, 0.0);
        let open = irradiance(f64::from(blocked(false, area_lights).picture().pixels[0].g));
        assert!((open - 1.01).abs() < 1e-3, "{open}");
    }
    let outcome = blocked(true, AreaLights::Random).render(0);
    assert_eq!((outcome.rays, outcome.shadow_rays), (16, 32));
    assert_eq!(blocked(false, AreaLights::Random).render(0).shadow_rays, 0);
}

#[test]
fn half_a_lamp_hidden_is_half_the_light() {
    // The blocker's edge runs through the middle of what the lamp's points are seen through.
    let hand = floor(direct(), DVec3::Z)
        .quad(dvec3(0.25, 0.0, 0.5), DVec3::X * 0.25, DVec3::Y * 0.25, "grey")
        .quad(dvec3(0.0, 0.0, 1.0), DVec3::Y * 0.1, DVec3::X * 0.1, "lamp")
        .grid(32)
        .samples(1024);
    let open = floor(direct(), DVec3::Z)
        .quad(dvec3(0.0, 0.0, 1.0), DVec3::Y * 0.1, DVec3::X * 0.1, "lamp")
        .grid(32)
        .samples(1024);
    let (half, whole) = (hand.estimate(), open.estimate());
    let verdict =
        agrees(half.mean(), half.standard_error(), 0.5 * whole.mean(), 3e-3 * half.mean());
    assert!(verdict.holds(), "{verdict:?}");
}

#[test]
fn mirrored_placements_keep_their_fronts() {
    // A lamp that faces up still does when it is mirrored sideways, and faces down when it is
    // mirrored upside down.
    let mirror = |x: f64, z: f64| Step::Scale(dvec3(x, 1.0, z));
    for (step, seen) in [(mirror(-1.0, 1.0), 2.0), (mirror(1.0, -1.0), 0.0)] {
        let lamps = |hand: Hand| hand.placed(step).camera(DVec3::Z * 3.0, DVec3::ZERO, 1.0);
        let start = || Hand::new(direct()).material("lamp", 0.0, 2.0);
        let (x, y) = (DVec3::X, DVec3::Y);
        let hands = [
            lamps(start().quad(DVec3::ZERO, x, y, "lamp")),
            lamps(start().triangle([-x - y, x - y, y], "lamp")),
            lamps(start().disk(DVec3::ZERO, DVec3::Z, 1.0, "lamp")),
        ];
        for hand in hands {
            assert_eq!(hand.picture().pixels[0].r, seen);
        }
    }
    // A smooth mesh mirrored looks like its mirror image: here it is the same on both sides.
    let ball = |step: Option<Step>| {
        let hand = Hand::new(direct()).mesh(bumpy_ball(12), 1.0, 0.5);
        let hand = step.into_iter().fold(hand, Hand::placed);
        hand.directional(DVec3::NEG_Z, 1.0).camera(DVec3::Z * 4.0, DVec3::ZERO, 40.0).size(16, 16)
    };
    let sum = |hand: Hand| hand.picture().pixels.iter().map(|p| f64::from(p.g)).sum::<f64>();
    let (plain, mirrored) = (sum(ball(None)), sum(ball(Some(mirror(-1.0, 1.0)))));
    assert!(plain > 1.0 && (mirrored / plain - 1.0).abs() < 0.05, "{plain} {mirrored}");
}

#[test]
fn the_preview_shows_colours_lamps_and_background() {
    let show = |material: &str| {
        Hand::new(Integrator::Preview(Preview {}))
            .material("grey", 0.5, 0.0)
            .material("lamp", 0.25, 3.0)
            .background(0.75)
            .quad(DVec3::ZERO, DVec3::X, DVec3::Y, material)
    };
    let above = |hand: Hand| hand.camera(DVec3::Z * 3.0, DVec3::ZERO, 0.01).picture().pixels[0].g;
    assert!((above(show("grey")) - 0.5).abs() < 1e-6);
    assert!((above(show("lamp")) - 3.25).abs() < 1e-6);
    // From the side by 60 degrees the cosine is one half; from behind a lamp does not shine.
    let slanted = dvec3(3.0_f64.sqrt(), 0.0, 1.0);
    let aside = show("grey").camera(slanted, DVec3::ZERO, 1e-3).picture().pixels[0].g;
    assert!((aside - 0.25).abs() < 1e-5, "{aside}");
    let behind = show("lamp").camera(-DVec3::Z, DVec3::ZERO, 0.01).picture().pixels[0].g;
    assert!((behind - 0.25).abs() < 1e-6);
    let past = show("grey").camera(DVec3::Z * 3.0, DVec3::Z * 4.0, 1.0).picture().pixels[0].g;
    assert_eq!(past, 0.75);
}
