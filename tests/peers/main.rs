//! Our figures against those of programs others wrote: flip-evaluator of NVIDIA for FLIP,
//! scikit-image for SSIM. Their values were recorded by measure.py, which makes them again.
//! And what run.py compares with other renderers, so far as it is ours.

mod pairs;
mod recorded;
mod scenes;

use std::path::Path;

use scn::math::Picture;
use scn::measure::{flip, ssim};

/// How far a mean of FLIP may be off. A tenth of what is promised, ten times what was seen.
const FLIP_TOLERANCE: f64 = 1e-4;

#[test]
fn flip_of_displayed_pictures_equals_flip_evaluator() {
    each(|pair, recorded| {
        let map = flip::ldr(&pair.reference, &pair.test, flip::PIXELS_PER_DEGREE);
        close(pair.name, "mean", map.mean(), recorded.ldr_mean, FLIP_TOLERANCE);
        close(pair.name, "max", largest(&map.values), recorded.ldr_max, FLIP_TOLERANCE);
    });
}

#[test]
fn flip_of_radiance_equals_flip_evaluator() {
    each(|pair, recorded| {
        let found = flip::hdr(&pair.reference, &pair.test, flip::PIXELS_PER_DEGREE).unwrap();
        close(pair.name, "start", found.exposures.start, recorded.start, 1e-4);
        close(pair.name, "stop", found.exposures.stop, recorded.stop, 1e-4);
        assert_eq!(found.exposures.count, recorded.exposures, "{}", pair.name);
        close(pair.name, "mean", found.map.mean(), recorded.hdr_mean, FLIP_TOLERANCE);
        let max = largest(&found.map.values);
        close(pair.name, "max", max, recorded.hdr_max, FLIP_TOLERANCE);
    });
}

#[test]
fn ssim_equals_scikit_image() {
    each(|pair, recorded| {
        let found = ssim(&pair.reference, &pair.test).unwrap();
        close(pair.name, "SSIM", found, recorded.ssim, 1e-5);
    });
}

#[test]
#[ignore = "writes the pictures that measure.py reads into the folder SCN_PAIRS names"]
fn write_pairs() {
    let folder = std::env::var("SCN_PAIRS").expect("SCN_PAIRS names a folder");
    for pair in pairs::all() {
        for (side, picture) in [("reference", &pair.reference), ("test", &pair.test)] {
            write(&Path::new(&folder).join(format!("{}.{side}.f32", pair.name)), picture);
        }
    }
}

/// Little-endian f32, red, green and blue of each pixel, row by row.
fn write(path: &Path, picture: &Picture) {
    let numbers = picture.pixels.iter().flat_map(|pixel| pixel.to_array());
    let bytes: Vec<u8> = numbers.flat_map(f32::to_le_bytes).collect();
    std::fs::write(path, bytes).unwrap();
}

fn each(check: impl Fn(&pairs::Pair, &recorded::Values)) {
    let pairs = pairs::all();
    assert_eq!(pairs.len(), recorded::VALUES.len());
    for (pair, recorded) in pairs.iter().zip(recorded::VALUES) {
        assert_eq!(pair.name, recorded.name);
        check(pair, recorded);
    }
}

#[track_caller]
fn close(pair: &str, what: &str, found: f64, recorded: f64, tolerance: f64) {
    assert!(
        (found - recorded).abs() <= tolerance,
        "{pair}: {what} {found}, recorded {recorded}, allowed {tolerance}"
    );
}

fn largest(values: &[f32]) -> f64 {
    values.iter().copied().fold(0.0, f32::max).into()
}
