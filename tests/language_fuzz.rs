//! Texts that are wrong on purpose: whatever is done to a scene, it is read without a panic, what
//! is broken is told, and told where it is.

use std::path::{Path, PathBuf};

use proptest::prelude::*;
use scn::cli::Disk;
use scn::diag::{Diagnostic, FileId, Level, Sources};
use scn::lang;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Scenes without a fault: those that are shipped, and the good ones of the suite.
fn scenes() -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    for folder in ["scenes", "scenes/lib", "tests/suite/good"] {
        for entry in std::fs::read_dir(root().join(folder)).unwrap() {
            let path = entry.unwrap().path();
            // Where the layout says nothing, nothing can be told from it.
            let plain = !path.ends_with("layout.scn");
            if plain && path.extension().is_some_and(|e| e == "scn") {
                found.push((path.clone(), std::fs::read_to_string(&path).unwrap()));
            }
        }
    }
    found.sort();
    assert!(found.len() >= 4);
    found
}

fn told(path: &Path, text: &str) -> (Vec<Diagnostic>, Sources) {
    let mut sources = Sources::new();
    let compiled = lang::compile(path, text, &[], &[], &Disk, &mut sources);
    for told in &compiled.diagnostics {
        assert!(!told.headline.is_empty());
        for label in &told.labels {
            // Every place is one of a text, and can be shown.
            let source = sources.get(label.span.file);
            assert!(source.text.get(label.span.range()).is_some(), "{told:?}");
        }
        for edit in told.mends.iter().flat_map(|mend| &mend.edits) {
            let source = sources.get(edit.span.file);
            assert!(source.text.get(edit.span.range()).is_some(), "{told:?}");
        }
    }
    (compiled.diagnostics, sources)
}

/// Characters of structure outside of comments and strings, the quotes of strings included.
fn structure(text: &str) -> Vec<(usize, char)> {
    let (mut quoted, mut comment) = (false, false);
    let mut found = Vec::new();
    for (at, c) in text.char_indices() {
        match c {
            '\n' => comment = false,
            _ if comment => {}
            '"' => {
                quoted = !quoted;
                found.push((at, c));
            }
            _ if quoted => {}
            '/' if text[at..].starts_with("//") => comment = true,
            '(' | ')' | '[' | ']' | '{' | '}' | ':' => found.push((at, c)),
            _ => {}
        }
    }
    found
}

#[test]
fn a_missing_character_of_structure_is_told_within_a_line_of_it() {
    let (mut all, mut near, mut lost) = (0, 0, Vec::new());
    for (path, text) in scenes() {
        for (at, c) in structure(&text) {
            let mut broken = text.clone();
            broken.remove(at);
            let (told, sources) = told(&path, &broken);
            let line = text[..at].matches('\n').count() + 1;
            all += 1;
            let hit = |told: &Diagnostic| {
                told.labels.iter().any(|label| {
                    let here = label.span.file == FileId(0);
                    here && sources.line_column(label.span).0.abs_diff(line) <= 1
                })
            };
            // A colon before a base is not missed: without it the words are something else.
            if told.iter().any(hit) {
                near += 1;
            } else {
                let name = path.file_name().unwrap().to_string_lossy().to_string();
                lost.push(format!("{name}:{line} `{c}` told {}", told.len()));
            }
        }
    }
    assert!(all > 250, "{all}");
    assert!(near * 100 >= all * 98, "{near} of {all}:\n{}", lost.join("\n"));
}

