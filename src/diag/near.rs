//! Words near a mistaken one: what "did you mean" offers, everywhere.

/// Candidates that are looked at: more than any person wrote.
const CANDIDATES: usize = 2000;

/// Words offered at most.
const OFFERED: usize = 3;

/// How alike two words must be: 1 less the edits between them for each letter of the longer one.
const ALIKE: f64 = 0.5;

/// How alike the beginning of a word is to the whole: more than words that differ in one letter of
/// five.
const BEGINNING: f64 = 0.81;

/// How alike another part of a word is to the whole.
const PART: f64 = 0.61;

/// Beside one that is nearer by this the others only distract.
const MUCH_NEARER: f64 = 0.25;

/// The words of `all` that look most like `word`, whatever their case, nearest first; at most
/// three, and none where none is near.
pub fn near<'w>(word: &str, all: impl IntoIterator<Item = &'w str>) -> Vec<&'w str> {
    let lower = word.to_lowercase();
    let mut found: Vec<(f64, &str)> = all
        .into_iter()
        .take(CANDIDATES)
        .filter(|other| !other.is_empty() && *other != word)
        .map(|other| (alike(&lower, &other.to_lowercase()), other))
        .filter(|(alike, _)| *alike >= ALIKE)
        .collect();
    found.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
    found.dedup_by_key(|(_, word)| *word);
    let best = found.first().map_or(0.0, |(alike, _)| *alike);
    found.retain(|(alike, _)| *alike > best - MUCH_NEARER);
    found.into_iter().map(|(_, word)| word).take(OFFERED).collect()
}

/// How alike two words in small letters are, 0 to 1.
fn alike(word: &str, other: &str) -> f64 {
    if other_short(word, other) {
        return 0.0;
    }
    let edits = strsim::damerau_levenshtein(word, other) as f64;
    let longest = word.chars().count().max(other.chars().count()).max(1) as f64;
    let alike = 1.0 - edits / longest;
    let at_least = match word.len().min(other.len()) {
        0..=2 => 0.0,
        _ if other.starts_with(word) => BEGINNING,
        _ if other.contains(word) || word.contains(other) => PART,
        _ => 0.0,
    };
    alike.max(at_least)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_names_are_near() {
        let all = ["albedo", "emission", "radius"];
        assert_eq!(near("albdo", all), ["albedo"]);
        assert_eq!(near("Radius", all), ["radius"]);
        assert!(near("file", all).is_empty());
        assert!(near("nosuch", ["h", "s"]).is_empty());
        assert!(near("red", ["rad"]).is_empty());
        assert_eq!(near("fo", ["of"]), ["of"]);
    }

    #[test]
    fn parts_of_names_are_near() {
        let all = ["fig01", "fig02", "fig03_mtl", "overview"];
        assert_eq!(near("fig03", all)[0], "fig03_mtl");
        assert_eq!(near("FIG02", all)[0], "fig02");
        assert_eq!(near("overvew", ["overview", "over", "view"]), ["overview"]);
        assert!(near("zebra", all).is_empty());
    }
}
