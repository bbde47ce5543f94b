//! Lines and words of Wavefront's formats, and places in them to show.
//!
//! A word is a range of bytes of the file: nothing is copied. A backslash before the end of a
//! line joins the next one; a `#` at the beginning of a word begins a comment.

use std::ops::Range;

/// The most bytes of a line that are shown on either side of a place, and of the place itself.
const SHOWN: usize = 60;

/// The most words of a line that are looked at; one more shows that there are too many.
pub(super) const MOST_WORDS: usize = 100_000;

/// A few lines of a file around a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excerpt {
    /// The lines; long ones are clipped.
    pub text: String,
    /// The number of the first of them, counted from 1.
    pub first_line: usize,
    /// The number of the line in which the place is.
    pub line: usize,
    /// The place, in bytes of `text`.
    pub range: Range<usize>,
}

/// Walks over lines, as far as backslashes join them.
pub(super) struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    number: usize,
}

/// A line: where it begins, and the number it has there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    /// Its first byte.
    pub start: usize,
    /// One past its last byte, comment included.
    pub end: usize,
    /// Its number, counted from 1.
    pub number: usize,
    /// Whether a backslash joined it from several.
    pub joined: bool,
}

impl<'a> Lines<'a> {
    /// From the first line on.
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0, number: 1 }
    }

    /// How many bytes are behind.
    pub fn position(&self) -> usize {
        self.at
    }

    /// The next line that has words; they are put into `words`, at most [`MOST_WORDS`] and one.
    pub fn next(&mut self, words: &mut Vec<Range<usize>>) -> Option<Line> {
        while self.at < self.bytes.len() {
            let line = self.line(words);
            if !words.is_empty() {
                return Some(line);
            }
        }
        None
    }

    fn line(&mut self, words: &mut Vec<Range<usize>>) -> Line {
        words.clear();
        let bytes = self.bytes;
        let mut line = Line { start: self.at, end: self.at, number: self.number, joined: false };
        let mut at = self.at;
        loop {
            line.end = at;
            match bytes.get(at) {
                None => break,
                Some(b'\n' | b'\r') => {
                    at += self.line_end(at);
                    self.number += 1;
                    break;
                }
                Some(b'\\') if self.line_end(at + 1) > 0 => {
                    at += 1 + self.line_end(at + 1);
                    self.number += 1;
                    line.joined = true;
                }
                Some(b' ' | b'\t' | 0x0b | 0x0c) => at += 1,
                Some(b'#') => {
                    at += bytes[at..].iter().take_while(|b| !matches!(b, b'\n' | b'\r')).count();
                }
                Some(_) => {
                    let start = at;
                    while at < bytes.len() && !self.ends_word(at) {
                        at += 1;
                    }
                    if words.len() <= MOST_WORDS {
                        words.push(start..at);
                    }
                }
            }
        }
        self.at = at;
        line
    }

    fn ends_word(&self, at: usize) -> bool {
        match self.bytes[at] {
            b' ' | b'\t' | b'\n' | b'\r' | 0x0b | 0x0c => true,
            b'\\' => matches!(self.bytes.get(at + 1), Some(b'\n' | b'\r')),
            _ => false,
        }
    }

    /// How long the line end at `at` is, zero if there is none.
    fn line_end(&self, at: usize) -> usize {
        match self.bytes.get(at..) {
            Some([b'\r', b'\n', ..]) => 2,
            Some([b'\r' | b'\n', ..]) => 1,
            _ => 0,
        }
    }
}

/// Words as text: UTF-8, or else the Latin-1 of old programs, in which every byte is a letter.
/// Control characters are replaced.
pub(super) fn decode(bytes: &[u8]) -> String {
    let shown = |c: char| match c {
        '\t' => ' ',
        c if c.is_control() => char::REPLACEMENT_CHARACTER,
        c => c,
    };
    match std::str::from_utf8(bytes) {
        Ok(text) => text.chars().map(shown).collect(),
        Err(_) => bytes.iter().map(|byte| shown(char::from(*byte))).collect(),
    }
}

/// What follows the first word of a line, as a name: blanks inside belong to it.
pub(super) fn name(bytes: &[u8], line: Line, words: &[Range<usize>]) -> String {
    if line.joined {
        let parts: Vec<_> = words[1..].iter().map(|word| decode(&bytes[word.clone()])).collect();
        return parts.join(" ");
    }
    decode(&bytes[words[0].end..line.end]).trim().to_string()
}

/// A word for a message, clipped.
pub(super) fn shown(bytes: &[u8], word: &Range<usize>) -> String {
    if word.len() <= SHOWN {
        return decode(&bytes[word.clone()]);
    }
    format!("{}…", decode(&bytes[word.start..word.start + SHOWN]))
}

