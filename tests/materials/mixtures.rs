//! Mixtures are what their parts are, by their part: exactly where that can be told, and among
//! them paths come to an end.

use glam::{DVec3, dvec3};
use scn::math::Spectrum;
use scn::scene::{self, Integrator, Sides};

use crate::by_hand::{Hand, at, path, splits};
use crate::{assert_mean, direct, even, tracer};

/// Paint under a sun, seen from above.
fn sunlit(material: &str, integrator: Integrator) -> Hand {
    Hand::new(integrator)
        .material("dark", 0.2, 0.0)
        .material("light", 0.8, 0.0)
        .mix("half", ["dark", "light"], 0.5)
        .mix("quarter", ["light", "dark"], 0.25)
        .mix("mixed", ["half", "quarter"], 0.6)
        .mix("all dark", ["dark", "light"], 0.0)
        .mix("all light", ["dark", "light"], 1.0)
        .directional(dvec3(1.0, 0.0, -1.0), 2.0_f64.sqrt() * std::f64::consts::PI)
        .disk(DVec3::ZERO, DVec3::Z, 1.0, material)
        .camera(DVec3::Z * 3.0, DVec3::ZERO, 1.0)
}

#[test]
fn paint_is_mixed_to_its_mean_to_the_last_digit() {
    for (material, truth) in [
        ("dark", 0.2),
        ("light", 0.8),
        ("half", 0.5),
        ("quarter", 0.65),
        ("mixed", 0.4 * 0.5 + 0.6 * 0.65),
        ("all dark", 0.2),
        ("all light", 0.8),
    ] {
        for integrator in [direct(0), tracer(0)] {
            let found = f64::from(sunlit(material, integrator).picture().pixels[0].g);
            assert!((found / truth - 1.0).abs() < 1e-6, "{material}: {found}, not {truth}");
        }
    }
}

/// A floor of paint and mirror under a lamp, a sky and a point, beside a ball: what is seen of the
/// mixture is the mean of what is seen of its parts, where light meets it once.
#[test]
fn what_a_mixture_shows_is_the_mean_of_what_its_parts_show() {
    let scene = |material: &str, integrator: Integrator| {
        let hand = Hand::new(integrator)
            .material("paint", 0.7, 0.0)
            .material("lamp", 0.0, 4.0)
            .mirror("mirror", 0.9)
            .metal("gold", Spectrum::Constant(0.4), Spectrum::Constant(2.4))
            .mix("shiny", ["paint", "mirror"], 0.3)
            .mix("rich", ["shiny", "gold"], 0.5)
            .quad(DVec3::ZERO, DVec3::X, DVec3::Y, material)
            .quad(dvec3(0.0, 1.0, 1.5), DVec3::Y * 0.5, DVec3::X * 0.7, "lamp")
            .point(dvec3(0.4, -0.5, 1.0), 0.3)
            .background(0.5)
            .camera(dvec3(0.0, -2.0, 2.0), DVec3::ZERO, 8.0);
        even(hand, 8192).estimate()
    };
    for (way, integrator) in [("direct", direct(0)), ("split", direct(2)), ("path", tracer(0))] {
        let [paint, mirror, gold] =
            ["paint", "mirror", "gold"].map(|it| scene(it, integrator.clone()).mean());
        for (material, parts) in [("shiny", [0.7, 0.3, 0.0]), ("rich", [0.35, 0.15, 0.5])] {
            let truth = parts[0] * paint + parts[1] * mirror + parts[2] * gold;
            let found = scene(material, integrator.clone());
            assert_mean(&found, truth, 0.01 * truth, &format!("{material} by {way}"));
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
    assert!((hand(Sides::Front, "both", 1.0) - 0.75 * 2.5).abs() < 1e-5);
}

#[test]
fn paths_among_mixtures_end_whatever_is_split() {
    let inside = |integrator: Integrator| {
        Hand::new(integrator)
            .material("chalk", 0.6, 0.0)
            .mirror("mirror", 1.0)
            .mix("half", ["mirror", "chalk"], 0.5)
            .sphere(DVec3::ZERO, 1.0, "half")
            .sphere(DVec3::ZERO, 0.1, "chalk")
            .camera(DVec3::new(0.5, 0.1, 0.2), DVec3::X, 40.0)
            .directional(DVec3::X, 1.0)
            .samples(4)
            .picture()
    };
    for (specular, diffuse) in [(1, 0), (3, 0), (0, 2), (2, 2)] {
        let splits = at(splits(specular, diffuse, 3));
        let picture = inside(Integrator::Path(scene::Path { splits, ..path() }));
        assert!(picture.pixels.iter().all(|pixel| pixel.is_finite()));
    }
}
