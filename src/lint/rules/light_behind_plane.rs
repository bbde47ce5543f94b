//! A directional light that comes from behind a plane without end: through the floor.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::placed::{Body, Thing};
use crate::lint::view::eye;
use crate::lint::{Shot, everywhere};
use crate::scene::Light;

pub(in crate::lint) fn look(shots: &[Shot], found: &mut Vec<Diagnostic>) {
    found.extend(everywhere(shots, |shot| {
        let scene = &shot.stage.scene;
        let integrator = &scene.integrator.value;
        let shadows = integrator.follows_light() && integrator.shadows().is_ok();
        let lights = scene.lights.iter().filter_map(|light| match &light.value.value {
            Light::Directional(sun) if !sun.irradiance.0.is_zero() => Some((light, sun)),
            _ => None,
        });
        let judged = lights.map(|(light, sun)| {
            let blocks = |plane: &&Thing| shadows && blocks(shot, plane, sun.direction.0);
            let plane = shot.things.iter().find(blocks);
            let at = sun.direction.span;
            (at, plane.map(|plane| behind(&light.name.value, at, plane)))
        });
        judged.collect()
    }));
}

/// Whether a plane keeps the light from the side of it on which the camera and all objects are.
fn blocks(shot: &Shot, plane: &Thing, direction: glam::DVec3) -> bool {
    let Body::Plane { point, normal } = plane.body else { return false };
    let Some((eye, _)) = eye(shot) else { return false };
    let side = (eye - point).dot(normal).signum();
    let boxes = shot.things.iter().map(Thing::bounds).filter(|bounds| !bounds.is_empty());
    // What is partly below the floor may be meant to be lit there.
    let all_here = boxes.into_iter().all(|bounds| {
        let least = -1e-6 * bounds.size();
        bounds.corners().iter().all(|p| (*p - point).dot(normal) * side >= least)
    });
    all_here && direction.dot(normal) * side > 0.0
}

fn behind(name: &str, at: Span, plane: &Thing) -> Diagnostic {
    let headline =
        format!("the light `{name}` comes from behind the plane `{}`", plane.name().value);
    Diagnostic::warning(Code::LINT_LIGHT_BEHIND_PLANE, headline)
        .label(at, "goes from the plane to the objects, and so through it")
        .label(plane.name().span, "has no end, and lets no light through")
        .why("`direction` is where the light goes, not where it comes from.")
        .help("turn it round: write the direction with the other signs")
}
