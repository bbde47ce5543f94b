//! Skies: samples against densities, and what is seen.

use super::*;
use crate::math::chi_squared;

const SAMPLES: u64 = 200_000;

/// East to the left, north away, and up: as a viewer has it who looks along −z with y up and
/// the sun behind.
fn turned() -> Mat3 {
    Mat3::from_cols(Vec3::new(0.6, 0.8, 0.0), Vec3::Z, Vec3::new(0.8, -0.6, 0.0)).transpose()
}

/// A sky with a bright side, a horizon, a dark patch, and colours.
fn sky(side: usize, ground: Rgb) -> Sky {
    let radiance = |w: Vec3| {
        let bright = (8.0 * (w.dot(Vec3::new(0.6, 0.0, 0.8)) - 1.0)).exp();
        let patch = if w.x < -0.2 && w.y > 0.1 { 0.0 } else { 1.0 };
        Rgb { r: 3.0 * bright, g: 0.2 * patch, b: 1.0 - w.z }
    };
    Sky::new(turned(), side, radiance, ground)
}

fn numbers(i: u64) -> [f64; 2] {
    random::unit_pair(random::at(23, i))
}

/// Bins of one solid angle over all directions.
fn bin(w: Vec3) -> usize {
    let level = (((w.z + 1.0) * 10.0) as usize).min(19);
    let turn = w.y.atan2(w.x) / HALF + 0.5;
    level * 24 + ((turn * 24.0) as usize).min(23)
}

#[test]
fn samples_follow_the_luminance_that_is_seen() {
    let across = Vec3::new(0.1, -0.2, -0.6).normalize();
    for (side, ground, normal) in [
        (1, Rgb::BLACK, Vec3::ZERO),
        (7, Rgb::grey(0.3), Vec3::ZERO),
        (64, Rgb::grey(0.05), Vec3::ZERO),
        (64, Rgb::BLACK, across),
    ] {
        let sky = sky(side, ground);
        let mut counts = vec![0; 480];
        for i in 0..SAMPLES {
            let (wi, radiance, pdf_w) = sky.sample(normal, numbers(i)).unwrap();
            assert!((wi.length() - 1.0).abs() < 1e-5);
            assert_eq!((radiance, pdf_w), (sky.radiance(wi), sky.pdf_w(normal, wi)));
            counts[bin(sky.to_place * wi)] += 1;
        }
        // What each bin should hold, by many points spread evenly.
        let mut probabilities = vec![0.0; 480];
        let points = 4_000_000_u64;
        for i in 0..points {
            let u = [0.5, 0.755_877_666, 0.569_840_291].map(|step: f64| (step * i as f64).fract());
            let wi = warp::square_to_sphere(Vec2::new(u[1] as f32, u[2] as f32));
            probabilities[bin(sky.to_place * wi)] += f64::from(sky.pdf_w(normal, wi));
        }
        let sphere = f64::from(2.0 * HALF) / points as f64;
        probabilities.iter_mut().for_each(|p| *p *= sphere);
        let sum: f64 = probabilities.iter().sum();
        assert!((sum - 1.0).abs() < 1e-4, "the density integrates to {sum}");
        probabilities.iter_mut().for_each(|p| *p /= sum);
        chi_squared::assert_fits(&counts, &probabilities);
    }
}

#[test]
fn a_sky_of_one_colour_has_that_everywhere_and_even_samples() {
    let sky = Sky::new(Mat3::IDENTITY, 5, |_| Rgb::grey(2.0), Rgb::grey(2.0));
    assert!((sky.total() / (4.0 * HALF) - 1.0).abs() < 1e-6);
    for i in 0..1000 {
        let (wi, radiance, pdf_w) = sky.sample(Vec3::ZERO, numbers(i)).unwrap();
        assert!((radiance.g - 2.0).abs() < 1e-6);
        assert!((pdf_w - 0.5 / HALF).abs() < 1e-7);
        assert!(wi.is_normalized());
    }
}

#[test]
fn up_is_the_sky_and_down_is_the_ground() {
    let sky =
        Sky::new(turned(), 8, |w| Rgb { r: w.x.max(0.0), g: w.y.max(0.0), b: w.z }, Rgb::BLACK);
    let seen = |east: f32, north: f32, up: f32| {
        sky.radiance(turned().transpose() * Vec3::new(east, north, up).normalize())
    };
    assert!((seen(0.0, 0.0, 1.0).b - 1.0).abs() < 1e-6);
    assert!((seen(1.0, 0.0, 1e-7).r - 1.0).abs() < 1e-3);
    assert!((seen(0.0, 1.0, 1e-7).g - 1.0).abs() < 1e-3);
    assert_eq!(seen(0.3, 0.4, -1e-3), Rgb::BLACK);
}

#[test]
fn a_black_sky_gives_no_light() {
    let sky = Sky::new(Mat3::IDENTITY, 4, |_| Rgb::BLACK, Rgb::BLACK);
    assert!(sky.sample(Vec3::X, [0.3, 0.7]).is_none());
    assert_eq!((sky.pdf_w(Vec3::X, Vec3::Z), sky.radiance(Vec3::Z)), (0.0, Rgb::BLACK));
}

#[test]
fn a_line_is_cut_where_its_part_ends() {
    for (a, b) in [(0.0, 1.0), (1.0, 0.0), (1.0, 1.0), (0.2, 3.0), (0.0, 0.0), (1e-30, 2e-30)] {
        for u in [0.0, 0.3, 0.999] {
            let x = f64::from(guide::on_line(a, b, u));
            let [a, b, u] = [a, b, u].map(f64::from);
            let part =
                if a + b > 0.0 { (a * x + 0.5 * (b - a) * x * x) / (0.5 * (a + b)) } else { x };
            assert!((part - u).abs() < 1e-6, "{a} {b} {u}: {x}");
        }
    }
}

/// What decides the noise of a surface that nothing hides the sky from.
#[test]
fn surfaces_look_where_their_light_comes_from() {
    let sky = sky(64, Rgb::grey(0.05));
    for i in 0..60 {
        let [u, v] = numbers(i);
        let normal = match i {
            0 => Vec3::X,
            1 => turned().transpose() * Vec3::Z,
            _ => warp::square_to_sphere(Vec2::new(u as f32, v as f32)),
        };
        let (mut sum, mut squares) = (0.0, 0.0);
        for j in 0..2000 {
            let (wi, radiance, pdf_w) = sky.sample(normal, numbers(1000 * i + j)).unwrap();
            let given = radiance.luminance() * normal.dot(wi).max(0.0) / pdf_w;
            sum += f64::from(given) / 2000.0;
            squares += f64::from(given * given) / 2000.0;
        }
        let variance = squares / (sum * sum) - 1.0;
        assert!(variance < 0.25, "{normal}: {variance}");
    }
}
