//! Lamps and lights give surfaces the light they should: irradiances with closed forms
//! (A1 to A3 of the ground truths), scene scales, and ways to write one lamp as several.

mod by_hand;

use glam::{DVec3, dvec3};
use scn::measure::statistics::{Moments, agrees};
use scn::scene::{self, Integrator};

use by_hand::{Hand, direct, path};

fn tracer(change: impl Fn(&mut scene::Path)) -> Integrator {
    let mut tracer = path();
    change(&mut tracer);
    Integrator::Path(tracer)
}

/// Holds when the mean is within `part` of the truth, and known to a quarter of that.
fn assert_is(what: &str, found: &Moments, truth: f64, part: f64) {
    let verdict = agrees(found.mean(), found.standard_error(), truth, part * truth);
    assert!(verdict.holds(), "{what}: {verdict}");
}

#[test]
fn a_point_gives_its_intensity_over_the_square_of_the_distance() {
    for (scale, height) in [(1.0, 1.0), (1e-6, 3.0), (1e7, 0.25)] {
        for tilt in [0.0, 0.6] {
            let hand = Hand::new(direct())
                .material("floor", 0.5, 0.0)
                .quad(DVec3::ZERO, DVec3::X * scale, DVec3::Y * scale, "floor")
                .point(dvec3(tilt, 0.0, height) * scale, 2.0 * scale * scale)
                .camera(DVec3::Z * 4.0 * scale, DVec3::ZERO, 0.001);
            let d = tilt.hypot(height);
            let truth = 0.5 / std::f64::consts::PI * 2.0 / (d * d) * (height / d);
            let found = f64::from(hand.picture().pixels[0].g);
            assert!((found / truth - 1.0).abs() < 3e-4, "{scale} {height}: {found} {truth}");
        }
    }
}

#[test]
fn a_spot_is_a_point_within_its_cone() {
    let lit = |angles, off: f64| {
        let hand = Hand::new(direct())
            .material("floor", 1.0, 0.0)
            .quad(DVec3::ZERO, DVec3::X, DVec3::Y, "floor")
            .spot(dvec3(off, 0.0, 1.0), dvec3(off, 0.0, 0.0), std::f64::consts::PI, angles)
            .camera(DVec3::Z * 4.0, DVec3::ZERO, 0.001);
        f64::from(hand.picture().pixels[0].g)
    };
    assert!((lit([30.0, 0.0], 0.0) - 1.0).abs() < 1e-4);
    let cos = |degrees: f64| degrees.to_radians().cos();
    for degrees in [19.0_f64, 21.0, 25.0, 29.0, 31.0] {
        let t = ((cos(degrees) - cos(30.0)) / (cos(20.0) - cos(30.0))).clamp(0.0, 1.0);
        let truth = t * t * (3.0 - 2.0 * t) * cos(degrees).powi(3);
        let found = lit([30.0, 10.0], degrees.to_radians().tan());
        assert!((found - truth).abs() < 1e-3, "{degrees}: {found} {truth}");
    }
}

#[test]
fn a_point_in_a_white_ball_lights_it_evenly_beyond_its_first_light() {
    let light = dvec3(0.5, 0.0, 0.0);
    let truths = [(DVec3::X, 1.411_174), (DVec3::NEG_X, 0.618_936), (DVec3::Y, 0.679_341)];
    for (p, truth) in truths {
        let found = Hand::new(tracer(|_| ()))
            .material("wall", 0.7, 0.0)
            .sphere(DVec3::ZERO, 1.0, "wall")
            .point(light, 1.0)
            .camera(DVec3::ZERO, p, 0.1)
            .samples(16_384)
            .estimate();
        // L = ρE/π.
        assert_is("ball", &found, truth, 0.005);
    }
}

#[test]
fn a_spot_that_fades_over_more_than_its_cone_is_refused() {
    let hand = |angles| {
        Hand::new(direct()).material("ball", 0.5, 0.0).sphere(DVec3::ZERO, 1.0, "ball").spot(
            DVec3::Z * 3.0,
            DVec3::ZERO,
            1.0,
            angles,
        )
    };
    assert_eq!(hand([20.0, 20.0]).codes(), Vec::<&str>::new());
    assert_eq!(hand([20.0, 20.1]).codes(), ["scene/wide-falloff"]);
    let far = hand([20.0, 0.0]).point(DVec3::splat(1e17), 1.0);
    assert_eq!(far.codes(), ["scene/beyond-numbers"]);
}
