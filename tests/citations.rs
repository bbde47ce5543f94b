//! Every citation, such as `[Woop13]`, is in docs/references.bib, and every entry there is cited.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Keys of citations in a text: a capital, letters, two digits; after `[`, and before `]` or `,`.
fn cited(text: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for (at, _) in text.match_indices('[') {
        let rest = &text[at + 1..];
        let name = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        let digits = rest[name..].bytes().take_while(u8::is_ascii_digit).count();
        let ends = rest[name + digits..].starts_with([']', ',']);
        let capital = rest.starts_with(|c: char| c.is_ascii_uppercase());
        if capital && name > 1 && digits == 2 && ends {
            found.insert(rest[..name + 2].to_string());
        }
    }
    found
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
    let found = cited("[Woop13] and [Turk94, sec. 2], not [f32; 3], [A1], [Woop2013] or a[B12x]");
    assert_eq!(found.into_iter().collect::<Vec<_>>(), ["Turk94", "Woop13"]);
}
