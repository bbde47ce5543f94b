//! The far ends: films, fields of view, distances, sizes, and what is refused there.

mod by_hand;

use std::f64::consts::PI;

use glam::{DVec3, dvec3};
use scn::measure::statistics::{Moments, agrees};
use scn::prepare::{self, Settings};
use scn::scene::{self, Step};

use by_hand::{Hand, Patient, at, bumpy_ball, direct, integrator, pixel_box, render, still_life};

fn filters() -> [scene::Filter; 4] {
    let number = |x: f64| at(scene::Number(x));
    [
        pixel_box(),
        scene::Filter::Tent(scene::Tent { radius: number(1.0) }),
        scene::Filter::Gaussian(scene::Gaussian { radius: number(1.5), deviation: number(0.5) }),
        scene::Filter::Mitchell(scene::Mitchell {
            radius: number(2.0),
            b: number(1.0 / 3.0),
            c: number(1.0 / 3.0),
        }),
    ]
}

#[test]
fn all_filters_agree_on_an_even_picture() {
    for filter in filters() {
        let signed = matches!(filter, scene::Filter::Mitchell(_));
        let hand = Hand::new(direct())
            .background(0.7)
            .camera(DVec3::Z, DVec3::ZERO, 40.0)
            .size(32, 32)
            .samples(64)
            .filter(filter);
        let mut moments = Moments::default();
        for pixel in hand.picture().pixels {
            assert!(signed || pixel.r == 0.7, "{pixel:?}");
            moments.add(f64::from(pixel.r));
        }
        let error = if signed { moments.standard_error() } else { 0.0 };
        let verdict = agrees(moments.mean(), error, f64::from(0.7_f32), 0.02 * 0.7);
        assert!(verdict.holds(), "{verdict:?}");
    }
}

#[test]
fn an_edge_is_filtered_as_the_filter_says() {
    // A lamp whose left edge runs through the middle of pixel 8: seen square on, at distance 1,
    // pixels are 1/16 wide. Of pixel 7, the filter's tail beyond one pixel is lit.
    let tails = [0.0, 0.0, 0.020_1, -0.017_49];
    for (filter, tail) in filters().into_iter().zip(tails) {
        let hand = Hand::new(direct())
            .material("lamp", 0.0, 1.0)
            .quad(dvec3(1.0 + 1.0 / 32.0, 0.0, 0.0), DVec3::X, DVec3::Y * 2.0, "lamp")
            .camera(DVec3::Z, DVec3::ZERO, 2.0 * 0.5_f64.atan().to_degrees())
            .size(16, 16)
            .samples(4096)
            .grid(64)
            .filter(filter);
        let picture = hand.picture();
        let row = |x: usize| {
            (0..16).fold(Moments::default(), |mut moments, y| {
                moments.add(f64::from(picture.at(x, y).g));
                moments
            })
        };
        let found = row(8);
        let verdict = agrees(found.mean(), found.standard_error(), 0.5, 0.01);
        assert!(verdict.holds(), "{verdict:?}");
        let found = row(7);
        let verdict = agrees(found.mean(), found.standard_error(), tail, 0.008);
        assert!(verdict.holds(), "{verdict:?}");
    }
}

#[test]
fn long_and_tiny_films_are_rendered() {
    for size in [[1, 1], [1, 65_535], [65_535, 1], [65_536, 65_536]] {
        let mut hand = still_life().size(size[0], size[1]).samples(1);
        let [x, y] = size.map(|n| n - 1);
        hand.settings.crop = Some([x, y, x + 1, y + 1]);
        assert!(hand.picture().pixels[0].is_finite());
    }
    let whole = still_life().size(1, 65_535).samples(1).picture();
    assert_eq!(whole.pixels.len(), 65_535);
    assert!(whole.pixels.iter().all(|pixel| pixel.is_finite()));
}

