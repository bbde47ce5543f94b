//! The figures of the worksheets done so far: each has a render that makes it, every shipped
//! render works, and what must differ or agree does.

use std::sync::LazyLock;

use scn::measure::statistics::{Moments, welch};

mod shots;
use shots::Shot;

/// The side of a picture here, as a part of its full one: 512 pixels become 32.
const SCALE: f64 = 1.0 / 16.0;
/// Pictures of different seeds that an estimate is made of.
const BATCHES: u64 = 16;
/// So many standard errors apart, two expectations differ; fixed seeds make it no gamble.
const APART: f64 = 4.0;

/// A worksheet: its scene file and the numbers of its figures.
struct Worksheet {
    file: &'static str,
    figures: std::ops::RangeInclusive<u32>,
}

const WORKSHEETS: &[Worksheet] = &[
    Worksheet { file: "scenes/w01_first_pictures.scn", figures: 1..=6 },
    Worksheet { file: "scenes/w02_sky_and_sun.scn", figures: 7..=10 },
    Worksheet { file: "scenes/w03_mirror_glass_metal.scn", figures: 11..=14 },
    Worksheet { file: "scenes/w04_soft_shadows.scn", figures: 15..=21 },
    Worksheet { file: "scenes/w05_path_tracing.scn", figures: 22..=26 },
];

static SHOTS: LazyLock<Vec<Vec<Shot>>> =
    LazyLock::new(|| WORKSHEETS.iter().map(|sheet| shots::open(sheet.file)).collect());

/// A render by its sheet and name: `w01/fig04`.
fn shot(name: &str) -> &'static Shot {
    let (sheet, render) = name.split_once('/').unwrap();
    let is_it = |other: &Worksheet| other.file.starts_with(&format!("scenes/{sheet}_"));
    let sheet = WORKSHEETS.iter().position(is_it).unwrap();
    let found = SHOTS[sheet].iter().find(|shot| shot.name == render);
    found.unwrap_or_else(|| panic!("no render {name}"))
}

/// The figure a caption begins with: "Figure 12. …", "Figure 12, left. …".
fn figure(caption: &str) -> Option<u32> {
    let rest = caption.strip_prefix("Figure ")?;
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    let follows = rest[digits..].starts_with(['.', ',']);
    follows.then(|| rest[..digits].parse().ok())?
}

/// The mean of a render's picture over all pixels and channels, once a seed.
fn means(name: &str) -> Moments {
    means_at(SCALE, name)
}

fn means_at(scale: f64, name: &str) -> Moments {
    let shot = shot(name);
    let prepared = shot.prepare(scale);
    let mean = |seed| {
        let picture = shot.picture(&prepared, seed);
        let sum: f64 = picture.pixels.iter().flat_map(|p| p.to_array()).map(f64::from).sum();
        sum / (3 * picture.pixels.len()) as f64
    };
    (0..BATCHES).map(mean).collect()
}

#[test]
fn every_figure_has_a_render() {
    for (sheet, shots) in WORKSHEETS.iter().zip(&*SHOTS) {
        for number in sheet.figures.clone() {
            let found = shots.iter().any(|shot| figure(shot.caption()) == Some(number));
            assert!(found, "{}: no caption begins with Figure {number}.", sheet.file);
        }
    }
}

#[test]
fn every_worksheet_is_in_the_table() {
    for entry in std::fs::read_dir(shots::path("scenes")).unwrap() {
        let name = format!("scenes/{}", entry.unwrap().file_name().to_str().unwrap());
        let listed = WORKSHEETS.iter().any(|sheet| sheet.file == name);
        // `w01_…`; others are scenes of other pages.
        let worksheet = name.starts_with("scenes/w") && name.ends_with(".scn");
        assert!(listed || !worksheet, "{name} is in no row of WORKSHEETS");
    }
}

#[test]
fn every_render_makes_a_picture() {
    for shot in SHOTS.iter().flatten() {
        let picture = shot.picture(&shot.prepare(SCALE), 0);
        assert_eq!((picture.width, picture.height), (32, 32), "{}", shot.name);
        let values: Vec<f32> = picture.pixels.iter().flat_map(|p| p.to_array()).collect();
        let (low, high) = values.iter().fold((f32::MAX, 0.0f32), |(low, high), &value| {
            assert!(value >= 0.0 && value.is_finite(), "{}: {value}", shot.name);
            (low.min(value), high.max(value))
        });
        assert!(high > low, "{} shows nothing", shot.name);
    }
}

#[test]
fn figures_that_show_different_things_differ() {
    let pairs = [
        ("w01/fig01", "w01/fig02"), // the headlight is no directional light
        ("w01/fig02", "w01/fig03_override"), // pink
        ("w01/fig02", "w01/fig04"), // shadows on the bunny
        ("w01/fig05", "w01/fig06"), // shadows in the box
        ("w02/day_7", "w02/day_17"), // the sun has gone round
        ("w03/fig11", "w03/fig12"), // a glass ball is no mirror
        ("w03/fig13", "w03/fig14"), // the elephant
        ("w04/fig16", "w04/day_11"), // the sun
        ("w02/day_11", "w04/day_11"), // the light of the sky
    ];
    for (a, b) in pairs {
        let (score, _, _) = welch(&means(a), &means(b));
        assert!(score.abs() > APART, "{a} and {b} differ by {score} standard errors only");
    }
}

#[test]
fn more_rays_a_pixel_change_no_expectation() {
    let sixteen = means("w01/rays_16");
    for name in ["w01/rays_1", "w01/rays_4", "w01/rays_9"] {
        let (score, _, _) = welch(&means(name), &sixteen);
        assert!(score.abs() < APART, "{name} is {score} standard errors from sixteen rays");
    }
}

#[test]
fn neither_splitting_nor_roulette_changes_an_expectation() {
    // Hundreds of paths a pixel: eight pixels a side are enough.
    let few = |name: &str| means_at(SCALE / 4.0, &format!("w05/{name}"));
    let left = few("fig22_left");
    for (a, b) in [(&left, "fig22_right"), (&left, "fig23_left"), (&left, "fig23_right")] {
        let (score, _, _) = welch(a, &few(b));
        assert!(score.abs() < APART, "{b} is {score} standard errors from figure 22, left");
    }
    for figure in ["fig24", "fig25"] {
        let [left, right] = ["left", "right"].map(|side| few(&format!("{figure}_{side}")));
        let (score, _, _) = welch(&left, &right);
        assert!(score.abs() < APART, "{figure}: {score} standard errors");
    }
}

#[test]
fn what_is_said_in_two_ways_is_the_same_picture() {
    for (a, b) in [("w01/fig03_mtl", "w01/fig03_override"), ("w01/fig04", "w01/rays_16")] {
        let picture = |name| shot(name).picture(&shot(name).prepare(SCALE), 7);
        assert!(picture(a) == picture(b), "{a} and {b} differ");
    }
}

#[test]
fn captions_tell_their_figure() {
    assert_eq!(figure("Figure 12. x"), Some(12));
    assert_eq!(figure("Figure 3, again."), Some(3));
    assert_eq!(figure("Figure 4 with 1 rays a pixel."), None);
    assert_eq!(figure("See Figure 4."), None);
}
