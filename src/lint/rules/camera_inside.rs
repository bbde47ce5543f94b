//! A camera inside of a closed object: it sees the inner side of one surface and nothing else.

use crate::bodies::Placed;
use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::lint::inside::{Side, side};

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let Some((eye, at)) = shot.eye() else { return };
    let boxes: Vec<_> = shot.things.iter().map(|thing| (thing, thing.bounds())).collect();
    for (i, (thing, bounds)) in boxes.iter().enumerate() {
        // Walls look inward, or shine, or have something between them: that is a room.
        if thing.shines() || thing.transmits() || side(thing, bounds, eye) != Side::Behind {
            continue;
        }
        let others =
            boxes.iter().enumerate().filter(|(j, (_, other))| *j != i && !other.is_empty());
        let mut others = others.map(|(_, (_, other))| other.centre());
        if !others.any(|centre| side(thing, bounds, centre) == Side::Behind) {
            found.push(inside(thing, at));
        }
    }
}

fn inside(thing: &Placed, at: Span) -> Diagnostic {
    let headline = format!("the camera is inside of `{}`", thing.name().value);
    Diagnostic::warning(Code::LINT_CAMERA_INSIDE, headline)
        .label(at, "stands inside of it")
        .label(thing.name().span, "is closed, and lets nothing through")
        .help("move the camera away from it; or check the unit of the object, if it is too large")
}
