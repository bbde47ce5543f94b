//! A render without a caption, while nearly all others of the file have one.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;

/// For each render without, so many must have one.
const OTHERS: usize = 3;

pub(in crate::lint) fn look(shots: &[Shot], found: &mut Vec<Diagnostic>) {
    let without = |shot: &&Shot| shot.stage.scene.caption.0.is_empty();
    let missing: Vec<&Shot> = shots.iter().filter(without).collect();
    if shots.len() - missing.len() >= OTHERS * missing.len() {
        found.extend(missing.iter().map(|shot| caption(shot.name(), shot.name.span)));
    }
}

fn caption(name: &str, at: Span) -> Diagnostic {
    let headline = format!("the render `{name}` has no caption, as others here have");
    Diagnostic::warning(Code::LINT_MISSING_CAPTION, headline)
        .label(at, "what does it show?")
        .help("say it in words, `caption: \"…\"`; they go into the EXR file")
}
