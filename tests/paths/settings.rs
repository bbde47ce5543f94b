//! Settings and samplers that only change the noise: each of them is tried on one scene, and none
//! may be left out of the list.

use scn::measure::statistics::{Moments, welch};
use scn::scene::{self, Depth, Integrator, LightCount, Roulette};

use crate::by_hand::vocabulary::{assert_complete, fields, words};
use crate::by_hand::{self, Hand, at, splits};
use crate::{APART, mapped, tracer};

/// The field, what is said of it, and how.
type Change<T> = (&'static str, &'static str, fn(&mut T));

const PATH: [Change<scene::Path>; 22] = [
    ("guide", "photons", |it| it.guide = at(scene::Guide::Photons)),
    ("mis", "off", |it| it.mis.value.0 = false),
    ("next_event", "off", |it| it.next_event.value.0 = false),
    ("lights", "2", |it| it.lights = at(Some(LightCount::Chosen(2)))),
    ("lights", "7", |it| it.lights = at(Some(LightCount::Chosen(7)))),
    ("lights", "all", |it| it.lights = at(Some(LightCount::All))),
    ("light_samples", "3", |it| it.light_samples = at(scene::Count(3))),
    ("lights", "all, 3 points", |it| {
        it.lights = at(Some(LightCount::All));
        it.light_samples = at(scene::Count(3));
    }),
    ("roulette", "mean", |it| it.roulette = at(Roulette::Mean)),
    ("roulette", "luminance", |it| it.roulette = at(Roulette::Luminance)),
    ("roulette", "throughput", |it| it.roulette = at(Roulette::Throughput)),
    ("roulette", "off", |it| {
        it.roulette = at(Roulette::Off);
        it.depth = at(Depth::Most(40));
    }),
    ("roulette_after", "0", |it| it.roulette_after = at(scene::Count(0))),
    ("roulette_after", "0, by mean", |it| {
        it.roulette_after = at(scene::Count(0));
        it.roulette = at(Roulette::Mean);
    }),
    ("roulette_after", "0, by luminance", |it| {
        it.roulette_after = at(scene::Count(0));
        it.roulette = at(Roulette::Luminance);
    }),
    ("roulette_after", "20", |it| it.roulette_after = at(scene::Count(20))),
    ("splits", "diffuse: 1, rays: 5", |it| it.splits = at(splits(0, 1, 5))),
    ("splits", "diffuse: 3, rays: 2", |it| it.splits = at(splits(0, 3, 2))),
    ("splits", "specular: 2", |it| it.splits = at(splits(2, 0, 1))),
    ("splits", "specular: 3, diffuse: 2, rays: 3", |it| it.splits = at(splits(3, 2, 3))),
    ("splits", "diffuse: 1, rays: 4, lights: 2, mis: off", |it| {
        it.splits = at(splits(0, 1, 4));
        it.lights = at(Some(LightCount::Chosen(2)));
        it.mis.value.0 = false;
    }),
    ("splits", "specular: 2, next_event: off", |it| {
        it.splits = at(splits(2, 0, 1));
        it.next_event.value.0 = false;
    }),
];

const DIRECT: [Change<scene::Direct>; 9] = [
    ("lights", "1", |it| it.lights = at(LightCount::Chosen(1))),
    ("lights", "3", |it| it.lights = at(LightCount::Chosen(3))),
    ("light_samples", "4", |it| it.light_samples = at(scene::Count(4))),
    ("roulette", "mean", |it| it.roulette = at(Roulette::Mean)),
    ("roulette", "luminance", |it| it.roulette = at(Roulette::Luminance)),
    ("roulette", "throughput", |it| it.roulette = at(Roulette::Throughput)),
    ("roulette", "off", |it| it.roulette = at(Roulette::Off)),
    ("splits", "specular: 1", |it| it.splits = at(splits(1, 0, 1))),
    ("splits", "specular: 8", |it| it.splits = at(splits(8, 0, 1))),
];

const AMBIENT: [Change<scene::Ambient>; 10] = [
    ("rays", "1", |it| it.rays = at(scene::Count(1))),
    ("rays", "9", |it| it.rays = at(scene::Count(9))),
    ("lights", "1", |it| it.lights = at(LightCount::Chosen(1))),
    ("light_samples", "4", |it| it.light_samples = at(scene::Count(4))),
    ("roulette", "mean", |it| it.roulette = at(Roulette::Mean)),
    ("roulette", "luminance", |it| it.roulette = at(Roulette::Luminance)),
    ("roulette", "throughput", |it| it.roulette = at(Roulette::Throughput)),
    ("roulette", "off", |it| it.roulette = at(Roulette::Off)),
    ("splits", "specular: 2", |it| it.splits = at(splits(2, 0, 1))),
    ("splits", "specular: 8", |it| it.splits = at(splits(8, 0, 1))),
];

/// What of each integrator makes another picture, and not another noise; and what speaks of several
/// pixels, of which tests/reuse.rs tells.
const OTHER_PICTURES: [(&str, &[&str]); 4] = [
    ("path", &["depth", "paths", "reuse"]),
    ("direct", &["shadows", "area_lights", "environment", "specular_depth", "paths"]),
    ("ambient", &["distance", "direct", "specular_depth", "paths"]),
    ("preview", &[]),
];

