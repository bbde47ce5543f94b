//! Ways to write one light as several, lights of any size and strength, and thousands of them:
//! what is chosen, and in which order, changes the noise alone.

mod by_hand;
mod shots;

use std::f64::consts::PI;

use glam::{DVec3, dvec3};
use scn::math::{Mesh, Rgb};
use scn::measure::statistics::{Moments, agrees, welch};
use scn::scene::{self, Integrator, LightCount};

use by_hand::{Hand, at, difference, direct, path};

/// So many standard errors apart, two expectations differ; fixed seeds make it no gamble.
const APART: f64 = 4.0;

fn asked(lights: LightCount, light_samples: u64) -> Integrator {
    let Integrator::Direct(it) = direct() else { panic!("direct") };
    let light_samples = at(scene::Count(light_samples));
    Integrator::Direct(scene::Direct { lights: at(lights), light_samples, ..it })
}

fn assert_same(name: &str, a: &Moments, b: &Moments) {
    let (score, _, _) = welch(a, b);
    assert!(score.abs() < APART, "{name}: {score}: {a:?} {b:?}");
    assert!(b.standard_error() < 0.02 * b.mean(), "{name}: {b:?}");
}

fn floor(integrator: Integrator) -> Hand {
    Hand::new(integrator)
        .material("floor", 0.6, 0.0)
        .quad(DVec3::ZERO, DVec3::X * 2.0, DVec3::Y * 2.0, "floor")
        .camera(dvec3(0.0, -3.0, 3.0), DVec3::ZERO, 30.0)
}

/// Seen from below the lamps, which are in no picture themselves.
fn below(hand: Hand) -> Hand {
    hand.camera(dvec3(0.0, -1.5, 0.25), DVec3::ZERO, 5.0)
}

#[test]
fn a_light_may_be_written_as_two() {
    let lit = |lights: &[f64]| {
        let hand = floor(asked(LightCount::All, 1)).sphere(DVec3::Z * 0.5, 0.3, "floor");
        let add = |hand: Hand, part: &f64| hand.point(dvec3(1.0, 0.3, 2.0), 4.0 * part);
        lights.iter().fold(hand, add).size(16, 16).picture()
    };
    let whole = lit(&[1.0]);
    assert!(whole.pixels.iter().any(|pixel| pixel.g > 0.1));
    for parts in [&[0.5, 0.5][..], &[0.25, 0.75], &[0.75, 0.25], &[0.125; 8]] {
        assert!(difference(&whole, &lit(parts)) < 1e-6, "{parts:?}");
    }
}

/// A square lamp, as a mesh of n × n squares.
fn square(n: u32) -> Mesh {
    let mut mesh = Mesh { material_names: vec!["lamp".into()], ..Mesh::default() };
    for i in 0..=n {
        for j in 0..=n {
            let at = |i: u32| f64::from(i) / f64::from(n) - 0.5;
            mesh.positions.push(dvec3(at(i), at(j), 1.0));
        }
    }
    for i in 0..n {
        for j in 0..n {
            let [a, b] = [i * (n + 1) + j, (i + 1) * (n + 1) + j];
            // It faces down.
            mesh.triangles.extend([[a, a + 1, b + 1], [a, b + 1, b]]);
        }
    }
    mesh.slots = vec![0; mesh.triangles.len()];
    mesh
}

#[test]
fn a_lamp_may_be_a_mesh_of_any_number_of_triangles() {
    let lit = |n: u32, integrator: Integrator| {
        let mut hand = floor(integrator).mesh(square(n), 1.0, 0.0);
        let mesh = hand.meshes.last_mut().unwrap().as_mut().unwrap();
        let scene::Material::Diffuse(diffuse) = &mut mesh.materials[0].value.value else {
            panic!("diffuse")
        };
        diffuse.emission = at(scene::Radiance(scn::math::Spectrum::Constant(3.0)));
        below(hand).samples(256).estimate()
    };
    let plain = lit(1, direct());
    assert!(plain.mean() > 0.1);
    for n in [2, 7, 20] {
        assert_same(&format!("{n} by direct"), &plain, &lit(n, direct()));
        assert_same(&format!("{n} by path"), &plain, &lit(n, Integrator::Path(path())));
    }
}

