//! Light that is scattered again and again is right: enclosures whose radiance is known, and
//! settings that must not matter.

#[path = "../by_hand/mod.rs"]
mod by_hand;
mod enclosures;
mod settings;

use glam::{DQuat, DVec3};
use scn::math::Spectrum;
use scn::measure::statistics::{Moments, welch};
use scn::scene::{self, Depth, Integrator};

use by_hand::{Hand, at, path};

/// So many standard errors apart, two expectations differ; fixed seeds make it no gamble.
const APART: f64 = 4.0;

fn tracer(change: impl Fn(&mut scene::Path)) -> Integrator {
    let mut tracer = path();
    change(&mut tracer);
    Integrator::Path(tracer)
}

/// Lamp, glass, metal and diffuse surfaces under a sky.
fn still_life(integrator: Integrator) -> Moments {
    mapped(integrator, |p| p, 1.0).samples(4096).estimate()
}

/// The same, each point moved and each length scaled.
fn mapped(integrator: Integrator, to: impl Fn(DVec3) -> DVec3, scale: f64) -> Hand {
    let way = |v: DVec3| to(v) - to(DVec3::ZERO);
    Hand::new(integrator)
        .material("floor", 0.7, 0.0)
        .material("lamp", 0.2, 12.0)
        .glass("glass", 1.5)
        .metal("gold", Spectrum::Constant(0.4), Spectrum::Constant(2.4))
        .quad(to(DVec3::ZERO), way(DVec3::X * 3.0), way(DVec3::Y * 3.0), "floor")
        .sphere(to(DVec3::new(-0.8, 0.0, 0.5)), 0.5 * scale, "gold")
        .sphere(to(DVec3::new(0.8, 0.0, 0.5)), 0.5 * scale, "glass")
        .quad(to(DVec3::new(0.0, 0.0, 2.5)), way(DVec3::Y * 0.8), way(DVec3::X * 0.8), "lamp")
        .background(0.3)
        .camera(to(DVec3::new(0.0, -3.0, 1.2)), to(DVec3::new(0.0, 0.0, 0.4)), 50.0)
        .up(way(DVec3::Z))
}

#[test]
fn size_place_and_direction_of_a_scene_change_nothing() {
    let tracer = || tracer(|_| ());
    let plain = mapped(tracer(), |p| p, 1.0).size(6, 4).samples(64);
    let picture = plain.picture();
    // By powers of two to the bit, from a millionth of a metre to a thousand kilometres.
    for power in [-20, 20] {
        let scale = 2.0_f64.powi(power);
        let scaled = mapped(tracer(), |p| p * scale, scale).size(6, 4).samples(64);
        assert!(scaled.picture() == picture, "scaled by 2^{power}");
    }
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 2.0_f64.sqrt());
    let plain = still_life(tracer());
    let far = DVec3::new(3e4, -1e5, 2e5);
    for (name, hand) in [
        ("1e-6", mapped(tracer(), |p| p * 1e-6, 1e-6)),
        ("1e7", mapped(tracer(), |p| p * 1e7, 1e7)),
        ("far away", mapped(tracer(), |p| p + far, 1.0)),
        ("turned", mapped(tracer(), |p| turn * p, 1.0)),
    ] {
        let (score, _, _) = welch(&plain, &hand.samples(4096).estimate());
        assert!(score.abs() < APART, "{name}: {score}");
    }
}

#[test]
fn light_of_any_strength_is_followed_alike() {
    let at_strength = |power: i32| {
        let mut hand = mapped(tracer(|_| ()), |p| p, 1.0).size(4, 4).samples(16);
        let factor = 2.0_f64.powi(power);
        for material in &mut hand.scene.materials {
            if let scene::Material::Diffuse(diffuse) = &mut material.value.value {
                diffuse.emission.value.0 = diffuse.emission.value.0.scaled(factor);
            }
        }
        let scene::Light::Constant(sky) = &mut hand.scene.lights[0].value.value else { panic!() };
        sky.radiance.value.0 = sky.radiance.value.0.scaled(factor);
        let factor = factor as f32;
        hand.picture().pixels.iter().map(|pixel| pixel.g / factor).collect::<Vec<_>>()
    };
    let plain = at_strength(0);
    for power in [-100, -1, 1, 100] {
        assert_eq!(at_strength(power), plain, "2^{power}");
    }
}

#[test]
fn paths_of_one_scattering_are_direct_light() {
    // No mirrors: `direct` follows them further than a path of one.
    let scene = |integrator: Integrator| {
        Hand::new(integrator)
            .material("floor", 0.7, 0.0)
            .material("lamp", 0.2, 12.0)
            .quad(DVec3::ZERO, DVec3::X * 3.0, DVec3::Y * 3.0, "floor")
            .sphere(DVec3::new(0.8, 0.0, 0.5), 0.5, "floor")
            .quad(DVec3::new(0.0, 0.0, 2.5), DVec3::Y * 0.8, DVec3::X * 0.8, "lamp")
            .directional(DVec3::new(1.0, 0.5, -2.0), 1.0)
            .background(0.3)
            .camera(DVec3::new(0.0, -3.0, 1.2), DVec3::new(0.0, 0.0, 0.4), 50.0)
            .samples(2048)
            .estimate()
    };
    let Integrator::Direct(mut direct) = by_hand::direct() else { panic!("direct") };
    direct.environment.value.0 = true;
    let direct = scene(Integrator::Direct(direct));
    for mis in [true, false] {
        let one = scene(tracer(|path| {
            path.depth = at(Depth::Most(1));
            path.mis.value.0 = mis;
        }));
        let (score, _, _) = welch(&direct, &one);
        assert!(score.abs() < APART, "{score}: {direct:?} {one:?}");
        assert!(one.standard_error() < 0.01 * one.mean());
    }
}
