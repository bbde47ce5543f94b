//! What must not change a picture by a bit: threads, passes, crops, powers of two. And what may
//! change it by noise alone: where the scene stands.

mod by_hand;

use std::sync::Mutex;

use glam::{DVec3, dvec3};
use scn::math::{Picture, Rgb};
use scn::measure::statistics::{Moments, welch};
use scn::prepare::Settings;
use scn::render::tiles::Threads;
use scn::run::{Stopped, Watch};
use scn::scene::{self, Step};

use by_hand::{Hand, Patient, Ticking, at, bumpy_ball, difference, direct, render, still_life};

/// Samples of a block of the still life.
const BLOCK: u64 = 64;

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let prepared = still_life().prepared();
    let run = |threads| Threads::new(threads).unwrap().run(|| render(&prepared, 3, 20, &Patient));
    let one = run(1);
    assert!(one.picture.pixels.iter().any(|pixel| pixel.g > 0.1));
    for threads in [2, 7] {
        let other = run(threads);
        assert_eq!(one.picture, other.picture);
        assert_eq!((one.rays, one.shadow_rays), (other.rays, other.shadow_rays));
    }
    assert_ne!(one.picture, render(&prepared, 4, 20, &Patient).picture, "the seed matters");
}

#[test]
fn any_cut_into_passes_gives_the_same_bits() {
    // Past two blocks and into a third. Clocks that run at other speeds make other passes.
    let prepared = still_life().size(20, 12).prepared();
    let samples = 2 * BLOCK + 22;
    let long = render(&prepared, 1, samples, &Patient).picture;
    for step in [0.01, 0.1, 0.3, 1e6] {
        let watch = Ticking::new(step, u64::MAX);
        assert_eq!(render(&prepared, 1, samples, &watch).picture, long, "{step}");
    }
}

#[test]
fn passes_end_with_their_blocks() {
    // One pixel is one tile, and tells its progress once a pass.
    struct Told(Mutex<Vec<u64>>);
    impl Watch for Told {
        fn cancelled(&self) -> bool {
            false
        }
        fn now(&self) -> f64 {
            0.0
        }
        fn progress(&self, done: u64, total: u64) {
            assert_eq!(total, 4 * BLOCK - 5);
            self.0.lock().unwrap().push(done);
        }
    }
    let told = Told(Mutex::default());
    render(&still_life().size(1, 1).prepared(), 0, 4 * BLOCK - 5, &told);
    let told = told.0.into_inner().unwrap();
    assert_eq!(told[..2], [1, 5], "short passes first");
    assert!((1..4).all(|n| told.contains(&(n * BLOCK))), "{told:?}");
    assert_eq!(*told.last().unwrap(), 4 * BLOCK - 5);
}

#[test]
fn a_cancelled_render_is_the_render_of_the_samples_it_has() {
    let prepared = still_life().prepared();
    let tiles = 9;
    let mut seen = Vec::new();
    // One question before the first pass is not asked; then one for each tile.
    for patience in [0, 4, tiles, tiles + 3, 3 * tiles, 40 * tiles, 1_000_000] {
        let watch = Ticking::new(0.2, patience);
        let outcome = render(&prepared, 1, 70, &watch);
        let last = watch.last.into_inner();
        match outcome.stopped {
            Stopped::Interrupted { tiles: Some(finished) } => {
                // Some tiles have one sample, the others are black.
                assert_eq!(outcome.samples, 0);
                assert_eq!((finished.done as u64, finished.of as u64), (patience, tiles));
                assert_eq!(outcome.rays, last);
                let whole = render(&prepared, 1, 1, &Patient).picture;
                let kept = |(a, b): (&Rgb, &Rgb)| a == b || *a == Rgb::BLACK;
                assert!(outcome.picture.pixels.iter().zip(&whole.pixels).all(kept));
            }
            other => {
                assert_eq!(other == Stopped::Samples, outcome.samples == 70);
                let whole = render(&prepared, 1, outcome.samples, &Patient);
                assert_eq!(outcome.picture, whole.picture);
                assert_eq!(outcome.rays, whole.rays);
            }
        }
        seen.push(outcome.samples);
    }
    assert_eq!((seen[1], seen[2], seen[6]), (0, 1, 70));
    assert!(seen[5] > 1 && seen[5] < 70, "{seen:?}");
}

#[test]
fn a_crop_is_the_part_of_the_whole() {
    let mut hand = still_life();
    let whole = hand.picture();
    hand.settings = Settings { crop: Some([7, 5, 41, 39]), ..Settings::default() };
    let part = hand.picture();
    assert_eq!((part.width, part.height), (34, 34));
    for y in 0..34 {
        for x in 0..34 {
            assert_eq!(part.at(x, y), whole.at(x + 7, y + 5));
        }
    }
}

