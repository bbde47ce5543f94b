//! What the README shows is what happens: its scenes render, its faulty scene is reported as
//! printed there, its commands and options exist.

use std::path::Path;
use std::process::Command;

mod shots;

const README: &str = include_str!("../README.md");

/// The fenced blocks of a page: what stands after the fence, and the text.
fn blocks(page: &str) -> Vec<(&str, String)> {
    let mut found: Vec<(&str, String)> = Vec::new();
    let mut open = false;
    for line in page.lines() {
        if let Some(info) = line.strip_prefix("```") {
            open = !open;
            if open {
                found.push((info, String::new()));
            }
        } else if open {
            let text = &mut found.last_mut().unwrap().1;
            text.push_str(line);
            text.push('\n');
        }
    }
    found
}

fn of_kind(kind: &str) -> Vec<String> {
    blocks(README).into_iter().filter(|(info, _)| *info == kind).map(|(_, text)| text).collect()
}

#[test]
fn its_scenes_render() {
    let scenes = of_kind("scn");
    assert!(scenes.len() >= 3);
    for text in scenes {
        let shots = shots::open_text(&shots::path("example.scn"), &text, &[]);
        for shot in shots.unwrap_or_else(|report| panic!("{report}")) {
            let picture = shot.picture(&shot.prepare(1.0 / 16.0), 0);
            assert!(
                picture.pixels.iter().any(|p| *p != picture.pixels[0]),
                "{} is empty",
                shot.name
            );
        }
    }
}

#[test]
fn its_scenes_are_in_the_style() {
    for text in of_kind("scn") {
        let id = scn::diag::Sources::new().add("scene.scn", text.as_str());
        let styled = scn::lang::format::format(&text, id).expect("no faults of syntax");
        assert_eq!(styled, text, "`scn fmt` would change it");
    }
}

#[test]
fn its_faulty_scene_is_reported_as_printed() {
    let faulty = of_kind("scn-faulty");
    let printed = of_kind("text");
    assert_eq!((faulty.len(), printed.len()), (1, 1));
    let (command, shown) = printed[0].split_once('\n').unwrap();
    let name = command.strip_prefix("$ scn lint ").unwrap();
    // Who saves it by that name overwrites none of the scenes before.
    let before = README.split("```scn-faulty").next().unwrap();
    assert!(before.contains(&format!("`{name}`, has three")) && name != "ball.scn");
    let report = shots::open_text(Path::new(name), &faulty[0], &[]).err().unwrap();
    assert!(shown.trim() == report.trim(), "the README should show:\n{report}");
}

#[test]
fn the_options_it_lists_are_those_of_the_command() {
    let output =
        Command::new(env!("CARGO_BIN_EXE_scn")).args(["render", "--help"]).output().unwrap();
    let help = String::from_utf8(output.stdout).unwrap();
    let options = |text: &str| -> Vec<String> {
        let name = |rest: &str| -> String {
            rest.chars().take_while(|c| c.is_ascii_lowercase() || *c == '-').collect()
        };
        let mut all: Vec<_> = text.split("--").skip(1).map(name).collect();
        all.retain(|option| !option.is_empty() && option != "help" && option != "release");
        all.sort();
        all.dedup();
        all
    };
    let table: String = README.lines().filter(|line| line.starts_with("| `-")).collect();
    assert_eq!(options(&table), options(&help));
}

#[test]
fn the_scene_files_it_names_are_there_and_the_gate_runs_its_test_command() {
    let mut named = 0;
    for word in README.split(|c: char| c.is_whitespace() || matches!(c, '`' | '(' | ')' | '"')) {
        let file =
            word.starts_with("scenes/") || word.starts_with("docs/") || word.starts_with("models/");
        if file {
            assert!(shots::path(word).exists(), "{word}");
            named += 1;
        }
    }
    assert!(named >= 3);
    let architecture = include_str!("../docs/architecture.md");
    assert!(README.contains("(docs/language.md)") && architecture.contains("(language.md)"));
    let gate = std::fs::read_to_string(shots::path(".ci/run")).unwrap();
    for text in [README, &gate] {
        assert!(text.lines().any(|line| line.trim() == "cargo test"));
    }
}
