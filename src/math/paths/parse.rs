//! From the text of an expression to its tree.
//!
//! ```text
//! either = row {"|" row}      row  = part {part}       part = atom ["*" | "+" | "?"]
//! atom   = "L" | "E" | "." | ("D" | "G" | "S") ["_r" | "_t"] | "(" either ")"
//! ```

use std::ops::Range;

use super::expression::{Fault, Letters, MOST_DEPTH, Node, Sign, Wrong};

/// The tree of a text, and the bytes of its letters; else all that is wrong with it, in the order
/// of the text.
pub(super) fn parse(text: &str) -> Result<(Node, Vec<Range<usize>>), Vec<Fault>> {
    let mut parser = Parser { text, at: 0, depth: 0, letters: Vec::new(), faults: Vec::new() };
    let root = parser.whole();
    if parser.faults.is_empty() {
        return Ok((root, parser.letters));
    }
    if let Some(deep) = parser.faults.iter().position(|fault| fault.wrong == Wrong::TooDeep) {
        // What follows was not read.
        return Err(vec![parser.faults.swap_remove(deep)]);
    }
    parser.faults.sort_by_key(|fault| (fault.at.start, fault.at.end));
    Err(parser.faults)
}

struct Parser<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
    letters: Vec<Range<usize>>,
    faults: Vec<Fault>,
}

