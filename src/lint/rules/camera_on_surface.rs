//! A camera that stands on a surface: rounding decides on which side of it.

use crate::bodies::{self, Placed};
use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let Some((eye, at)) = shot.eye() else { return };
    let within = bodies::together(&shot.stage.scene.camera.value, &shot.things);
    let on = |thing: &&Placed| bodies::is_on(thing, eye, within);
    found.extend(shot.things.iter().filter(on).map(|thing| stands_on(thing, at)));
}

fn stands_on(thing: &Placed, at: Span) -> Diagnostic {
    let name = &thing.name().value;
    let headline = format!("the camera stands on the surface of `{name}`");
    let why = match thing.transmits() {
        true => {
            "Rounding decides on which side of it the camera is, and so what medium it is in: the picture is of the one or of the other."
        }
        false => "Rounding decides on which side of it the camera is, ray by ray.",
    };
    Diagnostic::warning(Code::LINT_CAMERA_ON_SURFACE, headline)
        .label(at, "is at no distance from it")
        .label(thing.name().span, "the surface")
        .why(why)
        .help("move the camera to the side that is meant")
}
