//! The lines of the user's texts that a report shows: few, short, and harmless on a terminal.
//!
//! Lines that are too long are cut around the label, control characters become visible ones, and
//! labels over many lines shrink to their first.

use std::collections::BTreeSet;

use super::lines::{Lines, Position};
use super::{Diagnostic, FileId};

/// Lines shown before and after a labelled one.
const CONTEXT: usize = 1;
/// A label over more lines than this is shown on its first alone.
const MAX_LINES: usize = 6;

/// Text made up for one report, with the labels moved onto it.
#[derive(Debug)]
pub(super) struct Excerpt {
    /// Lines, each ended by a newline; those of one segment hang together.
    pub text: String,
    /// In the order they are shown: the file of the first label first.
    pub segments: Vec<Segment>,
    /// In the order of the diagnostic.
    pub labels: Vec<Shown>,
}

/// Neighbouring lines of one file.
#[derive(Debug)]
pub(super) struct Segment {
    /// Name of the file.
    pub name: String,
    /// Number of its first line, counted from 1.
    pub first_line: usize,
    /// How many lines.
    pub lines: usize,
    /// Its bytes in the excerpt.
    pub start: usize,
    /// One past its last byte.
    pub end: usize,
}

/// A label on the excerpt.
#[derive(Debug)]
pub(super) struct Shown {
    /// Its bytes in the excerpt.
    pub start: usize,
    /// One past its last byte; may be `start`.
    pub end: usize,
    /// Where it is in the user's text.
    pub position: Position,
    /// What it says.
    pub text: String,
}

/// A label on its way: bytes of its file, lines counted from 0 in the kept text.
struct Place {
    file: FileId,
    start: usize,
    end: usize,
    first: usize,
    last: usize,
}

impl Excerpt {
    /// What to show of `diagnostic`, with lines of about `width` characters at most.
    pub fn new(diagnostic: &Diagnostic, lines: &mut Lines<'_>, width: usize) -> Self {
        let places: Vec<Place> =
            diagnostic.labels.iter().map(|label| place(label.span, lines)).collect();
        let mut files: Vec<FileId> = Vec::new();
        for place in &places {
            if !files.contains(&place.file) {
                files.push(place.file);
            }
        }
        let mut excerpt = Self { text: String::new(), segments: Vec::new(), labels: Vec::new() };
        let mut moved = vec![(0, 0); places.len()];
        for file in files {
            excerpt.add_file(file, &places, lines, width, &mut moved);
        }
        for ((label, place), (start, end)) in diagnostic.labels.iter().zip(&places).zip(moved) {
            let position = lines.position(place.file, place.start);
            let text = harmless_text(&label.text);
            excerpt.labels.push(Shown { start, end: end.max(start), position, text });
        }
        excerpt
    }

    /// Adds the lines of `file` that have labels, and those around them.
    fn add_file(
        &mut self,
        file: FileId,
        places: &[Place],
        lines: &mut Lines<'_>,
        width: usize,
        moved: &mut [(usize, usize)],
    ) {
        let source = lines.sources().get(file);
        let starts = lines.starts(file);
        let here = || places.iter().enumerate().filter(|(_, place)| place.file == file);
        let end_of = |line: usize| starts.get(line + 1).map_or(source.text.len(), |next| next - 1);
        // The empty line after the last newline is worth showing only if something is said of it.
        let mut count = starts.len();
        if count > 1 && starts[count - 1] == source.text.len() {
            count -= 1;
        }
        let mut wanted = BTreeSet::new();
        for (_, place) in here() {
            wanted.extend(place.first.saturating_sub(CONTEXT)..=place.last);
            wanted.extend((place.last + 1..count).take(CONTEXT));
        }
        let mut previous: Option<usize> = None;
        for line in wanted {
            if previous.is_none_or(|previous| previous + 1 != line) {
                let start = self.text.len();
                self.segments.push(Segment {
                    name: harmless_line(&source.name),
                    first_line: source.first_line + line,
                    lines: 0,
                    start,
                    end: start,
                });
            }
            previous = Some(line);
            let (from, to) = (starts[line], end_of(line));
            let raw = source.text[from..to].trim_end_matches('\r');
            let focus = here()
                .filter(|(_, p)| p.first == line || p.last == line)
                .map(|(_, p)| if p.first == line { p.start - from } else { 0 })
                .min();
            let offsets = self.add_line(raw, focus.unwrap_or(0), width);
            for (which, place) in here() {
                if place.first == line {
                    moved[which].0 = offsets.of(raw, place.start - from);
                }
                if place.last == line {
                    moved[which].1 = offsets.of(raw, place.end.max(from) - from);
                }
            }
            if let Some(segment) = self.segments.last_mut() {
                segment.lines += 1;
                segment.end = self.text.len();
            }
        }
    }

    /// Adds a line, cut around byte `focus` if it is longer than `width` characters.
    fn add_line(&mut self, raw: &str, focus: usize, width: usize) -> Offsets {
        let count = raw.chars().count();
        let focus = raw[..focus.min(raw.len())].chars().count();
        let skipped = if count <= width {
            0
        } else {
            // A third of the line before the label, the rest after its beginning.
            focus.saturating_sub(width / 3).min(count - width)
        };
        let mut shown = Vec::with_capacity(width.min(count) + 1);
        if skipped > 0 {
            self.text.push('…');
        }
        for c in raw.chars().skip(skipped).take(width) {
            shown.push(self.text.len());
            self.text.push(harmless(c));
        }
        shown.push(self.text.len());
        if skipped + width < count {
            self.text.push('…');
        }
        self.text.push('\n');
        Offsets { skipped, shown }
    }
}

