//! Words near a mistaken one.

/// The candidates most like `word`, best first, three at most; none if nothing is like it.
pub fn near<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let word = word.to_lowercase();
    let mut all: Vec<(f64, &str)> = candidates
        .into_iter()
        .map(|candidate| {
            let other = candidate.to_lowercase();
            let inside = word.len().min(other.len()) >= 3
                && (other.contains(&word) || word.contains(&other));
            let likeness = strsim::jaro_winkler(&word, &other);
            (if inside { likeness.max(0.9) } else { likeness }, candidate)
        })
        .filter(|(likeness, _)| *likeness >= 0.75)
        .collect();
    all.sort_by(|a, b| b.0.total_cmp(&a.0).then_with(|| a.1.cmp(b.1)));
    all.dedup_by_key(|(_, candidate)| *candidate);
    // Beside one that is much nearer the others only distract.
    let best = all.first().map_or(0.0, |(likeness, _)| *likeness);
    all.retain(|(likeness, _)| *likeness > best - 0.05);
    all.into_iter().take(3).map(|(_, candidate)| candidate).collect()
}

/// "`a`, `b` or `c`".
pub fn either(words: &[&str]) -> String {
    quoted(words, "or")
}

/// "`a`, `b` and `c`", with a word such as "and" before the last.
pub fn quoted(words: &[&str], and: &str) -> String {
    let quoted: Vec<_> = words.iter().map(|word| format!("`{word}`")).collect();
    match quoted.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} {and} {last}", most.join(", ")),
    }
}

/// Names, not too many of them.
pub fn listed(names: &[&str]) -> String {
    const MOST: usize = 12;
    let mut text = names[..names.len().min(MOST)].join(", ");
    if names.len() > MOST {
        text.push_str(&format!(" and {} more", names.len() - MOST));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_words_are_those_a_person_means() {
        let words = ["fig01", "fig02", "fig03_mtl", "overview"];
        assert_eq!(near("fig3", words)[0], "fig03_mtl");
        assert_eq!(near("FIG02", words)[0], "fig02");
        assert_eq!(near("overvew", ["overview", "over", "view"]), ["overview"]);
        assert!(near("zebra", words).is_empty());
        assert_eq!(either(&["a", "b", "c"]), "`a`, `b` or `c`");
    }
}
