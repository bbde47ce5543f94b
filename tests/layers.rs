//! Pictures by paths: layers are what their expressions say, add up to the picture, and change
//! nothing of it; traced paths are what a pixel is made of.

mod by_hand;

use std::sync::Mutex;

use glam::DVec3;
use scn::math::Rgb;
use scn::math::paths::Expression;
use scn::measure::statistics::{Moments, welch};
use scn::prepare::Prepared;
use scn::render::film::{self, Taken};
use scn::render::integrators::Traced;
use scn::render::tiles::Threads;
use scn::run::{self, Begin, Watch};
use scn::scene::{self, Integrator, Layer, Named, Only, Paths, PathsLayer, Sides};

use by_hand::{Hand, Patient, Ticking, at, direct, path, render};

fn paths(text: &str) -> Paths {
    Paths { text: text.to_string(), expression: Expression::parse(text).unwrap() }
}

fn layered(mut hand: Hand, layers: &[&str]) -> Hand {
    for (number, text) in layers.iter().enumerate() {
        let only = match *text {
            "others" => Only::Others,
            text => Only::Paths(paths(text)),
        };
        let layer = Layer::PathsLayer(PathsLayer { only: at(only) });
        let name = at(format!("layer{number}"));
        hand.scene.layers.push(Named { name, value: at(layer) });
    }
    hand
}

fn showing(mut hand: Hand, text: &str) -> Hand {
    let shown = at(Some(paths(text)));
    match &mut hand.scene.integrator.value {
        Integrator::Ambient(it) => it.paths = shown,
        Integrator::Direct(it) => it.paths = shown,
        Integrator::Path(it) => it.paths = shown,
        Integrator::Preview(_) => panic!("follows no light"),
    }
    hand
}

fn tracer() -> Integrator {
    Integrator::Path(path())
}

/// Glass, metal and a lamp in the open.
fn still_life(integrator: Integrator) -> Hand {
    Hand::new(integrator)
        .material("floor", 0.7, 0.0)
        .material("lamp", 0.2, 12.0)
        .glass("glass", 1.5)
        .mirror("silver", 0.9)
        .quad(DVec3::ZERO, DVec3::X * 3.0, DVec3::Y * 3.0, "floor")
        .sphere(DVec3::new(-0.8, 0.0, 0.5), 0.5, "silver")
        .sphere(DVec3::new(0.8, 0.0, 0.5), 0.5, "glass")
        .quad(DVec3::new(0.0, 0.0, 2.5), DVec3::Y * 0.8, DVec3::X * 0.8, "lamp")
        .background(0.3)
        .camera(DVec3::new(0.0, -3.0, 1.2), DVec3::new(0.0, 0.0, 0.4), 50.0)
        .size(24, 18)
}

/// Seen, lit, caustics, mirrored; and the rest.
const LAYERS: [&str; 5] = ["L E", "L D E", "L S+ D E", "L .* S E", "others"];

fn layers(prepared: &Prepared, taken: &Taken) -> Vec<scn::math::Picture> {
    film::layers(&prepared.world.film.window, taken, prepared.world.light_unit)
}

#[test]
fn layers_add_up_to_the_picture_and_change_no_bit_of_it() {
    for integrator in [tracer(), direct()] {
        let plain = still_life(integrator.clone()).prepared();
        let prepared = layered(still_life(integrator), &LAYERS).prepared();
        let outcome = render(&prepared, 3, 20, &Patient);
        assert_eq!(outcome.picture, render(&plain, 3, 20, &Patient).picture);
        let layers = layers(&prepared, &outcome.taken);
        assert_eq!(layers.len(), LAYERS.len());
        for (i, pixel) in outcome.picture.pixels.iter().enumerate() {
            let sum = layers.iter().fold(Rgb::BLACK, |sum, layer| sum + layer.pixels[i]);
            let apart = (*pixel - sum).to_array().map(f32::abs);
            assert!(apart.iter().all(|x| *x <= 1e-5 * (1.0 + pixel.g)), "{pixel:?} {sum:?}");
        }
        // No layer but that of caustics is black, and that only where they are not followed.
        for (layer, text) in layers.iter().zip(LAYERS) {
            let black = layer.pixels.iter().all(|pixel| pixel.is_black());
            let followed =
                matches!(prepared.integrator, scn::render::integrators::Integrator::Path(_));
            assert_eq!(black, !followed && (text == "L S+ D E" || text == "others"), "{text}");
        }
    }
}

