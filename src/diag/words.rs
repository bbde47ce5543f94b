//! Names and numbers in sentences.

/// "`a`, `b` and `c`", with a word such as "and" before the last.
pub fn listed<'w>(words: impl IntoIterator<Item = &'w str>, last: &str) -> String {
    let words: Vec<_> = words.into_iter().map(|word| format!("`{word}`")).collect();
    match words.split_last() {
        None => String::new(),
        Some((only, [])) => only.clone(),
        Some((end, rest)) => format!("{} {last} {end}", rest.join(", ")),
    }
}

/// What is offered instead of a word that means nothing.
pub fn did_you_mean<'w>(words: impl IntoIterator<Item = &'w str>) -> String {
    format!("did you mean {}?", listed(words, "or"))
}

/// "`a`, `b` and `c`"; of more than `most` names, so many and how many more.
pub fn few<'w>(words: impl IntoIterator<Item = &'w str>, most: usize) -> String {
    let words: Vec<&str> = words.into_iter().collect();
    // Instead of "1 more" its name can stand.
    if words.len() <= most + 1 {
        return listed(words, "and");
    }
    let first: Vec<_> = words[..most].iter().map(|word| format!("`{word}`")).collect();
    format!("{} and {} more", first.join(", "), grouped((words.len() - most) as u64))
}

/// "1 render", "99,785 renders".
pub fn counted(n: u64, word: &str) -> String {
    if n == 1 { format!("1 {word}") } else { format!("{} {word}s", grouped(n)) }
}

/// Digits in groups of three: "99,785".
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_read_as_sentences() {
        assert_eq!(listed([], "or"), "");
        assert_eq!(listed(["a"], "or"), "`a`");
        assert_eq!(listed(["a", "b", "c"], "or"), "`a`, `b` or `c`");
        assert_eq!(few(["a", "b", "c"], 2), "`a`, `b` and `c`");
        assert_eq!(few(["a"; 9], 4), "`a`, `a`, `a`, `a` and 5 more");
    }

    #[test]
    fn counts_read_as_people_write_them() {
        assert_eq!(counted(1, "render"), "1 render");
        assert_eq!(counted(0, "light"), "0 lights");
        assert_eq!(counted(1_099_785, "triangle"), "1,099,785 triangles");
    }
}
