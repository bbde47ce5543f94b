//! Who may know whom: the table of docs/architecture.md, as a test.

use std::fs;
use std::path::{Path, PathBuf};

/// Room, and the rooms it may name. A room missing here may name nothing.
const MAY_NAME: &[(&str, &[&str])] = &[
    (
        "cli",
        &[
            "run", "prepare", "load", "lang", "measure", "files", "render", "scene", "diag",
            "data", "math",
        ],
    ),
    ("run", &["render", "measure", "files", "math"]),
    ("prepare", &["load", "scene", "render", "diag", "data", "math"]),
    ("load", &["scene", "files", "diag", "data", "math"]),
    ("lang", &["scene", "diag", "data", "math"]),
    ("scene", &["diag", "data", "math"]),
    ("render", &["math"]),
    ("measure", &["math"]),
    ("files", &["math"]),
    ("diag", &[]),
    ("math", &[]),
];

/// External crate, and the only places that may name it.
const QUARANTINE: &[(&str, &[&str])] = &[
    ("pest", &["lang/parse"]),
    ("pest_derive", &["lang/parse"]),
    ("miette", &["diag/print"]),
    ("tobj", &["files"]),
    ("image", &["files"]),
    ("png", &["files"]),
    ("exr", &["files"]),
    ("tempfile", &["files"]),
    ("puruspe", &["measure"]),
    ("obvhs", &["render/geometry"]),
    ("rayon", &["render", "prepare", "load", "files"]),
    ("clap", &["cli"]),
    ("indicatif", &["cli"]),
    ("ctrlc", &["cli"]),
    ("rustix", &["cli", "files"]),
    ("std::fs", &["files"]),
    ("std::time", &["cli"]),
    ("std::env", &["cli"]),
    ("println!", &["cli", "main"]),
    ("eprintln!", &["cli", "main"]),
    ("print!", &["cli", "main"]),
    ("eprint!", &["cli", "main"]),
];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// Where `word` stands in `line` as a whole path segment.
fn names(line: &str, word: &str) -> bool {
    line.match_indices(word).any(|(at, _)| {
        let before = line[..at].chars().next_back();
        let after = line[at + word.len()..].chars().next();
        let inside = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
        !inside(before) && !inside(after)
    })
}

/// The rooms a line names after `crate::`, braces included: `use crate::{diag, math::Rgb};`.
fn rooms_named(line: &str) -> Vec<String> {
    let word = |text: &str| -> String {
        text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
    };
    let mut found = Vec::new();
    for (at, start) in line.match_indices("crate::") {
        let rest = &line[at + start.len()..];
        if let Some(list) = rest.strip_prefix('{') {
            let mut depth = 0;
            let mut fresh = true;
            for (i, c) in list.char_indices() {
                match c {
                    '{' => depth += 1,
                    '}' if depth == 0 => break,
                    '}' => depth -= 1,
                    ',' if depth == 0 => fresh = true,
                    c if fresh && depth == 0 && c.is_alphabetic() => {
                        found.push(word(&list[i..]));
                        fresh = false;
                    }
                    _ => {}
                }
            }
        } else {
            found.push(word(rest));
        }
    }
    found
}

/// Source without comments and without line breaks inside `use` items.
fn statements(text: &str) -> Vec<(usize, String)> {
    let mut all: Vec<(usize, String)> = Vec::new();
    let mut open = false;
    for (number, line) in text.lines().enumerate() {
        let code = line.split("//").next().unwrap_or("").trim().to_string();
        if open {
            all.last_mut().unwrap().1.push_str(&code);
        } else {
            all.push((number + 1, code.clone()));
        }
        let starts = all.last().unwrap().1.trim_start_matches("pub ").starts_with("use ");
        open = starts && !all.last().unwrap().1.contains(';');
    }
    all
}

fn faults(room: &str, place: &str, text: &str) -> Vec<String> {
    let allowed = MAY_NAME.iter().find(|(name, _)| *name == room).map_or(&[][..], |(_, a)| a);
    let known = |name: &str| MAY_NAME.iter().any(|(room, _)| *room == name);
    let mut found = Vec::new();
    for (line, code) in statements(text) {
        for named in rooms_named(&code) {
            if known(&named) && named != room && !allowed.contains(&named.as_str()) {
                found.push(format!("src/{place}:{line}: {room} must not know {named}"));
            }
        }
        for (what, places) in QUARANTINE {
            let mention = what.ends_with('!') || what.contains("::");
            let hit = if mention {
                names(&code, what)
            } else {
                names(&code, &format!("{what}::")) && !names(&code, &format!("crate::{what}"))
            };
            let hit =
                hit || (!mention && code.contains(&format!("{what}::")) && names(&code, what));
            if hit && !places.iter().any(|p| place.starts_with(p)) {
                found.push(format!("src/{place}:{line}: {what} is kept in {places:?}"));
            }
        }
    }
    found
}

#[test]
fn every_room_knows_only_those_below_it() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&root, &mut files);
    let mut found = Vec::new();
    for path in files {
        let place = path.strip_prefix(&root).unwrap().to_str().unwrap().replace('\\', "/");
        let room = place.split(['/', '.']).next().unwrap();
        if matches!(room, "lib" | "main") {
            continue;
        }
        found.extend(faults(room, &place, &fs::read_to_string(&path).unwrap()));
    }
    assert!(found.is_empty(), "\n{}", found.join("\n"));
}

#[test]
fn a_planted_import_is_found() {
    let text = "//! x\nuse crate::scene::Scene;\nuse crate::{\n    diag,\n    math::Rgb,\n};\nuse exr::prelude;\n";
    let found = faults("render", "render/film.rs", text);
    assert_eq!(found.len(), 3, "{found:?}");
    assert!(found[0].starts_with("src/render/film.rs:2: render must not know scene"));
    assert!(found[2].contains("exr is kept in"));
    assert!(faults("files", "files/exr.rs", "use exr::prelude;").is_empty());
    assert!(faults("render", "render/film.rs", "// crate::scene is not named here").is_empty());
}
