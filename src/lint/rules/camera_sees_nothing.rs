//! A camera that has all objects behind it, or beside its field of view.

use glam::DVec3;

use crate::bodies::Body;
use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::lint::view::View;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let Some(view) = View::of(shot) else { return };
    // A plane without end is seen by nearly any camera.
    if shot.things.is_empty() || shot.things.iter().any(|it| matches!(it.body, Body::Plane { .. }))
    {
        return;
    }
    let boxes: Vec<_> = shot.things.iter().map(|thing| thing.bounds()).collect();
    let missed = |side: DVec3| {
        move |bounds: &crate::math::Bounds| {
            bounds.corners().iter().all(|corner| (*corner - view.eye).dot(side) < 0.0)
        }
    };
    let behind = boxes.iter().all(missed(view.forward));
    let seen = boxes.iter().any(|bounds| !view.sides().iter().any(|side| missed(*side)(bounds)));
    if behind || !seen {
        found.push(nothing(behind, view.at));
    }
}

fn nothing(behind: bool, at: Span) -> Diagnostic {
    let label = if behind {
        "looks this way: everything is behind it"
    } else {
        "looks this way: everything is beside its field of view"
    };
    Diagnostic::warning(Code::LINT_CAMERA_SEES_NOTHING, "the camera sees no object at all")
        .label(at, label)
        .help(
            "let `look_at` be a point of what is to be seen; `camera: overview` finds it by itself",
        )
}
