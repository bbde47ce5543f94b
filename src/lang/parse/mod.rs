//! Text → tree, by the grammar in grammar/scn.pest. The only folder that knows pest.

mod build;
mod explain;
mod foreign;
mod hints;
mod strings;
mod unit_form;
mod values;

use std::sync::Arc;

use pest::Parser;

use super::ast::{Expr, ExprKind, File, Set};
use super::errors::syntax;
use super::faults::Faults;
use super::limits;
use super::scan::{Scanned, scan};
use crate::diag::{Code, Diagnostic, FileId, Span};

use build::Builder;
pub use explain::innermost;

#[derive(pest_derive::Parser)]
#[grammar = "../grammar/scn.pest"]
struct Grammar;

type Pair<'t> = pest::iterators::Pair<'t, Rule>;

/// A tree and what is wrong with its text.
pub struct Parsed<T> {
    /// The tree, of what could be read.
    pub tree: T,
    /// What is wrong.
    pub faults: Faults,
    /// Places around repairs, where any further fault is probably a consequence.
    pub muted: Vec<Span>,
}

/// Reads a file.
pub fn file(text: &str, id: FileId) -> Parsed<File> {
    let mut tree = File::default();
    let whole = Span::new(id, 0, text.len());
    if text.len() > limits::FILE_BYTES {
        return failed(tree, syntax::file_too_large(whole));
    }
    if let Some(foreign) = foreign::recognise(text) {
        tree.first_line = Some(whole);
        let line = Span::new(id, foreign.line.start, foreign.line.end);
        let told = failed(tree, syntax::other_program(foreign.program, line));
        return Parsed { muted: vec![whole], ..told };
    }
    let scanned = scan(text);
    let mut faults = told(&scanned, text, id);
    let deep = faults.kept.iter().any(|d| d.code == Code::SYNTAX_TOO_DEEP);
    if deep || scanned.hopeless {
        tree.first_line = Some(whole);
        if !deep {
            faults.stop();
        }
        return Parsed { tree, faults, muted: vec![whole] };
    }
    let mut muted: Vec<_> = scanned.muted.iter().map(|r| Span::new(id, r.start, r.end)).collect();
    let source = scanned.repaired.clone().unwrap_or_else(|| text.to_string());
    match Grammar::parse(Rule::file, &source) {
        Ok(mut pairs) => {
            let mut builder = Builder::new(id, &source, &scanned);
            tree = builder.file(pairs.next().expect("a file"));
            muted.append(&mut builder.muted);
            faults.append(builder.faults);
        }
        Err(error) => {
            let at = scanned.original(stopped(&error));
            faults.push(explain::at(text, at, id));
        }
    }
    if faults.kept.iter().any(|told| told.code == Code::SYNTAX_EDITION) {
        // Of another edition nobody knows what is wrong.
        faults.kept.retain(|told| told.code == Code::SYNTAX_EDITION);
        muted.push(whole);
    }
    Parsed { tree, faults, muted }
}

/// Where the first line, items and fields begin, in bytes; or what is wrong with the text.
pub fn starts(text: &str, id: FileId) -> Result<Vec<usize>, Vec<Diagnostic>> {
    let parsed = file(text, id);
    if !parsed.faults.is_empty() {
        return Err(parsed.faults.finish());
    }
    let pairs = Grammar::parse(Rule::file, text);
    let pairs = pairs.map_err(|error| vec![explain::at(text, stopped(&error), id)])?;
    let begins = |rule| {
        use Rule::*;
        matches!(rule, edition | r#use | let_ | for_ | setup | render | without | set | entry)
    };
    let starts = pairs.flatten().filter(|pair| begins(pair.as_rule()));
    Ok(starts.map(|pair| pair.as_span().start()).collect())
}

/// Reads an argument of `--set`, whose `=` was replaced by `:`.
pub fn set(text: &str, id: FileId) -> Parsed<Option<Set>> {
    let (pair, mut parsed) = alone(Rule::set_alone, text, id);
    if let Some(pair) = pair {
        let scanned = Scanned::default();
        let mut builder = Builder::new(id, text, &scanned);
        let set = pair.into_inner().next().map(|set| builder.set(set));
        parsed.faults.append(builder.faults);
        return Parsed { tree: set.filter(|_| parsed.faults.is_empty()), ..parsed };
    }
    parsed
}

/// Reads a value alone: a default of the schema.
pub fn value(text: &str, id: FileId) -> Parsed<Arc<Expr>> {
    let (pair, mut parsed) = alone::<()>(Rule::value_alone, text, id);
    let mut tree = Expr { kind: ExprKind::Broken, span: Span::new(id, 0, text.len()) };
    if let Some(pair) = pair {
        let scanned = Scanned::default();
        let mut builder = Builder::new(id, text, &scanned);
        if let Some(value) = pair.into_inner().next() {
            tree = builder.value(value);
        }
        parsed.faults.append(builder.faults);
    }
    Parsed { tree: Arc::new(tree), faults: parsed.faults, muted: Vec::new() }
}

/// A text that is one thing: nothing is repaired in it.
fn alone<T>(rule: Rule, text: &str, id: FileId) -> (Option<Pair<'_>>, Parsed<Option<T>>) {
    let mut faults = told(&scan(text), text, id);
    let mut found = None;
    if faults.is_empty() {
        match Grammar::parse(rule, text) {
            Ok(mut pairs) => found = pairs.next(),
            Err(error) => faults.push(explain::at(text, stopped(&error), id)),
        }
    }
    (found, Parsed { tree: None, faults, muted: Vec::new() })
}

fn failed<T>(tree: T, diagnostic: Diagnostic) -> Parsed<T> {
    let mut faults = Faults::default();
    faults.push(diagnostic);
    Parsed { tree, faults, muted: Vec::new() }
}

fn told(scanned: &Scanned, text: &str, id: FileId) -> Faults {
    let mut faults = Faults::default();
    scanned.faults.iter().for_each(|fault| faults.push(syntax::brackets(fault, text, id)));
    faults
}

/// Where the grammar could not go on.
fn stopped(error: &pest::error::Error<Rule>) -> usize {
    match error.location {
        pest::error::InputLocation::Pos(at) => at,
        pest::error::InputLocation::Span((start, _)) => start,
    }
}

/// Whether a fault stands at a place that was repaired.
pub fn within(diagnostic: &Diagnostic, muted: &[Span]) -> bool {
    let Some(place) = diagnostic.place() else { return false };
    let inside = |m: &Span| m.file == place.file && m.start <= place.start && place.start < m.end;
    muted.iter().any(inside)
}
