//! What surfaces hide of even light from all around, against closed forms (A3 of the ground truths).

use glam::{DVec3, dvec3};
use scn::measure::statistics::agrees;
use scn::scene::{self, Integrator};

use crate::by_hand::{self, Hand, at};
use crate::even;

fn ambient(distance: Option<f64>) -> Integrator {
    Integrator::Ambient(scene::Ambient {
        rays: at(scene::Count(16)),
        distance: at(distance.map(scene::Length)),
        paths: at(None),
        direct: at(scene::Switch(false)),
        lights: at(scene::LightCount::All),
        light_samples: at(scene::Count(1)),
        specular_depth: at(scene::Depth::Most(10)),
        splits: at(by_hand::splits(0, 0, 1)),
        roulette: at(scene::Roulette::Throughput),
    })
}

/// What a point of a white floor sees of a sky of 1, as a part.
fn assert_seen(
    name: &str,
    (p, distance): (DVec3, Option<f64>),
    truth: f64,
    add: impl Fn(Hand) -> Hand,
) {
    let hand = Hand::new(ambient(distance)).material("white", 1.0, 0.0).background(1.0);
    let hand = add(hand).camera(p + DVec3::Z * 1e-3, p, 0.01);
    let found = even(hand, 256).estimate();
    let verdict = agrees(found.mean(), found.standard_error(), truth, 0.005);
    assert!(verdict.holds(), "{name}: {verdict}");
}

#[test]
fn surfaces_hide_the_sky_by_as_much_as_they_fill() {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let floor = |hand: Hand| hand.plane(DVec3::ZERO, z, "white");
    assert_seen("wall", (x * 0.5, None), 0.723_607, |hand| {
        floor(hand).quad(z * 0.5, y * 500.0, z * 0.5, "white")
    });
    for (p, truth) in [([0.5; 2], 0.239_456), ([1e-4; 2], 0.138_532), ([0.25; 2], 0.207_843)] {
        assert_seen("cube", (dvec3(p[0], p[1], 0.0), None), truth, |hand| {
            let (h, k, up) = (x * 0.5, y * 0.5, z * 0.5);
            let hand = hand.quad(h + k, h, k, "white").quad(k + up, k, up, "white");
            let hand = hand.quad(x + k + up, k, up, "white").quad(h + up, h, up, "white");
            hand.quad(h + y + up, h, up, "white")
        });
    }
    for (d, truth) in
        [(0.25, 0.086_925), (0.5, 0.284_458), (1.0, 0.646_447), (2.0, 0.910_557), (4.0, 0.985_733)]
    {
        assert_seen("ball", (x * d, None), truth, |hand| floor(hand).sphere(z, 1.0, "white"));
    }
    // A right-angled groove, a metre wide on either side, half a metre from its bottom.
    let (left, right) = (dvec3(-1.0, 0.0, 1.0).normalize(), dvec3(1.0, 0.0, 1.0).normalize());
    let hand = Hand::new(ambient(None)).material("white", 1.0, 0.0).background(1.0);
    let hand = hand.quad(left * 0.5, y * 500.0, left * 0.5, "white");
    let hand = hand.quad(right * 0.5, y * 500.0, right * 0.5, "white");
    let hand = hand.camera(right * 0.5 + left * 1e-3, right * 0.5, 0.01);
    let found = even(hand, 256).estimate();
    let verdict = agrees(found.mean(), found.standard_error(), 0.723_607, 0.005);
    assert!(verdict.holds(), "groove: {verdict}");
    for (k, truth) in [(0.5, 0.804_499), (0.25, 0.657_481), (0.1, 0.563_556)] {
        assert_seen("nearby wall", (x * k, Some(1.0)), truth, |hand| {
            floor(hand).quad(DVec3::ZERO, y * 50.0, z * 50.0, "white")
        });
    }
}
