//! An object wholly inside of another that is closed: it is not seen, and shines on nothing.

use crate::bodies::Placed;
use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::lint::inside::{Side, side};

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let Some((eye, _)) = shot.eye() else { return };
    let boxes: Vec<_> = shot.things.iter().map(|thing| (thing, thing.bounds())).collect();
    for (thing, bounds) in boxes.iter().filter(|(_, bounds)| !bounds.is_empty()) {
        let around = boxes.iter().find(|(outer, space)| {
            let fits = space.holds(bounds.min) && space.holds(bounds.max);
            let inside = |p| side(outer, space, p) != Side::Outside;
            !std::ptr::eq(*thing, *outer)
                && !outer.transmits()
                && fits
                && bounds.corners().into_iter().all(inside)
                && !inside(eye)
        });
        if let Some((outer, _)) = around {
            found.push(enclosed(thing, outer));
        }
    }
}

fn enclosed(thing: &Placed, outer: &Placed) -> Diagnostic {
    let (name, around) = (&thing.name().value, &outer.name().value);
    let (what, label) = match thing.shines() {
        true => ("lamp", "shines on the inside of the other alone"),
        false => ("object", "is seen by nobody"),
    };
    let headline = format!("the {what} `{name}` is wholly inside of `{around}`");
    Diagnostic::warning(Code::LINT_ENCLOSED, headline)
        .label(thing.name().span, label)
        .label(outer.name().span, "is closed, and lets no light through")
        .help(format!("move `{name}` out of it, or take it away"))
}