/// The lines around a place. `line` begins at or before it and is where counting starts.
pub(super) fn excerpt(bytes: &[u8], line: Line, place: Range<usize>) -> Excerpt {
    let breaks = |range: Range<usize>| {
        let at =
            |i: usize| bytes[i] == b'\n' || (bytes[i] == b'\r' && bytes.get(i + 1) != Some(&b'\n'));
        range.filter(|i| at(*i)).count()
    };
    let number = line.number + breaks(line.start..place.start);
    let is_break = |byte: &u8| matches!(byte, b'\n' | b'\r');

    let back = &bytes[line.start..place.start];
    let start = back.iter().rposition(is_break).map_or(line.start, |i| line.start + i + 1);
    let end = bytes[place.start..].iter().position(is_break);
    let end = end.map_or(bytes.len(), |i| place.start + i);

    let mut text = String::new();
    let mut first_line = number;
    // The line before.
    if start > 0 {
        let stop = start - if bytes[..start].ends_with(b"\r\n") { 2 } else { 1 };
        let far = stop.saturating_sub(2 * SHOWN);
        if let Some(i) = bytes[far..stop].iter().rposition(is_break).map(|i| far + i + 1) {
            text = decode(&bytes[i..stop]) + "\n";
            first_line -= 1;
        } else if far == 0 {
            text = decode(&bytes[..stop]) + "\n";
            first_line -= 1;
        }
    }
    // The line itself.
    let from = start.max(place.start.saturating_sub(2 * SHOWN));
    text.push_str(if from > start { "…" } else { "" });
    text.push_str(&decode(&bytes[from..place.start]));
    let begin = text.len();
    let last = place.end.min(end).min(place.start + SHOWN);
    text.push_str(&decode(&bytes[place.start..last]));
    let range = begin..text.len();
    let rest = end.min(last + SHOWN);
    text.push_str(&decode(&bytes[last..rest]));
    text.push_str(if rest < end { "…" } else { "" });
    text.push('\n');
    // The line after.
    let after = end + if bytes[end..].starts_with(b"\r\n") { 2 } else { 1 };
    if let Some(bytes) = bytes.get(after..).filter(|bytes| !bytes.is_empty()) {
        let length = bytes.iter().take(2 * SHOWN).position(is_break);
        let clipped = &bytes[..length.unwrap_or(bytes.len().min(2 * SHOWN))];
        text.push_str(&decode(clipped));
        text.push('\n');
    }
    Excerpt { text, first_line, line: number, range }
}

/// The lines around line `number`, whose words are the place.
pub(super) fn excerpt_of_line(bytes: &[u8], number: usize) -> Option<Excerpt> {
    let (mut lines, mut words) = (Lines::new(bytes), Vec::new());
    while let Some(line) = lines.next(&mut words) {
        if line.number == number {
            let end = words.iter().rev().find(|_| !line.joined).unwrap_or(&words[0]).end;
            return Some(excerpt(bytes, line, words[0].start..end));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(text: &str) -> Vec<(usize, Vec<String>)> {
        let (mut lines, mut words, mut found) = (Lines::new(text.as_bytes()), Vec::new(), vec![]);
        while let Some(line) = lines.next(&mut words) {
            found.push((line.number, words.iter().map(|w| text[w.clone()].to_string()).collect()));
        }
        found
    }

    #[test]
    fn lines_join_and_count_whatever_ends_them() {
        let text = "# a \\\nv 1\\\n 2 \\\r\n3 # x\r\n\rf\t1\\2 a#b\n\\\n";
        let words = |words: &[&str]| words.iter().map(|w| w.to_string()).collect::<Vec<_>>();
        let wanted = vec![(2, words(&["v", "1", "2", "3"])), (6, words(&["f", "1\\2", "a#b"]))];
        assert_eq!(all(text), wanted);
    }

    #[test]
    fn excerpts_show_the_place_and_its_neighbours() {
        let text = format!("a\nv 1 \\\n2 x 3{}\r\nlast", " 9".repeat(1000));
        let bytes = text.as_bytes();
        let (mut lines, mut words) = (Lines::new(bytes), Vec::new());
        lines.next(&mut words);
        let line = lines.next(&mut words).unwrap();
        let excerpt = excerpt(bytes, line, words[3].clone());
        assert_eq!((excerpt.first_line, excerpt.line), (2, 3));
        assert_eq!(&excerpt.text[excerpt.range.clone()], "x");
        let shown: Vec<_> = excerpt.text.lines().collect();
        assert_eq!((shown[0], shown[2]), ("v 1 \\", "last"));
        assert!(shown[1].starts_with("2 x 3 9") && shown[1].ends_with('…'));
        assert!(shown[1].len() < 100);
    }

    #[test]
    fn old_names_stay_readable() {
        assert_eq!(decode(b"caf\xe9\x07"), "café\u{fffd}");
        assert_eq!(decode("café".as_bytes()), "café");
    }
}