#[test]
fn layers_have_the_same_bits_whatever_the_threads_passes_slices_and_breaks() {
    /// Keeps what was taken after the second pass.
    struct Second(Ticking, Mutex<(u32, Option<(Taken, f64)>)>);
    impl Watch for Second {
        fn cancelled(&self) -> bool {
            false
        }
        fn now(&self) -> f64 {
            self.0.now()
        }
        fn progress(&self, _done: u64, _total: u64) {}
        fn passed(&self, taken: &Taken, seconds: f64) {
            let (count, kept) = &mut *self.1.lock().unwrap();
            *count += 1;
            if *count == 2 {
                *kept = Some((taken.clone(), seconds));
            }
        }
    }
    let prepared = layered(still_life(tracer()), &LAYERS).prepared();
    let Prepared { world, integrator, .. } = &prepared;
    let samples = 2 * 64 + 22;
    let whole = render(&prepared, 1, samples, &Patient).taken;
    let expected = layers(&prepared, &whole);
    let two = Threads::new(2).unwrap().run(|| render(&prepared, 1, samples, &Patient));
    assert_eq!(layers(&prepared, &two.taken), expected);

    let watch = Second(Ticking::new(0.3, u64::MAX), Mutex::new((0, None)));
    assert_eq!(layers(&prepared, &render(&prepared, 1, samples, &watch).taken), expected);
    let (taken, seconds) = watch.1.into_inner().unwrap().1.expect("several passes");
    assert!(taken.fits(&world.film.window, LAYERS.len(), world.sampler.rhythm()));
    let settings = run::Settings::samples(1, samples);
    let resumed = run::render(world, integrator, &settings, Begin { taken, seconds }, &Patient);
    assert_eq!(layers(&prepared, &resumed.taken), expected);

    let slice = |first: u64, end: u64| {
        let settings = run::Settings::samples(1, end);
        run::render(world, integrator, &settings, Begin::at(world, first), &Patient).taken
    };
    let joined = slice(0, 64).join(slice(64, 128)).unwrap().join(slice(128, samples)).unwrap();
    assert_eq!(layers(&prepared, &joined), expected);
}

#[test]
fn each_order_of_scattering_has_its_part_of_an_enclosure() {
    // All around the same radiance: what was scattered n times is albedoⁿ of what is emitted.
    let albedo = 0.6;
    let hand = Hand::new(tracer()).material("wall", albedo, 1.0).sphere(DVec3::ZERO, 1.0, "wall");
    let mut hand = hand.camera(DVec3::new(0.3, 0.1, 0.2), DVec3::X, 40.0).samples(4096);
    if let scene::Material::Diffuse(wall) = &mut hand.scene.materials[0].value.value {
        wall.emits = at(Sides::Both);
    }
    let texts = ["L E", "L D E", "L D D E", "L D D D+ E"];
    let truths = [1.0, albedo, albedo.powi(2), albedo.powi(3) / (1.0 - albedo)];
    let prepared = layered(hand, &texts).prepared();
    let mut moments = texts.map(|_| Moments::default());
    for seed in 0..16 {
        let taken = render(&prepared, seed, 4096, &Patient).taken;
        for (moments, layer) in moments.iter_mut().zip(layers(&prepared, &taken)) {
            moments.add(f64::from(layer.pixels[0].g));
        }
    }
    for ((moments, truth), text) in moments.iter().zip(truths).zip(texts) {
        let error = moments.standard_error();
        assert!((moments.mean() - truth).abs() <= 4.0 * error + 1e-6, "{text}: {moments:?}");
        assert!(error < 0.01 * truth, "{text}: {error}");
    }
}

