//! Comments that allow a finding: `// lint: allow(rule, rule) because "…"`.
//!
//! At the end of a line such a comment speaks of that line, on a line of its own of the next one
//! that is no comment; where an item or a field begins there, of all of it. Errors cannot be
//! allowed. A finding in a mesh or .mtl file is allowed where the scene names that file.

use std::collections::HashMap;
use std::ops::Range;

use super::{Look, errors, rules};
use crate::diag::{CODES, Code, Diagnostic, FileId, Level, Sources, Span};
use crate::lang::{comments, outline::Outline};

/// How much of a file's findings there is to judge a comment by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seen {
    /// The file is free of errors, and was looked at as it stands: all renders, no `--set`.
    pub whole: bool,
    /// It has renders.
    pub renders: bool,
}

/// A comment that allows.
struct Allow {
    comment: Span,
    /// The bytes it speaks of.
    covers: Range<usize>,
    /// The bytes between its brackets.
    list: Range<usize>,
    names: Vec<Allowed>,
    reason: bool,
}

/// A name in it.
struct Allowed {
    text: String,
    at: Span,
    code: Option<Code>,
    used: bool,
}

/// The findings that no comment allows, and what is wrong with comments of the main file.
pub fn allowed(
    found: Vec<Diagnostic>,
    outline: &Outline,
    sources: &Sources,
    seen: Seen,
) -> Vec<Diagnostic> {
    let mut kept = Vec::new();
    let mut own = Vec::new();
    let mut allows: HashMap<FileId, Vec<Allow>> = HashMap::new();
    for (i, file) in outline.files.iter().enumerate() {
        let mut faults = Vec::new();
        allows.insert(*file, read(&sources.get(*file).text, *file, &mut faults));
        if i == 0 {
            own = faults;
        }
    }
    for diagnostic in found {
        let place = diagnostic.labels.iter().find(|label| allows.contains_key(&label.span.file));
        let here = place.and_then(|label| Some((label.span, allows.get_mut(&label.span.file)?)));
        let mut is_allowed = false;
        if let Some((span, all)) = here.filter(|_| diagnostic.level < Level::Error) {
            for allow in all.iter_mut().filter(|it| it.covers.contains(&(span.start as usize))) {
                for name in allow.names.iter_mut().filter(|it| it.code == Some(diagnostic.code)) {
                    name.used = true;
                    is_allowed = true;
                }
            }
        }
        if !is_allowed {
            kept.push(diagnostic);
        }
    }
    let main = outline.files.first();
    for allow in main.and_then(|file| allows.get(file)).into_iter().flatten() {
        judge(allow, &sources.get(allow.comment.file).text, seen, &mut own);
    }
    kept.extend(own);
    kept
}

/// Tells what is wrong with a comment, now that it is known what it allowed.
fn judge(allow: &Allow, text: &str, seen: Seen, found: &mut Vec<Diagnostic>) {
    if !allow.reason {
        found.push(errors::without_reason(allow.comment));
    }
    let can_tell = |code: Code| {
        let needs_renders = !rules::RULES
            .iter()
            .any(|rule| rule.code == code && matches!(rule.look, Look::Text(_)));
        seen.whole && (seen.renders || !needs_renders)
    };
    let unused = |name: &&Allowed| !name.used && name.code.is_some_and(can_tell);
    let kept: Vec<&str> =
        allow.names.iter().filter(|name| !unused(name)).map(|name| &*name.text).collect();
    let file = allow.comment.file;
    let change = match kept.as_slice() {
        [] => (whole_comment(text, allow.comment), String::new()),
        names => (Span::new(file, allow.list.start, allow.list.end), names.join(", ")),
    };
    for name in &allow.names {
        match name.code {
            None => found.push(errors::unknown(&name.text, name.at)),
            Some(_) if unused(&name) => {
                found.push(errors::unused(&name.text, name.at, change.clone()));
            }
            Some(_) => {}
        }
    }
}

/// A comment with the blanks before it; with its line, where that holds nothing else.
fn whole_comment(text: &str, comment: Span) -> Span {
    let Range { start, end } = comment.range();
    let before = text[..start].trim_end_matches([' ', '\t']).len();
    if before > 0 && !text[..before].ends_with('\n') {
        return Span::new(comment.file, before, end);
    }
    let newline = usize::from(text[end..].starts_with('\n'));
    Span::new(comment.file, before, end + newline)
}