/// Two thousand points, spots and small lamps over a floor, with a sun and a sky.
fn many(integrator: Integrator) -> Hand {
    let mut hand = below(floor(integrator)).material("lamp", 0.0, 40.0).background(0.02);
    hand = hand.directional(dvec3(1.0, 0.5, -1.0), 0.2);
    for i in 0..2000_u32 {
        // Spread evenly over a square, at several heights.
        let part = |step: f64| (step * f64::from(i)).fract();
        let (x, y) = (part(0.754_877_666), part(0.569_840_291));
        let place = dvec3(4.0 * x - 2.0, 4.0 * y - 2.0, 0.3 + part(0.381_966));
        hand = match i % 20 {
            0 => hand.sphere(place, 0.01, "lamp"),
            1 => hand.disk(place, DVec3::NEG_Z, 0.01, "lamp"),
            2 => hand.quad(place, DVec3::Y * 0.01, DVec3::X * 0.01, "lamp"),
            n if n < 10 => hand.spot(place, place - DVec3::Z, 0.01, [40.0, 10.0]),
            _ => hand.point(place, 0.005 * part(0.618_034).powi(4)),
        };
    }
    hand
}

#[test]
fn which_lights_are_asked_changes_the_noise_alone() {
    let all = many(asked(LightCount::All, 1)).samples(8).estimate();
    for (lights, light_samples, samples) in [(1, 1, 1024), (8, 1, 128), (2, 3, 256)] {
        let integrator = asked(LightCount::Chosen(lights), light_samples);
        let found = many(integrator).samples(samples).estimate();
        assert_same(&format!("{lights} lights, {light_samples} points"), &all, &found);
    }
    let twice = many(asked(LightCount::All, 2)).samples(4).estimate();
    assert_same("all, 2 points", &all, &twice);
}

/// Direct light, with that of a sky.
fn with_sky() -> Integrator {
    let Integrator::Direct(it) = direct() else { panic!("direct") };
    Integrator::Direct(scene::Direct { environment: at(scene::Switch(true)), ..it })
}

#[test]
fn light_of_the_sky_is_the_same_by_each_integrator() {
    let lit = |integrator| {
        floor(integrator)
            .material("lamp", 0.0, 5.0)
            .sphere(DVec3::Z * 0.5, 0.5, "floor")
            .sphere(dvec3(1.0, 0.0, 1.5), 0.2, "lamp")
            .background(0.7)
            .size(4, 4)
            .samples(256)
            .estimate()
    };
    let plain = lit(with_sky());
    let ambient = scene::Ambient {
        rays: at(scene::Count(4)),
        distance: at(None),
        direct: at(scene::Switch(true)),
        lights: at(LightCount::All),
        light_samples: at(scene::Count(1)),
        specular_depth: at(scene::Depth::Most(10)),
        splits: at(by_hand::splits(0, 0, 1)),
        roulette: at(scene::Roulette::Throughput),
        paths: at(None),
    };
    assert_same("ambient", &plain, &lit(Integrator::Ambient(ambient)));
    let depth = at(scene::Depth::Most(1));
    assert_same("path", &plain, &lit(Integrator::Path(scene::Path { depth, ..path() })));
}

