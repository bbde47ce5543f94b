//! `scn compare` from end to end: figures, exit statuses, refusals, the difference picture.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use scn::files::exr::Layers;
use scn::files::{Metadata, exr, png};
use scn::math::{Picture, Rgb};
use serde_json::Value;
use tempfile::TempDir;

/// A folder with pictures.
struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Writes an EXR that says of itself what `words` holds.
    fn exr(&self, name: &str, picture: &Picture, words: &[(&str, &str)]) {
        let words: Metadata =
            words.iter().map(|(k, v)| (format!("scn:{k}"), v.to_string())).collect();
        exr::write(&self.path(name), &Layers::new(picture.clone()), &words).unwrap();
    }

    fn png(&self, name: &str, picture: &Picture) {
        png::write(&self.path(name), picture, 1.0, &Metadata::new()).unwrap();
    }

    /// Runs `scn compare` there.
    fn compare(&self, arguments: &[&str]) -> Told {
        let mut command = Command::new(env!("CARGO_BIN_EXE_scn"));
        let output = command.current_dir(self.0.path()).arg("compare").args(arguments).output();
        Told::from(output.unwrap())
    }

    fn json(&self, arguments: &[&str]) -> Value {
        let told = self.compare(&[arguments, &["--format", "json"]].concat());
        serde_json::from_str(&told.stdout).unwrap_or_else(|_| panic!("{told:?}"))
    }
}

#[derive(Debug)]
struct Told {
    status: i32,
    stdout: String,
    stderr: String,
}

