//! Expressions over paths of light.

use crate::diag;
use crate::diag::Span;
use crate::lang::errors::{name as names, paths as errors};
use crate::lang::eval::Evaluator;
use crate::lang::value::{Value, ValueKind};
use crate::math::paths::Expression;
use crate::scene::Paths;
use crate::scene::schema::{Checked, Words};

/// An expression in quotes, or one of `words`.
pub fn paths(ev: &Evaluator, value: &Value, words: Option<&Words>, what: &str) -> Option<Checked> {
    let all: Vec<&str> = words.iter().flat_map(|words| words.all).map(|(word, _)| *word).collect();
    let span = value.span;
    match &value.kind {
        ValueKind::Word(word) => {
            let found = all.iter().position(|known| *known == &*word.text);
            if found.is_none() && diag::near(&word.text, all.iter().copied()).is_empty() {
                ev.reports.tell(errors::no_text(what, &value.described(), &all, span));
            } else if found.is_none() {
                ev.reports.tell(names::unknown_word(what, &word.text, &all, span));
            }
            found.map(Checked::Word)
        }
        ValueKind::Text { text, .. } if all.contains(&text.trim()) => {
            ev.reports.tell(errors::word_in_quotes(what, text.trim(), span));
            None
        }
        ValueKind::Text { text, .. } => match Expression::parse(text) {
            Ok(expression) => Some(Checked::Paths(Paths { text: text.to_string(), expression })),
            Err(faults) => {
                // Where the text stands as it is, faults are shown in it.
                let plain = ev.written(span).is_some_and(|written| {
                    written.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) == Some(text)
                });
                for fault in &faults {
                    let inside = plain.then(|| {
                        let start = span.start as usize + 1;
                        Span::new(span.file, start + fault.at.start, start + fault.at.end)
                    });
                    ev.reports.tell(errors::unreadable(what, fault, text, (span, inside)));
                }
                None
            }
        },
        _ => {
            ev.reports.tell(errors::no_text(what, &value.described(), &all, span));
            None
        }
    }
}
