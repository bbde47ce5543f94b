//! Mirrors, metals, glass and mixtures keep the energy of light, and give it back where physics
//! has it.

#[path = "../by_hand/mod.rs"]
mod by_hand;

use glam::{DVec3, dvec3};
use scn::math::Spectrum;
use scn::measure::statistics::Moments;
use scn::scene::{self, Depth, Integrator, Sides};

use by_hand::{Hand, at, bumpy_ball, path, splits};

/// So many standard errors apart, two expectations differ; fixed seeds make it no gamble.
const APART: f64 = 4.0;

fn tracer(specular: u64) -> Integrator {
    Integrator::Path(scene::Path { splits: at(splits(specular, 0, 1)), ..path() })
}

/// `direct`, with any number of mirrors.
fn direct(specular: u64) -> Integrator {
    let Integrator::Direct(direct) = by_hand::direct() else { panic!("direct") };
    Integrator::Direct(scene::Direct {
        specular_depth: at(Depth::Unlimited),
        splits: at(splits(specular, 0, 1)),
        environment: at(scene::Switch(true)),
        ..direct
    })
}

/// Every material, each with its part of even light that comes back, if that is one number.
fn furnace(integrator: Integrator) -> Hand {
    Hand::new(integrator)
        .material("paint", 0.6, 0.0)
        .mirror("mirror", 1.0)
        .glass("glass", 1.5)
        .metal("silver", Spectrum::Constant(0.06), Spectrum::Constant(3.586))
        .mix("dusty", ["glass", "mirror"], 0.25)
        .mix("dustier", ["dusty", "paint"], 0.5)
        .background(1.0)
}

/// The mean of the picture is `truth`, to `close` or four standard errors of at most a quarter of it.
fn assert_mean(found: &Moments, truth: f64, close: f64, what: &str) {
    let error = found.standard_error();
    assert!(error <= close / 4.0, "{what}: {error} is too noisy for {close}");
    assert!((found.mean() - truth).abs() <= close.max(APART * error), "{what}: {found:?}, {truth}");
}

#[test]
fn in_even_light_each_material_gives_back_its_part_from_outside_and_inside() {
    for (material, truth) in [("paint", 0.6), ("mirror", 1.0), ("glass", 1.0), ("dusty", 1.0)] {
        for integrator in [tracer(0), tracer(2), direct(2)] {
            for eye in [dvec3(0.0, 0.0, 4.0), dvec3(0.2, 0.1, 0.3)] {
                let inside = eye.length() < 1.0;
                if inside && ["paint", "mirror"].contains(&material) {
                    // No light comes in.
                    continue;
                }
                // In glass the same light comes from less solid angle: n² times the radiance.
                let truth = if inside { 2.25 * truth } else { truth };
                let hand = furnace(integrator.clone())
                    .sphere(DVec3::ZERO, 1.0, material)
                    .camera(eye, DVec3::ZERO, 20.0)
                    .samples(1024);
                assert_mean(&hand.estimate(), truth, 0.02, material);
            }
        }
    }
}

#[test]
fn metal_gives_back_its_reflectance() {
    for (degrees, truth) in [(0.0, 0.982836), (60.0, 0.980802), (85.0, 0.989470), (89.0, 0.997704)]
    {
        let (sin, cos) = f64::to_radians(degrees).sin_cos();
        let hand = furnace(direct(1)).disk(DVec3::ZERO, DVec3::Z, 1.0, "silver").camera(
            dvec3(3.0 * sin, 0.0, 3.0 * cos),
            DVec3::ZERO,
            1e-3,
        );
        let found = f64::from(hand.picture().pixels[0].g);
        assert!((found - truth).abs() < 1e-5, "{degrees}: {found}, not {truth}");
    }
}

#[test]
fn a_smooth_mirror_and_smooth_glass_lose_no_light_along_their_silhouettes() {
    for integrator in [direct(1), tracer(8)] {
        for (material, close) in [("mirror", 1e-4), ("glass", 0.02)] {
            // Coarse, so that its two normals are far apart.
            let hand = furnace(integrator.clone()).mesh(bumpy_ball(8), 1.0, 0.0);
            let mut hand = hand.camera(DVec3::Z * 4.0, DVec3::ZERO, 40.0).size(32, 32).samples(64);
            let made_of = scene::Ref::new(material);
            let of = hand.scene.material(&made_of).clone();
            hand.meshes.last_mut().unwrap().as_mut().unwrap().materials = vec![of];
            let picture = hand.picture();
            let pixels = picture.pixels.len() as f64;
            let mean = picture.pixels.iter().map(|p| f64::from(p.g)).sum::<f64>() / pixels;
            assert!((mean - 1.0).abs() < close, "{material}: {mean}");
            if material == "mirror" {
                assert!(picture.pixels.iter().all(|p| (p.g - 1.0).abs() < 1e-4));
            }
        }
    }
}