/// Where the characters of a line went.
struct Offsets {
    skipped: usize,
    /// Where each character shown begins, and where the last one ends.
    shown: Vec<usize>,
}

impl Offsets {
    /// Where byte `at` of the line is in the excerpt: at its edge if it was cut off.
    fn of(&self, raw: &str, at: usize) -> usize {
        let character = raw[..at.min(raw.len())].chars().count();
        self.shown[character.saturating_sub(self.skipped).min(self.shown.len() - 1)]
    }
}

/// A span as a place: without the newlines at its end, and not over too many lines.
fn place(span: super::Span, lines: &mut Lines<'_>) -> Place {
    let (start, mut end) = lines.range(span);
    let text = &lines.sources().get(span.file).text;
    end = start + text[start..end].trim_end_matches(['\n', '\r']).len();
    let first = lines.index(span.file, start);
    let mut last = lines.index(span.file, end);
    if last - first >= MAX_LINES {
        last = first;
        end = lines.starts(span.file)[first + 1] - 1;
    }
    Place { file: span.file, start, end, first, last }
}

/// A text with control characters made visible: it moves no cursor and turns no text around.
/// Newlines stay.
pub fn harmless_text(text: &str) -> String {
    text.chars().map(|c| if c == '\n' { c } else { harmless(c) }).collect()
}

/// The same of what is to stay on one line, such as the name of a file: newlines are made visible.
pub fn harmless_line(text: &str) -> String {
    text.chars().map(|c| if c == '\n' { '\u{240a}' } else { harmless(c) }).collect()
}

/// A character that moves no cursor and turns no text around.
fn harmless(c: char) -> char {
    match c {
        '\t' => c,
        '\0'..='\x1f' => char::from_u32(0x2400 + c as u32).unwrap_or('\u{fffd}'),
        '\x7f' => '\u{2421}',
        '\u{80}'..='\u{9f}'
        | '\u{61c}'
        | '\u{200e}'
        | '\u{200f}'
        | '\u{2028}'..='\u{202e}'
        | '\u{2066}'..='\u{2069}'
        | '\u{feff}' => '\u{fffd}',
        c => c,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Code, Sources, Span};

    fn excerpt(text: &str, spans: &[(usize, usize)], width: usize) -> Excerpt {
        let mut sources = Sources::new();
        let file = sources.add_excerpt("x.scn", text, 10);
        let mut fault = Diagnostic::error(Code::SYNTAX_UNEXPECTED, "fault");
        for (start, end) in spans {
            fault = fault.label(Span::new(file, *start, *end), "here");
        }
        Excerpt::new(&fault, &mut Lines::new(&sources), width)
    }

    fn labelled(excerpt: &Excerpt, which: usize) -> &str {
        &excerpt.text[excerpt.labels[which].start..excerpt.labels[which].end]
    }

    #[test]
    fn a_long_line_is_cut_around_its_label() {
        let text = format!("{}needle{}\n", "é ".repeat(400_000), "x".repeat(300));
        let at = text.find("needle").unwrap();
        let shown = excerpt(&text, &[(at, at + 6)], 60);
        assert_eq!(labelled(&shown, 0), "needle");
        assert!(shown.text.chars().count() < 70, "{}", shown.text);
        assert!(shown.text.starts_with('…') && shown.text.ends_with("…\n"));
        assert_eq!(shown.labels[0].position, Position { line: 10, column: 800_001 });
    }

    #[test]
    fn control_characters_are_shown_not_obeyed() {
        let shown = excerpt("a\x1b[31m\0b\u{202e}c\r\n", &[(1, 2)], 60);
        assert_eq!(shown.text, "a\u{241b}[31m\u{2400}b\u{fffd}c\n");
        assert_eq!(labelled(&shown, 0), "\u{241b}");
    }

    #[test]
    fn labels_far_apart_have_segments_of_their_own() {
        let text = "a\nb\nc\nd\ne\nf\ng\nh\n";
        let shown = excerpt(text, &[(12, 13), (0, 1)], 60);
        let lines: Vec<_> = shown.segments.iter().map(|s| (s.first_line, s.lines)).collect();
        assert_eq!(lines, [(10, 2), (15, 3)]);
        assert_eq!((labelled(&shown, 0), labelled(&shown, 1)), ("g", "a"));
    }

    #[test]
    fn the_end_of_a_text_can_be_labelled() {
        let shown = excerpt("one\n", &[(4, 4)], 60);
        assert_eq!(shown.text, "one\n\n");
        assert_eq!(shown.labels[0].position, Position { line: 11, column: 1 });
        assert_eq!(excerpt("", &[(0, 0)], 60).text, "\n");
        // Spans that lie: beyond the end, or in the middle of a character.
        assert_eq!(labelled(&excerpt("é", &[(1, 99)], 60), 0), "é");
    }

    #[test]
    fn a_label_over_many_lines_shrinks_to_the_first() {
        let shown = excerpt(&"line\n".repeat(20), &[(2, 90)], 60);
        assert_eq!(labelled(&shown, 0), "ne");
    }
}
