//! Comments that allow a finding: `// lint: allow(rule, rule) because "…"`.
//!
//! At the end of a line such a comment speaks of that line, on a line of its own of the next one
//! that is no comment; where an item or a field begins there, of all of it. Errors cannot be
//! allowed. A finding in a mesh or .mtl file is allowed where the scene names that file.

mod blocks;

use std::collections::HashMap;
use std::ops::Range;

use self::blocks::{Blocks, Lines};
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
}

/// What the comments of a text allow.
struct Allows {
    all: Vec<Allow>,
    blocks: Blocks,
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
    let mut allows: HashMap<FileId, Allows> = HashMap::new();
    for (i, file) in outline.files.iter().enumerate() {
        let mut faults = Vec::new();
        let all = read(&sources.get(*file).text, *file, &mut faults);
        let blocks = Blocks::of(all.iter().flat_map(|allow| {
            let codes = allow.names.iter().filter_map(|name| name.code);
            codes.map(|code| (&allow.covers, code))
        }));
        allows.insert(*file, Allows { all, blocks });
        if i == 0 {
            own = faults;
        }
    }
    for diagnostic in found {
        let place = diagnostic.labels.iter().find(|label| allows.contains_key(&label.span.file));
        let here = place.and_then(|label| Some((label.span, allows.get_mut(&label.span.file)?)));
        let is_allowed =
            here.filter(|_| diagnostic.level < Level::Error).is_some_and(|(span, allows)| {
                allows.blocks.allow(diagnostic.code, span.start as usize)
            });
        if !is_allowed {
            kept.push(diagnostic);
        }
    }
    if let Some(allows) = outline.files.first().and_then(|file| allows.get(file)) {
        for allow in &allows.all {
            let text = &sources.get(allow.comment.file).text;
            judge(allow, &allows.blocks, text, seen, &mut own);
        }
    }
    kept.extend(own);
    kept
}

/// Tells what is wrong with a comment, now that it is known what it allowed.
fn judge(allow: &Allow, blocks: &Blocks, text: &str, seen: Seen, found: &mut Vec<Diagnostic>) {
    if !allow.reason {
        found.push(errors::without_reason(allow.comment));
    }
    let can_tell = |code: Code| {
        let needs_renders = !rules::RULES
            .iter()
            .any(|rule| rule.code == code && matches!(rule.look, Look::Text(_)));
        seen.whole && (seen.renders || !needs_renders)
    };
    let unused = |name: &&Allowed| {
        name.code.is_some_and(|code| can_tell(code) && !blocks.used(code, allow.covers.start))
    };
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
    let lines = Lines::of(text, &all);
    let targets = targets(text, &all, &lines);
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
                let covers = lines.block(targets[i]);
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
        });
        at += part.len() + 1;
    }
    found
}

/// Where the line begins that each comment of a text speaks of.
fn targets(text: &str, comments: &[Range<usize>], lines: &Lines) -> Vec<usize> {
    let alone = |at: usize| text[lines.start(at)..at].trim().is_empty();
    let mut found = vec![0; comments.len()];
    for (i, comment) in comments.iter().enumerate().rev() {
        let next = comments.get(i + 1).filter(|next| lines.start(next.start) == comment.end + 1);
        // Comments may go on below it.
        found[i] = match next {
            _ if !alone(comment.start) => lines.start(comment.start),
            Some(next) if alone(next.start) => found[i + 1],
            _ => (comment.end + 1).min(text.len()),
        };
    }
    found
}

#[cfg(test)]
mod tests;
