//! Pixels that share light: less noise, the same picture.

mod by_hand;
#[path = "shots/mod.rs"]
mod shots;

use std::path::Path;

use glam::{DVec3, dvec3};
use scn::math::paths::Expression;
use scn::math::{Picture, Spectrum};
use scn::measure::statistics::{Moments, agrees, welch};
use scn::plan::{Feature, Need, Plan};
use scn::prepare::Prepared;
use scn::render::film;
use scn::render::tiles::Threads;
use scn::scene::{self, Depth, Integrator, Layer, Named, Only, Paths, PathsLayer};

use by_hand::{Hand, Patient, Ticking, at, difference, path, render, splits};

fn tracer(reuse: u64, change: fn(&mut scene::Path)) -> Integrator {
    let mut tracer = scene::Path { reuse: at(scene::Count(reuse)), ..path() };
    change(&mut tracer);
    Integrator::Path(tracer)
}

/// A room with a lamp in it, and a ball on its floor.
fn room(integrator: Integrator, ball: &str) -> Hand {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    Hand::new(integrator)
        .size(40, 20)
        .material("white", 0.8, 0.0)
        .material("grey", 0.4, 0.0)
        .material("black", 0.0, 0.0)
        .material("lamp", 0.0, 20.0)
        .material("shining", 0.5, 2.0)
        .glass("glass", 1.5)
        .mirror("silver", 0.9)
        .metal("gold", Spectrum::Constant(0.4), Spectrum::Constant(2.4))
        .mix("worn", ["gold", "white"], 0.4)
        .quad(dvec3(0.0, -1.0, 0.0), z, x * 2.0, "white")
        .quad(dvec3(0.0, 1.0, 0.0), x * 2.0, z, "white")
        .quad(dvec3(0.0, 0.0, -1.0), x * 2.0, y, "white")
        .quad(dvec3(-2.0, 0.0, 0.0), y, z, "grey")
        .quad(dvec3(2.0, 0.0, 0.0), z, y, "shining")
        .quad(dvec3(0.3, 0.99, 0.0), x * 0.3, z * 0.3, "lamp")
        .sphere(dvec3(-0.6, -0.5, -0.2), 0.5, ball)
        .camera(dvec3(0.0, 0.0, 4.0), DVec3::ZERO, 30.0)
}

/// Parts of a picture, by columns and rows: light that is given to the wrong one would show, though the
/// whole were right.
const PARTS: [usize; 2] = [4, 2];

fn means(picture: &Picture) -> Vec<f64> {
    let [columns, rows] = PARTS;
    let mut sums = vec![0.0; columns * rows];
    for (nth, pixel) in picture.pixels.iter().enumerate() {
        let (x, y) = (nth % picture.width, nth / picture.width);
        let part = y * rows / picture.height * columns + x * columns / picture.width;
        sums[part] += f64::from(pixel.r + 2.0 * pixel.g + pixel.b);
    }
    let pixels = picture.pixels.len() / sums.len();
    sums.iter().map(|sum| sum / pixels as f64).collect()
}

/// The means of parts of pictures of these seeds, and the relative variance of their pixels.
fn moments(prepared: &Prepared, samples: u64, seeds: std::ops::Range<u64>) -> (Vec<Moments>, f64) {
    let mut all = vec![Moments::default(); PARTS[0] * PARTS[1]];
    let of = |seed| render(prepared, seed, samples, &Patient).picture;
    let pictures: Vec<Picture> = seeds.map(of).collect();
    for picture in &pictures {
        all.iter_mut().zip(means(picture)).for_each(|(moments, mean)| moments.add(mean));
    }
    let pixels = pictures[0].pixels.len();
    let noise = (0..pixels).map(|pixel| {
        let of = pictures.iter().map(|picture| f64::from(picture.pixels[pixel].g));
        let of: Moments = of.collect();
        of.variance() / (of.mean().powi(2) + 1e-4)
    });
    (all, noise.sum::<f64>() / pixels as f64)
}

/// The most standard errors that one of many parts may be off by.
const APART: f64 = 4.5;

/// Tells how many times as much noise there is if no light is shared.
fn assert_same(what: &str, plain: &Prepared, shared: &Prepared, samples: u64) -> f64 {
    let (plain, noise) = moments(plain, samples, 0..30);
    let (shared, less) = moments(shared, samples, 100..130);
    for (nth, (a, b)) in plain.iter().zip(&shared).enumerate() {
        let (z, ..) = welch(a, b);
        assert!(z.abs() < APART, "{what}, part {nth}: {z}, {a:?}, {b:?}");
        assert!(b.standard_error() < 0.02 * b.mean(), "{what}, part {nth}: {b:?}");
    }
    noise / less
}

