//! What `scn lint --format sarif` writes is SARIF 2.1.0: every object that it writes has the
//! properties that the standard asks for, none that it does not know, and values of their types.
//!
//! The table is read off the OASIS standard, section 3 (errata 01), as far as scn writes it; the
//! schema itself is not part of this project, for its terms are not those of free software.
//! `tests/sarif.py` holds a log to it by hand.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::{Value, json};

/// What a property may hold.
#[derive(Clone, Copy)]
enum Is {
    /// Any words, of at least this many bytes.
    Text,
    /// A reference of RFC 3986.
    Uri,
    /// One of these words.
    One(&'static [&'static str]),
    /// A whole number from here on.
    From(i64),
    /// An object of this kind.
    An(&'static str),
    /// So many of that kind at least; `bool`: no two the same.
    Many(&'static str, usize, bool),
}

/// The objects: name, properties that must be there, and those that may.
type Properties = &'static [(&'static str, Is)];
const OBJECTS: &[(&str, Properties, Properties)] = &[
    (
        "log",
        &[("version", Is::One(&["2.1.0"])), ("runs", Is::Many("run", 0, false))],
        &[("$schema", Is::Uri)],
    ),
    (
        "run",
        &[("tool", Is::An("tool"))],
        &[
            ("columnKind", Is::One(&["utf16CodeUnits", "unicodeCodePoints"])),
            ("results", Is::Many("result", 0, false)),
        ],
    ),
    ("tool", &[("driver", Is::An("component"))], &[]),
    (
        "component",
        &[("name", Is::Text)],
        &[("version", Is::Text), ("rules", Is::Many("rule", 0, true))],
    ),
    (
        "rule",
        &[("id", Is::Text)],
        &[("shortDescription", Is::An("multiformat")), ("help", Is::An("multiformat"))],
    ),
    ("multiformat", &[("text", Is::Text)], &[("markdown", Is::Text)]),
    ("message", &[("text", Is::Text)], &[]),
    (
        "result",
        &[("message", Is::An("message"))],
        &[
            ("ruleId", Is::Text),
            ("ruleIndex", Is::From(-1)),
            ("level", Is::One(&["none", "note", "warning", "error"])),
            ("locations", Is::Many("location", 0, false)),
            ("relatedLocations", Is::Many("location", 0, true)),
            ("fixes", Is::Many("fix", 0, true)),
        ],
    ),
    ("location", &[], &[("physicalLocation", Is::An("physical")), ("message", Is::An("message"))]),
    ("physical", &[("artifactLocation", Is::An("artifact"))], &[("region", Is::An("region"))]),
    ("artifact", &[], &[("uri", Is::Uri)]),
    (
        "region",
        &[],
        &[
            ("startLine", Is::From(1)),
            ("startColumn", Is::From(1)),
            ("endLine", Is::From(1)),
            ("endColumn", Is::From(1)),
        ],
    ),
    (
        "fix",
        &[("artifactChanges", Is::Many("change", 1, true))],
        &[("description", Is::An("message"))],
    ),
    (
        "change",
        &[
            ("artifactLocation", Is::An("artifact")),
            ("replacements", Is::Many("replacement", 1, false)),
        ],
        &[],
    ),
    (
        "replacement",
        &[("deletedRegion", Is::An("region"))],
        &[("insertedContent", Is::An("content"))],
    ),
    ("content", &[], &[("text", Is::Text)]),
];

/// What is wrong with a value that is to be an object of this kind.
fn wrong(value: &Value, kind: &str, place: &str, found: &mut Vec<String>) {
    let (_, must, may) = OBJECTS.iter().find(|(name, ..)| *name == kind).expect(kind);
    let Some(object) = value.as_object() else {
        return found.push(format!("{place} is no object"));
    };
    for (name, _) in must.iter().filter(|(name, _)| !object.contains_key(*name)) {
        found.push(format!("{place} lacks {name}"));
    }
    for (name, value) in object {
        let place = format!("{place}.{name}");
        match must.iter().chain(*may).find(|(known, _)| known == name) {
            None => found.push(format!("{place} is not of the standard")),
            Some((_, is)) => held(value, *is, &place, found),
        }
    }
}

fn held(value: &Value, is: Is, place: &str, found: &mut Vec<String>) {
    let good = match is {
        Is::Text => value.is_string(),
        Is::Uri => value.as_str().is_some_and(|text| {
            !text.is_empty()
                && text
                    .bytes()
                    .all(|b| b.is_ascii_alphanumeric() || b"-._~:/?#@!$&'()*+,;=%".contains(&b))
        }),
        Is::One(words) => value.as_str().is_some_and(|word| words.contains(&word)),
        Is::From(least) => value.as_i64().is_some_and(|number| number >= least),
        Is::An(kind) => return wrong(value, kind, place, found),
        Is::Many(kind, least, unique) => {
            let Some(all) = value.as_array() else {
                return found.push(format!("{place} is no array"));
            };
            for (i, value) in all.iter().enumerate() {
                wrong(value, kind, &format!("{place}[{i}]"), found);
            }
            let twice = |i: usize| all[..i].contains(&all[i]);
            all.len() >= least && !(unique && (1..all.len()).any(twice))
        }
    };
    if !good {
        found.push(format!("{place} cannot be {value:.80}"));
    }
}

fn scenes(folder: &Path, all: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            scenes(&path, all);
        } else if path.extension().is_some_and(|ending| ending == "scn") {
            all.push(path);
        }
    }
}

/// What is told of all scenes of the suite, and of a file that is not there.
fn log() -> Value {
    let mut files = vec![PathBuf::from("none such é.scn")];
    scenes(Path::new("tests/suite"), &mut files);
    let mut command = Command::new(env!("CARGO_BIN_EXE_scn"));
    let output = command.args(["lint", "--format", "sarif"]).args(&files).output().unwrap();
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn what_is_written_is_sarif() {
    let mut log = log();
    let mut found = Vec::new();
    wrong(&log, "log", "log", &mut found);
    assert!(found.is_empty(), "{found:#?}");
    let run = &log["runs"][0];
    let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
    let results = run["results"].as_array().unwrap();
    assert!(results.len() > 300, "{}", results.len());
    for result in results {
        let rule = &rules[result["ruleIndex"].as_u64().unwrap() as usize];
        assert_eq!(rule["id"], result["ruleId"]);
        for location in result["locations"].as_array().into_iter().flatten() {
            let region = &location["physicalLocation"]["region"];
            let at = |line: &str, column: &str| (region[line].as_u64(), region[column].as_u64());
            assert!(at("startLine", "startColumn") <= at("endLine", "endColumn"), "{result:#}");
        }
    }
    // Everything that is ever written was written.
    for key in ["relatedLocations", "fixes", "locations"] {
        assert!(results.iter().any(|result| result.get(key).is_some()), "{key}");
    }

    let result = log["runs"][0]["results"][0].as_object_mut().unwrap();
    result.remove("message");
    result.insert("levels".into(), json!("error"));
    result.insert("ruleIndex".into(), json!(-2));
    let mut found = Vec::new();
    wrong(&log, "log", "log", &mut found);
    assert_eq!(found.len(), 3, "{found:#?}");
}
