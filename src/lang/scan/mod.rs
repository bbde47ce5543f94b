//! Brackets and strings, before the grammar sees a text: what is open is closed, what is too much
//! is taken away, so that one missing bracket costs one report and nothing after it is lost.
//!
//! A balanced text is left alone, whatever its layout. Only where brackets do not match does
//! indentation tell which of them is to blame: an opener is unclosed if a line begins an item no
//! deeper than the opener's own line; a closer belongs to the opener of its own indentation.

mod lines;

use std::ops::Range;

use super::limits;
use crate::diag::Diagnostic;
use lines::{
    begins_item, braces, is_word, likely_end, line_rest, number_length, second_key, text_braces,
};

/// A fault of brackets or strings. Offsets are bytes of the text as given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// An opener without closer, and where the closer was put.
    Unclosed { open: usize, bracket: char, end: usize },
    /// A string without its second quote: where it begins, where it was taken to end.
    String { open: usize, end: usize },
    /// A closer without opener.
    Stray { at: usize, bracket: char },
    /// A closer whose opener is missing after the line that begins at `item`.
    Unopened { at: usize, item: Range<usize>, insert: usize },
    /// More than [`limits::DEPTH`] brackets or signs inside each other.
    TooDeep { at: usize },
}

/// Something inserted: where in the text as given, how many bytes, and how many before it.
#[derive(Clone, Copy, Debug)]
struct Insertion {
    at: usize,
    length: usize,
    before: usize,
}

/// A text that the grammar can take.
#[derive(Clone, Debug, Default)]
pub struct Scanned {
    /// The text with balanced brackets; None if it is so already.
    pub repaired: Option<String>,
    /// What was inserted: where in the text as given, and how many bytes.
    insertions: Vec<Insertion>,
    /// What was found.
    pub faults: Vec<Fault>,
    /// Bytes around repairs: a fault found there later is probably their consequence.
    pub muted: Vec<Range<usize>>,
    /// Brackets and strings are so wrong that the rest was not looked at.
    pub hopeless: bool,
}

impl Scanned {
    /// The place in the text as given of a place in the repaired one.
    pub fn original(&self, repaired: usize) -> usize {
        let known = self.insertions.partition_point(|i| i.at + i.before < repaired);
        match known.checked_sub(1).map(|last| self.insertions[last]) {
            None => repaired,
            Some(Insertion { at, length, before }) => {
                repaired - before - length.min(repaired - at - before)
            }
        }
    }

    /// Whether a fault stands at a place that was repaired.
    pub fn is_muted(&self, fault: &Diagnostic) -> bool {
        let place = fault.place().filter(|_| !self.muted.is_empty());
        let Some(at) = place.map(|place| place.start as usize) else { return false };
        self.muted.iter().any(|range| range.contains(&at))
    }
}

/// Balances a text.
pub fn scan(text: &str) -> Scanned {
    let mut quick = Scanner::new(text, false);
    quick.run();
    if quick.faults.is_empty() {
        return Scanned::default();
    }
    if quick.faults.iter().any(|fault| matches!(fault, Fault::TooDeep { .. })) {
        quick.faults.retain(|fault| matches!(fault, Fault::TooDeep { .. }));
        return Scanned { faults: quick.faults, ..Scanned::default() };
    }
    let mut careful = Scanner::new(text, true);
    careful.run();
    if careful.faults.len() >= limits::FAULTS {
        careful.faults.truncate(limits::FAULTS);
        return Scanned { faults: careful.faults, hopeless: true, ..Scanned::default() };
    }
    careful.finish()
}

/// An opener that waits for its closer.
#[derive(Clone, Copy)]
struct Open {
    bracket: u8,
    at: usize,
    line: usize,
    indent: usize,
}

/// A line that begins an item.
#[derive(Clone, Copy)]
struct Head {
    line: usize,
    start: usize,
    indent: usize,
    /// Brackets open before it.
    depth: usize,
}