#[test]
fn a_missing_bracket_costs_few_reports() {
    let (mut brackets, mut reports, mut worst) = (0, 0, (0, String::new()));
    for (path, text) in scenes() {
        for (at, c) in structure(&text).into_iter().filter(|(_, c)| *c != ':') {
            let mut broken = text.clone();
            broken.remove(at);
            let count = told(&path, &broken).0.len();
            brackets += 1;
            reports += count;
            if count > worst.0 {
                let line = text[..at].matches('\n').count() + 1;
                worst = (count, format!("{}:{line} `{c}`", path.display()));
            }
        }
    }
    let mean = reports as f64 / brackets as f64;
    assert!(mean < 1.5, "{mean} reports a bracket; {worst:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_read(text in "\\PC{0,200}") {
        told(Path::new("scene.scn"), &text);
    }

    #[test]
    fn any_words_and_signs_are_read(
        words in prop::collection::vec(
            prop::sample::select(vec![
                "scn 1 in m\n", "integrator", "film", "object", "material", "a", "b", "{", "}",
                "(", ")", "[", "]", ":", ",", ".", "=", "+", "-", "*", "/", "^", "\"", "\n", "1",
                "2 m", "3 deg", "12:30", "to", "step", "with", "use", "let", "for", "in", "setup",
                "render", "without", "rgb(1, 2, 3)", "sphere", "//", "\"{a}\"", "%", "W",
            ]),
            0..60,
        ),
    ) {
        told(Path::new("scene.scn"), &format!("scn 1 in m\n{}", words.join(" ")));
    }

    #[test]
    fn a_mutated_scene_is_read(
        which in any::<prop::sample::Index>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<char>(), 0..3_usize), 1..6),
    ) {
        let scenes = scenes();
        let (path, text) = &scenes[which.index(scenes.len())];
        let mut chars: Vec<char> = text.chars().collect();
        for (at, c, how) in changes {
            let at = at.index(chars.len());
            match how {
                0 => { chars.remove(at); }
                1 => chars.insert(at, c),
                _ => chars[at] = c,
            }
        }
        told(path, &chars.into_iter().collect::<String>());
    }
}

#[test]
fn texts_made_to_exhaust_the_reader_are_refused_quickly() {
    let deep = |open: &str, close: &str, n: usize| {
        format!("scn 1 in m\nintegrator: preview\nlet a = {}1{}\n", open.repeat(n), close.repeat(n))
    };
    let chain: String = (0..20_000).map(|i| format!("let a{i} = a{}\n", i + 1)).collect();
    let loops = (0..40).fold(String::new(), |s, i| format!("{s}for v{i} in 1 to 9 {{"));
    let texts = [
        deep("(", ")", 64),
        deep("[", "]", 64),
        deep("{ a: ", "}", 63),
        deep("(", ")", 200_000),
        deep("[", "", 200_000),
        deep("- ", "", 200_000),
        deep("f(", ")", 64),
        format!("scn 1 in m\nlet a = 1{}\n", " + 1".repeat(300_000)),
        format!("scn 1 in m\ncaption: \"{{{}\"\n", "(".repeat(100_000)),
        format!("scn 1 in m\n{chain}\nfilm.exposure: a0\n"),
        format!("scn 1 in m\n{loops}{}\n", "}".repeat(40)),
        "scn 1 in m\nlet f(a) = f(a)\nfilm.exposure: f(1)\n".to_string(),
        "scn 1 in m\nlet f(a) = [a, a]\nlet b = f(f(f(f(f(f(f(f(f(f(f(f(f(f(f(f(f(f(f(f(f(f(f(f(f(f(1))))))))))))))))))))))))))\ncaption: b\n".to_string(),
        format!("scn 1 in m\n{}\n", "}".repeat(100_000)),
        format!("scn 1 in m\n{}\n", "\"".repeat(100_001)),
    ];
    for text in texts {
        told(Path::new("scene.scn"), &text);
    }
}

/// Ends of lines outside of brackets, comments and strings, where an item ends.
fn between_items(text: &str) -> Vec<usize> {
    let marks = structure(text);
    let mut found = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let end = start + line.trim_end().len();
        let open = |c: char| "([{".contains(c) as i64 - ")]}".contains(c) as i64;
        let before = marks.iter().take_while(|(at, _)| *at < end);
        let depth: i64 = before.map(|(_, c)| open(*c)).sum();
        if depth == 0 && !line.contains("//") && !line.trim().is_empty() {
            found.push(end);
        }
        start += line.len();
    }
    found
}

#[test]
fn nothing_after_an_item_is_passed_over() {
    let junk = ["# yes", "yes", "32", "$$$", "\"hello\"", "(1, 2)", "[3]", "==", "%%", "! x: 1"]
        .into_iter()
        .chain(["& y", "°", "é", "; ;", "?", "@a", "1..3", "'x'", "~", "|", "\\", "`"]);
    for (path, text) in scenes() {
        let ends = between_items(&text);
        assert!(!ends.is_empty(), "{}", path.display());
        for (i, junk) in junk.clone().enumerate() {
            // Each junk at some of the places, so that all places have some.
            for end in ends.iter().skip(i % 3).step_by(3) {
                let changed = format!("{} {junk}{}", &text[..*end], &text[*end..]);
                let (told, _) = told(&path, &changed);
                let errors = told.iter().filter(|told| told.level == Level::Error).count();
                assert!(errors > 0, "{} byte {end}: `{junk}` is not told", path.display());
            }
        }
    }
}
