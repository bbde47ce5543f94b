//! Pairs of pictures made to differ in one way each: noise, blur, hue, place, fireflies, range.

use scn::math::{Picture, Rgb};

pub const WIDTH: usize = 96;
pub const HEIGHT: usize = 64;

pub struct Pair {
    pub name: &'static str,
    pub reference: Picture,
    pub test: Picture,
}

/// All pairs, in the order of the recorded values.
pub fn all() -> Vec<Pair> {
    let pair = |name, reference: &dyn Fn(f32, f32) -> Rgb, test: &dyn Fn(f32, f32) -> Rgb| Pair {
        name,
        reference: picture(reference),
        test: picture(test),
    };
    let ramp = |x: f32, y: f32| Rgb::new(x / 96.0, y / 64.0, 0.5 * (1.0 - x / 96.0));
    let checks = |x: f32, y: f32| {
        let dark = (x / 8.0).floor() + (y / 8.0).floor();
        if dark % 2.0 == 0.0 { Rgb::new(0.8, 0.75, 0.6) } else { Rgb::new(0.02, 0.05, 0.1) }
    };
    let stripes = |x: f32, y: f32| {
        let wave = 0.5 + 0.5 * (0.35 * x + 0.1 * y).sin();
        Rgb::new(wave, 0.4, 1.0 - wave)
    };
    let room = |x: f32, y: f32| {
        let off = (x - 70.0).hypot(y - 15.0);
        if off < 4.0 {
            Rgb::new(2e4, 1.8e4, 1.4e4)
        } else {
            Rgb::new(0.9, 0.7, 0.5) * (20.0 / (off * off))
        }
    };
    let night = |x: f32, y: f32| {
        if y < 36.0 { Rgb::BLACK } else { Rgb::new(1.0, 0.8, 1.2) * (x / 96.0 * 12.0 - 9.0).exp() }
    };
    vec![
        pair("noise", &ramp, &|x, y| ramp(x, y) + (noise(x, y, 1) + Rgb::grey(-0.5)) * 0.2),
        pair("blur", &checks, &|x, y| {
            let taps = (-2..=2).flat_map(|i| (-2..=2).map(move |j| (i as f32, j as f32)));
            taps.fold(Rgb::BLACK, |sum, (i, j)| sum + checks(x + i, y + j) * (1.0 / 25.0))
        }),
        pair("hue", &stripes, &|x, y| {
            let c = stripes(x, y);
            Rgb::new(0.8 * c.r + 0.1 * c.b, 1.15 * c.g, 0.9 * c.b)
        }),
        pair("shift", &checks, &|x, y| checks(x + 1.0, y)),
        pair("sun", &room, &|x, y| {
            let n = noise(x, y, 2);
            let firefly = if n.r > 0.995 { 500.0 * n.g } else { 0.0 };
            room(x, y) * (0.7 + 0.6 * n.b) + Rgb::grey(firefly)
        }),
        pair("night", &night, &|x, y| night(x, y) * (0.5 + noise(x, y, 3).g) + Rgb::grey(1e-5)),
        pair("exposure", &room, &|x, y| room(x, y) * 1.3),
    ]
}

fn picture(pixel: &dyn Fn(f32, f32) -> Rgb) -> Picture {
    let places = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x as f32, y as f32)));
    let pixels = places.map(|(x, y)| pixel(x, y)).collect();
    Picture { width: WIDTH, height: HEIGHT, pixels }
}

/// Uniform in [0, 1) for each pixel and component.
fn noise(x: f32, y: f32, seed: u32) -> Rgb {
    let place = (y as u32 * WIDTH as u32 + x as u32) * 3 + seed * 1_000_000;
    let [r, g, b] = [0, 1, 2].map(|i| (hash(place + i) >> 8) as f32 / 16_777_216.0);
    Rgb::new(r, g, b)
}

/// PCG's output over one step, kept here so that the pairs stay what their values were taken of.
fn hash(input: u32) -> u32 {
    let state = input.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}