#[test]
fn light_that_is_shared_changes_the_noise_and_not_the_picture() {
    for (ball, gain) in [("white", 2.5), ("glass", 1.2), ("worn", 1.5)] {
        let of = |reuse| room(tracer(reuse, |_| ()), ball).prepared();
        let found = assert_same(ball, &of(1), &of(16), 16);
        assert!(found > gain, "{ball}: {found}");
    }
}

#[test]
fn whatever_else_paths_do_they_share_light_and_lose_none() {
    type Change = fn(&mut scene::Path);
    let changes: [(&str, Change); 9] = [
        ("no lights asked", |it| it.next_event = at(scene::Switch(false))),
        ("not weighed", |it| it.mis = at(scene::Switch(false))),
        ("two lights asked", |it| it.light_samples = at(scene::Count(2))),
        ("early roulette", |it| it.roulette_after = at(scene::Count(0))),
        ("no roulette", |it| {
            it.roulette = at(scene::Roulette::Off);
            it.depth = at(Depth::Most(5));
        }),
        ("scattered thrice", |it| it.depth = at(Depth::Most(3))),
        ("both ways of mirrors", |it| it.splits = at(splits(2, 0, 1))),
        ("two ways from what scatters", |it| it.splits = at(splits(0, 1, 2))),
        ("guided", |it| it.guide = at(scene::Guide::Photons)),
    ];
    for ((what, change), ball) in
        changes.into_iter().zip(["worn", "silver", "glass"].into_iter().cycle())
    {
        let of = |reuse| room(tracer(reuse, change), ball).prepared();
        let (plain, shared) = (of(1), of(9));
        let once = |prepared| render(prepared, 3, 1, &Patient).picture;
        assert_ne!(once(&plain), once(&shared), "{what}: nothing is shared");
        assert_same(&format!("{what}, {ball}"), &plain, &shared, 16);
    }
}

#[test]
fn in_a_room_without_corners_in_the_dark_light_is_what_it_must_be() {
    // All of it shines 1 and gives back a half: 2 everywhere.
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let hand = Hand::new(tracer(16, |it| it.next_event = at(scene::Switch(false))))
        .size(16, 16)
        .material("wall", 0.5, 1.0)
        .quad(dvec3(0.0, -1.0, 0.0), z, x, "wall")
        .quad(dvec3(0.0, 1.0, 0.0), x, z, "wall")
        .quad(dvec3(0.0, 0.0, -1.0), x, y, "wall")
        .quad(dvec3(0.0, 0.0, 1.0), y, x, "wall")
        .quad(dvec3(-1.0, 0.0, 0.0), y, z, "wall")
        .quad(dvec3(1.0, 0.0, 0.0), z, y, "wall")
        .camera(dvec3(0.2, 0.1, 0.9), dvec3(-0.3, -0.2, -1.0), 100.0)
        .prepared();
    let mut moments = Moments::default();
    for seed in 0..30 {
        let picture = render(&hand, seed, 64, &Patient).picture;
        let sum: f64 = picture.pixels.iter().map(|pixel| f64::from(pixel.g)).sum();
        moments.add(sum / picture.pixels.len() as f64);
    }
    let verdict = agrees(moments.mean(), moments.standard_error(), 2.0, 2e-3);
    assert!(verdict.holds(), "{verdict:?}");
}

#[test]
fn layers_share_as_the_picture_does() {
    let paths =
        |text: &str| Paths { text: text.to_string(), expression: Expression::parse(text).unwrap() };
    let shown = |reuse, text: &str| {
        let mut hand = room(tracer(reuse, |_| ()), "silver");
        let Integrator::Path(path) = &mut hand.scene.integrator.value else { panic!("path") };
        path.paths = at(Some(paths(text)));
        hand.prepared()
    };
    for text in ["L D D E", "L D D S E | L D D D E"] {
        assert_same(text, &shown(1, text), &shown(12, text), 16);
    }
    // The picture is the sum of its layers, sample by sample.
    let mut hand = room(tracer(12, |_| ()), "silver");
    for (name, only) in [("twice", Only::Paths(paths("L D D E"))), ("others", Only::Others)] {
        let layer = Layer::PathsLayer(PathsLayer { only: at(only) });
        hand.scene.layers.push(Named { name: at(name.to_string()), value: at(layer) });
    }
    let prepared = hand.prepared();
    let outcome = render(&prepared, 1, 4, &Patient);
    let world = &prepared.world;
    let layers = film::layers(&world.film.window, &outcome.taken, world.light_unit);
    let mut sum = layers[0].clone();
    for (sum, other) in sum.pixels.iter_mut().zip(&layers[1].pixels) {
        *sum += *other;
    }
    assert!(difference(&sum, &outcome.picture) < 1e-4);
    assert!(layers.iter().all(|layer| layer.pixels.iter().any(|pixel| pixel.g > 0.1)));
}

