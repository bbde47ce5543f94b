//! A light without extent that comes from behind a plane without end: through the floor.

use glam::DVec3;

use crate::bodies::{Body, Placed};
use crate::diag::{Code, Diagnostic, Span};
use crate::lint::{Shot, everywhere};
use crate::scene::{Light, PointLight, SpotLight};

pub(in crate::lint) fn look(shots: &[Shot], found: &mut Vec<Diagnostic>) {
    found.extend(everywhere(shots, |shot| {
        let scene = &shot.stage.scene;
        let integrator = &scene.integrator.value;
        let shadows = integrator.follows_light() && integrator.shadows().is_ok();
        let shining = scene
            .lights
            .iter()
            .filter(|light| light.value.shine().is_some_and(|shine| !shine.spectrum.is_zero()));
        let judged = shining.filter_map(|light| {
            let (from, at) = match &light.value.value {
                Light::Directional(sun) => (From::Afar(-sun.direction.0), sun.direction.span),
                Light::PointLight(PointLight { position, .. })
                | Light::SpotLight(SpotLight { position, .. }) => {
                    (From::Here(position.0), position.span)
                }
                _ => return None,
            };
            let blocks = |plane: &&Placed| shadows && blocks(shot, plane, from);
            let plane = shot.things.iter().find(blocks);
            Some((at, plane.map(|plane| behind(&light.name.value, from, at, plane))))
        });
        judged.collect()
    }));
}

/// Where light comes from.
#[derive(Clone, Copy)]
enum From {
    /// Infinitely far away, in this direction.
    Afar(DVec3),
    /// A point.
    Here(DVec3),
}

/// Whether a plane keeps the light from the side of it on which the camera and all objects are.
fn blocks(shot: &Shot, plane: &Placed, from: From) -> bool {
    let Body::Plane { point, normal, .. } = plane.body else { return false };
    let Some((eye, _)) = shot.eye() else { return false };
    let side = (eye - point).dot(normal).signum();
    let boxes = shot.things.iter().map(Placed::bounds).filter(|bounds| !bounds.is_empty());
    // What is partly below the floor may be meant to be lit there.
    let all_here = boxes.into_iter().all(|bounds| {
        let least = -1e-6 * bounds.size();
        bounds.corners().iter().all(|p| (*p - point).dot(normal) * side >= least)
    });
    let height = match from {
        From::Afar(to_light) => to_light.dot(normal),
        From::Here(light) => (light - point).dot(normal),
    };
    all_here && height * side < 0.0
}

fn behind(name: &str, from: From, at: Span, plane: &Placed) -> Diagnostic {
    let headline =
        format!("the light `{name}` comes from behind the plane `{}`", plane.name().value);
    let fault = Diagnostic::warning(Code::LINT_LIGHT_BEHIND_PLANE, headline);
    let no_way = "has no end, and lets no light through";
    match from {
        From::Afar(_) => fault
            .label(at, "goes from the plane to the objects, and so through it")
            .label(plane.name().span, no_way)
            .why("`direction` is where the light goes, not where it comes from.")
            .help("turn it round: write the direction with the other signs"),
        From::Here(_) => fault
            .label(at, "is on the other side of the plane than all objects")
            .label(plane.name().span, no_way)
            .help("move the light to the side of the objects"),
    }
}
