//! Every citation, such as `[Woop13]`, is in docs/references.bib, and every entry there is cited.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Keys of citations in a text, among what brackets hold between commas: a capital, letters, and
/// two digits.
fn cited(text: &str) -> BTreeSet<String> {
    let is_key = |word: &&str| {
        let name = word.trim_end_matches(|c: char| c.is_ascii_digit());
        word.len() == name.len() + 2
            && name.len() > 1
            && name.starts_with(|c: char| c.is_ascii_uppercase())
            && name.bytes().all(|b| b.is_ascii_alphabetic())
    };
    let brackets = text.split('[').skip(1).filter_map(|rest| rest.split_once(']'));
    let words = brackets.flat_map(|(inside, _)| inside.split(',').map(str::trim));
    words.filter(is_key).map(str::to_string).collect()
}

fn files(folder: &Path, endings: &[&str], found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, endings, found);
        } else if path.extension().is_some_and(|e| endings.iter().any(|ending| e == *ending)) {
            found.push(path);
        }
    }
}

#[test]
fn every_citation_has_an_entry_and_every_entry_is_cited() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let library = fs::read_to_string(root.join("docs/references.bib")).unwrap();
    let entries: BTreeSet<String> = library
        .lines()
        .filter(|line| line.starts_with('@'))
        .map(|line| line.split_once('{').unwrap().1.trim_end_matches(',').to_string())
        .collect();

    let mut places = vec![root.join("README.md")];
    for folder in ["src", "docs", "examples", "models", "scenes"] {
        files(&root.join(folder), &["rs", "md", "scn"], &mut places);
    }
    let mut all = BTreeSet::new();
    let mut missing = Vec::new();
    for place in places {
        for key in cited(&fs::read_to_string(&place).unwrap()) {
            if !entries.contains(&key) {
                missing.push(format!("{}: [{key}]", place.display()));
            }
            all.insert(key);
        }
    }
    assert!(missing.is_empty(), "not in docs/references.bib:\n{}", missing.join("\n"));
    let unused: Vec<_> = entries.difference(&all).collect();
    assert!(unused.is_empty(), "in docs/references.bib, but cited nowhere: {unused:?}");
}

#[test]
fn citations_are_told_from_other_brackets() {
    let found =
        cited("[Woop13], [Turk94, sec. 2, Jung20]; not [f32; 3], [A1], [Woop2013], a[B12x]");
    assert_eq!(found.into_iter().collect::<Vec<_>>(), ["Jung20", "Turk94", "Woop13"]);
}
