//! A text without faults as words, numbers, strings and signs, with the comments before each.

use crate::math::units;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A word, keywords included.
    Word,
    /// A number without its unit, or a time of day.
    Number,
    /// A string with its quotes.
    Text,
    /// A bracket, a comma, an operator.
    Sign(u8),
    /// The end of the text.
    End,
}

/// A token, and what stands between the one before and itself.
#[derive(Clone, Debug)]
pub struct Token<'t> {
    pub kind: Kind,
    /// As written.
    pub text: &'t str,
    /// Its first byte.
    pub start: usize,
    /// Whether it begins a line, or a comment stands before it.
    pub newline: bool,
    /// Whether a blank line stands before it, after the comments.
    pub blank: bool,
    pub comments: Vec<Comment<'t>>,
}

/// A comment.
#[derive(Clone, Copy, Debug)]
pub struct Comment<'t> {
    /// From its slashes to its last character that is no blank.
    pub text: &'t str,
    /// Whether nothing else stands on its line.
    pub own_line: bool,
    /// Whether a blank line stands before it.
    pub blank: bool,
}

/// The tokens of a text; the last one is its end.
pub fn read(text: &str) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    let mut at = 0;
    loop {
        let mut comments = Vec::new();
        let (mut newlines, mut newline) = (0, at == 0);
        loop {
            let rest = &text[at..];
            if rest.starts_with('\n') {
                newlines += 1;
                newline = true;
                at += 1;
            } else if let Some(c) = rest.chars().next().filter(|c| " \t\r\u{feff}".contains(*c)) {
                at += c.len_utf8();
            } else if rest.starts_with("//") {
                let line = rest.lines().next().unwrap_or(rest);
                let own_line = newline;
                comments.push(Comment { text: line.trim_end(), own_line, blank: newlines > 1 });
                newlines = 0;
                newline = true;
                at += line.len();
            } else {
                break;
            }
        }
        let (kind, length) = token(&text[at..]);
        let token = &text[at..at + length];
        tokens.push(Token { kind, text: token, start: at, newline, blank: newlines > 1, comments });
        if kind == Kind::End {
            return tokens;
        }
        at += length;
    }
}

/// What a text begins with, and how many bytes long that is.
fn token(text: &str) -> (Kind, usize) {
    let bytes = text.as_bytes();
    match bytes.first() {
        None => (Kind::End, 0),
        Some(b'"') => {
            let mut end = 1;
            while end < bytes.len() && bytes[end] != b'"' {
                end += if bytes[end] == b'\\' { 2 } else { 1 };
            }
            (Kind::Text, (end + 1).min(bytes.len()))
        }
        Some(b) if b.is_ascii_digit() => (Kind::Number, number(bytes)),
        Some(b) if b.is_ascii_alphabetic() || *b == b'_' => (Kind::Word, run(bytes, is_word)),
        // Beyond words and strings a text without faults is ASCII.
        Some(b) => (Kind::Sign(*b), text.chars().next().map_or(1, char::len_utf8)),
    }
}

fn is_word(byte: &u8) -> bool {
    byte.is_ascii_alphanumeric() || *byte == b'_'
}

fn is_digit(byte: &u8) -> bool {
    byte.is_ascii_digit() || *byte == b'_'
}

/// How many bytes at the beginning are such.
fn run(bytes: &[u8], such: impl Fn(&u8) -> bool) -> usize {
    bytes.iter().position(|b| !such(b)).unwrap_or(bytes.len())
}

/// Bytes of a number, or of a time of day with its colon.
fn number(bytes: &[u8]) -> usize {
    let hours = run(bytes, u8::is_ascii_digit);
    if hours <= 2 && bytes.get(hours) == Some(&b':') && run(&bytes[hours + 1..], is_word) == 2 {
        let minutes = &bytes[hours + 1..hours + 3];
        if minutes.iter().all(u8::is_ascii_digit) {
            return hours + 3;
        }
    }
    let mut end = run(bytes, is_digit);
    if bytes.get(end) == Some(&b'.') && bytes.get(end + 1).is_some_and(u8::is_ascii_digit) {
        end += 1 + run(&bytes[end + 1..], is_digit);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        if bytes.get(end + 1 + sign).is_some_and(u8::is_ascii_digit) {
            end += 1 + sign;
            end += run(&bytes[end..], is_digit);
        }
    }
    end
}

/// Whether `tokens[at]` is an operator between two values, not a sign before one.
pub fn is_operator(tokens: &[Token], at: usize) -> bool {
    if !matches!(tokens[at].kind, Kind::Sign(b'+' | b'-' | b'*' | b'/')) || at == 0 {
        return false;
    }
    let before = &tokens[at - 1];
    match before.kind {
        Kind::Word => !super::super::words::is_keyword(before.text),
        Kind::Number | Kind::Text => true,
        Kind::Sign(sign) => matches!(sign, b')' | b']' | b'}' | b'%'),
        Kind::End => false,
    }
}

/// Whether a blank belongs between `tokens[before]` and the token after it, on one line.
pub fn spaced(tokens: &[Token], before: usize) -> bool {
    let after = before + 1;
    let (left, right) = (&tokens[before], &tokens[after]);
    let sign =
        |token: &Token, signs: &[u8]| matches!(token.kind, Kind::Sign(s) if signs.contains(&s));
    if sign(left, b".^") || sign(right, b".^:,") {
        return false;
    }
    for operator in [before, after] {
        if is_operator(tokens, operator) {
            return !joins_units(tokens, operator);
        }
    }
    // A sign before a value.
    if sign(left, b"+-") {
        return false;
    }
    let calls = sign(right, b"(") && left.kind == Kind::Word;
    !calls || super::super::words::is_keyword(left.text)
}

/// Whether a slash parts two units, as in `W/m^2/sr`.
fn joins_units(tokens: &[Token], slash: usize) -> bool {
    let unit = |at: usize| tokens[at].kind == Kind::Word && units::find(tokens[at].text).is_some();
    let sign = |at: usize, s: u8| tokens[at].kind == Kind::Sign(s);
    if !sign(slash, b'/') || !unit(slash + 1) {
        return false;
    }
    let mut left = slash - 1;
    if tokens[left].kind == Kind::Number && left > 2 {
        left -= usize::from(sign(left - 1, b'-'));
        if !sign(left - 1, b'^') {
            return false;
        }
        left -= 2;
    }
    unit(left) && (left == 0 || !sign(left - 1, b'.'))
}
