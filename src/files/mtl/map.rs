//! The operands of `map_Kd`: options, then the name of a file, which may have blanks in it.

use std::ops::Range;

/// A picture that a colour is multiplied by.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// The name of its file, as written.
    pub file: String,
    /// Whether the texels of its edge go on beyond it, and not the picture again.
    pub clamp: bool,
    /// Whether there are options that change its place or its colours, which are not read.
    pub options: bool,
}

/// Reads the words after the statement; None if no file is named.
pub(super) fn parse(text: &str, words: &[Range<usize>]) -> Option<Map> {
    let word = |at: usize| words.get(at).map(|word| &text[word.clone()]);
    let is_number = |at: usize| word(at).is_some_and(|word| word.parse::<f64>().is_ok());
    let mut map = Map { file: String::new(), clamp: false, options: false };
    let mut at = 1;
    loop {
        let operands = match word(at)? {
            "-clamp" => {
                map.clamp = word(at + 1) == Some("on");
                1
            }
            // How it is filtered.
            "-blendu" | "-blendv" | "-texres" => 1,
            "-boost" | "-cc" | "-imfchan" | "-bm" => {
                map.options = true;
                1
            }
            "-mm" => {
                map.options = true;
                2
            }
            "-o" | "-s" | "-t" => {
                map.options = true;
                (1..=3).take_while(|next| is_number(at + next)).count()
            }
            _ => break,
        };
        at += 1 + operands;
    }
    let last = words.last()?;
    map.file = text[words[at].start..last.end].to_string();
    Some(map)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(text: &str) -> Option<Map> {
        let mut words = Vec::new();
        for word in text.split_whitespace() {
            let start = word.as_ptr() as usize - text.as_ptr() as usize;
            words.push(start..start + word.len());
        }
        parse(text, &words)
    }

    #[test]
    fn options_come_before_names_and_names_have_blanks() {
        let plain = |file: &str| Some(Map { file: file.into(), clamp: false, options: false });
        assert_eq!(map("map_Kd a.png"), plain("a.png"));
        assert_eq!(map("map_Kd -blendu off old wood 2.jpg"), plain("old wood 2.jpg"));
        let clamped = map("map_Kd -clamp on -o 1 0.5 2.png").unwrap();
        assert!(clamped.clamp && clamped.options && clamped.file == "2.png");
        assert!(map("map_Kd -s 1 1 1 -mm 0 1 x.png").is_some_and(|map| map.file == "x.png"));
        for text in ["map_Kd", "map_Kd -clamp on", "map_Kd -s 1 1 1", "map_Kd -mm 1"] {
            assert_eq!(map(text), None, "{text}");
        }
    }
}