#[test]
fn the_narrowest_and_the_widest_view_are_right() {
    // Straight on, every pixel of a lit wall has the same radiance however wide the view.
    for fov in [1e-3, 1.0, 90.0, 179.9] {
        let hand = Hand::new(direct())
            .material("grey", 0.5, 0.0)
            .plane(DVec3::ZERO, DVec3::Z, "grey")
            .directional(DVec3::NEG_Z, 2.0)
            .camera(DVec3::Z, DVec3::ZERO, fov)
            .size(8, 8);
        for pixel in hand.picture().pixels {
            assert!((f64::from(pixel.g) * PI - 1.0).abs() < 1e-5, "{fov}: {pixel:?}");
        }
    }
}

#[test]
fn a_telescope_sees_what_a_close_camera_sees() {
    // The same picture from ever farther away, through an ever narrower view.
    let see = |distance: f64, floor: bool| {
        let fov = 2.0 * (1.5 / distance).atan().to_degrees();
        let hand = Hand::new(direct())
            .size(24, 24)
            .samples(4)
            .mesh(bumpy_ball(12), 1.0, 0.7)
            .directional(dvec3(-1.0, -1.0, -1.0), 3.0)
            .material("white", 0.9, 0.0)
            .camera(dvec3(0.0, 0.3, 1.0).normalize() * distance, DVec3::ZERO, fov);
        let hand = if floor { hand.plane(dvec3(0.0, -1.2, 0.0), DVec3::Y, "white") } else { hand };
        hand.picture()
    };
    for floor in [false, true] {
        let near = see(1e4, floor);
        for distance in [1e5, 1e7, 1e9] {
            let far = see(distance, floor);
            let apart = |(a, b): &(&scn::math::Rgb, &scn::math::Rgb)| (a.g - b.g).abs() > 0.01;
            let differing = near.pixels.iter().zip(&far.pixels).filter(apart).count();
            assert!(differing <= 18, "{distance}: {differing} of {}", near.pixels.len());
        }
    }
}

#[test]
fn a_camera_on_or_inside_a_surface_sees_something_finite() {
    for eye in [dvec3(0.0, 1.0, 0.0), dvec3(0.0, 0.5, 0.0), dvec3(0.0, 1.0 + 1e-12, 0.0)] {
        let hand = Hand::new(direct())
            .material("grey", 0.5, 0.1)
            .sphere(DVec3::ZERO, 1.0, "grey")
            .quad(dvec3(0.0, 1.0, 0.0), DVec3::Z, DVec3::X, "grey")
            .camera(eye, dvec3(1.0, 1.0, 0.3), 100.0)
            .size(16, 16)
            .samples(4);
        let picture = hand.picture();
        assert!(picture.pixels.iter().all(|pixel| pixel.is_finite() && pixel.g >= 0.0));
    }
}

#[test]
fn lamps_of_any_size_light_alike() {
    // The lamp fills the same solid angle from each distance: areas 1e-12 to 1e12.
    for size in [1e-6, 1.0, 1e6] {
        let hand = Hand::new(direct())
            .material("grey", 0.5, 0.0)
            .material("lamp", 0.0, 1.0)
            .quad(DVec3::ZERO, DVec3::X * 0.01 * size, DVec3::Y * 0.01 * size, "grey")
            .quad(DVec3::Z * size, DVec3::Y * 0.5 * size, DVec3::X * 0.5 * size, "lamp")
            .camera(dvec3(0.0, 0.03, 0.1) * size, DVec3::ZERO, 1e-3)
            .grid(64)
            .samples(4096);
        let found = hand.estimate();
        let truth = 0.752275 * 0.5 / PI;
        let verdict = agrees(found.mean(), found.standard_error(), truth, 3e-3 * truth);
        assert!(verdict.holds(), "{size}: {verdict:?}");
    }
}