/// A lamp, a point and a spot over a floor, so many times as large and as bright.
fn lit(size: f64, bright: f64) -> Vec<Rgb> {
    let scaled = |p: DVec3| p * size;
    let mut picture = Hand::new(Integrator::Path(path()))
        .material("floor", 0.6, 0.0)
        .material("lamp", 0.3, 3.0 * bright)
        .quad(DVec3::ZERO, scaled(DVec3::X * 2.0), scaled(DVec3::Y * 2.0), "floor")
        .quad(scaled(dvec3(0.0, 0.5, 1.0)), scaled(DVec3::Y * 0.3), scaled(DVec3::X * 0.2), "lamp")
        .sphere(scaled(dvec3(-1.0, 0.0, 0.5)), 0.25 * size, "lamp")
        .point(scaled(dvec3(1.0, 0.3, 2.0)), 2.0 * bright * size * size)
        .spot(scaled(dvec3(-1.0, 0.3, 2.0)), DVec3::ZERO, bright * size * size, [30.0, 5.0])
        .camera(scaled(dvec3(0.0, -3.0, 3.0)), DVec3::ZERO, 40.0)
        .size(12, 12)
        .samples(4)
        .picture();
    picture.pixels.iter_mut().for_each(|pixel| *pixel = *pixel / bright as f32);
    picture.pixels
}

#[test]
fn powers_of_two_of_size_and_brightness_change_no_bit() {
    let plain = lit(1.0, 1.0);
    assert!(plain.iter().any(|pixel| pixel.g > 0.2));
    for power in [1, -20, 20] {
        let factor = 2.0_f64.powi(power);
        assert_eq!(lit(factor, 1.0), plain, "size 2^{power}");
        assert_eq!(lit(1.0, factor), plain, "brightness 2^{power}");
    }
    for bright in [1e-30, 1e-10, 1e30] {
        for (a, b) in lit(1.0, bright).iter().zip(&plain) {
            assert!((a.g - b.g).abs() <= 1e-4 * (b.g + 0.01), "{bright}: {} {}", a.g, b.g);
        }
    }
}

/// Disks of 1e-12 to 1e12 m², and squares and balls of about as much: right above a floor, as far
/// away as they are large, and much farther.
#[test]
fn lamps_of_any_area_give_their_light() {
    let z = DVec3::Z;
    let chosen = asked(LightCount::Chosen(1), 1);
    for integrator in [direct(), chosen, Integrator::Path(path())] {
        for (radius, h) in
            [(5.6e-7_f64, 1.0_f64), (5.6e-7, 5.6e-7), (1.0, 1.0), (5.6e5, 5.6e5), (5.6e5, 1e7)]
        {
            let size = radius.max(h);
            let hand = || {
                let round = at(scene::Count(1024));
                let mut hand = Hand::new(integrator.clone())
                    .material("floor", 1.0, 0.0)
                    .material("lamp", 0.0, 1.0)
                    .disk(DVec3::ZERO, z, 1e-3 * size, "floor")
                    .camera(z * 1e-2 * size, DVec3::ZERO, 0.01)
                    .samples(1024);
                hand.scene.sampler = at(scene::Sampler::Sobol(scene::Sobol { round }));
                hand
            };
            let (r, far) = (radius * radius, h * h);
            // Of a square of side 2 r: 4/π · a/√(a² + 1) · atan(a/√(a² + 1)), a = r/h.
            let a = radius / h / (r / far + 1.0).sqrt();
            for (name, hand, truth) in [
                ("disk", hand().samples(8192).disk(z * h, -z, radius, "lamp"), r / (r + far)),
                (
                    "square",
                    hand().quad(z * h, DVec3::Y * radius, DVec3::X * radius, "lamp"),
                    4.0 / PI * a * a.atan(),
                ),
                ("ball", hand().sphere(z * 2.0 * h, radius, "lamp"), r / (4.0 * far)),
            ] {
                let found = hand.estimate();
                let what = format!("{name} of {radius} m, {h} m away");
                let verdict = agrees(found.mean(), found.standard_error(), truth, 0.003 * truth);
                assert!(verdict.holds(), "{what}: {verdict}");
            }
        }
    }
}

