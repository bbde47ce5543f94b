//! The tour in docs/: its scenes are those of scenes/tour/, and each step of one is a scene beyond
//! doubt, in the style, that makes a picture.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use scn::cli;
use scn::diag::{self, Sources};
use scn::lang;

mod shots;

/// A side of a picture here, as a part of its full one.
const SCALE: f64 = 1.0 / 16.0;
/// The same where errors are measured.
const OF_ERRORS: f64 = 0.5;
/// By how much the error of a picture of that size may differ from the one the page states, which
/// is rounded and of the full size: as a factor.
const NEAR: f64 = 1.3;

/// Each scene of the page, as it stands after each block that goes on with it.
fn scenes() -> Vec<Vec<String>> {
    read().0
}

/// The same with what an answer adds.
fn steps() -> Vec<String> {
    let (scenes, answers) = read();
    scenes.into_iter().flatten().chain(answers).collect()
}

/// The steps of each scene, and scenes with an answer.
fn read() -> (Vec<Vec<String>>, Vec<String>) {
    let page = fs::read_to_string(shots::path("docs/tour.md")).unwrap();
    let (mut scenes, mut answers): (Vec<Vec<String>>, Vec<String>) = Default::default();
    for block in page.split("\n```scn").skip(1) {
        let (kind, rest) = block.split_once('\n').unwrap();
        let text = rest.split("```").next().unwrap();
        match kind {
            "" => scenes.push(vec![text.to_string()]),
            " more" | " answer" => {
                let steps = scenes.last_mut().expect("a scene to go on with");
                let whole = format!("{}\n{text}", steps.last().unwrap());
                if kind == " more" { steps.push(whole) } else { answers.push(whole) }
            }
            other => panic!("a block of the tour is `scn{other}`"),
        }
    }
    (scenes, answers)
}

fn files() -> Vec<PathBuf> {
    let folder = fs::read_dir(shots::path("scenes/tour")).unwrap();
    folder.map(|entry| entry.unwrap().path()).collect()
}

#[test]
fn the_scenes_of_the_page_are_those_of_the_folder() {
    let page: BTreeSet<_> = scenes().iter().map(|steps| steps.last().unwrap().clone()).collect();
    let folder: BTreeSet<_> =
        files().iter().map(|path| fs::read_to_string(path).unwrap()).collect();
    assert!(folder.len() >= 3);
    assert_eq!(page, folder, "docs/tour.md and scenes/tour/ differ");
}

#[test]
fn every_step_is_beyond_doubt_and_in_the_style() {
    let path = shots::path("scenes/tour/step.scn");
    for text in &steps() {
        let mut sources = Sources::new();
        let found = cli::check(&path, text, &[], &mut sources).found;
        let report = diag::print::report(&found, &sources, "a step", diag::print::Look::PLAIN);
        assert!(report.is_empty(), "{text}\n{report}");
        let id = sources.add("step.scn".to_string(), text.clone());
        let styled = lang::format::format(text, id).expect("no faults of syntax");
        assert_eq!(&styled, text, "`scn fmt` would change it");
    }
}

#[test]
fn every_step_makes_a_picture() {
    for text in &steps() {
        let shots = shots::open_text(&shots::path("scenes/tour/step.scn"), text, &[]);
        for shot in shots.unwrap_or_else(|report| panic!("{report}")) {
            let picture = shot.picture(&shot.prepare(SCALE), 0);
            let values = picture.pixels.iter().flat_map(|pixel| pixel.to_array());
            let (low, high) = values.fold((f32::MAX, 0.0f32), |(low, high), value| {
                assert!(value >= 0.0 && value.is_finite(), "{}: {value}", shot.name);
                (low.min(value), high.max(value))
            });
            assert!(high > low, "{} shows nothing", shot.name);
        }
    }
}

/// The numbers before `%` in a text, as parts of one.
fn percents(text: &str) -> Vec<f64> {
    let before = text.split('%').filter_map(|part| part.split_whitespace().next_back());
    before.filter_map(|word| word.parse::<f64>().ok()).map(|number| number / 100.0).collect()
}

#[test]
fn the_errors_it_states_are_about_those_of_its_pictures() {
    let page = fs::read_to_string(shots::path("docs/tour.md")).unwrap();
    let table = page.split("| render | error |").nth(1).unwrap().split("\n\n").next().unwrap();
    let mut stated: Vec<(String, u64, Vec<f64>)> = Vec::new();
    for row in table.lines().filter_map(|line| line.strip_prefix("| `")) {
        let (name, rest) = row.split_once('`').unwrap();
        stated.push((name.to_string(), if name.ends_with("_4") { 4 } else { 64 }, percents(rest)));
    }
    assert_eq!(stated.len(), 4);
    let end = page.split("stopped   by error, after 256 samples a pixel\n").nth(1).unwrap();
    let end = end.lines().next().unwrap();
    stated.push(("until".to_string(), 256, percents(&end.replacen("95 %", "", 1))));
    let shots = shots::open("scenes/tour/lamp.scn");
    for (name, samples, stated) in stated {
        let shot = shots.iter().find(|shot| shot.name == name).unwrap();
        let outcome = shot.outcome(&shot.prepare(OF_ERRORS), 0, samples);
        let noise = outcome.noise.unwrap();
        let found = [noise.relmse, noise.low, noise.high].map(f64::sqrt);
        assert_eq!(stated.len(), if outcome.bound { 1 } else { 3 }, "{name}");
        for (i, (stated, found)) in stated.iter().zip(found).enumerate() {
            // The ends of an interval are less certain than the middle.
            let most = if i == 0 { NEAR } else { NEAR * NEAR };
            let near = (stated / found).max(found / stated) < most;
            assert!(near, "{name}: docs/tour.md says {stated}, and {found} is found");
        }
    }
}

#[test]
fn the_scene_that_is_broken_is_told_as_printed() {
    let page = fs::read_to_string(shots::path("docs/tour.md")).unwrap();
    let shown = page.split("```text\n").nth(1).unwrap().split("```").next().unwrap();
    let whole = scenes()[0][0].replace("35 deg", "35").replace("material: clay", "material: caly");
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("ball.scn"), whole).unwrap();
    let mut lint = Command::new(env!("CARGO_BIN_EXE_scn"));
    lint.current_dir(folder.path()).args(["lint", "ball.scn", "--format", "short"]);
    let found = String::from_utf8(lint.output().unwrap().stdout).unwrap();
    assert_eq!(shown, found);
}
