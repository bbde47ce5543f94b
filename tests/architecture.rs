//! Who may know whom: the tables of docs/architecture.md, held against src/.

use std::fs;
use std::path::{Path, PathBuf};

const DOCUMENT: &str = include_str!("../docs/architecture.md");

/// A row of a table: its first cell, and the words of its second.
type Row = (&'static str, Vec<&'static str>);

/// The rows of the table under a heading of docs/architecture.md. Words stand in backticks.
fn table(heading: &str) -> Vec<Row> {
    let lines = DOCUMENT.lines().skip_while(|line| *line != heading).skip(1);
    let section = lines.take_while(|line| !line.starts_with('#'));
    let words = |cell: &'static str| cell.split('`').skip(1).step_by(2).collect::<Vec<_>>();
    let row = |line: &'static str| {
        let mut cells = line.split('|').skip(1);
        let first = words(cells.next()?).first().copied()?;
        Some((first, words(cells.next()?)))
    };
    section.filter(|line| line.starts_with('|')).filter_map(row).collect()
}

/// Rooms, and the rooms each may name. A room missing there may name nothing.
fn may_name() -> Vec<Row> {
    table("## Who may know whom")
}

/// External crates and the like, and the only places that may name each.
fn quarantine() -> Vec<Row> {
    table("## Who may use what")
}

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

/// Whether a path in `line` begins with the crate `word`; `files::exr::write` is ours.
fn names_crate(line: &str, word: &str) -> bool {
    line.match_indices(&format!("{word}::")).any(|(at, _)| {
        let before = line[..at].chars().next_back();
        !before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == ':')
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
    let rooms = may_name();
    let allowed = rooms.iter().find(|(name, _)| *name == room).map_or(&[][..], |(_, a)| a);
    let known = |name: &str| rooms.iter().any(|(room, _)| *room == name);
    let quarantine = quarantine();
    let mut found = Vec::new();
    for (line, code) in statements(text) {
        for named in rooms_named(&code) {
            if known(&named) && named != room && !allowed.contains(&named.as_str()) {
                found.push(format!("src/{place}:{line}: {room} must not know {named}"));
            }
        }
        for (what, places) in &quarantine {
            let mention = what.ends_with('!') || what.contains("::");
            let hit = if mention { names(&code, what) } else { names_crate(&code, what) };
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
    assert!(faults("cli", "cli/picture.rs", "files::exr::write(path)").is_empty());
    assert_eq!(faults("cli", "cli/picture.rs", "use {exr::prelude, std::fmt};").len(), 1);
    assert!(faults("render", "render/film.rs", "// crate::scene is not named here").is_empty());
}

#[test]
fn the_tables_are_found() {
    assert!(
        may_name().iter().any(|(room, rooms)| *room == "render" && *rooms == ["optics", "math"])
    );
    assert!(may_name().iter().any(|(room, rooms)| *room == "math" && rooms.is_empty()));
    assert!(quarantine().iter().any(|(what, places)| *what == "obvhs" && places.len() == 1));
    assert!(quarantine().len() > 15);
}

#[test]
fn every_room_has_a_row() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for entry in fs::read_dir(root).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        let known = may_name().iter().any(|(room, _)| *room == name);
        assert!(known || !path.is_dir(), "src/{name} has no row in docs/architecture.md");
    }
}

#[test]
fn every_test_file_has_a_row() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let mut there = Vec::new();
    for entry in fs::read_dir(tests).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        if path.join("main.rs").exists() {
            there.push(format!("tests/{name}/"));
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            there.push(format!("tests/{name}"));
        }
    }
    let section = DOCUMENT.split("\n## Tests\n").nth(1).unwrap();
    let cells = section.lines().filter_map(|line| line.strip_prefix('|')?.split('|').next());
    let mut listed: Vec<String> =
        cells.flat_map(|cell| cell.split('`').skip(1).step_by(2).map(str::to_string)).collect();
    there.sort();
    listed.sort();
    assert_eq!(listed, there, "docs/architecture.md lists other tests than there are");
}

#[test]
fn every_crate_of_the_quarantine_is_in_use() {
    let manifest =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml")).unwrap();
    for (what, _) in quarantine() {
        let mention = what.ends_with('!') || what.contains("::");
        let used = manifest.lines().any(|line| line.starts_with(&format!("{what} = ")));
        assert!(mention || used, "docs/architecture.md keeps `{what}`, which is not in Cargo.toml");
    }
}