impl Parser<'_> {
    /// The next character that is no blank.
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.text[self.at..].chars().next()
    }

    fn next(&mut self) -> Option<char> {
        let next = self.peek();
        self.at += next.map_or(0, char::len_utf8);
        next
    }

    fn fault(&mut self, at: Range<usize>, wrong: Wrong, instead: Option<String>) {
        self.faults.push(Fault { at, wrong, instead });
    }

    fn whole(&mut self) -> Node {
        let mut all = vec![self.either()];
        while self.next().is_some() {
            // Only a `)` ends what is no group.
            self.fault(self.at - 1..self.at, Wrong::Unopened, None);
            if self.peek().is_some() {
                all.push(self.either());
            }
        }
        one_or(all, Node::Row)
    }

    fn either(&mut self) -> Node {
        let from = self.at;
        let mut all = vec![self.row()];
        let mut bar = None;
        while self.peek() == Some('|') {
            bar = Some(self.at);
            self.at += 1;
            all.push(self.row());
        }
        if let Some(bar) = bar
            && all.iter().any(|row| *row == Node::Row(Vec::new()))
        {
            self.fault(bar..bar + 1, Wrong::Empty, None);
        } else if all[0] == Node::Row(Vec::new()) && self.faults.is_empty() {
            let end = self.at + usize::from(self.peek().is_some());
            self.fault(from.saturating_sub(1)..end, Wrong::Empty, None);
        }
        one_or(all, Node::Either)
    }

    fn row(&mut self) -> Node {
        let mut all = Vec::new();
        while let Some(char) = self.peek() {
            if matches!(char, '|' | ')') {
                break;
            }
            let from = self.at;
            if Sign::of(char).is_some() {
                self.at += 1;
                self.fault(from..self.at, Wrong::NothingRepeated, anything(char));
                continue;
            }
            let atom = self.atom(char);
            all.push(self.repeated(atom));
        }
        one_or(all, Node::Row)
    }

    fn repeated(&mut self, atom: Node) -> Node {
        let from = self.at;
        let mut signs: Option<(Sign, usize)> = None;
        let start = self.peek().map_or(from, |_| self.at);
        let mut end = start;
        while let Some(sign) = self.peek().and_then(Sign::of) {
            self.at += 1;
            end = self.at;
            signs = Some(signs.map_or((sign, 1), |(before, count)| (before.and(sign), count + 1)));
        }
        match signs {
            None => atom,
            Some((sign, count)) => {
                if count > 1 {
                    let instead = Some(sign.char().to_string());
                    self.fault(start..end, Wrong::TwoSigns, instead);
                } else if has_end(&atom) {
                    let alone = matches!(atom, Node::One(_));
                    let anything = anything(sign.char()).filter(|_| alone);
                    let instead = anything.map(|it| format!(" {it}"));
                    self.fault(start..end, Wrong::EndRepeated, instead);
                }
                Node::Repeated(Box::new(atom), sign)
            }
        }
    }

    /// One letter, or a group; `first` is what comes next.
    fn atom(&mut self, first: char) -> Node {
        let from = self.at;
        self.at += first.len_utf8();
        match first {
            '(' => self.group(from),
            '[' => self.bracket(from),
            '.' => {
                self.letters.push(from..self.at);
                Node::One(Letters::ANY)
            }
            _ => self.letter(from, first),
        }
    }

    fn group(&mut self, from: usize) -> Node {
        if self.depth == MOST_DEPTH {
            self.fault(from..from + 1, Wrong::TooDeep, None);
            self.at = self.text.len();
            return Node::One(Letters::ANY);
        }
        self.depth += 1;
        let inner = self.either();
        self.depth -= 1;
        if self.next().is_none() {
            self.fault(from..from + 1, Wrong::Unclosed, None);
        }
        inner
    }

    /// Other programs write `[SD]` for `(S|D)`.
    fn bracket(&mut self, from: usize) -> Node {
        let inner = self.text[self.at..].split_once(']').map(|(inner, _)| inner);
        if let Some(inner) = inner {
            self.at += inner.len() + 1;
        }
        let letters = |inner: &str| {
            let all: Vec<String> =
                inner.chars().filter(|c| !c.is_whitespace()).map(String::from).collect();
            let known = all.iter().all(|letter| Letters::named(letter).is_some());
            (known && !all.is_empty()).then(|| format!("({})", all.join("|")))
        };
        self.fault(from..self.at, Wrong::Unknown, inner.and_then(letters));
        Node::One(Letters::ANY)
    }

    fn letter(&mut self, from: usize, first: char) -> Node {
        let known = first.to_ascii_uppercase();
        let meant = match known {
            'L' | 'E' => Some(known),
            'D' | 'G' | 'S' => Some(known),
            // Other programs call the eye a camera.
            'C' => Some('E'),
            _ => None,
        };
        let sided = matches!(meant, Some('D' | 'G' | 'S'));
        let rest = &self.text[self.at..];
        // `S_r`; or `Sr`, whose underscore was forgotten.
        let (mut side, mut length) = (None, 0);
        if let Some(after) = rest.strip_prefix('_') {
            let char = after.chars().next().filter(|char| char.is_alphanumeric());
            (side, length) = (Some(char), 1 + char.map_or(0, char::len_utf8));
        } else if let (Some(_), Some(char @ ('r' | 't'))) = (meant, rest.chars().next()) {
            (side, length) = (Some(Some(char)), 1);
        }
        self.at += length;
        let side_of =
            |char: char| Some(char.to_ascii_lowercase()).filter(|side| matches!(side, 'r' | 't'));
        let written = &self.text[from..self.at];
        let spelt = match (meant, side) {
            (Some(letter), None) => Some(letter.to_string()),
            (Some(letter), Some(Some(char))) if sided => {
                side_of(char).map(|side| format!("{letter}_{side}"))
            }
            (Some(letter), Some(_)) if !sided => Some(letter.to_string()),
            _ => None,
        };
        if let Some(letters) = Letters::named(written) {
            self.letters.push(from..self.at);
            return Node::One(letters);
        }
        let wrong =
            if side.is_some() && meant == Some(first) { Wrong::Side } else { Wrong::Unknown };
        let letters = spelt.as_deref().and_then(Letters::named).unwrap_or(Letters::ANY);
        self.fault(from..self.at, wrong, spelt);
        Node::One(letters)
    }
}

/// Whether there is a light or an eye in it.
fn has_end(node: &Node) -> bool {
    match node {
        Node::One(letters) => *letters == Letters::LIGHT || *letters == Letters::EYE,
        Node::Row(all) | Node::Either(all) => all.iter().any(has_end),
        Node::Repeated(node, _) => has_end(node),
    }
}

/// In names of files a `*` stands for anything; here `.*` does.
fn anything(sign: char) -> Option<String> {
    (sign == '*').then(|| ".*".to_string())
}

/// The only one, or all of them.
fn one_or(mut all: Vec<Node>, whole: fn(Vec<Node>) -> Node) -> Node {
    match all.pop() {
        Some(only) if all.is_empty() => only,
        Some(last) => {
            all.push(last);
            whole(all)
        }
        None => whole(all),
    }
}
