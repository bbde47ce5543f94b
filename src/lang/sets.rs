//! The arguments of `--set`, each a text of its own: `path=value`.

use std::path::Path;

use super::ast;
use super::errors::sets as errors;
use super::eval::{Evaluator, FileFacts};
use super::{parse, words};
use crate::diag::{FileId, Sources, Span};

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
        // The form of an item.
        let mut item = text.clone();
        item.replace_range(equals..=equals, ":");
        let parsed = parse::set(&item, id);
        ev.reports.tell_text(id, parsed.faults);
        all.extend(parsed.tree);
    }
    all
}

/// Where the path ends and the value begins.
fn equals(text: &str, id: FileId) -> Result<usize, Box<crate::diag::Diagnostic>> {
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
