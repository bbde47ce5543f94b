//! A limit of error that can never end the render: the samples end it first.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;

/// No error is looked at of fewer samples a pixel.
const LEAST: u64 = 256;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let stop = &shot.stage.scene.stop;
    if let (Some(samples), Some(_)) = (&stop.samples.value, &stop.error.value)
        && shot.own_limits
        && samples.0 <= LEAST
    {
        found.push(unreachable(samples.0, stop.samples.span, stop.error.span));
    }
}

fn unreachable(samples: u64, at: Span, error: Span) -> Diagnostic {
    let headline = format!("after {samples} samples no error can have ended the render");
    Diagnostic::warning(Code::LINT_UNREACHABLE_ERROR, headline)
        .label(error, "is never looked at")
        .label(at, "ends the render first")
        .why(format!(
            "The error of a picture is looked at from {LEAST} samples a pixel on, not before."
        ))
        .help("allow more samples, such as `samples: 4096`, or ask for no error")
}