/// The comments of a text that allow.
fn read(text: &str, file: FileId, faults: &mut Vec<Diagnostic>) -> Vec<Allow> {
    let all = comments(text);
    let mut found = Vec::new();
    for (i, comment) in all.iter().enumerate() {
        let end = comment.start + text[comment.clone()].trim_end().len();
        let words = &text[comment.start..end];
        let inside = words.trim_start_matches('/').trim_start();
        let Some(rest) = inside.strip_prefix("lint:") else { continue };
        let span = Span::new(file, comment.start, end);
        match parts(rest) {
            Some((list, reason)) => {
                let start = end - rest.len() + list.start;
                let list = start..start + list.len();
                let names = names(text, list.clone(), file);
                let covers = covered(text, &all, i);
                found.push(Allow { comment: span, covers, list, names, reason });
            }
            None => faults.push(errors::form(span)),
        }
    }
    found
}

/// The bytes between the brackets of ` allow(…) because "…"`, and whether there is a reason.
fn parts(rest: &str) -> Option<(Range<usize>, bool)> {
    let after = rest.trim_start().strip_prefix("allow")?.trim_start().strip_prefix('(')?;
    let start = rest.len() - after.len();
    let length = after.find(')')?;
    let list = start..start + length;
    if after[..length].split(',').any(|name| name.trim().is_empty()) {
        return None;
    }
    let because = after[length + 1..].trim();
    if because.is_empty() {
        return Some((list, false));
    }
    let reason = because.strip_prefix("because")?.trim_start();
    let reason = reason.strip_prefix('"')?.strip_suffix('"')?;
    Some((list, !reason.trim().is_empty()))
}

fn names(text: &str, list: Range<usize>, file: FileId) -> Vec<Allowed> {
    let mut at = list.start;
    let mut found = Vec::new();
    for part in text[list].split(',') {
        let word = part.trim();
        let start = at + (part.len() - part.trim_start().len());
        let known = |code: &&Code| {
            code.name == word || code.name.strip_prefix("lint/").is_some_and(|rule| rule == word)
        };
        found.push(Allowed {
            text: word.to_string(),
            at: Span::new(file, start, start + word.len()),
            code: CODES.iter().find(known).copied(),
            used: false,
        });
        at += part.len() + 1;
    }
    found
}

/// The bytes the `i`-th comment of a text speaks of.
fn covered(text: &str, comments: &[Range<usize>], i: usize) -> Range<usize> {
    let line_start = |at: usize| text[..at].rfind('\n').map_or(0, |newline| newline + 1);
    let alone = |at: usize| text[line_start(at)..at].trim().is_empty();
    let mut last = i;
    if !alone(comments[i].start) {
        let start = line_start(comments[i].start);
        return start..block_end(text, comments, start);
    }
    // Comments may go on below it.
    while let Some(next) = comments.get(last + 1)
        && alone(next.start)
        && line_start(next.start) == comments[last].end + 1
    {
        last += 1;
    }
    let start = (comments[last].end + 1).min(text.len());
    start..block_end(text, comments, start)
}

/// The end of what begins on the line at `start`: of the line where all its brackets are closed.
fn block_end(text: &str, comments: &[Range<usize>], start: usize) -> usize {
    let first = comments.partition_point(|comment| comment.start < start);
    let mut next = comments[first..].iter().peekable();
    let mut depth = 0_isize;
    let mut quoted = false;
    let bytes = text.as_bytes();
    let mut at = start;
    while at < bytes.len() {
        if next.peek().is_some_and(|comment| comment.start == at) {
            at = next.next().map_or(at, |comment| comment.end);
            continue;
        }
        match bytes[at] {
            b'\n' if depth <= 0 => return at,
            b'\n' => quoted = false,
            b'\\' if quoted => at += usize::from(bytes.get(at + 1) != Some(&b'\n')),
            b'"' => quoted = !quoted,
            b'{' | b'(' | b'[' if !quoted => depth += 1,
            b'}' | b')' | b']' if !quoted => depth -= 1,
            _ => {}
        }
        at += 1;
    }
    text.len()
}

#[cfg(test)]
mod tests;
