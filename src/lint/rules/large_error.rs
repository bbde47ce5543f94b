//! A limit of error so large that per cent were probably meant.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;

/// Larger errors are seen at a glance; nobody waits for so little.
const LARGEST: f64 = 0.1;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let error = &shot.stage.scene.stop.error;
    if let Some(limit) = error.value.as_ref().filter(|limit| limit.0 > LARGEST) {
        found.push(large(limit.0, error.span));
    }
}

fn large(limit: f64, at: Span) -> Diagnostic {
    let (percent, meant) = (rounded(limit * 100.0), rounded(limit));
    let headline = format!("this render may end with an error of {percent} %");
    Diagnostic::warning(Code::LINT_LARGE_ERROR, headline)
        .label(at, format!("is {percent} %"))
        .why("A number without `%` is a part of one: 1 is all of the light.")
        .help(format!("did you mean `{meant} %`?"))
}

/// Without the dust of rounding.
fn rounded(x: f64) -> f64 {
    (x * 1e6).round() / 1e6
}
