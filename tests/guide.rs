//! Paths that photons guide: less noise, the same picture.

mod by_hand;

use glam::{DVec3, dvec3};
use scn::math::Spectrum;
use scn::measure::statistics::{Moments, welch};
use scn::plan::{Feature, Need, Plan};
use scn::render::tiles::Threads;
use scn::scene::{self, Guide, Integrator};

use by_hand::{Hand, Patient, at, path, render};

fn tracer(guide: Guide) -> Integrator {
    Integrator::Path(scene::Path { guide: at(guide), ..path() })
}

/// A small lamp over a floor, in a room with this ball.
fn ball(guide: Guide, material: &str) -> Hand {
    Hand::new(tracer(guide))
        .size(24, 18)
        .material("white", 0.7, 0.0)
        .material("lamp", 0.0, 5.0)
        .glass("glass", 1.5)
        .mirror("silver", 0.9)
        .metal("gold", Spectrum::Constant(0.4), Spectrum::Constant(2.4))
        .mix("worn", ["gold", "white"], 0.4)
        .quad(dvec3(0.0, 0.0, 0.0), DVec3::Z * 2.0, DVec3::X * 2.0, "white")
        .quad(dvec3(0.0, 1.0, -2.0), DVec3::X * 2.0, DVec3::Y, "white")
        .quad(dvec3(-0.5, 2.0, 0.3), DVec3::X * 0.3, DVec3::Z * 0.3, "lamp")
        .sphere(dvec3(0.1, 0.6, 0.0), 0.5, material)
        .camera(dvec3(0.0, 1.4, 4.0), dvec3(0.0, 0.5, 0.0), 40.0)
}

/// Means of the whole picture over seeds, and the mean over seeds of the squares of pixels' errors
/// against `truth`, where light is.
fn moments(hand: Hand, samples: u64, seeds: std::ops::Range<u64>) -> (Moments, f64) {
    let prepared = hand.prepared();
    let mut means = Moments::default();
    let pictures: Vec<_> =
        seeds.map(|seed| render(&prepared, seed, samples, &Patient).picture).collect();
    for picture in &pictures {
        let sum: f64 = picture.pixels.iter().map(|pixel| f64::from(pixel.g)).sum();
        means.add(sum / picture.pixels.len() as f64);
    }
    let mut noise = 0.0;
    for pixel in 0..pictures[0].pixels.len() {
        let mut of_pixel = Moments::default();
        pictures.iter().for_each(|picture| of_pixel.add(f64::from(picture.pixels[pixel].g)));
        noise += of_pixel.variance() / (of_pixel.mean().powi(2) + 1e-4);
    }
    (means, noise / pictures[0].pixels.len() as f64)
}

#[test]
fn a_guide_changes_the_noise_and_not_the_picture() {
    for material in ["glass", "silver", "gold", "worn"] {
        let (plain, noise) = moments(ball(Guide::Off, material), 16, 0..60);
        let (guided, less) = moments(ball(Guide::Photons, material), 16, 100..160);
        let (z, ..) = welch(&plain, &guided);
        assert!(z.abs() < 4.0, "{material}: {z}, {plain:?}, {guided:?}");
        assert!(less < 0.5 * noise, "{material}: {less} against {noise}");
    }
}

/// The same ball of silver under a large lamp: so little noise that a hundredth of the light shows.
fn bright(tracer: scene::Path) -> Hand {
    ball(Guide::Off, "silver").integrator(Integrator::Path(tracer)).quad(
        dvec3(0.0, 2.5, 0.0),
        DVec3::X * 2.0,
        DVec3::Z * 2.0,
        "lamp",
    )
}

#[test]
fn whatever_else_paths_do_a_guide_loses_no_light() {
    type Change = fn(&mut scene::Path);
    let changes: [(&str, Change); 5] = [
        ("nothing", |_| ()),
        ("no lights asked", |it| it.next_event = at(scene::Switch(false))),
        ("not weighed", |it| it.mis = at(scene::Switch(false))),
        ("splits, no lights asked", |it| {
            it.splits = at(by_hand::splits(1, 1, 3));
            it.next_event = at(scene::Switch(false));
        }),
        ("early roulette", |it| it.roulette_after = at(scene::Count(0))),
    ];
    for (name, change) in changes {
        let of = |guide| {
            let mut tracer = scene::Path { guide: at(guide), ..path() };
            change(&mut tracer);
            bright(tracer)
        };
        let once = |guide| render(&of(guide).prepared(), 3, 1, &Patient).picture;
        assert_ne!(once(Guide::Photons), once(Guide::Off), "{name}: not guided");

        let (plain, _) = moments(of(Guide::Off), 64, 0..20);
        let (guided, _) = moments(of(Guide::Photons), 64, 100..120);
        let (z, ..) = welch(&plain, &guided);
        assert!(z.abs() < 4.0, "{name}: {z}, {plain:?}, {guided:?}");
        for moments in [plain, guided] {
            assert!(moments.standard_error() < 3e-3 * moments.mean(), "{name}: {moments:?}");
        }
    }
}

/// Black paint that shines lies where photons land: it may scatter, and does not.
#[test]
fn gloss_among_what_photons_tell_of_loses_nothing() {
    let of = |guide, seeds| {
        let hand = bright(scene::Path { guide: at(guide), ..path() })
            .material("black", 0.0, 0.0)
            .mix("gloss", ["silver", "black"], 0.9)
            .quad(dvec3(0.0, 0.001, 0.8), DVec3::Z * 0.5, DVec3::X, "gloss");
        moments(hand, 64, seeds).0
    };
    let (plain, guided) = (of(Guide::Off, 0..20), of(Guide::Photons, 100..120));
    let (z, ..) = welch(&plain, &guided);
    assert!(z.abs() < 4.0, "{z}, {plain:?}, {guided:?}");
}

#[test]
fn a_guide_is_the_same_for_any_number_of_threads_and_anywhere() {
    let run = |threads, hand: Hand| {
        Threads::new(threads).unwrap().run(|| render(&hand.prepared(), 3, 8, &Patient).picture)
    };
    let one = run(1, ball(Guide::Photons, "glass"));
    assert_eq!(run(3, ball(Guide::Photons, "glass")), one);
    assert_ne!(run(1, ball(Guide::Off, "glass")), one);
}

#[test]
fn where_there_is_nothing_to_guide_by_the_picture_is_the_same_to_the_bit() {
    let run = |guide| render(&ball(guide, "white").prepared(), 3, 8, &Patient).picture;
    assert_eq!(run(Guide::Photons), run(Guide::Off));
}

#[test]
fn photons_are_sent_only_where_light_may_come_by_a_mirror() {
    let need = |hand: Hand| {
        let plan = Plan::of(&hand.stage());
        plan.answers.iter().find(|answer| answer.feature == Feature::Guide).unwrap().need
    };
    assert_eq!(need(ball(Guide::Photons, "glass")), Need::Required);
    assert_eq!(need(ball(Guide::Off, "glass")), Need::Unneeded);
    assert_eq!(need(ball(Guide::Photons, "white")), Need::Unneeded);
}