/// What comes through plates of glass, 20 wide, of the light of a lamp behind them.
fn plates(integrator: Integrator, count: usize, degrees: f64) -> Hand {
    let (sin, cos) = f64::to_radians(degrees).sin_cos();
    let mut hand = Hand::new(integrator).glass("glass", 1.5).material("lamp", 0.0, 1.0);
    let mut at = 0.0;
    for _ in 0..count {
        for front in [1.0, -1.0] {
            let (u, v) = (DVec3::X * 500.0, DVec3::Y * 500.0 * front);
            hand = hand.quad(DVec3::NEG_Z * at, u, v, "glass");
            at += 0.1;
        }
    }
    hand = hand.quad(DVec3::NEG_Z * (at + 1.0), DVec3::X * 900.0, DVec3::Y * 900.0, "lamp");
    hand.camera(dvec3(sin, 0.0, cos), DVec3::ZERO, 1e-3)
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
    // Ten plates: by chance.
    for (degrees, truth) in [(0.0, 6.0 / 11.0), (45.0, 0.485921)] {
        for integrator in [direct(0), tracer(0)] {
            let found = plates(integrator, 10, degrees).samples(16384).estimate();
            assert_mean(&found, truth, 0.02 * truth, &format!("ten at {degrees}"));
        }
    }
}

#[test]
fn glass_of_index_one_is_not_there() {
    let scene = |material: &str| {
        let hand = Hand::new(tracer(0)).glass("nothing", 1.0).material("paint", 0.0, 0.2);
        let hand = hand.background(0.3);
        let hand = hand.quad(DVec3::NEG_Z * 3.0, DVec3::X * 9.0, DVec3::Y * 0.2, "paint");
        let hand = match material {
            "nothing" => hand.sphere(DVec3::ZERO, 1.0, "nothing"),
            _ => hand,
        };
        let Integrator::Path(path) = path_without_lamps() else { panic!("path") };
        let hand = hand.integrator(Integrator::Path(path));
        hand.camera(DVec3::Z * 4.0, DVec3::ZERO, 40.0).size(32, 32).picture()
    };
    // Emission and background alone: what is seen is where it was, but for edges.
    let (with, without) = (scene("nothing"), scene("none"));
    let apart = with.pixels.iter().zip(&without.pixels).filter(|(a, b)| (a.g - b.g).abs() > 1e-5);
    assert!(apart.count() <= 4, "things were moved");
}

/// Light that no surface scatters.
fn path_without_lamps() -> Integrator {
    let mut glass_only = path();
    glass_only.next_event = at(scene::Switch(false));
    glass_only.depth = at(Depth::Most(2));
    glass_only.roulette = at(scene::Roulette::Off);
    glass_only.splits = at(splits(4, 0, 1));
    Integrator::Path(glass_only)
}

#[test]
fn mirrors_that_face_each_other_come_to_an_end() {
    // A room of mirrors around a lamp: 1 + ρ + ρ² + … of its light, less what the lamp hides.
    for (reflectance, roulette) in [(1.0, true), (0.9, true), (0.9, false)] {
        let mut tracer = path();
        if !roulette {
            tracer.roulette = at(scene::Roulette::Off);
            tracer.depth = at(Depth::Most(500));
        }
        let hand = Hand::new(Integrator::Path(tracer))
            .mirror("mirror", reflectance)
            .material("lamp", 0.0, 1.0)
            .quad(DVec3::Z * 1.0, DVec3::X * 50.0, DVec3::NEG_Y * 50.0, "mirror")
            .quad(DVec3::Z * -1.0, DVec3::X * 50.0, DVec3::Y * 50.0, "mirror")
            .background(1.0)
            .camera(DVec3::ZERO, dvec3(0.02, 0.01, 1.0), 1.0)
            .size(4, 4)
            .samples(16);
        // Along this way light is mirrored some hundred times before it leaves.
        for pixel in hand.picture().pixels {
            assert!(pixel.g.is_finite() && pixel.g >= 0.0);
        }
    }
    // A closed room of perfect mirrors has no light of its own, and ends.
    let hand = Hand::new(tracer(0))
        .mirror("mirror", 1.0)
        .sphere(DVec3::ZERO, 1.0, "mirror")
        .background(1.0)
        .camera(dvec3(0.1, 0.2, 0.0), DVec3::X, 40.0)
        .size(4, 4)
        .samples(16);
    assert!(hand.picture().pixels.iter().all(|pixel| pixel.g == 0.0));
}

#[test]
fn metal_may_have_any_index() {
    for n in [1e-30, 1e-3, 1.0, 1e20] {
        for k in [0.0, 1.0, 1e6, 1e20, 1e300] {
            let metal = [n, k].map(Spectrum::Constant);
            let [n, k] = metal;
            let hand = Hand::new(direct(0))
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

#[test]
fn mirrors_and_mixtures_shine_what_they_are_said_to() {
    let shining = |emits: Sides| {
        scene::Material::Mirror(scene::Mirror {
            reflectance: at(scene::Textured::Plain(scene::Reflectance(Spectrum::Constant(0.5)))),
            emission: at(scene::Radiance(Spectrum::Constant(2.0))),
            emits: at(emits),
        })
    };
    let hand = |emits: Sides, material: &str, side: f64| {
        Hand::new(direct(1))
            .made_of("shining", shining(emits))
            .material("paint", 0.0, 0.0)
            .mix("both", ["shining", "paint"], 0.25)
            .disk(DVec3::ZERO, DVec3::Z, 1.0, material)
            .background(1.0)
            .camera(DVec3::Z * 3.0 * side, DVec3::ZERO, 1.0)
            .picture()
            .pixels[0]
            .g
    };
    assert!((hand(Sides::Front, "shining", 1.0) - 2.5).abs() < 1e-5);
    assert!((hand(Sides::Front, "shining", -1.0) - 0.5).abs() < 1e-5);
    assert!((hand(Sides::Both, "shining", -1.0) - 2.5).abs() < 1e-5);
    assert!((hand(Sides::Front, "both", 1.0) - 0.75 * 2.5).abs() < 0.02);
}
