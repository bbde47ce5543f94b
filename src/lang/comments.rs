//! Where the comments of a text are. A text that is wrong has comments as well.

use std::ops::Range;

/// The bytes of each comment, from its `//` to the end of its line, the newline not included.
pub fn comments(text: &str) -> Vec<Range<usize>> {
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut at = 0;
    let mut quoted = false;
    while at < bytes.len() {
        match bytes[at] {
            // A string ends on its line, even one that lacks its quote.
            b'\n' => quoted = false,
            b'"' => quoted = !quoted,
            b'\\' if quoted && bytes.get(at + 1).is_some_and(|next| *next != b'\n') => at += 1,
            b'/' if !quoted && bytes.get(at + 1) == Some(&b'/') => {
                let length =
                    bytes[at..].iter().position(|b| *b == b'\n').unwrap_or(text.len() - at);
                found.push(at..at + length);
                at += length;
                continue;
            }
            _ => {}
        }
        at += 1;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_are_outside_of_strings() {
        let text = "// a\nx: \"http://b \\\" // c\" // d // e\ny: \"open // f\nz / 2 // \u{e9}";
        let found: Vec<_> = comments(text).into_iter().map(|range| &text[range]).collect();
        assert_eq!(found, ["// a", "// d // e", "// \u{e9}"]);
        assert!(comments("\"\\").is_empty() && comments("/").is_empty());
    }
}
