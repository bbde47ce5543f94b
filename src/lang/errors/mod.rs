//! The faults of a scene file, one function each, by family.

pub mod import;
pub mod more;
pub mod name;
pub mod paths;
pub mod quantities;
pub mod render;
pub mod spectrum;
pub mod syntax;
pub mod types;
mod unit_tail;

/// Names that are looked at to find the nearest: more than any person wrote.
const CANDIDATES: usize = 2000;

/// The words of `all` that look most like `word`, nearest first; at most three.
pub fn nearest<'w>(word: &str, all: impl IntoIterator<Item = &'w str>) -> Vec<&'w str> {
    let lower = word.to_lowercase();
    let mut found: Vec<(f64, &str)> = all
        .into_iter()
        .take(CANDIDATES)
        .filter(|other| !other.is_empty() && *other != word)
        .map(|other| {
            let other_lower = other.to_lowercase();
            let edits = strsim::damerau_levenshtein(&lower, &other_lower) as f64;
            let longest = lower.chars().count().max(other_lower.chars().count()).max(1) as f64;
            let mut alike = 1.0 - edits / longest;
            let shorter = lower.len().min(other_lower.len());
            if shorter > 2 && (other_lower.contains(&lower) || lower.contains(&other_lower)) {
                alike = alike.max(0.61);
            }
            (alike, other)
        })
        .filter(|(alike, other)| *alike >= 0.5 && !other_short(&lower, &other.to_lowercase()))
        .collect();
    found.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
    found.dedup_by_key(|(_, word)| *word);
    let best = found.first().map_or(0.0, |(alike, _)| *alike);
    found.retain(|(alike, _)| *alike > best - 0.25);
    found.into_iter().map(|(_, word)| word).take(3).collect()
}

/// Short words of the same length with other letters are other words, not the same misspelt.
fn other_short(a: &str, b: &str) -> bool {
    let letters = |word: &str| {
        let mut letters: Vec<char> = word.chars().collect();
        letters.sort_unstable();
        letters
    };
    a.len() == b.len() && a.len() <= 3 && letters(a) != letters(b)
}

/// "`a`, `b` or `c`".
pub fn listed<'w>(words: impl IntoIterator<Item = &'w str>, last: &str) -> String {
    let words: Vec<_> = words.into_iter().map(|word| format!("`{word}`")).collect();
    match words.split_last() {
        None => String::new(),
        Some((only, [])) => only.clone(),
        Some((end, rest)) => format!("{} {last} {end}", rest.join(", ")),
    }
}

/// "a length", "an angle".
pub fn with_article(noun: &str) -> String {
    let vowel = noun.trim_start_matches('`').starts_with(['a', 'e', 'i', 'o', 'u']);
    format!("{} {noun}", if vowel { "an" } else { "a" })
}

/// Several of a kind of declaration.
pub fn plural(kind: &str) -> String {
    match kind {
        "medium" => "media".to_string(),
        _ => format!("{kind}s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_names_are_near() {
        let all = ["albedo", "emission", "radius"];
        assert_eq!(nearest("albdo", all), ["albedo"]);
        assert_eq!(nearest("Radius", all), ["radius"]);
        assert!(nearest("file", all).is_empty());
        assert!(nearest("nosuch", ["h", "s"]).is_empty());
        assert!(nearest("red", ["rad"]).is_empty());
        assert_eq!(nearest("fo", ["of"]), ["of"]);
    }

    #[test]
    fn lists_read_as_sentences() {
        assert_eq!(listed(["a", "b", "c"], "or"), "`a`, `b` or `c`");
        assert_eq!(listed(["a"], "or"), "`a`");
        assert_eq!(with_article("angle"), "an angle");
        assert_eq!([plural("medium"), plural("light")], ["media", "lights"]);
    }
}
