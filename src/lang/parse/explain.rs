//! What a text that the grammar refuses should have been: where the grammar stopped, what stands
//! there, and what the brackets and the word before it ask for.

use pest::Parser;

use super::build::Builder;
use super::{Grammar, Pair, Rule, hints, stopped};
use crate::diag::{Diagnostic, FileId, Span};
use crate::lang::errors::syntax;
use crate::lang::words::is_keyword;

/// Tells of an item, which begins at byte `start` of the source.
pub fn item(builder: &mut Builder, text: &str, start: usize) -> Diagnostic {
    refused(builder, Rule::item_alone, text, start)
}

/// Tells of what follows a whole item on its line.
pub fn leftover(builder: &mut Builder, text: &str, start: usize, last: Span) -> Diagnostic {
    let (at, length) = thing(text, 0);
    let span = builder.place(start + at, start + at + length);
    if let Some(told) = comment(text, builder.place(start, start + text.len())) {
        return told;
    }
    let found = text.get(at..at + length).unwrap_or("");
    if let Some(told) = dangling(builder, start + at, last) {
        return told;
    }
    let told = syntax::unexpected("a comma or a new line after this item", found, span);
    let told = hinted(told, builder.source, start + at);
    if told.help.is_some() {
        // Both are one value in another form: its first half is not wrong as well.
        builder.muted.push(last);
    }
    told
}

/// Tells of an operator at the end of a line, after which an item begins that was taken for its
/// value, as part of the item `last`; the grammar stopped in it, at byte `at` of the source.
pub fn dangling(builder: &mut Builder, at: usize, last: Span) -> Option<Diagnostic> {
    let operator = hints::dangling(builder.source, at)?;
    builder.muted.push(last);
    let sign = &builder.source[operator..operator + 1];
    Some(syntax::nothing_after(sign, builder.place(operator, operator + 1)))
}

/// Tells of a field.
pub fn entry(builder: &mut Builder, text: &str, start: usize) -> Diagnostic {
    refused(builder, Rule::entry_alone, text, start)
}

/// A text as a field, if it is one.
pub fn entry_alone(text: &str) -> Option<Pair<'_>> {
    Grammar::parse(Rule::entry_alone, text).ok()?.next()?.into_inner().next()
}

fn refused(builder: &mut Builder, rule: Rule, text: &str, start: usize) -> Diagnostic {
    let at = match Grammar::parse(rule, text) {
        Ok(_) => text.len(),
        Err(error) => stopped(&error),
    };
    if let Some((whole, fraction)) = hints::decimal_comma(builder.source, start) {
        let begin = start - 1 - whole.len();
        let span = builder.place(begin, start + fraction.len());
        let told = syntax::decimal_comma(whole, fraction, span);
        builder.muted.push(builder.place(begin, start));
        return told;
    }
    let (at, length) = thing(text, at);
    let whole = builder.place(start, start + text.len());
    let span = builder.place(start + at, start + at + length);
    let told = tell(text, at, whole, span, rule == Rule::entry_alone);
    hinted(told, builder.source, start + at)
}

/// Tells of a text that is not part of a file: the grammar stopped at byte `at`.
pub fn at(text: &str, at: usize, file: FileId) -> Diagnostic {
    let (at, length) = thing(text, at.min(text.len()));
    let whole = Span::new(file, 0, text.len());
    tell(text, at, whole, Span::new(file, at, at + length), false)
}

/// Tells of a value in a string, which stands at `span`.
pub fn inside(text: &str, at: usize, span: Span) -> Diagnostic {
    let (at, length) = thing(text, at.min(text.len()));
    let start = span.start as usize + at;
    tell(text, at, span, Span::new(span.file, start, start + length), true)
}

/// A fault with what was probably meant at byte `at`, unless it says so already.
fn hinted(told: Diagnostic, source: &str, at: usize) -> Diagnostic {
    match hints::hint(source, at).filter(|_| told.help.is_none()) {
        Some(help) => told.help(help),
        None => told,
    }
}

/// The thing at `at`, or the next one: where it begins, how long it is. At the end of the text
/// that is the last thing before it.
fn thing(text: &str, at: usize) -> (usize, usize) {
    let rest = &text[at..];
    let at = at + (rest.len() - rest.trim_start().len());
    let rest = &text[at..];
    match rest.chars().next() {
        None => (text.trim_end().len(), 0),
        Some(c) if c.is_alphanumeric() || c == '_' => {
            (at, rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len()))
        }
        Some('"') => (at, rest[1..].find('"').map_or(rest.len(), |end| end + 2)),
        Some(c) => (at, c.len_utf8()),
    }
}

/// Tells of a comment of another language, if the text begins with one.
fn comment(text: &str, whole: Span) -> Option<Diagnostic> {
    let start = text.trim_start();
    let begins = start.starts_with('#') || start.starts_with("/*") || start.starts_with("--");
    begins.then(|| syntax::comment(start.split_whitespace().next().unwrap_or("#"), whole))
}

fn tell(text: &str, at: usize, whole: Span, span: Span, in_record: bool) -> Diagnostic {
    if let Some(told) = comment(text, whole) {
        return told;
    }
    let start = text.trim_start();
    let length = (span.end - span.start) as usize;
    let found = text.get(at..at + length).unwrap_or("");
    let before = text[..at].trim_end();
    if !in_record && before.is_empty() && !found.starts_with(|c: char| c.is_alphabetic()) {
        return syntax::unexpected("an item such as `kind name: value`", found, span);
    }
    let bracket = innermost(before);
    let after_word = before.ends_with(|c: char| c.is_alphanumeric() || "_\"%)]}".contains(c));
    if is_keyword(found) && (before.is_empty() || (after_word && !before.contains([':', '=']))) {
        return syntax::keyword_as_name(found, span);
    }
    let line = before.rsplit('\n').next().unwrap_or(before);
    let expected = match (bracket, after_word) {
        (Some('('), true) => "`,` or `)`",
        (Some('['), true) => "`,` or `]`",
        (None, true) if found == "," && line.contains([':', '=']) => "an operator, or the end",
        (Some('{'), true) | (None, true) if line.contains([':', '=']) => {
            "a comma or a new line, or an operator"
        }
        (Some('{'), true) => "`:`",
        (None, true) if starts_with_keyword(start) => shape(start),
        (None, true) => "`:` and a value",
        (_, false) if before.ends_with(',') && bracket == Some('{') => "a field",
        _ if before.is_empty() => "a field such as `word: value`",
        _ => "a value",
    };
    syntax::unexpected(expected, found, span)
}

/// The bracket that is open at the end of a text.
pub fn innermost(text: &str) -> Option<char> {
    let mut open = Vec::new();
    let mut quoted = false;
    for c in text.chars() {
        match c {
            '"' => quoted = !quoted,
            '(' | '[' | '{' if !quoted => open.push(c),
            ')' | ']' | '}' if !quoted => {
                open.pop();
            }
            _ => {}
        }
    }
    open.pop()
}

fn starts_with_keyword(text: &str) -> bool {
    is_keyword(text.split(|c: char| !c.is_alphanumeric()).next().unwrap_or(""))
}

/// The shape of an item that begins with a keyword.
fn shape(text: &str) -> &'static str {
    match text.split(|c: char| !c.is_alphanumeric()).next().unwrap_or("") {
        "use" => "a file name in quotes, as in `use \"lib/box.scn\"`",
        "let" => "`let name = value`",
        "for" => "`for name in values { … }`",
        "setup" => "`setup name: base + base { … }`",
        "render" => "`render name: base + base { … }`",
        "without" => "`without kind name`",
        _ => "a value",
    }
}
