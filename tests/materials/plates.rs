//! Plates of glass, in air and in contact, to the transmittance that is known of them: light goes
//! back and forth between their surfaces.

use glam::{DVec3, dvec3};
use scn::scene::{self, Integrator, Material};

use crate::by_hand::{Hand, at};
use crate::{assert_mean, direct, even, tracer};

/// What comes through surfaces of these materials, one behind the other and each facing front or
/// back, of the light of a lamp behind them.
fn through(hand: Hand, surfaces: &[(&str, f64)], degrees: f64) -> Hand {
    let (sin, cos) = f64::to_radians(degrees).sin_cos();
    let mut hand = hand.material("lamp", 0.0, 1.0);
    for (number, (material, front)) in surfaces.iter().enumerate() {
        hand = hand.plane(DVec3::NEG_Z * 0.1 * number as f64, DVec3::Z * *front, material);
    }
    let lamp = DVec3::NEG_Z * (0.1 * surfaces.len() as f64 + 1.0);
    let hand = hand.quad(lamp, DVec3::X * 900.0, DVec3::Y * 900.0, "lamp");
    hand.camera(dvec3(sin, 0.0, cos), DVec3::ZERO, 1e-3)
}

fn plates(integrator: Integrator, count: usize, degrees: f64) -> Hand {
    let surfaces = [("glass", 1.0), ("glass", -1.0)].repeat(count);
    through(Hand::new(integrator).glass("glass", 1.5), &surfaces, degrees)
}

#[test]
fn plates_of_glass_let_through_what_they_are_known_to() {
    // One plate: all ways on are followed to the tenth, and what is left is by chance.
    for (degrees, truth) in [(0.0, 0.923077), (60.0, 1.0 - 0.16377)] {
        for integrator in [direct(10), tracer(10)] {
            let found = plates(integrator, 1, degrees).samples(64).estimate();
            assert_mean(&found, truth, 0.003 * truth, &format!("one at {degrees}"));
        }
    }
    // Ten plates: by chance, from the third surface on.
    for (integrator, degrees, truth, samples) in
        [(tracer(2), 0.0, 6.0 / 11.0, 20_480), (direct(2), 45.0, 0.485921, 40_000)]
    {
        let found = even(plates(integrator, 10, degrees), samples).estimate();
        assert_mean(&found, truth, 0.005 * truth, &format!("ten at {degrees}"));
    }
}

/// A surface between two of the media of the scene.
fn between(hand: Hand, name: &str, [inside, outside]: [&str; 2]) -> Hand {
    let dielectric = scene::Dielectric {
        inside: at(scene::Ref::new(inside)),
        outside: at(Some(scene::Ref::new(outside))),
    };
    hand.made_of(name, Material::Dielectric(dielectric))
}

/// Wine between two panes: one surface where glass and wine touch, not two with air in between.
#[test]
fn wine_that_touches_its_glass_is_one_surface_with_it() {
    for (degrees, truth) in [(0.0, 0.912045), (45.0, 0.892610)] {
        for integrator in [direct(8), tracer(8)] {
            let hand = Hand::new(integrator).glass("glass", 1.52).glass("wine", 1.345);
            let hand = between(hand, "touch", ["wine", "glass"]);
            let surfaces = [("glass", 1.0), ("touch", 1.0), ("touch", -1.0), ("glass", -1.0)];
            let found = even(through(hand, &surfaces, degrees), 512).estimate();
            assert_mean(&found, truth, 0.003 * truth, &format!("at {degrees}"));
        }
    }
}

/// Sixty-four balls, each within the last, of two kinds of glass by turns.
#[test]
fn glass_in_glass_in_glass_is_not_seen_in_a_white_room() {
    let mut hand = Hand::new(tracer(0)).glass("flint", 1.7).glass("crown", 1.5).background(1.0);
    hand = between(hand, "outward", ["flint", "crown"]);
    hand = between(hand, "inward", ["crown", "flint"]);
    for number in 0..64 {
        let material = match number {
            0 => "crown",
            n if n % 2 == 1 => "outward",
            _ => "inward",
        };
        hand = hand.sphere(DVec3::ZERO, 0.97_f64.powi(number), material);
    }
    let found = hand.camera(DVec3::Z * 4.0, DVec3::ZERO, 25.0).samples(256).estimate();
    assert_mean(&found, 1.0, 0.005, "nested");
}
