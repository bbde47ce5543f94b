//! The arguments of `--set`, each a text of its own: `path=value`.

use std::path::Path;

use super::ast;
use super::errors::sets as errors;
use super::eval::{Evaluator, FileFacts};
use super::{parse, words};
use crate::diag::{Diagnostic, FileId, Sources, Span};
use crate::scene::KINDS;

/// What the arguments say, as if each stood in the file `main` at `path`, whose bare coordinates
/// are in `unit`; told where they say nothing.
pub fn read(
    sets: &[String],
    main: FileId,
    path: &Path,
    ev: &mut Evaluator,
    unit: Option<f64>,
    sources: &mut Sources,
) -> Vec<ast::Set> {
    let mut all = Vec::new();
    for text in sets {
        let id = sources.add_argument("--set", text.as_str());
        let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
        let first_line = Some(Span::new(main, 0, 0));
        ev.add_file(id, FileFacts { folder, text: text.as_str().into(), unit, first_line });
        let equals = match equals(text, id) {
            Ok(equals) => equals,
            Err(fault) => {
                ev.reports.tell(*fault);
                continue;
            }
        };
        if let Some(fault) = several(text, id) {
            ev.reports.tell(fault);
            continue;
        }
        // The form of an item.
        let mut item = text.clone();
        item.replace_range(equals..=equals, ":");
        let parsed = parse::set(&item, id);
        ev.reports.tell_text(id, parsed.faults);
        all.extend(parsed.tree);
    }
    all
}

/// Tells of several paths, each with a value, where commas outside all brackets part them.
fn several(text: &str, id: FileId) -> Option<Diagnostic> {
    let open =
        |before: &str| before.matches('"').count() % 2 == 1 || parse::innermost(before).is_some();
    let commas = text.match_indices(',').map(|(at, _)| at).filter(|at| !open(&text[..*at]));
    let commas: Vec<usize> = commas.collect();
    let ends = commas.iter().copied().chain([text.len()]);
    let begins = [0].into_iter().chain(commas.iter().map(|at| at + 1));
    let parts: Option<Vec<_>> = begins.zip(ends).map(|(a, b)| parted(&text[a..b])).collect();
    let parts = parts.filter(|parts| parts.len() > 1)?;
    // What is no kind of item is a part of the thing that was changed before it.
    let mut outer = "";
    let said = parts.iter().map(|(path, value)| {
        let alone = path.chars().all(|c| c.is_alphanumeric() || c == '_');
        match alone && !outer.is_empty() && KINDS.iter().all(|kind| kind.word != *path) {
            true => format!("{outer}.{path}={value}"),
            false => {
                outer = path.rsplit_once('.').map_or("", |(outer, _)| outer);
                format!("{path}={value}")
            }
        }
    });
    Some(errors::several(&said.collect::<Vec<_>>(), Span::new(id, commas[0], commas[0] + 1)))
}

/// The path and the value of a text that has the form of both.
fn parted(text: &str) -> Option<(&str, &str)> {
    let (path, value) = text.split_once(['=', ':'])?;
    let (path, value) = (path.trim(), value.trim());
    let of_path = |c: char| c.is_alphanumeric() || "_.\" ".contains(c);
    let is_path = path.starts_with(char::is_alphabetic) && path.chars().all(of_path);
    (is_path && !value.is_empty()).then_some((path, value))
}

/// Where the path ends and the value begins.
fn equals(text: &str, id: FileId) -> Result<usize, Box<Diagnostic>> {
    let span = |start: usize, end: usize| Span::new(id, start, end);
    let first = |sign: char| {
        let quoted = |at: usize| text[..at].matches('"').count() % 2 == 1;
        text.match_indices(sign).map(|(at, _)| at).find(|at| !quoted(*at))
    };
    let begin = text.len() - text.trim_start().len();
    let word_end = text[begin..].find(|c: char| !c.is_alphanumeric() && c != '_');
    let word = &text[begin..word_end.map_or(text.len(), |end| begin + end)];
    if words::is_keyword(word) {
        return Err(Box::new(errors::keyword(word, span(begin, begin + word.len()))));
    }
    match first('=') {
        None => Err(Box::new(errors::no_equals(text.trim(), first(':'), span(0, text.len())))),
        Some(at) if text[..at].trim().is_empty() => {
            Err(Box::new(errors::no_path(span(at, at + 1))))
        }
        Some(at) => Ok(at),
    }
}
