//! What is inside quotes: escapes and `{values}`.

use pest::Parser;

use super::build::Builder;
use super::{Grammar, Rule, explain, stopped};
use crate::lang::ast::{Expr, ExprKind, Piece};
use crate::lang::errors::syntax;
use crate::lang::{limits, scan};

/// The pieces of a string: `inside` the quotes, which begins at byte `at` of the source.
pub fn pieces(builder: &mut Builder, inside: &str, at: usize) -> Vec<Piece> {
    let mut found = Vec::new();
    let mut words = String::new();
    let mut rest = inside.char_indices().peekable();
    while let Some((i, c)) = rest.next() {
        let next = rest.peek().map(|(_, c)| *c);
        match c {
            '\\' => match escape(&inside[i..]) {
                Ok((c, length)) => {
                    words.push(c);
                    while rest.peek().is_some_and(|(j, _)| *j < i + length) {
                        rest.next();
                    }
                }
                Err(length) => {
                    let span = builder.place(at + i, at + i + length);
                    builder.tell(syntax::bad_escape(&inside[i..i + length], span));
                    while rest.peek().is_some_and(|(j, _)| *j < i + length) {
                        rest.next();
                    }
                }
            },
            '{' | '}' if next == Some(c) => {
                words.push(c);
                rest.next();
            }
            '}' => {
                let span = builder.place(at + i, at + i + 1);
                builder.tell(syntax::lone_brace('}', span));
            }
            '{' => {
                let Some(length) = closing(&inside[i..]) else {
                    let span = builder.place(at + i, at + i + 1);
                    builder.tell(syntax::lone_brace('{', span));
                    continue;
                };
                if !words.is_empty() {
                    found.push(Piece::Words(std::mem::take(&mut words)));
                }
                let text = &inside[i + 1..i + length];
                found.push(Piece::Value(interpolated(builder, text, at + i + 1)));
                while rest.peek().is_some_and(|(j, _)| *j <= i + length) {
                    rest.next();
                }
            }
            _ => words.push(c),
        }
    }
    if !words.is_empty() || found.is_empty() {
        found.push(Piece::Words(words));
    }
    found
}

/// The character an escape stands for and its length in bytes; or how much of it is wrong.
fn escape(text: &str) -> Result<(char, usize), usize> {
    match text.chars().nth(1) {
        Some('"') => Ok(('"', 2)),
        Some('\\') => Ok(('\\', 2)),
        Some('n') => Ok(('\n', 2)),
        Some('u') => {
            let end = text.find('}').filter(|_| text[2..].starts_with('{')).ok_or(2_usize)?;
            let code = u32::from_str_radix(&text[3..end], 16).ok().and_then(char::from_u32);
            code.map(|c| (c, end + 1)).ok_or(end + 1)
        }
        Some(c) => Err(1 + c.len_utf8()),
        None => Err(1),
    }
}

/// Where the brace that opens `text` is closed.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0;
    for (at, c) in text.char_indices() {
        match c {
            // No value is so deep; looking on from each of many braces would take for ever.
            '{' if depth > limits::DEPTH => return None,
            '{' => depth += 1,
            '}' if depth == 1 => return Some(at),
            '}' => depth -= 1,
            _ => {}
        }
    }
    None
}

/// A value inside a string.
fn interpolated(builder: &mut Builder, text: &str, at: usize) -> Expr {
    let span = builder.place(at, at + text.len());
    let broken = Expr { kind: ExprKind::Broken, span };
    let deep = text.bytes().filter(|b| matches!(b, b'(' | b'[' | b'{')).count() > limits::DEPTH;
    if deep || !scan::scan(text).faults.is_empty() {
        builder.tell(syntax::interpolation(span));
        return broken;
    }
    match Grammar::parse(Rule::value_alone, text) {
        Ok(mut pairs) => {
            let value = pairs.next().and_then(|pair| pair.into_inner().next());
            let outer = builder.shift(at);
            let value = value.map_or(broken, |value| builder.value(value));
            builder.unshift(outer);
            value
        }
        Err(_) if text.trim().is_empty() => {
            builder.tell(syntax::interpolation(span));
            broken
        }
        Err(error) => {
            let at = stopped(&error);
            builder.tell(explain::inside(text, at, span));
            broken
        }
    }
}
