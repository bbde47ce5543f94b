//! Samples are followed together, many at a time: each comes out as it would alone, to the bit.

mod by_hand;

use glam::{DVec3, dvec3};
use scn::math::{Rgb, Spectrum};
use scn::prepare::Settings;
use scn::run::Watch;
use scn::scene::{self, Integrator, LightCount};

use by_hand::{Hand, Patient, Ticking, at, path, render, splits};

/// Columns and rows: with all samples more than are on their way at once.
const SIZE: [u64; 2] = [11, 7];

/// Samples of a pixel: some begin where others of it end.
const SAMPLES: u64 = 5;

fn tracer(change: impl Fn(&mut scene::Path)) -> Integrator {
    let mut tracer = path();
    tracer.roulette_after = at(scene::Count(1));
    change(&mut tracer);
    Integrator::Path(tracer)
}

/// A room without a front, seen from there.
fn room(integrator: Integrator) -> Hand {
    Hand::new(integrator)
        .size(SIZE[0], SIZE[1])
        .material("white", 0.8, 0.0)
        .material("lamp", 0.3, 9.0)
        .quad(dvec3(0.0, -1.0, 0.0), DVec3::Z, DVec3::X, "white")
        .quad(dvec3(0.0, 1.0, 0.0), DVec3::X, DVec3::Z, "white")
        .quad(dvec3(-1.0, 0.0, 0.0), DVec3::Y, DVec3::Z, "white")
        .quad(dvec3(1.0, 0.0, 0.0), DVec3::Z, DVec3::Y, "white")
        .quad(dvec3(0.0, 0.0, -1.0), DVec3::X, DVec3::Y, "white")
        .quad(dvec3(0.2, -0.7, -0.1), DVec3::Z * 0.3, dvec3(0.3, 0.1, 0.0), "white")
        .camera(dvec3(0.0, 0.0, 3.5), DVec3::ZERO, 40.0)
}

/// With one lamp: the only light, and a rectangle.
fn one_lamp(integrator: Integrator) -> Hand {
    room(integrator).quad(dvec3(0.0, 0.98, 0.0), DVec3::X * 0.4, DVec3::Z * 0.4, "lamp")
}

/// With lights of many kinds.
fn many_lights(integrator: Integrator) -> Hand {
    one_lamp(integrator)
        .material("glow", 0.5, 3.0)
        .disk(dvec3(-0.98, 0.3, 0.0), DVec3::X, 0.3, "glow")
        .sphere(dvec3(-0.4, -0.6, 0.3), 0.3, "glow")
        .point(dvec3(0.7, 0.4, 0.6), 0.5)
        .spot(dvec3(0.0, 0.5, 2.0), dvec3(0.5, -1.0, 0.0), 4.0, [30.0, 20.0])
        .directional(dvec3(0.3, -0.2, -1.0), 1.0)
        .background(0.25)
}

/// With surfaces of all kinds, some of which send several rays on.
fn all_surfaces(integrator: Integrator) -> Hand {
    one_lamp(integrator)
        .glass("glass", 1.5)
        .mirror("silver", 0.9)
        .metal("gold", Spectrum::Constant(0.4), Spectrum::Constant(2.4))
        .mix("worn", ["gold", "white"], 0.4)
        .sphere(dvec3(-0.5, -0.6, 0.2), 0.35, "glass")
        .sphere(dvec3(0.5, 0.1, 0.2), 0.35, "silver")
        .sphere(dvec3(-0.3, 0.4, -0.4), 0.35, "worn")
        .background(0.25)
}

fn sobol(mut hand: Hand, round: u64) -> Hand {
    let sampler = scene::Sobol { round: at(scene::Count(round)) };
    hand.scene.sampler = at(scene::Sampler::Sobol(sampler));
    hand
}

/// Each with what it is to show.
fn scenes() -> Vec<(&'static str, Hand)> {
    let plain = || tracer(|_| ());
    let all = tracer(|it| {
        it.lights = at(Some(LightCount::All));
        it.light_samples = at(scene::Count(2));
    });
    let several = tracer(|it| it.splits = at(splits(2, 1, 3)));
    let by_chance = tracer(|it| it.next_event = at(scene::Switch(false)));
    let third = at(scene::Number(1.0 / 3.0));
    let mitchell = scene::Mitchell { radius: at(scene::Number(2.0)), b: third.clone(), c: third };
    vec![
        ("one lamp, asked together", sobol(one_lamp(plain()), 64)),
        ("independent numbers", one_lamp(plain())),
        ("one of many lights", sobol(many_lights(plain()), 64)),
        ("more questions than are answered at once", sobol(many_lights(all), 64)),
        ("branches that wait", sobol(all_surfaces(several), 64)),
        ("light found by chance", sobol(all_surfaces(by_chance), 64)),
        ("direct light", sobol(many_lights(by_hand::direct()), 64)),
        (
            "a filter that weighs",
            sobol(all_surfaces(plain()), 8).filter(scene::Filter::Mitchell(mitchell)),
        ),
    ]
}

/// What a pixel is, and the rays it took, if nothing else is rendered.
fn alone(hand: &Hand, [x, y]: [u64; 2], watch: &dyn Watch) -> (Rgb, [u64; 2]) {
    let mut hand = hand.clone();
    hand.settings = Settings { crop: Some([x, y, x + 1, y + 1]), ..Settings::default() };
    let outcome = render(&hand.prepared(), 3, SAMPLES, watch);
    (outcome.picture.pixels[0], [outcome.rays, outcome.shadow_rays])
}

#[test]
fn a_sample_comes_out_the_same_in_any_wave() {
    for (what, hand) in scenes() {
        let whole = render(&hand.prepared(), 3, SAMPLES, &Patient);
        let mut asked = [0, 0];
        for (x, y) in (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y))) {
            let pixel = whole.picture.at(x as usize, y as usize);
            let (of_wave, rays) = alone(&hand, [x, y], &Patient);
            assert_eq!(of_wave, pixel, "{what}: ({x}, {y}), all samples in one wave");
            // So slow a clock that each pass takes one sample.
            let (of_one, _) = alone(&hand, [x, y], &Ticking::new(1e6, u64::MAX));
            assert_eq!(of_one, pixel, "{what}: ({x}, {y}), each sample by itself");
            (0..2).for_each(|i| asked[i] += rays[i]);
        }
        assert_eq!(asked, [whole.rays, whole.shadow_rays], "{what}");
        let lit = whole.picture.pixels.iter().filter(|pixel| pixel.g > 0.0).count();
        assert!(lit > whole.picture.pixels.len() / 2, "{what}: {lit}");
    }
}

/// Sixty-four paths of a hundred surfaces are asked about while they are under way, not after it.
#[test]
fn samples_are_given_up_together() {
    let long = tracer(|it| {
        it.roulette = at(scene::Roulette::Off);
        it.depth = at(scene::Depth::Most(100));
    });
    let hand = Hand::new(long)
        .size(8, 8)
        .material("wall", 0.9, 1.0)
        .sphere(DVec3::ZERO, 1.0, "wall")
        .camera(DVec3::ZERO, DVec3::X, 40.0);
    let prepared = hand.prepared();
    // Patience for the question before the only tile, and for all of them.
    for (patience, samples) in [(1, 0), (1_000, 1)] {
        let outcome = render(&prepared, 3, 1, &Ticking::new(1.0, patience));
        assert_eq!(outcome.samples, samples, "{patience} questions");
    }
}