/// Lights and surfaces, each in a line of its own; their order in the text means nothing.
#[test]
fn the_order_of_a_text_changes_no_bit() {
    let lines = [
        "light sun: directional { direction: (1, -0.5, -2), irradiance: 1 W/m^2 }",
        "light bulb: point { position: (0.4, -0.5, 1), intensity: 0.3 W/sr }",
        "light sky: constant { radiance: 0.2 W/m^2/sr }",
        "light lantern: spot { position: (-1, 0.3, 2), direction: (1, 0, -2), intensity: 2 W/sr, cone: 30 deg }",
        "material floor: diffuse { albedo: 0.6 }",
        "material shiny: mix { first: floor, second: gold, amount: 0.4 }",
        "material gold: conductor { ior: metal.gold }",
        "material lamp: diffuse { albedo: 0.1, emission: 4 W/m^2/sr }",
        "object ball: sphere { center: (0, 0.4, 0.4), radius: 0.4 m, material: shiny }",
        "object card: quad { corner: (-2, -2, 0), u: (4, 0, 0), v: (0, 4, 0), material: floor }",
        "object dim: disk { center: (1, 0, 1), normal: -z, radius: 0.2 m, material: lamp }",
        "object small: triangle { a: (-1, 0, 1), b: (-1, 0.5, 1), c: (-0.5, 0, 1.3), material: lamp }",
        "camera: perspective { eye: (0, -3, 2), look_at: (0, 0, 0.2), up: z, fov_y: 40 deg }",
        "film: { size: (12, 12) }",
        "integrator: path { lights: 2 }",
        "stop: { samples: 16 }",
    ];
    let picture = |order: &[usize]| {
        let text: Vec<_> = order.iter().map(|line| lines[*line]).collect();
        let text = format!("scn 1 in m\n{}\n", text.join("\n"));
        let shots = shots::open_text(std::path::Path::new("it.scn"), &text, &[]);
        let shot = shots.unwrap_or_else(|report| panic!("{report}")).remove(0);
        shot.picture(&shot.prepare(1.0), 0)
    };
    let plain: Vec<usize> = (0..lines.len()).collect();
    let first = picture(&plain);
    assert!(first.pixels.iter().any(|pixel| pixel.g > 0.1));
    for turn in [3, 7, 11] {
        let order: Vec<_> = plain.iter().map(|line| (line * turn + turn) % lines.len()).collect();
        assert_eq!(picture(&order).pixels, first.pixels, "{order:?}");
    }
    let back: Vec<_> = plain.iter().rev().copied().collect();
    assert_eq!(picture(&back).pixels, first.pixels);
}

/// The same lights by other names, and so in another order; and the triangles of a mesh in another.
#[test]
fn the_order_of_lights_and_triangles_changes_the_noise_alone() {
    let mut hand = many(asked(LightCount::Chosen(2), 1)).samples(512);
    let plain = hand.estimate();
    hand.scene.lights.reverse();
    assert_same("lights", &plain, &hand.estimate());
    let stride = 7;
    let count = hand.scene.lights.len();
    let turned = (0..count).map(|i| hand.scene.lights[i * stride % count].clone()).collect();
    hand.scene.lights = turned;
    assert_same("lights by sevens", &plain, &hand.estimate());
    hand.scene.objects.reverse();
    hand.meshes.reverse();
    assert_same("objects", &plain, &hand.estimate());

    let show = |turn: usize| {
        let mut mesh = by_hand::bumpy_ball(12);
        mesh.triangles.rotate_left(turn);
        mesh.normal_indices.rotate_left(turn);
        let hand = floor(Integrator::Path(path())).mesh(mesh, 0.5, 0.7).background(0.4);
        hand.directional(dvec3(1.0, 0.5, -1.0), 2.0).size(16, 16).samples(16).picture()
    };
    // Of no lamp the triangles are chosen: what is met is the same, wherever it stands.
    assert!(difference(&show(0), &show(101)) < 1e-6);
}