struct Scanner<'t> {
    text: &'t str,
    bytes: &'t [u8],
    /// Use indentation; repair.
    careful: bool,
    open: Vec<Open>,
    heads: Vec<Head>,
    line: usize,
    line_start: usize,
    indent: usize,
    /// The first thing of the line is still to come.
    fresh: bool,
    /// End of the last thing that was no blank.
    content_end: usize,
    /// Begin of the word or string before, and of the comma before that.
    key: Option<(usize, Option<usize>)>,
    comma: Option<usize>,
    faults: Vec<Fault>,
    insert: Vec<(usize, &'static str)>,
    blank: Vec<usize>,
    muted: Vec<Range<usize>>,
    /// Closing braces still to come, less the opening ones.
    surplus: isize,
}

impl<'t> Scanner<'t> {
    fn new(text: &'t str, careful: bool) -> Self {
        Self {
            text,
            bytes: text.as_bytes(),
            careful,
            open: Vec::new(),
            heads: Vec::new(),
            line: 0,
            line_start: 0,
            indent: 0,
            fresh: true,
            content_end: 0,
            key: None,
            comma: None,
            faults: Vec::new(),
            insert: Vec::new(),
            blank: Vec::new(),
            muted: Vec::new(),
            surplus: text.bytes().map(braces).sum(),
        }
    }

    fn run(&mut self) {
        let mut at = 0;
        let mut signs = 0;
        while at < self.bytes.len() && self.faults.len() < limits::FAULTS {
            let byte = self.bytes[at];
            match byte {
                b'\n' => {
                    at += 1;
                    self.line += 1;
                    self.line_start = at;
                    self.fresh = true;
                    continue;
                }
                b' ' | b'\t' | b'\r' => {
                    at += 1;
                    continue;
                }
                b'/' if self.bytes.get(at + 1) == Some(&b'/') => {
                    let rest = line_rest(&self.bytes[at..]);
                    self.surplus -= text_braces(&self.bytes[at..at + rest]);
                    at += rest;
                    continue;
                }
                _ => {}
            }
            if self.fresh {
                self.fresh = false;
                self.begin_line(at);
            }
            signs = if matches!(byte, b'+' | b'-') { signs + 1 } else { 0 };
            if signs > limits::DEPTH || self.open.len() > limits::DEPTH {
                self.faults.push(Fault::TooDeep { at });
                return;
            }
            let next = match byte {
                b'"' => self.string(at),
                b'(' | b'[' | b'{' => {
                    let Self { line, indent, .. } = *self;
                    self.open.push(Open { bracket: byte, at, line, indent });
                    at + 1
                }
                b')' | b']' | b'}' => {
                    self.close(at, byte);
                    at + 1
                }
                b':' => {
                    self.colon();
                    at + 1
                }
                _ if byte.is_ascii_digit() => at + number_length(&self.bytes[at..]),
                _ if is_word(byte) => {
                    let length = self.bytes[at..].iter().take_while(|b| is_word(**b)).count();
                    self.key = Some((at, self.comma));
                    at + length
                }
                _ => at + self.text[at..].chars().next().map_or(1, char::len_utf8),
            };
            if !is_word(byte) && byte != b'"' {
                self.key = None;
            }
            self.surplus -= text_braces(&self.bytes[at..next]);
            self.comma = (byte == b',').then_some(at);
            self.content_end = next;
            at = next;
        }
        while let Some(open) = self.open.pop() {
            self.unclosed(open, self.content_end);
        }
    }

    /// A string from its first quote; gives where the text goes on.
    fn string(&mut self, at: usize) -> usize {
        self.key = Some((at, self.comma));
        let mut end = at + 1;
        while let Some(&byte) = self.bytes.get(end) {
            match byte {
                b'"' => return end + 1,
                b'\n' => break,
                b'\\' if self.bytes.get(end + 1).is_some_and(|b| *b != b'\n') => {
                    end += 1 + self.text[end + 1..].chars().next().map_or(1, char::len_utf8);
                }
                _ => end += 1,
            }
        }
        let end = end.min(self.bytes.len());
        let line = at..end;
        let inside = self.text[line.clone()].trim_end();
        let end = at + likely_end(inside);
        self.faults.push(Fault::String { open: at, end });
        self.insert.push((end, "\""));
        self.muted.push(self.line_start..line.end);
        end
    }