/// The same scene with all lengths times `k`, by the numbers themselves.
fn scaled(k: f64) -> Hand {
    Hand::new(direct())
        .size(32, 24)
        .samples(9)
        .material("white", 0.8, 0.0)
        .material("shining", 0.5, 7.0)
        .mesh(bumpy_ball(10), k, 0.7)
        .sphere(k * dvec3(1.5, -0.3, 0.8), k * 0.7, "white")
        .plane(k * dvec3(0.0, -1.0, 0.0), DVec3::Y, "white")
        .quad(k * dvec3(0.5, 3.0, 0.0), DVec3::X * k * 0.5, DVec3::Z * k * 0.5, "shining")
        .disk(k * dvec3(-2.0, 1.0, 0.0), DVec3::X, k * 0.4, "shining")
        .directional(dvec3(-1.0, -1.0, -0.5), 2.0)
        .camera(k * dvec3(1.0, 2.0, 6.0), DVec3::ZERO, 45.0)
}

#[test]
fn scenes_scaled_by_powers_of_two_give_the_same_bits() {
    let one = scaled(1.0).picture();
    for exponent in [-100, -20, -1, 20, 100] {
        assert_eq!(scaled(2.0_f64.powi(exponent)).picture(), one, "2^{exponent}");
    }
}

#[test]
fn other_scales_differ_by_rounding_alone() {
    let one = scaled(1.0).picture();
    for k in [1e-9, 1e-6, 0.3, 1e6, 1e7] {
        let other = scaled(k).picture();
        // Rounding moves an edge over a sample now and then.
        let apart = |(a, b): &(&Rgb, &Rgb)| (a.g - b.g).abs() > 1e-4 * a.g.max(1.0);
        let moved = one.pixels.iter().zip(&other.pixels).filter(apart).count();
        assert!(moved <= one.pixels.len() / 100, "{k}: {moved}");
    }
}

/// The still life, moved as a whole; its camera and its objects alike.
fn moved(by: DVec3) -> Hand {
    let mut hand = still_life().samples(4);
    for object in &mut hand.scene.objects {
        let place = match &mut object.value.value {
            scene::Object::Disk(it) => &mut it.place,
            scene::Object::Mesh(it) => &mut it.place,
            scene::Object::Quad(it) => &mut it.place,
            scene::Object::Sphere(it) => &mut it.place,
            _ => continue,
        };
        *place = at(scene::Place(vec![Step::Move(by)]));
    }
    hand.camera(dvec3(1.0, 2.0, 6.0) + by, by, 45.0)
}

#[test]
fn scenes_moved_far_away_differ_by_noise_alone() {
    let mean = |picture: &Picture| {
        picture.pixels.iter().map(|p| f64::from(p.g)).sum::<f64>() / picture.pixels.len() as f64
    };
    let sample = |by: DVec3, seeds: std::ops::Range<u64>| {
        let prepared = moved(by).prepared();
        let mut moments = Moments::default();
        seeds.for_each(|seed| moments.add(mean(&render(&prepared, seed, 4, &Patient).picture)));
        moments
    };
    let here = sample(DVec3::ZERO, 0..16);
    for far in [dvec3(1e5, -1e5, 1e5), dvec3(-1e7, 0.0, 0.0)] {
        let there = sample(far, 16..32);
        let (z, ..) = welch(&here, &there);
        assert!(z.abs() < 4.0, "{far}: {z}");
        // The same seed shows the same, but for edges.
        let (a, b) = (moved(DVec3::ZERO).picture(), moved(far).picture());
        let apart = |(a, b): &(&Rgb, &Rgb)| (a.g - b.g).abs() > 1e-4;
        let differing = a.pixels.iter().zip(&b.pixels).filter(apart).count();
        assert!(differing <= a.pixels.len() / 100, "{far}: {differing}");
    }
}

#[test]
fn emission_scales_the_picture_exactly() {
    let lit = |k: f64| {
        Hand::new(direct())
            .size(8, 8)
            .samples(4)
            .material("grey", 0.5, 0.0)
            .material("lamp", 0.3, k)
            .sphere(DVec3::ZERO, 1.0, "grey")
            .quad(dvec3(0.0, 3.0, 0.0), DVec3::X, DVec3::Z, "lamp")
            .directional(dvec3(0.0, -1.0, -1.0), k)
            .background(k)
            .camera(dvec3(0.0, 0.0, 5.0), DVec3::ZERO, 40.0)
            .picture()
    };
    let one = lit(1.0);
    for exponent in [-99, 99] {
        let factor = 2.0_f32.powi(exponent);
        let expected: Vec<_> = one.pixels.iter().map(|pixel| *pixel * factor).collect();
        assert_eq!(lit(f64::from(factor)).pixels, expected, "2^{exponent}");
    }
    for factor in [1e-30, 1e30] {
        let other = lit(factor);
        for (a, b) in one.pixels.iter().zip(&other.pixels) {
            let error = f64::from(b.g) - factor * f64::from(a.g);
            assert!(
                error.abs() <= 1e-6 * factor * f64::from(a.g.max(0.1)),
                "{factor}: {a:?} {b:?}"
            );
        }
    }
}

#[test]
fn difference_finds_differences() {
    let (a, mut b) = (Picture::black(2, 1), Picture::black(2, 1));
    assert_eq!(difference(&a, &b), 0.0);
    b.pixels[1].b = -0.5;
    assert_eq!(difference(&a, &b), 0.5);
}
