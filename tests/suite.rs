//! Compiles every scene of tests/suite and compares what is told with the annotations in it;
//! tests/suite/README.md says how they are written.

mod common;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use common::show;
use scn::cli::Disk;
use scn::diag::{Level, Sources};
use scn::lang;

/// What an annotation expects: line, code, part of the headline.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Expected {
    file: String,
    line: usize,
    code: String,
    headline: String,
}

fn annotations(name: &str, text: &str) -> Vec<Expected> {
    let mut found = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let Some((_, note)) = line.split_once("//~") else { continue };
        let up = note.chars().take_while(|c| *c == '^').count();
        for one in note[up..].split(';') {
            let (code, headline) = one.split_once(':').unwrap_or((one, ""));
            found.push(Expected {
                file: name.to_string(),
                line: i + 1 - up,
                code: code.trim().to_string(),
                headline: headline.trim().to_string(),
            });
        }
    }
    found
}

/// Arguments of `--set`, each on a line that begins with `//$ `.
fn sets(text: &str) -> Vec<String> {
    text.lines().filter_map(|line| line.strip_prefix("//$ ")).map(str::to_string).collect()
}

/// Names of renders expected, on a line that begins with `//= `.
fn renders(text: &str) -> Option<Vec<String>> {
    let line = text.lines().find_map(|line| line.strip_prefix("//="))?;
    let names = line.split(',').map(str::trim).filter(|name| !name.is_empty());
    Some(names.map(str::to_string).collect())
}

fn faults(path: &Path) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let mut sources = Sources::new();
    let compiled = lang::compile(path, &text, &sets(&text), &[], &Disk, &mut sources);
    let mut expected: BTreeMap<String, Vec<Expected>> = BTreeMap::new();
    for id in 0..sources_count(&compiled, &sources) {
        let source = sources.get(scn::diag::FileId(id as u32));
        expected.entry(source.name.to_string()).or_insert(annotations(&source.name, &source.text));
    }
    let mut open: Vec<Expected> = expected.into_values().flatten().collect();
    let mut report = String::new();
    for told in &compiled.diagnostics {
        let (file, line) = match told.place() {
            Some(span) => (sources.get(span.file).name.to_string(), sources.line_column(span).0),
            None => (String::new(), 0),
        };
        let at_set = file == "--set";
        let hit = open.iter().position(|e| {
            let place = at_set || (e.file == file && e.line == line);
            place && e.code == told.code.name && told.headline.contains(&e.headline)
        });
        match hit {
            Some(hit) => {
                open.remove(hit);
            }
            None => writeln!(report, "not expected:\n{}", show(told, &sources)).unwrap(),
        }
    }
    for missed in open {
        writeln!(report, "not told: {missed:?}").unwrap();
    }
    let errors = compiled.diagnostics.iter().any(|told| told.level == Level::Error);
    if let Some(expected) = renders(&text) {
        let found: Vec<_> = compiled.renders.iter().map(|r| r.name.value.clone()).collect();
        if found != expected {
            writeln!(report, "renders {found:?}, not {expected:?}").unwrap();
        }
    } else if !errors && compiled.renders.is_empty() {
        writeln!(report, "no error and no render").unwrap();
    }
    report
}

/// How many texts there are: spans lead to the last of them at least.
fn sources_count(compiled: &lang::Compiled, _: &Sources) -> usize {
    let spans = compiled.diagnostics.iter().flat_map(|told| &told.labels);
    spans.map(|label| label.span.file.0 as usize + 1).max().unwrap_or(1)
}

fn scenes(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().to_string();
        if path.is_dir() {
            scenes(&path, found);
        } else if name.ends_with(".scn") && !name.starts_with('_') {
            found.push(path);
        }
    }
}

#[test]
fn every_scene_of_the_suite_is_told_what_it_says() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite");
    let mut all = Vec::new();
    scenes(&root, &mut all);
    all.sort();
    assert!(all.len() >= 40, "{}", all.len());
    let mut report = String::new();
    for path in all {
        let faults = faults(&path);
        if !faults.is_empty() {
            writeln!(report, "--- {}\n{faults}", path.strip_prefix(&root).unwrap().display())
                .unwrap();
        }
    }
    assert!(report.is_empty(), "\n{report}");
}
