//! Lamps and lights give surfaces the light they should: irradiances with closed forms
//! (A1 to A3 of the ground truths), scene scales, and ways to write one lamp as several.

#[path = "../by_hand/mod.rs"]
mod by_hand;
mod every;
mod hidden;

use std::f64::consts::PI;

use glam::{DVec3, dvec3};
use scn::measure::statistics::{Moments, agrees, welch};
use scn::scene::{self, Integrator};

use by_hand::{Hand, at, direct, path};

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
            let truth = 0.5 / PI * 2.0 / (d * d) * (height / d);
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
            .spot(dvec3(off, 0.0, 1.0), dvec3(off, 0.0, 0.0), PI, angles)
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
            .camera(DVec3::ZERO, p, 0.1);
        // L = ρE/π.
        assert_is("ball", &found.samples(16_384).estimate(), truth, 0.005);
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

/// Evenly spread samples, so that a few of them suffice.
fn even(mut hand: Hand, samples: u64) -> Hand {
    let round = at(scene::Count(samples));
    hand.scene.sampler = at(scene::Sampler::Sobol(scene::Sobol { round }));
    hand.samples(samples)
}

/// A white, tiny surface at the origin, seen from close by, among black surfaces that shine with a
/// radiance of 1; its pixel is E/π.
fn receiver(integrator: Integrator, normal: DVec3) -> Hand {
    Hand::new(integrator)
        .material("floor", 1.0, 0.0)
        .material("lamp", 0.0, 1.0)
        .disk(DVec3::ZERO, normal, 1e-3, "floor")
        .camera(normal * 1e-2, DVec3::ZERO, 0.01)
}

/// Ways to find the light of a lamp, each with the samples it wants.
fn ways() -> Vec<(&'static str, Integrator, u64)> {
    vec![
        ("direct", direct(), 512),
        ("path", tracer(|_| ()), 512),
        ("mis: off", tracer(|path| path.mis.value.0 = false), 512),
    ]
}

/// Judges a lamp by all ways, and by chance alone if it is `large`.
fn assert_irradiance(
    name: &str,
    normal: DVec3,
    truth: f64,
    large: bool,
    add: impl Fn(Hand) -> Hand,
) {
    // Parts of a near disk's square miss it.
    let more = if name.contains("disk") { 8 } else { 1 };
    let mut ways = ways();
    if large {
        ways.push((
            "next_event: off",
            tracer(|path| path.next_event.value.0 = false),
            16_384 / more,
        ));
    }
    for (way, integrator, samples) in ways {
        let samples = more * samples;
        let found = even(add(receiver(integrator, normal)), samples).estimate();
        assert_is(&format!("{name} by {way}"), &found, truth / PI, 0.003);
    }
}

#[test]
fn disks_give_their_irradiance() {
    let disk = |name: &str, (radius, h, off): (f64, f64, f64), truth: f64, large: bool| {
        assert_irradiance(name, DVec3::Z, truth, large, |hand| {
            hand.disk(dvec3(off, 0.0, h), DVec3::NEG_Z, radius, "lamp")
        });
    };
    disk("disk on axis", (1.0, 1.0, 0.0), PI / 2.0, true);
    disk("small disk", (0.5, 2.0, 0.0), 0.184_800, false);
    disk("tiny disk", (1e-3, 1.0, 0.0), PI * 1e-6 / (1.0 + 1e-6), false);
    disk("endless disk", (1e3, 1.0, 0.0), 3.141_589_5, true);
    disk("disk aside", (1.0, 1.0, 1.0), 0.868_315, true);
    disk("disk far aside", (1.0, 1.0, 2.0), 0.165_833, false);
    disk("disk elsewhere", (0.75, 1.25, 1.5), 0.210_195, false);
    // Closer than its radius it is sampled in another way: by the square around it.
    for (h, off) in [(0.3, 0.0), (0.4, 0.5), (0.5, 0.95), (0.2, 1.1)] {
        let (h_2, off_2) = (f64::powi(h, 2), f64::powi(off, 2));
        let root = ((h_2 + off_2 + 1.0).powi(2) - 4.0 * off_2).sqrt();
        let truth = 0.5 * PI * (1.0 - (h_2 + off_2 - 1.0) / root);
        disk("disk close by", (1.0, h, off), truth, off < 1.0);
    }
}

/// By chance alone small lamps are found so seldom that only their noise can be asked.
#[test]
fn small_lamps_are_found_by_chance_as_often_as_they_should_be() {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let chance = || tracer(|path| path.next_event.value.0 = false);
    type Add = fn(Hand) -> Hand;
    let lamps: [(&str, f64, Add); 4] = [
        ("disk", 0.184_800 / PI, |hand| hand.disk(z_up(2.0), DVec3::NEG_Z, 0.5, "lamp")),
        ("disk aside", 0.165_833 / PI, |hand| {
            hand.disk(dvec3(2.0, 0.0, 1.0), DVec3::NEG_Z, 1.0, "lamp")
        }),
        ("sphere", 1e-2, |hand| hand.sphere(z_up(3.0), 0.3, "lamp")),
        ("sphere at the horizon", 0.090_586 / PI, |hand| hand.sphere(DVec3::X * 2.0, 1.0, "lamp")),
    ];
    for (name, truth, add) in lamps {
        let found = even(add(receiver(chance(), z)), 16_384).estimate();
        let (mean, error) = (found.mean(), found.standard_error());
        assert!((mean - truth).abs() < 4.0 * error && error < 0.02 * truth, "{name}: {found:?}");
    }
    // A lamp that sees itself in part, on a floor of its own: asked and by chance.
    let lit = |integrator: Integrator| {
        let hand = receiver(integrator, z).material("wall", 0.5, 0.0).material("bulb", 0.4, 8.0);
        let hand = hand.quad(x * 0.5, z, y, "wall").quad(z, y * 0.4, x * 0.4, "wall");
        even(hand.sphere(dvec3(0.1, 0.2, 0.4), 0.1, "bulb"), 8192).estimate()
    };
    let (asked, by_chance) = (lit(tracer(|_| ())), lit(chance()));
    let (score, _, _) = welch(&asked, &by_chance);
    assert!(score.abs() < 4.0, "{score}: {asked:?} {by_chance:?}");
    assert!(by_chance.standard_error() < 0.02 * asked.mean(), "{by_chance:?}");
}