#[test]
fn where_bodies_overlap_no_light_is_lost() {
    // Between floor and wall, all in glass, a part of the water's surface that is not there.
    let text = |reuse: u64| {
        format!(
            "scn 1 in m
            film: {{ size: (40, 20), filter: box {{}} }}
            sampler: independent
            stop: {{ samples: 4 }}
            integrator: path {{ reuse: {reuse}, next_event: off }}
            camera: perspective {{ eye: (0, 0.5, 1.8), look_at: (0, 0, 0), fov_y: 60 deg }}
            light sky: constant {{ radiance: 1 W/m^2/sr }}
            medium crown: homogeneous {{ ior: 1.5 }}
            medium water: homogeneous {{ ior: 1.33 }}
            material chalk: diffuse {{ albedo: 0.8 }}
            object block: sphere {{ center: (0, 0, 0), radius: 2 m, material: dielectric {{ inside: crown }} }}
            object drop: sphere {{ center: (1.8, 0, 0), radius: 1.3 m, material: dielectric {{ inside: water }}, yields_to: block }}
            object floor: disk {{ center: (0, -0.5, 0), normal: y, radius: 1.4 m, material: chalk }}
            object wall: disk {{ center: (0, 0.2, -0.9), normal: z, radius: 1 m, material: chalk }}\n"
        )
    };
    let of = |reuse| {
        let shots = shots::open_text(Path::new("it.scn"), &text(reuse), &[]);
        shots.unwrap_or_else(|report| panic!("{report}"))[0].prepare(1.0)
    };
    let (plain, shared) = (of(1), of(16));
    assert!(shared.world.overlaps.is_some());
    assert_same("overlaps", &plain, &shared, 32);
}

#[test]
fn what_is_shared_is_the_same_for_any_threads_passes_and_parts_of_the_film() {
    let hand = || room(tracer(16, |_| ()), "glass").size(70, 40);
    let prepared = hand().prepared();
    let whole = render(&prepared, 3, 70, &Patient).picture;
    for threads in [1, 3] {
        let run = || render(&prepared, 3, 70, &Patient).picture;
        assert_eq!(Threads::new(threads).unwrap().run(run), whole, "{threads} threads");
    }
    for step in [0.01, 0.3, 1e6] {
        let watch = Ticking::new(step, u64::MAX);
        assert_eq!(render(&prepared, 3, 70, &watch).picture, whole, "{step}");
    }
    let mut part = hand();
    part.settings.crop = Some([21, 9, 66, 35]);
    let part = render(&part.prepared(), 3, 70, &Patient).picture;
    for (nth, pixel) in part.pixels.iter().enumerate() {
        let (x, y) = (21 + nth % part.width, 9 + nth / part.width);
        assert_eq!(*pixel, whole.pixels[y * whole.width + x], "{x}, {y}");
    }
}

#[test]
fn a_plan_tells_whether_there_is_light_to_share() {
    let need = |hand: Hand| {
        let plan = Plan::of(&hand.stage());
        let answer = plan.answers.iter().find(|answer| answer.feature == Feature::Reuse);
        answer.unwrap().need
    };
    let alone = |material: &str| {
        let hand = Hand::new(tracer(16, |_| ())).background(1.0).material("white", 0.8, 0.0);
        hand.mirror("silver", 0.9).mix("worn", ["silver", "white"], 0.1).disk(
            DVec3::ZERO,
            DVec3::Z,
            1.0,
            material,
        )
    };
    let two = |material| alone(material).sphere(DVec3::Z, 0.5, material);
    assert_eq!(need(room(tracer(16, |_| ()), "glass")), Need::Required);
    assert_eq!(need(two("white")), Need::Required);
    let once: fn(&mut scene::Path) = |it| it.depth = at(Depth::Most(1));
    let nothing = [
        room(tracer(1, |_| ()), "glass"),
        room(tracer(16, once), "glass"),
        alone("white"),
        two("worn"),
    ];
    for (nth, hand) in nothing.into_iter().enumerate() {
        assert_eq!(need(hand), Need::Unneeded, "{nth}");
    }
    // What is left out changes no bit.
    let of = |reuse| {
        let hand = two("worn").integrator(tracer(reuse, |_| ())).size(8, 8);
        render(&hand.prepared(), 3, 8, &Patient).picture
    };
    assert_eq!(of(16), of(1));
}