fn direct() -> scene::Direct {
    let Integrator::Direct(direct) = by_hand::direct() else { panic!("direct") };
    scene::Direct {
        environment: at(scene::Switch(true)),
        specular_depth: at(Depth::Most(8)),
        ..direct
    }
}

/// By no means the same picture as `direct`, but for what surrounds it.
fn ambient() -> scene::Ambient {
    let direct = direct();
    scene::Ambient {
        rays: at(scene::Count(4)),
        distance: at(None),
        direct: at(scene::Switch(true)),
        lights: direct.lights,
        light_samples: direct.light_samples,
        specular_depth: direct.specular_depth,
        splits: direct.splits,
        roulette: direct.roulette,
        paths: direct.paths,
    }
}

/// Lamp, glass, metal and diffuse surfaces under a sky, and a mixture; by so many samples for each
/// of 16 estimates.
fn seen(integrator: Integrator, samples: u64) -> Moments {
    let mut hand = still_life(integrator).samples(samples);
    hand.scene.sampler = at(sobol(samples));
    hand.estimate()
}

fn sobol(round: u64) -> scene::Sampler {
    scene::Sampler::Sobol(scene::Sobol { round: at(scene::Count(round)) })
}

fn still_life(integrator: Integrator) -> Hand {
    mapped(integrator, |p| p, 1.0).mix("worn", ["gold", "floor"], 0.4).sphere(
        glam::DVec3::new(0.1, -0.7, 0.3),
        0.3,
        "worn",
    )
}

fn assert_same(what: &str, a: &Moments, b: &Moments) {
    let (score, _, _) = welch(a, b);
    assert!(score.abs() < APART, "{what}: {score}: {a:?} {b:?}");
    // Sharp enough to tell a wrong factor.
    assert!(b.standard_error() < 0.015 * b.mean(), "{what}: {b:?}");
}

#[test]
fn no_setting_is_left_out() {
    assert_complete("integrators", OTHER_PICTURES.map(|it| it.0).to_vec(), words::<Integrator>());
    for (integrator, others) in OTHER_PICTURES {
        let tried: Vec<&str> = match integrator {
            "path" => PATH.iter().map(|it| it.0).collect(),
            "direct" => DIRECT.iter().map(|it| it.0).collect(),
            "ambient" => AMBIENT.iter().map(|it| it.0).collect(),
            _ => Vec::new(),
        };
        let both = tried.into_iter().chain(others.iter().copied()).collect();
        assert_complete(integrator, both, fields::<Integrator>(integrator));
    }
    for changes in [
        PATH.map(|it| (it.0, it.1)).to_vec(),
        DIRECT.map(|it| (it.0, it.1)).to_vec(),
        AMBIENT.map(|it| (it.0, it.1)).to_vec(),
    ] {
        let roulettes = changes.iter().filter(|it| it.0 == "roulette").map(|it| it.1).collect();
        assert_complete("kinds of roulette", roulettes, words::<Roulette>());
    }
    assert_complete("samplers", samplers().map(|it| it.0).to_vec(), words::<scene::Sampler>());
}

#[test]
fn settings_of_path_change_the_noise_alone() {
    let plain = seen(tracer(|_| ()), 8192);
    for (field, value, change) in PATH {
        assert_same(&format!("{field}: {value}"), &plain, &seen(tracer(change), 2048));
    }
}

#[test]
fn settings_of_direct_and_ambient_change_the_noise_alone() {
    let plain = seen(Integrator::Direct(direct()), 4096);
    for (field, value, change) in DIRECT {
        let mut direct = direct();
        change(&mut direct);
        let found = seen(Integrator::Direct(direct), 2048);
        assert_same(&format!("direct, {field}: {value}"), &plain, &found);
    }
    for (field, value, change) in AMBIENT {
        let mut ambient = ambient();
        change(&mut ambient);
        let found = seen(Integrator::Ambient(ambient), 2048);
        assert_same(&format!("ambient, {field}: {value}"), &plain, &found);
    }
}

/// Each with a setting of its own other than what it is usually given.
fn samplers() -> [(&'static str, scene::Sampler); 6] {
    let stratified =
        |grid| scene::Sampler::Stratified(scene::Stratified { grid: at(scene::Count(grid)) });
    [
        ("independent", scene::Sampler::Independent(scene::Independent {})),
        ("sobol", sobol(64)),
        ("sobol", sobol(1000)),
        ("stratified", stratified(1)),
        ("stratified", stratified(3)),
        ("stratified", stratified(8)),
    ]
}

#[test]
fn every_sampler_comes_to_the_same_end() {
    for integrator in [tracer(|_| ()), tracer(|it| it.splits = at(splits(1, 1, 3)))] {
        let plain = seen(integrator.clone(), 4096);
        for (_, sampler) in samplers() {
            let mut hand = still_life(integrator.clone()).samples(4096);
            hand.scene.sampler = at(sampler.clone());
            assert_same(&format!("{sampler:?}"), &plain, &hand.estimate());
        }
    }
}
