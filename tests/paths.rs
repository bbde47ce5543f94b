//! Light that is scattered again and again is right: enclosures whose radiance is known, and
//! settings that must not matter.

mod by_hand;

use glam::DVec3;
use scn::measure::statistics::{Moments, welch};
use scn::scene::{self, Depth, Integrator, LightCount, Roulette, Sides};

use by_hand::{Hand, at, path, splits};

/// So many standard errors apart, two expectations differ; fixed seeds make it no gamble.
const APART: f64 = 4.0;

fn tracer(change: impl Fn(&mut scene::Path)) -> Integrator {
    let mut tracer = path();
    change(&mut tracer);
    Integrator::Path(tracer)
}

/// Inside a hollow sphere that shines and scatters.
fn enclosure(albedo: f64, integrator: Integrator) -> Hand {
    let hand = Hand::new(integrator).material("wall", albedo, 1.0);
    let wall = hand.scene.materials[0].value.value.clone();
    let scene::Material::Diffuse(mut wall) = wall else { panic!("diffuse") };
    wall.emits = at(Sides::Both);
    let mut hand = hand.sphere(DVec3::ZERO, 1.0, "wall");
    hand.scene.materials[0].value.value = scene::Material::Diffuse(wall);
    hand.camera(DVec3::new(0.3, 0.1, 0.2), DVec3::X, 40.0)
}

#[test]
fn a_shining_enclosure_has_its_radiance() {
    for (albedo, truth) in [(0.5, 2.0), (0.8, 5.0), (0.95, 20.0)] {
        let found = enclosure(albedo, tracer(|_| ())).size(8, 8).samples(64).estimate();
        assert!((found.mean() - truth).abs() < APART * found.standard_error(), "{found:?}");
        assert!(found.standard_error() < 0.05 * truth);
    }
    // A depth leaves the rest of the series out.
    let cut = enclosure(0.8, tracer(|path| path.depth = at(Depth::Most(2))));
    let found = cut.size(8, 8).samples(64).estimate();
    let truth = 1.0 + 0.8 + 0.64;
    assert!((found.mean() - truth).abs() < APART * found.standard_error() + 1e-5, "{found:?}");
}

/// Lamp, mirror, glass, metal and diffuse surfaces under a sky.
fn still_life(integrator: Integrator) -> Moments {
    let gold = scene::Conductor {
        ior: at(scene::Index {
            n: scn::math::Spectrum::Constant(0.4),
            k: scn::math::Spectrum::Constant(2.4),
        }),
    };
    Hand::new(integrator)
        .material("floor", 0.7, 0.0)
        .material("lamp", 0.2, 12.0)
        .glass("glass", 1.5)
        .made_of("gold", scene::Material::Conductor(gold))
        .quad(DVec3::ZERO, DVec3::X * 3.0, DVec3::Y * 3.0, "floor")
        .sphere(DVec3::new(-0.8, 0.0, 0.5), 0.5, "gold")
        .sphere(DVec3::new(0.8, 0.0, 0.5), 0.5, "glass")
        .quad(DVec3::new(0.0, 0.0, 2.5), DVec3::Y * 0.8, DVec3::X * 0.8, "lamp")
        .background(0.3)
        .camera(DVec3::new(0.0, -3.0, 1.2), DVec3::new(0.0, 0.0, 0.4), 50.0)
        .samples(4096)
        .estimate()
}

#[test]
fn settings_that_only_change_the_noise_change_nothing_else() {
    let plain = still_life(tracer(|_| ()));
    let settings: [(&str, &dyn Fn(&mut scene::Path)); 9] = [
        ("mis: off", &|path| path.mis.value.0 = false),
        ("next_event: off", &|path| path.next_event.value.0 = false),
        ("lights: all", &|path| path.lights = at(LightCount::All)),
        ("light_samples: 3", &|path| path.light_samples = at(scene::Count(3))),
        ("roulette: mean", &|path| path.roulette = at(Roulette::Mean)),
        ("roulette: luminance", &|path| path.roulette = at(Roulette::Luminance)),
        ("roulette_after: 0", &|path| path.roulette_after = at(scene::Count(0))),
        ("splits.diffuse", &|path| path.splits = at(splits(0, 1, 5))),
        ("splits.specular", &|path| path.splits = at(splits(2, 0, 1))),
    ];
    for (name, change) in settings {
        let found = still_life(tracer(change));
        let (score, _, _) = welch(&plain, &found);
        assert!(score.abs() < APART, "{name}: {score}: {plain:?} {found:?}");
    }
}

#[test]
fn glass_in_a_white_room_is_not_seen() {
    for index in [1.0, 1.0 + 1e-7, 1.33, 1.5, 100.0] {
        for integrator in
            [tracer(|_| ()), tracer(|path| path.splits = at(splits(2, 0, 1))), by_hand::direct()]
        {
            let hand = Hand::new(integrator.clone())
                .glass("glass", index)
                .sphere(DVec3::ZERO, 1.0, "glass")
                .background(1.0)
                .camera(DVec3::Z * 4.0, DVec3::ZERO, 20.0)
                .size(4, 4)
                .samples(64);
            let mut hand = hand;
            if let Integrator::Direct(direct) = &mut hand.scene.integrator.value {
                direct.specular_depth = at(Depth::Unlimited);
            }
            for pixel in hand.picture().pixels {
                // Only rounding and roulette are left.
                assert!((pixel.g - 1.0).abs() < 0.15, "{index}: {}", pixel.g);
            }
        }
    }
}
