//! The scenes of the project against the linter: what fires on good practice is a faulty rule.

use std::path::{Path, PathBuf};

use scn::cli;
use scn::diag::{self, Sources};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The report of what is found in a text; empty if nothing is.
fn told(path: &Path, text: &str) -> String {
    let mut sources = Sources::new();
    let found = cli::check(path, text, &[], &mut sources).found;
    diag::print::report(&found, &sources, &path.to_string_lossy(), diag::print::Look::PLAIN)
}

fn scenes(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            scenes(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "scn") {
            found.push(path);
        }
    }
}

#[test]
fn shipped_scenes_are_beyond_doubt() {
    let mut all = Vec::new();
    scenes(&root().join("scenes"), &mut all);
    assert!(all.len() >= 3);
    for path in all {
        let report = told(&path, &std::fs::read_to_string(&path).unwrap());
        assert!(report.is_empty(), "{report}");
    }
}

#[test]
fn scenes_of_the_readme_are_beyond_doubt() {
    let text = std::fs::read_to_string(root().join("README.md")).unwrap();
    let scenes: Vec<_> = text.split("```scn\n").skip(1).collect();
    assert!(scenes.len() >= 3);
    for scene in scenes {
        let scene = scene.split("```").next().unwrap();
        let report = told(&root().join("example.scn"), scene);
        assert!(report.is_empty(), "{scene}\n{report}");
    }
}