#[test]
fn light_may_be_beyond_single_precision_on_its_way() {
    // So close to so bright a lamp the irradiance is 4e40; the picture of a black floor is not.
    for factor in [1e-36, 1e36] {
        let hand = Hand::new(integrator(true, scene::AreaLights::Center))
            .material("black", 1e-6, 0.0)
            .material("lamp", 0.0, factor)
            .quad(DVec3::ZERO, DVec3::X, DVec3::Y, "black")
            .quad(DVec3::Z * 0.005, DVec3::Y * 0.5, DVec3::X * 0.5, "lamp")
            .camera(dvec3(0.0, 0.001, 0.002), DVec3::ZERO, 1e-3);
        let found = f64::from(hand.picture().pixels[0].g) / factor;
        let expected = 1e-6 / PI / 0.005_f64.powi(2);
        assert!((found / expected - 1.0).abs() < 1e-5, "{found} for {expected}");
    }
}

#[test]
fn a_white_furnace_from_a_million_samples_keeps_its_digits() {
    let hand = Hand::new(direct()).background(0.1).camera(DVec3::Z, DVec3::ZERO, 40.0);
    let prepared = hand.prepared();
    let outcome = render(&prepared, 0, 1_000_001, &Patient);
    assert_eq!(outcome.samples, 1_000_001);
    assert_eq!(outcome.picture.pixels[0].g, 0.1);
}

#[test]
fn what_can_not_be_rendered_is_refused() {
    let ball = || Hand::new(direct()).material("m", 0.5, 0.0).directional(DVec3::NEG_Y, 1.0);
    let start = || ball().sphere(DVec3::ZERO, 1.0, "m");
    let lamp = || start().material("lamp", 0.0, 1.0);
    let center = || integrator(true, scene::AreaLights::Center);
    let with_up = |mut hand: Hand, up: DVec3| {
        let scene::Camera::Perspective(camera) = &mut hand.scene.camera.value else { panic!() };
        camera.up = at(scene::Direction(up));
        hand
    };
    let (o, x, y, z) = (DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z);
    let rows: Vec<(Hand, &[&str])> = vec![
        (start(), &[]),
        (start().camera(z, z, 40.0), &["scene/camera-looks-nowhere"]),
        (start().camera(z * 5.0, o, 40.0), &[]),
        (with_up(start().camera(z * 5.0, o, 40.0), -z), &["scene/camera-looks-along-up"]),
        (with_up(start().camera(z * 5.0, o, 40.0), dvec3(1e-6, 0.0, 1.0)), &[]),
        (start().camera(z * 1e30, o, 40.0), &["scene/camera-too-far"]),
        (start().camera(z * 1e300, -z * 1e300, 40.0), &["scene/camera-too-far"]),
        (start().camera(z * 1.5e308, -z * 1.5e308, 40.0), &["scene/camera-too-far"]),
        (start().camera(z * 1e6, o, 40.0), &[]),
        (ball(), &["scene/nothing-to-see"]),
        (ball().camera(z, o, 40.0), &[]),
        (ball().plane(o, y, "m"), &["scene/nothing-to-see"]),
        (start().placed(Step::Scale(dvec3(1.0, 0.0, 1.0))), &["scene/beyond-numbers"]),
        (start().placed(Step::Scale(dvec3(1.0, 2.0, 1.0))), &["scene/uneven-scale"]),
        (start().placed(Step::Scale(dvec3(-2.0, 2.0, 2.0))), &[]),
        (start().placed(Step::Rotate(dvec3(0.6, 0.0, 0.8), 0.7)), &[]),
        (start().placed(Step::Scale(DVec3::splat(1e50))), &["scene/beyond-numbers"]),
        (start().placed(Step::Scale(DVec3::splat(1e200))), &["scene/beyond-numbers"]),
        (start().placed(Step::Move(x * 1e50)), &["scene/beyond-numbers"]),
        (start().quad(o, x, y, "m").placed(Step::Scale(dvec3(3.0, 2.0, 1.0))), &[]),
        (start().quad(o, x, x * 2.0, "m"), &["scene/no-area"]),
        (start().quad(o, x, o, "m"), &["scene/no-area"]),
        (start().triangle([o, x, x * 3.0], "m"), &["scene/no-area"]),
        (start().triangle([o, x * 1e-3, y * 1e-3], "m"), &[]),
        (start().triangle([o, x * 1e-30, y * 1e-30], "m"), &["scene/lost-triangles"]),
        (start().sphere(x * 0.9, 1e-9, "m"), &["scene/too-small"]),
        (start().sphere(x * 0.9, 1e-5, "m"), &[]),
        (lamp().plane(-y, y, "lamp"), &["scene/endless-lamp"]),
        (lamp().sphere(y * 3.0, 0.1, "lamp"), &[]),
        (lamp().sphere(y * 3.0, 0.1, "lamp").integrator(center()), &["scene/closed-lamp"]),
        (lamp().disk(y * 3.0, -y, 0.1, "lamp").integrator(center()), &[]),
        (lamp().mesh(bumpy_ball(8), 1.0, 0.5), &[]),
        (start().directional(y, 1e38), &["scene/too-bright"]),
        (start().background(1e300), &["scene/too-bright"]),
        (start().plane(-y * 1e39, y, "m"), &["scene/beyond-numbers"]),
        (start().plane(-y * 1e12, y, "m"), &[]),
        (start().size(65_536, 65_536), &["scene/too-much-memory"]),
        (start().size(8192, 8192), &[]),
        (
            Hand::new(direct()).material("m", 0.5, 0.0).sphere(o, 1.0, "m"),
            &["scene/nothing-shines"],
        ),
    ];
    for (row, (hand, expected)) in rows.into_iter().enumerate() {
        assert_eq!(hand.codes(), expected, "row {row}");
        // Whatever is no error can be rendered.
        let found = hand.diagnostics();
        if found.iter().all(|fault| fault.level == scn::diag::Level::Warning) {
            let mut hand = hand;
            hand.settings.crop = Some([0, 0, 1, 1]);
            assert!(hand.picture().pixels[0].is_finite(), "row {row}");
        }
    }
}

