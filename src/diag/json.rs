//! Diagnostics for machines: one JSON object with all of them.
//!
//! Lines and columns count from 1, columns in characters; `end_column` is one past the last.

use serde::Serialize;

use super::lines::Lines;
use super::{Diagnostic, Sources, Span, order};

#[derive(Serialize)]
struct Report<'a> {
    diagnostics: Vec<Fault<'a>>,
    errors: usize,
    warnings: usize,
}

#[derive(Serialize)]
struct Fault<'a> {
    code: &'static str,
    level: String,
    headline: &'a str,
    why: Option<&'a str>,
    help: Option<&'a str>,
    labels: Vec<Place<'a>>,
    mends: Vec<Mend<'a>>,
}

#[derive(Serialize)]
struct Mend<'a> {
    title: &'a str,
    safe: bool,
    edits: Vec<Place<'a>>,
}

/// A place with words: of a label, or to stand there.
#[derive(Serialize)]
struct Place<'a> {
    file: &'a str,
    line: usize,
    column: usize,
    end_line: usize,
    end_column: usize,
    text: &'a str,
}

/// `{"diagnostics": […], "errors": n, "warnings": n}`.
pub fn report(diagnostics: &[Diagnostic], sources: &Sources) -> serde_json::Value {
    let mut lines = Lines::new(sources);
    let (errors, warnings) = order::count(diagnostics);
    let diagnostics = diagnostics.iter().map(|diagnostic| fault(diagnostic, &mut lines)).collect();
    serde_json::to_value(Report { diagnostics, errors, warnings })
        .expect("words and numbers are always JSON")
}

fn fault<'a>(diagnostic: &'a Diagnostic, lines: &mut Lines<'a>) -> Fault<'a> {
    let labels = diagnostic.labels.iter().map(|l| place(l.span, &l.text, lines)).collect();
    let mends = diagnostic
        .mends
        .iter()
        .map(|mend| Mend {
            title: &mend.title,
            safe: mend.safe,
            edits: mend.edits.iter().map(|edit| place(edit.span, &edit.text, lines)).collect(),
        })
        .collect();
    Fault {
        code: diagnostic.code.name,
        level: diagnostic.level.to_string(),
        headline: &diagnostic.headline,
        why: diagnostic.why.as_deref(),
        help: diagnostic.help.as_deref(),
        labels,
        mends,
    }
}

fn place<'a>(span: Span, text: &'a str, lines: &mut Lines<'a>) -> Place<'a> {
    let (start, end) = lines.positions(span);
    Place {
        file: &lines.sources().get(span.file).name,
        line: start.line,
        column: start.column,
        end_line: end.line,
        end_column: end.column,
        text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::Code;

    #[test]
    fn control_characters_in_names_and_words_stay_json() {
        let mut sources = Sources::new();
        let file = sources.add("a\u{1}\"\n.scn", "é\0x\n");
        let fault = Diagnostic::error(Code::SYNTAX_UNEXPECTED, "a \u{7} bell")
            .label(Span::new(file, 3, 4), "\u{1b}[0m")
            .mend("write `y`", Span::new(file, 3, 4), "y");
        let text = report(&[fault], &sources).to_string();
        let back: serde_json::Value = serde_json::from_str(&text).unwrap();
        let first = &back["diagnostics"][0];
        assert_eq!(first["headline"], "a \u{7} bell");
        assert_eq!(first["labels"][0]["column"], 3);
        assert_eq!(first["labels"][0]["file"], "a\u{1}\"\n.scn");
        assert_eq!(first["mends"][0]["edits"][0]["text"], "y");
        assert_eq!((&back["errors"], &back["warnings"]), (&1.into(), &0.into()));
    }
}
