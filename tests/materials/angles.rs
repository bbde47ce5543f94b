//! Fresnel's formulas in pictures: what glass and metals give back at each angle, from air and
//! from within, to the numbers that are known (A4 of the ground truths).

use glam::{DVec3, dvec3};
use scn::math::Spectrum;

use crate::by_hand::Hand;
use crate::direct;

const ANGLES: [f64; 6] = [0.0, 45.0, 60.0, 75.0, 85.0, 89.0];

/// What a plane of a material gives back of light of 1, seen at an angle; behind it is darkness.
fn given_back(hand: Hand, degrees: f64, from_behind: bool) -> f64 {
    let side = if from_behind { -1.0 } else { 1.0 };
    let (sin, cos) = degrees.to_radians().sin_cos();
    let hand = hand
        .background(1.0)
        .material("dark", 0.0, 0.0)
        .plane(DVec3::ZERO, DVec3::Z, "it")
        .disk(DVec3::Z * -1e-3 * side, DVec3::Z, 2.0, "dark")
        .camera(dvec3(0.3 * sin, 0.0, 0.3 * side * cos), DVec3::ZERO, 1e-6);
    f64::from(hand.picture().pixels[0].g)
}

fn assert_near(found: f64, truth: f64, what: &str) {
    assert!((found - truth).abs() < 1e-5, "{what}: {found}, not {truth}");
}

#[test]
fn glass_gives_back_what_it_is_known_to() {
    let known: [(f64, &[f64]); 3] = [
        (1.5, &[0.04, 0.050240, 0.089187, 0.253061, 0.612800, 0.904185]),
        (1.33, &[0.020059, 0.027521, 0.059126, 0.211427, 0.582728]),
        (2.42, &[0.172395, 0.181521, 0.211598, 0.330627, 0.621622]),
    ];
    for (index, parts) in known {
        for (degrees, truth) in ANGLES.into_iter().zip(parts) {
            let found = given_back(Hand::new(direct(1)).glass("it", index), degrees, false);
            assert_near(found, *truth, &format!("{index} at {degrees}"));
        }
    }
    let within = [(20.0, 0.041729), (40.0, 0.245291), (41.8, 0.890772), (41.82, 1.0), (89.0, 1.0)];
    for (degrees, truth) in within {
        let found = given_back(Hand::new(direct(1)).glass("it", 1.5), degrees, true);
        // So close to the last angle rounding of directions shows.
        let close = if degrees == 41.8 { 1e-3 } else { 1e-5 };
        assert!((found - truth).abs() < close, "within, at {degrees}: {found}, not {truth}");
    }
    for (index, degrees, truth) in
        [(100.0, 0.0, 0.960788), (1.0 + 2.0_f64.powi(-23), 89.99, 0.246361)]
    {
        let found = given_back(Hand::new(direct(1)).glass("it", index), degrees, false);
        // A grazing angle is known to what f32 knows of its cosine.
        assert!((found / truth - 1.0).abs() < 3e-3, "{index} at {degrees}: {found}, not {truth}");
    }
}

#[test]
fn metals_give_back_what_they_are_known_to() {
    let known = [
        ((0.43, 2.455), [0.786916, 0.785459, 0.788132, 0.825029, 0.919646, 0.982462]),
        ((0.14, 3.697), [0.962585, 0.961135, 0.958123, 0.956660, 0.975978, 0.994685]),
        ((1.38, 1.914), [0.408220, 0.415468, 0.439799, 0.540234, 0.765842, 0.943683]),
        ((0.06, 3.586), [0.982836, 0.982163, 0.980802, 0.980397, 0.989470, 0.997704]),
        ((1.02, 2.577), [0.619450, 0.618148, 0.621545, 0.670952, 0.829901, 0.960051]),
    ];
    for ((n, k), parts) in known {
        for (degrees, truth) in ANGLES.into_iter().zip(parts) {
            let [re, im] = [n, k].map(Spectrum::Constant);
            let found = given_back(Hand::new(direct(1)).metal("it", re, im), degrees, false);
            assert_near(found, truth, &format!("{n} + {k}i at {degrees}"));
        }
    }
}

#[test]
fn a_metal_that_absorbs_nothing_is_glass_and_one_that_absorbs_all_a_mirror() {
    for degrees in ANGLES {
        for n in [1.0, 1.0 + 1e-7, 1.5, 100.0] {
            let [re, none] = [n, 0.0].map(Spectrum::Constant);
            let metal = given_back(Hand::new(direct(1)).metal("it", re, none), degrees, false);
            let glass = given_back(Hand::new(direct(1)).glass("it", n), degrees, false);
            assert!((metal - glass).abs() < 1e-6, "{n} at {degrees}: {metal}, {glass}");
        }
        for k in [1e6, 1e10, 1e20, 1e300] {
            let [n, k] = [1e-3, k].map(Spectrum::Constant);
            let found = given_back(Hand::new(direct(1)).metal("it", n, k), degrees, false);
            assert_near(found, 1.0, &format!("{degrees}"));
        }
    }
}

#[test]
fn metal_may_have_any_index() {
    for n in [1e-30, 1e-3, 1.0, 1e20] {
        for k in [0.0, 1.0, 1e6, 1e20, 1e300] {
            let metal = [n, k].map(Spectrum::Constant);
            let [n, k] = metal;
            let hand = Hand::new(direct(1))
                .metal("metal", n, k)
                .sphere(DVec3::ZERO, 1.0, "metal")
                .background(1.0)
                .camera(DVec3::Z * 4.0, DVec3::ZERO, 40.0)
                .size(8, 8);
            for pixel in hand.picture().pixels {
                assert!((0.0..=1.00001).contains(&pixel.g), "{}", pixel.g);
            }
        }
    }
}