    /// A line begins with something.
    fn begin_line(&mut self, at: usize) {
        self.indent = at - self.line_start;
        if !self.careful || !begins_item(&self.bytes[at..]) {
            return;
        }
        while let Some(&open) = self.open.last() {
            let parted = open.bracket != b'{' || self.indent <= open.indent;
            if self.line == open.line || !(parted || self.indent == 0) {
                break;
            }
            self.open.pop();
            self.unclosed(open, self.content_end);
        }
        let Self { line, indent, .. } = *self;
        self.heads.push(Head { line, start: at, indent, depth: self.open.len() });
    }

    /// A colon: the word before it is a field's, which stands in braces only.
    fn colon(&mut self) {
        let Some((key, comma)) = self.key.filter(|_| self.careful) else { return };
        while let Some(&open) = self.open.last() {
            if open.bracket == b'{' || open.at > key {
                break;
            }
            self.open.pop();
            self.unclosed(open, comma.unwrap_or(key));
        }
    }

    fn close(&mut self, at: usize, closer: u8) {
        let opener = match closer {
            b')' => b'(',
            b']' => b'[',
            _ => b'{',
        };
        let first = self.bytes[self.line_start..at].iter().all(|b| matches!(b, b' ' | b'\t'));
        if self.careful && closer == b'}' && self.unopened(at, first) {
            return;
        }
        let wanted = |open: &Open| {
            open.bracket == opener
                && (!self.careful || !first || closer != b'}' || open.indent == self.indent)
        };
        let found = self.open.iter().rposition(wanted);
        let found = found.or_else(|| self.open.iter().rposition(|open| open.bracket == opener));
        let Some(found) = found else {
            self.faults.push(Fault::Stray { at, bracket: closer as char });
            self.blank.push(at);
            self.mute_line(at);
            return;
        };
        while self.open.len() > found + 1 {
            let open = self.open.pop().expect("longer than found");
            let end = if first { self.content_end } else { at };
            self.unclosed(open, end);
        }
        self.open.pop();
    }

    /// Whether a closing brace tells of a missing `{`, by the line it stands in.
    fn unopened(&mut self, at: usize, first: bool) -> bool {
        let top = self.open.iter().rev().find(|open| open.bracket == b'{');
        let indent = self.indent;
        let in_line = top.is_some_and(|open| open.line == self.line);
        let fits = top.is_some_and(|open| !first || open.indent == indent);
        let surplus = self.surplus > self.open.len() as isize;
        if in_line || (fits && !surplus) || (fits && first) {
            return false;
        }
        let head = if first {
            let above = |head: &&Head| {
                head.indent == indent
                    && head.line < self.line
                    && top.is_none_or(|open| head.line > open.line)
            };
            self.heads.iter().rev().find(above).copied()
        } else {
            self.heads.last().filter(|head| head.line == self.line).copied()
        };
        let Some(head) = head else { return false };
        // Nothing stands inside: the brace is one too many.
        if first && !self.heads.iter().any(|inner| inner.line > head.line) {
            return false;
        }
        let end = head.start + line_rest(&self.bytes[head.start..]);
        let line = &self.text[head.start..end];
        let code = line.split("//").next().unwrap_or("").trim_end();
        let insert = if first {
            head.start + code.len()
        } else {
            match second_key(code) {
                Some(key) => head.start + key,
                None => return false,
            }
        };
        if code.ends_with('{') || head.depth > self.open.len() {
            return false;
        }
        self.faults.push(Fault::Unopened { at, item: head.start..head.start + code.len(), insert });
        self.insert.push((insert, " {"));
        // What stands between is read as it was meant only if the repair was right.
        self.muted.push(head.start..at + 1);
        true
    }