#[test]
fn a_picture_of_some_paths_is_what_their_layer_is() {
    let green = |picture: &scn::math::Picture| {
        picture.pixels.iter().map(|pixel| f64::from(pixel.g)).sum::<f64>()
    };
    let both = |text: &str| {
        let layered = layered(still_life(tracer()), &[text]).prepared();
        let alone = showing(still_life(tracer()), text).prepared();
        let (mut a, mut b) = (Moments::default(), Moments::default());
        let (mut rays, mut fewer) = (0, 0);
        for seed in 0..16 {
            let outcome = render(&layered, seed, 64, &Patient);
            a.add(green(&layers(&layered, &outcome.taken)[0]));
            rays += outcome.shadow_rays;
            let outcome = render(&alone, 100 + seed, 64, &Patient);
            b.add(green(&outcome.picture));
            fewer += outcome.shadow_rays;
        }
        let (score, _, _) = welch(&a, &b);
        assert!(score.abs() < 4.0 && a.mean() > 0.0, "{text}: {score} {a:?} {b:?}");
        assert!(fewer < rays, "{text}: what cannot be shown is not followed");
    };
    for text in ["L D E", "L S+ D E", "L D S .* E", "L .* D_r S_r E"] {
        both(text);
    }
}

#[test]
fn traced_paths_add_up_to_the_pixel() {
    for integrator in [tracer(), direct(), ambient(), split()] {
        let prepared = still_life(integrator).prepared();
        let Prepared { world, integrator, .. } = &prepared;
        let samples = 40;
        let picture = render(&prepared, 5, samples, &Patient).picture;
        let mut longest = 0;
        for (x, y) in [(4, 9), (18, 9), (12, 16), (12, 0), (20, 12)] {
            let mut sum = [0.0; 3];
            for sample in 0..samples {
                integrator.trace(world, 5, [x, y], sample, |weight, traced: Traced| {
                    longest = longest.max(traced.surfaces.len());
                    for (sum, value) in sum.iter_mut().zip(traced.radiance.to_array()) {
                        *sum += weight * f64::from(value) * world.light_unit / samples as f64;
                    }
                });
            }
            let pixel = picture.at(x as usize, y as usize).to_array().map(f64::from);
            assert!(pixel[1] > 0.0);
            for (sum, pixel) in sum.iter().zip(pixel) {
                assert!((sum / pixel - 1.0).abs() < 1e-5, "({x}, {y}): {sum} {pixel}");
            }
        }
        assert!(longest >= 2);
    }
}

#[test]
fn each_traced_path_ends_at_its_own_light() {
    let lights = at(Some(scene::LightCount::All));
    let prepared = Hand::new(Integrator::Path(scene::Path { lights, ..path() }))
        .material("floor", 0.7, 0.0)
        .quad(DVec3::ZERO, DVec3::X * 3.0, DVec3::Y * 3.0, "floor")
        .sphere(DVec3::new(0.0, 2.0, 0.5), 0.5, "floor")
        .point(DVec3::new(-1.0, 0.0, 2.0), 1.0)
        .point(DVec3::new(1.0, 0.5, 1.0), 1.0)
        .camera(DVec3::new(0.0, -3.0, 1.2), DVec3::ZERO, 20.0)
        .prepared();
    let mut sources = Vec::new();
    let visit = |_, traced: Traced| sources.push(traced.source);
    prepared.integrator.trace(&prepared.world, 5, [0, 0], 0, visit);
    assert_eq!(sources.len(), 2);
    assert_ne!(sources[0], sources[1]);
}

fn ambient() -> Integrator {
    Integrator::Ambient(scene::Ambient {
        rays: at(scene::Count(4)),
        distance: at(None),
        direct: at(scene::Switch(true)),
        lights: at(scene::LightCount::All),
        light_samples: at(scene::Count(2)),
        specular_depth: at(scene::Depth::Most(10)),
        splits: at(by_hand::splits(1, 0, 1)),
        roulette: at(scene::Roulette::Mean),
        paths: at(None),
    })
}

fn split() -> Integrator {
    Integrator::Path(scene::Path { splits: at(by_hand::splits(2, 1, 3)), ..path() })
}