#[test]
fn planes_may_be_far_away() {
    let hand = Hand::new(direct())
        .material("grey", 0.5, 0.0)
        .sphere(DVec3::ZERO, 1.0, "grey")
        .plane(DVec3::Z * -1e15, DVec3::Z, "grey")
        .directional(DVec3::NEG_Z, 1.0)
        .camera(dvec3(3.0, 0.0, 10.0), dvec3(3.0, 0.0, 0.0), 1.0);
    let found = f64::from(hand.picture().pixels[0].g) * PI / 0.5;
    assert!((found - 1.0).abs() < 1e-5, "{found}");
}

#[test]
fn settings_that_do_not_suit_the_film_are_told_in_a_sentence() {
    let stage = still_life().size(512, 256).stage();
    let unfit = |scale: f64, crop: Option<[u64; 4]>| {
        let settings = Settings { scale, crop, ..Settings::default() };
        let told = settings.unfit(&stage).map(|unfit| unfit.to_string());
        let (prepared, found) = prepare::prepare(&stage, &settings, &scn::math::NoProgress);
        assert_eq!(prepared.is_none(), told.is_some());
        assert!(found.is_empty());
        told.unwrap_or_default()
    };
    assert_eq!(unfit(1.0, None), "");
    assert_eq!(unfit(0.5, Some([0, 0, 256, 128])), "");
    assert_eq!(unfit(0.0, None), "a film cannot be scaled by 0");
    assert_eq!(unfit(f64::NAN, None), "a film cannot be scaled by NaN");
    assert_eq!(unfit(0.001, None), "scaled by 0.001, a film of 512 × 256 has no pixel");
    assert_eq!(unfit(1e300, None), "scaled by 1e300, a film of 512 × 256 has too many pixels");
    let beyond = "the crop 0,0,512,257 reaches beyond the film of 512 × 256";
    assert_eq!(unfit(1.0, Some([0, 0, 512, 257])), beyond);
    let empty = "the crop 9,0,9,5 has no pixel; the film is 512 × 256";
    assert_eq!(unfit(1.0, Some([9, 0, 9, 5])), empty);
}
