//! A rotation by several turns: an angle in degrees with the unit `rad`.

use std::f64::consts::TAU;

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::scene::Step;

/// Turns beyond which nobody turns a thing on purpose; an animation may count up to a few.
const MOST: f64 = 4.0;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    for thing in &shot.things {
        let place = thing.place();
        for step in &place.value.0 {
            if let Step::Rotate(_, angle) = step
                && angle.abs() > MOST * TAU
            {
                found.push(many(&thing.name().value, *angle, place.span));
            }
        }
    }
}

fn many(name: &str, angle: f64, at: Span) -> Diagnostic {
    let turns = (angle.abs() / TAU).floor();
    let headline = format!("`{name}` is rotated by more than {turns} whole turns");
    let angle = (angle * 1e6).round() / 1e6;
    Diagnostic::warning(Code::LINT_MANY_TURNS, headline)
        .label(at, format!("by {angle} rad in one step"))
        .why("Whole turns change nothing.")
        .help(format!("write `{angle} deg`, if degrees are meant"))
}