impl From<Output> for Told {
    fn from(output: Output) -> Self {
        Self {
            status: output.status.code().unwrap(),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

/// 40 × 30 pixels: a ramp times `factor`.
fn ramp(factor: f32) -> Picture {
    let pixel = |i: usize| Rgb::new(0.5, i as f32 / 1200.0, 2.0) * factor;
    Picture { width: 40, height: 30, pixels: (0..1200).map(pixel).collect() }
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn a_is_judged_against_b() {
    let folder = Folder::new();
    folder.exr("a.exr", &ramp(1.1), &[]);
    folder.exr("b.exr", &ramp(1.0), &[]);
    let told = folder.compare(&["a.exr", "b.exr"]);
    assert_eq!((told.status, told.stderr.as_str()), (0, ""));
    assert!(told.stdout.starts_with("Against b.exr, 40 × 30 pixels\n"), "{}", told.stdout);
    assert!(told.stdout.contains("ε of relmse is 0.01.\n"), "{}", told.stdout);

    let json = folder.json(&["a.exr", "b.exr"]);
    let metrics = &json["pictures"][0]["metrics"];
    // A tenth of 0.5, of 1199/2400 on average, and of 2.
    for (metric, wanted) in [
        ("bias_red", 0.05),
        ("bias_green", 0.1 * 1199.0 / 2400.0),
        ("bias_blue", 0.2),
        ("error_max", 0.2),
    ] {
        assert!((number(&metrics[metric]) - wanted).abs() < 1e-6, "{metric}: {metrics}");
    }
    // The other way round it is too dark.
    let json = folder.json(&["b.exr", "a.exr"]);
    assert!((number(&json["pictures"][0]["metrics"]["bias_red"]) + 0.05).abs() < 1e-6);
    assert_eq!(json["reference"]["file"], "a.exr");
}

#[test]
fn with_a_reference_both_are_judged_side_by_side() {
    let folder = Folder::new();
    folder.exr("new.exr", &ramp(1.05), &[]);
    folder.exr("old.exr", &ramp(0.8), &[]);
    folder.exr("truth.exr", &ramp(1.0), &[]);
    let arguments = ["new.exr", "old.exr", "--reference", "truth.exr"];
    let json = folder.json(&arguments);
    let bias = |i: usize| number(&json["pictures"][i]["metrics"]["bias_red"]);
    assert!((bias(0) - 0.025).abs() < 1e-6 && (bias(1) + 0.1).abs() < 1e-6, "{json}");
    let told = folder.compare(&arguments);
    let heading = told.stdout.lines().nth(2).unwrap();
    let words: Vec<_> = heading.split_whitespace().collect();
    assert_eq!(words, ["new.exr", "old.exr"]);
    assert!(told.stdout.starts_with("Against truth.exr"));
}

#[test]
fn equal_pictures_have_no_error() {
    let folder = Folder::new();
    folder.exr("a.exr", &ramp(1.0), &[]);
    folder.exr("b.exr", &ramp(1.0), &[]);
    let json = folder.json(&["a.exr", "b.exr", "--fail-if", "error_max > 0"]);
    for (name, value) in json["pictures"][0]["metrics"].as_object().unwrap() {
        let wanted = if name == "ssim" { 1.0 } else { 0.0 };
        assert!((number(value) - wanted).abs() < 1e-6, "{name} {value}");
    }
    assert_eq!(json["conditions"][0]["holds"], false);
}

#[test]
fn epsilon_is_the_users() {
    let folder = Folder::new();
    let flat = |grey| Picture { width: 20, height: 20, pixels: vec![Rgb::grey(grey); 400] };
    folder.exr("a.exr", &flat(0.5), &[]);
    folder.exr("b.exr", &flat(0.0), &[]);
    let relmse = |arguments: &[&str]| {
        let json = folder.json(&[&["a.exr", "b.exr"], arguments].concat());
        number(&json["pictures"][0]["metrics"]["relmse"])
    };
    assert!((relmse(&[]) - 25.0).abs() < 1e-6);
    assert!((relmse(&["--epsilon", "0.5"]) - 0.5).abs() < 1e-9);
    for bad in ["0", "-1", "nan", "inf", "small"] {
        let told = folder.compare(&["a.exr", "b.exr", &format!("--epsilon={bad}")]);
        assert_eq!(told.status, 2, "{told:?}");
    }
}

#[test]
fn the_epsilon_of_a_file_is_taken_and_another_one_told() {
    let folder = Folder::new();
    folder.exr("a.exr", &ramp(2.0), &[("error_epsilon", "1e-4")]);
    folder.exr("b.exr", &ramp(1.0), &[]);
    let used = |json: &Value| number(&json["settings"]["relmse_epsilon"]);
    let plain = folder.json(&["a.exr", "b.exr"]);
    let own = folder.json(&["a.exr", "b.exr", "--epsilon", "own"]);
    let near = folder.json(&["a.exr", "b.exr", "--epsilon", "1.5e-4"]);
    assert_eq!((used(&plain), used(&own)), (0.01, 1e-4));
    assert!(plain["notes"].to_string().contains("--epsilon own"), "{plain}");
    assert!(!own["notes"].to_string().contains("own"), "{own}");
    assert!(!near["notes"].to_string().contains("own"), "{near}");
    let told = folder.compare(&["b.exr", "a.exr", "--epsilon", "own"]);
    assert_eq!(told.status, 2);
    assert!(told.stderr.contains("`b.exr` states no ε"), "{told:?}");
}

#[test]
fn a_condition_that_holds_ends_with_one() {
    let folder = Folder::new();
    folder.exr("a.exr", &ramp(1.1), &[]);
    folder.exr("b.exr", &ramp(1.0), &[]);
    folder.exr("c.exr", &ramp(1.0), &[]);
    let told = folder.compare(&["a.exr", "b.exr", "--fail-if", "relmse > 1e-6"]);
    assert_eq!(told.status, 1, "{told:?}");
    assert!(told.stderr.starts_with("failed: relmse > 0.000001 holds for a.exr: 0.0"), "{told:?}");
    assert!(told.stdout.contains("relmse_trimmed"), "the figures are told all the same");
    let told =
        folder.compare(&["a.exr", "b.exr", "--fail-if", "relmse > 1", "--fail-if", "ssim<.1"]);
    assert_eq!((told.status, told.stderr.as_str()), (0, ""));
    // Any of several, of either picture.
    let both =
        ["c.exr", "a.exr", "--reference", "b.exr", "--fail-if", "mse>9", "--fail-if", "bias>.09"];
    let told = folder.compare(&both);
    assert_eq!(told.status, 1, "{told:?}");
    assert!(told.stderr.contains("holds for a.exr") && !told.stderr.contains("c.exr"), "{told:?}");
}

#[test]
fn what_is_no_condition_is_refused_with_the_metrics_there_are() {
    let folder = Folder::new();
    folder.exr("a.exr", &ramp(1.0), &[]);
    let told = folder.compare(&["a.exr", "a.exr", "--fail-if", "rellmse > 1"]);
    assert_eq!((told.status, told.stdout.as_str()), (2, ""));
    assert!(told.stderr.contains("did you mean `relmse`"), "{told:?}");
    assert!(told.stderr.contains("flip_ldr, flip_hdr, ssim"), "{told:?}");
}

#[test]
fn an_undefined_metric_cannot_be_judged() {
    let folder = Folder::new();
    folder.exr("a.exr", &ramp(1.0), &[]);
    folder.exr("black.exr", &ramp(0.0), &[]);
    let told = folder.compare(&["a.exr", "black.exr", "--fail-if", "flip_hdr > 0.1"]);
    assert_eq!(told.status, 2, "{told:?}");
    assert!(told.stderr.contains("the reference is black"), "{told:?}");
    assert!(told.stdout.contains("flip_hdr is undefined: the reference is black"), "{told:?}");
    let json = folder.json(&["a.exr", "black.exr"]);
    assert_eq!(json["pictures"][0]["metrics"]["flip_hdr"], Value::Null);
    let small = Picture { width: 5, height: 5, pixels: vec![Rgb::ONE; 25] };
    folder.exr("s.exr", &small, &[]);
    let told = folder.compare(&["s.exr", "s.exr"]);
    assert!(told.stdout.contains("ssim is undefined: the pictures are smaller"), "{told:?}");
}

#[test]
fn pngs_are_decoded_to_linear_light() {
    let folder = Folder::new();
    let flat = |grey| Picture { width: 20, height: 20, pixels: vec![Rgb::grey(grey); 400] };
    folder.png("a.png", &flat(0.5));
    folder.exr("b.exr", &flat(0.5), &[]);
    let json = folder.json(&["a.png", "b.exr"]);
    let metrics = &json["pictures"][0]["metrics"];
    // 0.5 is byte 188, which is 0.502886: the rounding of eight bits, no more.
    assert!((number(&metrics["bias"]) - 0.002_886).abs() < 1e-5, "{metrics}");
    assert_eq!(metrics["flip_hdr"], Value::Null);
    assert!(json["notes"][0].as_str().unwrap().contains("is a PNG"), "{json}");
    let told = folder.compare(&["a.png", "a.png"]);
    assert!(told.stdout.contains("flip_hdr is undefined: a PNG holds no radiance"), "{told:?}");
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let folder = Folder::new();
    folder.exr("a.exr", &ramp(1.0), &[]);
    folder.exr("small.exr", &Picture::black(20, 30), &[]);
    std::fs::write(folder.path("text.exr"), "no picture").unwrap();
    std::fs::write(folder.path("a.jpg"), "no picture").unwrap();
    for (arguments, words) in [
        (vec!["a.exr", "small.exr"], "`a.exr` has 40 × 30 pixels, and `small.exr` has 20 × 30"),
        (vec!["a.exr", "none.exr"], "`none.exr` does not exist"),
        (vec!["a.exr", "text.exr"], "`text.exr` is no whole EXR"),
        (vec!["a.exr", "a.jpg"], "`a.jpg` ends neither in .exr nor in .png"),
        (vec!["a.exr", "."], "`.` ends neither"),
        (vec!["a.exr"], "required arguments were not provided"),
        (vec!["a.exr", "a.exr", "-o", "a.exr"], "does not end in .png"),
        (vec!["a.exr", "a.exr", "-o", "a.exr/d.png"], "`a.exr/d.png` "),
    ] {
        let told = folder.compare(&arguments);
        assert_eq!((told.status, told.stdout.as_str()), (2, ""), "{arguments:?}: {told:?}");
        assert!(told.stderr.contains(words), "{arguments:?}: {}", told.stderr);
    }
    // All that cannot be read is told at once.
    let told = folder.compare(&["none.exr", "text.exr", "--reference", "a.jpg"]);
    assert_eq!(told.stderr.lines().count(), 3, "{told:?}");
}

#[test]
fn different_parts_of_a_film_are_refused() {
    let folder = Folder::new();
    for (name, origin) in [("left.exr", [0, 0]), ("right.exr", [40, 0]), ("left2.exr", [0, 0])] {
        let layers = Layers {
            film: [80, 30],
            origin,
            main: ramp(1.0),
            named: Vec::new(),
            scalars: Vec::new(),
        };
        exr::write(&folder.path(name), &layers, &Metadata::new()).unwrap();
    }
    let told = folder.compare(&["left.exr", "right.exr"]);
    assert_eq!(told.status, 2, "{told:?}");
    assert!(told.stderr.contains("`right.exr` has 40 × 30 pixels from (40, 0)"), "{told:?}");
    assert_eq!(folder.compare(&["left.exr", "left2.exr"]).status, 0);
}

#[test]
fn a_nan_of_another_program_is_counted_and_placed() {
    let folder = Folder::new();
    folder.exr("a.exr", &ramp(1.0), &[]);
    ::exr::prelude::write_rgb_file(folder.path("b.exr"), 40, 30, |x, y| {
        if (x, y) == (7, 3) { (f32::NAN, 1.0, 1.0) } else { (0.5, 0.5, 0.5) }
    })
    .unwrap();
    let told = folder.compare(&["a.exr", "b.exr"]);
    assert_eq!(told.status, 2, "{told:?}");
    assert!(told.stderr.contains("`b.exr` has 1 pixel with a component"), "{told:?}");
    assert!(told.stderr.contains("column 7, row 3"), "{told:?}");
}

#[test]
fn what_the_files_say_differently_is_told() {
    let folder = Folder::new();
    let words = |hash, samples, seed| {
        [("hash", hash), ("samples", samples), ("seed", seed), ("time", seed), ("version", "1")]
    };
    folder.exr("a.exr", &ramp(1.0), &words("aaaa", "64", "0"));
    folder.exr("b.exr", &ramp(1.1), &words("bbbb", "1024", "1"));
    folder.exr("c.exr", &ramp(1.1), &words("aaaa", "16", "0"));
    let told = folder.compare(&["a.exr", "b.exr"]).stdout;
    let line = |key: &str| {
        told.lines().find(|l| l.trim_start().starts_with(key)).map(str::split_whitespace)
    };
    let cells = |key: &str| line(key).map(|cells| cells.collect::<Vec<_>>());
    assert_eq!(cells("hash"), Some(vec!["hash", "aaaa", "bbbb"]), "{told}");
    assert_eq!(cells("samples"), Some(vec!["samples", "64", "1024"]));
    assert_eq!((cells("time"), cells("version")), (None, None), "{told}");
    assert!(told.contains("note: a.exr and b.exr are of different scenes"), "{told}");

    let json = folder.json(&["a.exr", "c.exr"]);
    assert_eq!(json["differing"]["scn:samples"], serde_json::json!(["64", "16"]));
    let notes = json["notes"].to_string();
    assert!(notes.contains("one scene and one seed"), "{notes}");
    assert!(notes.contains("c.exr has fewer samples than a.exr"), "{notes}");
    // A note is told in lines no longer than a page is wide.
    let told = folder.compare(&["a.exr", "c.exr"]).stdout;
    assert!(told.contains("\nnote: a.exr and c.exr are of one scene and one seed"), "{told}");
    assert!(told.lines().all(|line| line.chars().count() <= 100), "{told}");

    let json = folder.json(&["a.exr", "a.exr"]);
    assert!(json["notes"][0].as_str().unwrap().contains("the same file"), "{json}");
}

#[test]
fn the_difference_picture_shows_where() {
    let folder = Folder::new();
    let mut spot = ramp(1.0);
    for y in 10..20 {
        for x in 25..35 {
            spot.pixels[y * 40 + x] = Rgb::new(0.0, 0.0, 0.0);
        }
    }
    folder.exr("spot.exr", &spot, &[]);
    folder.exr("same.exr", &ramp(1.0), &[]);
    folder.exr("truth.exr", &ramp(1.0), &[]);
    let brightness =
        |path: &Path, x: usize, y: usize| png::read(path).unwrap().0.at(x, y).luminance();
    let told = folder.compare(&["spot.exr", "truth.exr", "-o", "new/diff.png"]);
    assert_eq!(told.status, 0, "{told:?}");
    assert!(told.stdout.contains("flip_hdr as a picture"), "{told:?}");
    let path = folder.path("new/diff.png");
    let (picture, words) = png::read(&path).unwrap();
    assert_eq!((picture.width, picture.height), (40, 30));
    assert!(words[0].1.starts_with("flip_hdr of spot.exr against truth.exr"), "{words:?}");
    assert!(brightness(&path, 30, 15) > 0.3, "{}", brightness(&path, 30, 15));
    assert!(brightness(&path, 3, 3) < 0.001);

    // Two judged: the first on the left.
    let two = ["same.exr", "spot.exr", "--reference", "truth.exr", "-o", "two.png"];
    let json = folder.json(&two);
    assert_eq!(json["difference"]["file"], "two.png");
    let path = folder.path("two.png");
    assert_eq!(png::read(&path).unwrap().0.width, 80);
    assert!(brightness(&path, 30, 15) < 0.001 && brightness(&path, 70, 15) > 0.3);

    // With a PNG there is no radiance.
    folder.png("truth.png", &ramp(1.0));
    let json = folder.json(&["spot.exr", "truth.png", "-o", "shown.png"]);
    assert_eq!(json["difference"]["shows"], "flip_ldr");
}

#[test]
fn no_picture_compared_is_overwritten() {
    let folder = Folder::new();
    folder.png("a.png", &ramp(1.0));
    let before = std::fs::read(folder.path("a.png")).unwrap();
    let told = folder.compare(&["a.png", "a.png", "-o", "./a.png"]);
    assert_eq!(told.status, 2, "{told:?}");
    assert!(told.stderr.contains("is one of the pictures compared"), "{told:?}");
    assert_eq!(std::fs::read(folder.path("a.png")).unwrap(), before);
}

#[test]
fn files_called_alike_are_told_apart_and_terminals_left_alone() {
    let folder = Folder::new();
    for name in ["one/fig.exr", "two/fig.exr"] {
        std::fs::create_dir_all(folder.path(name).parent().unwrap()).unwrap();
    }
    folder.exr("one/fig.exr", &ramp(1.1), &[("render", "\x1b[31mred\x07")]);
    folder.exr("two/fig.exr", &ramp(1.0), &[("render", "plain")]);
    let told = folder.compare(&["one/fig.exr", "two/fig.exr"]);
    assert!(told.stdout.starts_with("Against two/fig.exr"), "{}", told.stdout);
    assert!(told.stdout.contains("one/fig.exr"), "{}", told.stdout);
    assert!(!told.stdout.contains('\x1b') && !told.stdout.contains('\x07'), "{}", told.stdout);
}

#[test]
fn the_help_names_every_metric() {
    let folder = Folder::new();
    let told = folder.compare(&["--help"]);
    for metric in scn::measure::METRICS {
        assert!(told.stdout.contains(metric.name), "{}", metric.name);
        assert!(include_str!("../docs/compare.md").contains(&format!("`{}`", metric.name)));
    }
}

#[test]
fn renders_of_one_file_are_told_to_be_so() {
    let folder = Folder::new();
    let words = |render, hash| [("scene", "w01.scn"), ("render", render), ("hash", hash)];
    folder.exr("a.exr", &ramp(1.1), &words("rays_4", "aaaa"));
    folder.exr("b.exr", &ramp(1.0), &words("rays_16", "bbbb"));
    folder.exr("c.exr", &ramp(1.0), &words("rays_4", "cccc"));
    let notes = |one, other| folder.json(&[one, other])["notes"].to_string();
    let told = notes("a.exr", "b.exr");
    assert!(told.contains("other renders of the same file, w01.scn: rays_4 and rays_16"), "{told}");
    // One render with two hashes was changed.
    assert!(notes("a.exr", "c.exr").contains("of different scenes"), "{told}");
}

#[test]
fn renders_of_one_light_and_one_seed_share_random_numbers() {
    let folder = Folder::new();
    let words = |render, hash, light_hash, seed| {
        let all = [("scene", "w01.scn"), ("render", render), ("hash", hash)];
        [&all[..], &[("light_hash", light_hash), ("seed", seed)]].concat()
    };
    folder.exr("most.exr", &ramp(1.1), &words("most", "aaaa", "1111", "0"));
    folder.exr("reference.exr", &ramp(1.0), &words("reference", "bbbb", "1111", "0"));
    folder.exr("brighter.exr", &ramp(1.0), &words("most", "cccc", "1111", "0"));
    folder.exr("other_seed.exr", &ramp(1.0), &words("reference", "bbbb", "1111", "1"));
    folder.exr("other_light.exr", &ramp(1.0), &words("reference", "bbbb", "2222", "0"));
    let notes = |other| folder.json(&["most.exr", other])["notes"].to_string();
    let shared = "they may share random numbers";
    let told = notes("reference.exr");
    assert!(told.contains("other renders of the same file"), "{told}");
    assert!(told.contains("one seed, and differ in nothing that samples depend on"), "{told}");
    assert!(told.contains(shared) && told.contains("with another --seed."), "{told}");
    let told = notes("brighter.exr");
    assert!(told.contains(shared) && !told.contains("different scenes"), "{told}");
    for other in ["other_seed.exr", "other_light.exr"] {
        let told = notes(other);
        assert!(told.contains("other renders of the same file"), "{told}");
        assert!(!told.contains(shared), "{told}");
    }
}
