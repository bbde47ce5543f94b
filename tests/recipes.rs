//! The recipes in docs/: their scenes and files, put where the page says, are beyond doubt, in the
//! style, and make pictures; their commands end as shown.
//!
//! Blocks are "```scn NAME" and "```file NAME", and "```console" with lines `$ scn …`; below a
//! line `$ echo $?` stands the status of the command before. What is in `scenes/` is read as if it
//! stood there; all else has a folder of its own, one a page.

use std::path::{Path, PathBuf};
use std::process::Command;

use scn::cli;
use scn::diag::{Sources, print};
use scn::lang;

mod shots;

/// A side of a picture here, as a part of its full one.
const SCALE: f64 = 1.0 / 16.0;

/// What stands after the backticks of a block, and its text.
type Block = (String, String);

/// The pages that have recipes.
fn pages() -> Vec<(PathBuf, Vec<Block>)> {
    let mut all = Vec::new();
    for entry in std::fs::read_dir(shots::path("docs")).unwrap() {
        let page = entry.unwrap().path();
        if page.extension().is_none_or(|ending| ending != "md") {
            continue;
        }
        let text = std::fs::read_to_string(&page).unwrap();
        let fences = text.split("\n```").skip(1).step_by(2);
        let blocks = fences.filter_map(|fence| fence.split_once('\n'));
        let ours = |info: &str| {
            let named = info.strip_prefix("scn ").is_some_and(|name| name.ends_with(".scn"));
            named || info.starts_with("file ") || info == "console"
        };
        let blocks = blocks.filter(|(info, _)| ours(info));
        let blocks: Vec<Block> =
            blocks.map(|(info, text)| (info.to_string(), format!("{text}\n"))).collect();
        if !blocks.is_empty() {
            all.push((page, blocks));
        }
    }
    all
}

/// A folder with the files of a page.
fn folder(blocks: &[Block]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (info, text) in blocks {
        if let Some((_, name)) = info.split_once(' ')
            && !name.starts_with("scenes/")
        {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
    }
    folder
}

fn scene_is_right(path: &Path, text: &str) {
    let mut sources = Sources::new();
    let found = cli::check(path, text, &[], &mut sources).found;
    let report = print::report(&found, &sources, "it", print::Look::PLAIN);
    assert!(report.is_empty(), "{text}\n{report}");
    let id = sources.add("scene.scn", text);
    let styled = lang::format::format(text, id).expect("no faults of syntax");
    assert_eq!(styled, text, "`scn fmt` would change it");
    for shot in shots::open_text(path, text, &[]).unwrap_or_else(|report| panic!("{report}")) {
        let picture = shot.picture(&shot.prepare(SCALE), 0);
        assert!(picture.pixels.iter().any(|pixel| pixel.g > 0.0), "{} is black", shot.name);
    }
}

#[test]
fn scenes_are_beyond_doubt_and_make_pictures() {
    let mut scenes = 0;
    for (_, blocks) in pages() {
        let folder = folder(&blocks);
        for (info, text) in &blocks {
            let Some(name) = info.strip_prefix("scn ") else { continue };
            let at_home = name.starts_with("scenes/");
            let path = if at_home { shots::path(name) } else { folder.path().join(name) };
            scene_is_right(&path, text);
            scenes += 1;
        }
    }
    assert!(scenes >= 6, "{scenes}");
}

/// The words of a command line; single quotes keep blanks together.
fn words(line: &str) -> Vec<String> {
    let mut all = Vec::new();
    for (i, part) in line.split('\'').enumerate() {
        match i % 2 {
            0 => all.extend(part.split_whitespace().map(str::to_string)),
            _ => all.push(part.to_string()),
        }
    }
    all
}

#[test]
fn commands_end_as_shown() {
    let mut judged = 0;
    for (page, blocks) in pages() {
        let folder = folder(&blocks);
        for (_, text) in blocks.iter().filter(|(info, _)| info == "console") {
            let mut status = None;
            let mut lines = text.lines();
            while let Some(line) = lines.next() {
                if line == "$ echo $?" {
                    assert_eq!(status.map(|s: i32| s.to_string()).as_deref(), lines.next());
                    judged += 1;
                    continue;
                }
                let command = line.strip_prefix("$ scn ").expect("a command of scn");
                let mut run = Command::new(env!("CARGO_BIN_EXE_scn"));
                let output = run.current_dir(folder.path()).args(words(command)).output().unwrap();
                status = output.status.code();
                let error = String::from_utf8_lossy(&output.stderr);
                assert!(matches!(status, Some(0 | 1)), "{}: {line}\n{error}", page.display());
            }
        }
    }
    assert!(judged >= 3, "{judged}");
}
