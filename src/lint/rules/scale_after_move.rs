//! A scale that follows a move: it scales the way that was moved as well.

use glam::DVec3;

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::scene::Step;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    for thing in &shot.things {
        let place = thing.place();
        let moves = |step: &Step| matches!(step, Step::Move(by) if *by != DVec3::ZERO);
        let scales = |step: &Step| matches!(step, Step::Scale(by) if *by != DVec3::ONE);
        let steps = &place.value.0;
        let first = steps.iter().position(moves);
        let last = steps.iter().rposition(scales);
        // Who moves again afterwards scales about a point, or knows.
        if let (Some(first), Some(last)) = (first, last)
            && first < last
            && !steps[last..].iter().any(moves)
        {
            found.push(after(&thing.name().value, place.span));
        }
    }
}

fn after(name: &str, at: Span) -> Diagnostic {
    let headline = format!("`{name}` is scaled after it was moved");
    Diagnostic::warning(Code::LINT_SCALE_AFTER_MOVE, headline)
        .label(at, "the scale stretches the way it was moved, too")
        .why("Steps go first to last, and a scale goes out from the origin.")
        .help(
            "write `scale` before `move`; or `move` it back afterwards, to scale it about a point",
        )
}