    fn unclosed(&mut self, open: Open, end: usize) {
        let bracket = open.bracket as char;
        self.faults.push(Fault::Unclosed { open: open.at, bracket, end });
        self.insert.push((
            end,
            match open.bracket {
                b'(' => ")",
                b'[' => "]",
                _ => "}",
            },
        ));
        if open.bracket != b'{' {
            self.mute_line(open.at);
        }
    }

    fn mute_line(&mut self, at: usize) {
        if self.muted.last().is_some_and(|last| last.contains(&at)) {
            return;
        }
        let start = self.text[..at].rfind('\n').map_or(0, |newline| newline + 1);
        self.muted.push(start..at + line_rest(&self.bytes[at..]));
    }

    fn finish(mut self) -> Scanned {
        // Stable: what was inserted first at a place stands first there.
        self.insert.sort_by_key(|(at, _)| *at);
        let mut bytes = self.bytes.to_vec();
        for at in self.blank {
            bytes[at] = b' ';
        }
        let blanked = String::from_utf8(bytes).expect("ASCII was replaced by ASCII");
        let mut repaired = String::with_capacity(blanked.len() + 2 * self.insert.len());
        let mut from = 0;
        for (at, what) in &self.insert {
            repaired.push_str(&blanked[from..*at]);
            repaired.push_str(what);
            from = *at;
        }
        repaired.push_str(&blanked[from..]);
        let mut before = 0;
        let insertion = |(at, what): &(usize, &str)| {
            let insertion = Insertion { at: *at, length: what.len(), before };
            before += what.len();
            insertion
        };
        let insertions = self.insert.iter().map(insertion).collect();
        Scanned {
            repaired: Some(repaired),
            insertions,
            faults: self.faults,
            muted: self.muted,
            hopeless: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn repaired(text: &str) -> String {
        scan(text).repaired.unwrap_or_else(|| text.to_string())
    }

    #[test]
    fn balanced_text_is_left_alone_whatever_its_layout() {
        for text in ["a: {\nb: 1\n}", "a: b {\n      c: (1,\n2)\nd: 3 } // {", "a: \"{{ (\""] {
            assert!(scan(text).faults.is_empty(), "{text}");
        }
    }

    #[test]
    fn a_missing_closer_is_put_where_the_layout_wants_it() {
        assert_eq!(repaired("a: {\n    b: 1\nc: 2\n"), "a: {\n    b: 1}\nc: 2\n");
        assert_eq!(repaired("a: { b: (1, 2, c: 3 }"), "a: { b: (1, 2), c: 3 }");
        assert_eq!(repaired("a: [f(1, 2]"), "a: [f(1, 2)]");
        let nested = "s {\n    a: b {\n        c: 1\n}\n";
        assert_eq!(repaired(nested), "s {\n    a: b {\n        c: 1}\n}\n");
    }

    #[test]
    fn a_missing_opener_is_put_on_the_line_it_belongs_to() {
        assert_eq!(repaired("a: size: 1 }"), "a:  {size: 1 }");
        assert_eq!(repaired("a: mesh\n    b: 1\n}\n"), "a: mesh {\n    b: 1\n}\n");
        assert_eq!(repaired("a: 1)\nb: 2"), "a: 1 \nb: 2");
    }

    #[test]
    fn a_missing_quote_costs_its_line_only() {
        assert_eq!(repaired("f: { a: \"x.obj, b: 1 }\n"), "f: { a: \"x.obj\", b: 1 }\n");
        assert_eq!(repaired("use \"x\na: 1"), "use \"x\"\na: 1");
    }

    #[test]
    fn letters_beyond_ascii_are_never_cut() {
        for text in ["a: (3:\u{1d62d}4", "a: 3:\u{1d62d} }", "a: é\u{1d62d}b: 1 }", "a: \"\\é"] {
            assert!(!scan(text).faults.is_empty(), "{text}");
        }
    }

    #[test]
    fn places_in_the_repaired_text_lead_back() {
        let text = "a: { b: (1, 2, c: 3 }";
        let scanned = scan(text);
        let repaired = scanned.repaired.clone().unwrap();
        let at = repaired.find('c').unwrap();
        assert_eq!(&text[scanned.original(at)..][..1], "c");
    }
}
