//! An object wholly behind an opaque plane without end, seen from the camera: under the floor.

use glam::DVec3;

use crate::bodies::{Body, Placed};
use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::math::Bounds;

/// Parts of an object's size by which it may rise from the plane and still be told: rounding.
const ROUNDING: f64 = 1e-9;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let Some((eye, at)) = shot.eye() else { return };
    let boxes: Vec<(&Placed, Bounds)> = shot.things.iter().map(|it| (it, it.bounds())).collect();
    let bounded: Vec<_> = boxes.iter().filter(|(_, bounds)| !bounds.is_empty()).collect();
    for plane in &shot.things {
        let Body::Plane { point, normal, .. } = plane.body else { continue };
        // Through glass and water, and what has some of them mixed in, the other side is seen.
        if plane.transmits() {
            continue;
        }
        let side = (eye - point).dot(normal).signum();
        let hidden = |bounds: &Bounds| {
            let most = ROUNDING * bounds.size();
            let heights = bounds.corners().map(|p: DVec3| (p - point).dot(normal) * side);
            // What lies in the plane is not behind it.
            heights.iter().all(|h| *h <= most) && heights.iter().any(|h| *h < -most)
        };
        let behind: Vec<_> = bounded.iter().filter(|(_, bounds)| hidden(bounds)).collect();
        if !behind.is_empty() && behind.len() == bounded.len() {
            found.push(camera(plane, at));
            continue;
        }
        // Without shadows a lamp shines through the floor.
        for (thing, _) in behind.iter().filter(|(thing, _)| !thing.shines()) {
            found.push(object(thing, plane));
        }
    }
}

fn camera(plane: &Placed, at: Span) -> Diagnostic {
    let headline = format!("the plane `{}` hides everything from the camera", plane.name().value);
    Diagnostic::warning(Code::LINT_HIDDEN_BY_PLANE, headline)
        .label(at, "stands on one side of it")
        .label(plane.name().span, "all objects are on its other side")
        .help("raise the camera above the plane, or lower the plane")
}

fn object(thing: &Placed, plane: &Placed) -> Diagnostic {
    let (name, floor) = (&thing.name().value, &plane.name().value);
    let headline = format!("`{name}` is hidden behind the plane `{floor}`");
    Diagnostic::warning(Code::LINT_HIDDEN_BY_PLANE, headline)
        .label(thing.name().span, "no part of it is on the camera's side")
        .label(plane.name().span, "has no end, and lets nothing through")
        .help(format!("move `{name}`, or the plane's `point`, so that it can be seen"))
}