fn z_up(height: f64) -> DVec3 {
    DVec3::Z * height
}

#[test]
fn rectangles_and_triangles_give_their_irradiance() {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    assert_irradiance("rectangle", z, 1.740_840, true, |hand| hand.quad(z, y, x, "lamp"));
    assert_irradiance("square", z, 0.752_275, true, |hand| hand.quad(z, y * 0.5, x * 0.5, "lamp"));
    assert_irradiance("wall", z, 0.597_329, true, |hand| hand.quad(x + z, z, y, "lamp"));
    let corners = [dvec3(-1.0, 1.0, 2.0), dvec3(2.0, 0.5, 1.0), dvec3(0.3, -1.5, 1.5)];
    let triangle = |hand: Hand| hand.triangle(corners, "lamp");
    assert_irradiance("triangle", z, 0.919_901, true, triangle);
    let tilted = dvec3(1.0, 2.0, 2.0) / 3.0;
    assert_irradiance("triangle across the horizon", tilted, 0.695_631, true, triangle);
}

#[test]
fn spheres_give_their_irradiance() {
    for (distance, degrees, truth) in [
        (3.0, 0.0, 0.349_066),
        (3.0, 60.0, 0.174_533),
        (2.0, 80.0, 0.171_832),
        (2.0, 90.0, 0.090_586),
        (2.0, 100.0, 0.035_449),
    ] {
        let (sin, cos) = f64::to_radians(degrees).sin_cos();
        let name = format!("sphere at {degrees} degrees");
        let samples = if degrees > 85.0 { 4096 } else { 1024 };
        for (way, integrator, _) in ways() {
            let hand = receiver(integrator, DVec3::Z);
            let centre = distance * dvec3(sin, 0.0, cos);
            let found = even(hand.sphere(centre, 1.0, "lamp"), samples).estimate();
            assert_is(&format!("{name} by {way}"), &found, truth / PI, 0.003);
        }
    }
}

/// Far, touched, and seen from next to nothing away: on the axis E = π (R / d)² for each.
#[test]
fn spheres_far_away_and_close_by_give_their_irradiance() {
    for (distance, radius) in [(1e4, 1.0), (1e4, 1e-3), (10.0, 9.9), (1.0, 0.98)] {
        for (way, integrator, samples) in ways() {
            let hand = receiver(integrator, DVec3::Z);
            let hand = hand.sphere(DVec3::Z * distance, radius, "lamp");
            let truth = (radius / distance).powi(2);
            let found = even(hand, samples).estimate();
            assert_is(&format!("{radius} at {distance} by {way}"), &found, truth, 0.003);
        }
    }
    // From inside, and from a floor that the sphere stands on.
    for (way, integrator, samples) in ways() {
        let inside = |mut hand: Hand| {
            for material in &mut hand.scene.materials {
                if let scene::Material::Diffuse(it) = &mut material.value.value {
                    it.emits = at(scene::Sides::Both);
                }
            }
            hand.sphere(dvec3(0.2, 0.1, 0.4), 1.0, "lamp")
        };
        let found = even(inside(receiver(integrator.clone(), DVec3::Z)), samples).estimate();
        assert_is(&format!("inside by {way}"), &found, 1.0, 0.003);
        // Above the horizon: what the formula for the occlusion of the ball on a plane leaves out.
        let hand = receiver(integrator, DVec3::Z).sphere(dvec3(1.0, 0.0, 1.0), 1.0, "lamp");
        let found = even(hand, 4 * samples).estimate();
        assert_is(&format!("on the floor by {way}"), &found, 1.0 - 0.646_447, 0.003);
    }
}

#[test]
fn faces_of_a_cube_see_each_other_by_their_form_factors() {
    let (x, y, z) = (DVec3::X * 0.5, DVec3::Y * 0.5, DVec3::Z * 0.5);
    for (name, truth, lamp) in
        [("opposite", 0.199_825, [z * 2.0, y, x]), ("adjacent", 0.200_044, [x + z, z, y])]
    {
        for (way, integrator, _) in ways().into_iter().take(2) {
            let hand = Hand::new(integrator)
                .material("floor", 1.0, 0.0)
                .material("lamp", 0.0, 1.0)
                .quad(DVec3::ZERO, x, y, "floor")
                .quad(lamp[0], lamp[1], lamp[2], "lamp")
                .camera(z, DVec3::ZERO, 90.0);
            let found = even(hand, 32_768).estimate();
            assert_is(&format!("{name} by {way}"), &found, truth, 0.003);
        }
    }
}

#[test]
fn concentric_spheres_have_their_radiosities() {
    for (towards, truth) in [(DVec3::ZERO, 1.089_109), (DVec3::Z * 2.0, 0.297_030)] {
        let hand = Hand::new(tracer(|_| ()))
            .material("inner", 0.3, 1.0 / PI)
            .material("outer", 0.6, 0.0)
            .sphere(DVec3::ZERO, 1.0, "inner")
            .sphere(DVec3::ZERO, 2.0, "outer")
            .camera(dvec3(0.0, 0.1, 1.5), towards, 1.0);
        assert_is("concentric", &even(hand, 8192).estimate(), truth / PI, 0.005);
    }
}
