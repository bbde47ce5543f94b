//! The faults of a scene file, one function each, by family.

pub mod circle;
pub mod import;
pub mod more;
pub mod name;
pub mod paths;
pub mod quantities;
pub mod render;
pub mod sets;
pub mod spectrum;
pub mod syntax;
pub mod types;
mod unit_tail;

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
    fn words_are_bent() {
        assert_eq!(with_article("angle"), "an angle");
        assert_eq!([plural("medium"), plural("light")], ["media", "lights"]);
    }
}
