//! What should be known beside the figures: files that tell different things of themselves, and
//! comparisons that mean less than they seem to.

use super::report::brief;
use super::{Comparison, input::Input};
use crate::cli::words::NAMES;
use crate::diag::harmless_text;
use crate::diag::words::few;
use crate::files;

/// What differs from picture to picture without telling why the pictures do.
const SILENT: [&str; 2] = ["scn:time", "scn:caption"];

/// Figures whose ε differ by more than this factor are told to be different.
const OTHER_EPSILON: f64 = 2.0;

/// Values longer than this, in characters, are cut in tables.
const LONGEST_VALUE: usize = 24;

/// A key with what each file says under it, the reference last; `None` where it says nothing.
pub struct Difference<'a> {
    pub key: &'a str,
    pub values: Vec<Option<&'a str>>,
}

/// The keys of ours under which the files say different things, in the first file's order.
pub fn differences<'a>(inputs: &[&'a Input]) -> Vec<Difference<'a>> {
    let mut keys: Vec<&str> = Vec::new();
    for (key, _) in inputs.iter().flat_map(|input| &input.words) {
        if key.starts_with("scn:")
            && !SILENT.contains(&key.as_str())
            && !keys.contains(&key.as_str())
        {
            keys.push(key);
        }
    }
    let all = keys.into_iter().map(|key| {
        let values = inputs.iter().map(|input| input.word(key)).collect();
        Difference { key, values }
    });
    all.filter(|it| it.values.iter().any(|value| *value != it.values[0])).collect()
}

/// Sentences on what the figures may not show.
pub fn notes(comparison: &Comparison) -> Vec<String> {
    let reference = comparison.reference;
    let mut notes = Vec::new();
    let of_all = |layer: &&String| {
        *layer != "error" && comparison.tests.iter().all(|it| it.input.layers.contains(layer))
    };
    let layers: Vec<&str> = reference.layers.iter().filter(of_all).map(String::as_str).collect();
    if comparison.layer.is_none() && !layers.is_empty() {
        notes.push(format!(
            "all light is compared; --layer NAME compares a layer: {}.",
            harmless(&few(layers, NAMES))
        ));
    }
    for judged in &comparison.tests {
        let input = judged.input;
        let both = |key| input.word(key).zip(reference.word(key));
        let (a, b) = (&input.name, &reference.name);
        if files::regular::identity(&input.path) == files::regular::identity(&reference.path) {
            notes.push(format!("{a} and its reference are the same file."));
            continue;
        }
        let equal = |key| both(key).map(|(x, y)| x == y);
        // What samples depend on; where a file does not tell it, all that its scene is.
        let same_light = equal("scn:light_hash").or(equal("scn:hash")) == Some(true);
        let same_scene = equal("scn:hash") != Some(false);
        if !same_scene {
            let same_file = both("scn:scene").filter(|(x, y)| x == y);
            let renders = both("scn:render").filter(|(x, y)| x != y);
            match same_file.zip(renders) {
                Some(((file, _), (x, y))) => notes.push(format!(
                    "{a} and {b} are other renders of the same file, {}: {} and {}.",
                    harmless(file),
                    harmless(x),
                    harmless(y),
                )),
                None if same_light => {}
                None => notes.push(format!(
                    "{a} and {b} are of different scenes, or of one that was changed between them."
                )),
            }
        }
        let radiance = input.radiance == reference.radiance;
        if radiance && same_light && equal("scn:seed") == Some(true) {
            let what = match same_scene {
                true => "are of one scene and one seed",
                false => "have one seed, and differ in nothing that samples depend on",
            };
            notes.push(format!(
                "{a} and {b} {what}: they may share random numbers, and then their noise is alike \
                 and the error shown too small. Render the reference with another --seed."
            ));
        }
        let count = |input: &Input| input.word("scn:samples").and_then(|n| n.parse::<u64>().ok());
        if count(reference).zip(count(input)).is_some_and(|(few, own)| few < own) {
            notes.push(format!(
                "{b} has fewer samples than {a}: what is shown is rather the reference's error."
            ));
        }
        let used = comparison.settings.epsilon;
        let other = |own: &f64| !(1.0 / OTHER_EPSILON..=OTHER_EPSILON).contains(&(own / used));
        if let Some(own) = input.epsilon().filter(other) {
            notes.push(format!(
                "the error that {a} states has ε = {}, and relmse here {}: they are \
                 different figures. --epsilon own takes the one of the file.",
                brief(own),
                brief(used)
            ));
        }
        if input.radiance != reference.radiance {
            notes.push(format!(
                "one of {a} and {b} is a PNG: exposed, clipped to what a display shows and rounded \
                 to eight bits. Compare EXR files to measure radiance."
            ));
        }
    }
    notes
}

/// The text on one line, without characters that would move a terminal's cursor or change its
/// colours.
pub fn harmless(text: &str) -> String {
    harmless_text(text).replace(['\n', '\t'], " ")
}

/// A value fit for a table.
pub fn short(value: &str) -> String {
    let value = harmless(value);
    // Numbers are told as exactly as they are read: `1.2345678901234567e-2,0e0`.
    let numbers: Option<Vec<f64>> = value.split(',').map(|part| part.parse().ok()).collect();
    let value = match numbers {
        Some(numbers) if value.contains(['.', 'e']) => {
            numbers.into_iter().map(brief).collect::<Vec<_>>().join(" ")
        }
        _ => value,
    };
    if value.chars().count() <= LONGEST_VALUE {
        return value;
    }
    let start: String = value.chars().take(LONGEST_VALUE - 1).collect();
    format!("{start}…")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_as_long_as_people_read_them() {
        for (value, text) in [
            ("5.8541391208401954e-2", "0.05854"),
            ("0e0,1.109491687627513e-1", "0 0.1109"),
            ("208", "208"),
            ("a,b.c", "a,b.c"),
            ("3e5c0d01c82f5ab8c1e2aa00", "3e5c0d01c82f5ab8c1e2aa00"),
            ("1e5", "100000"),
            ("0123456789012345678901234", "01234567890123456789012…"),
        ] {
            assert_eq!(short(value), text);
        }
    }
}
