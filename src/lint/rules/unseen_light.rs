//! A light, or a lamp's emission, that no render follows: all of them are previews.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::{Shot, everywhere};
use crate::scene::Integrator;

pub(in crate::lint) fn look(shots: &[Shot], found: &mut Vec<Diagnostic>) {
    found.extend(everywhere(shots, |shot| {
        let scene = &shot.stage.scene;
        let preview = matches!(scene.integrator.value, Integrator::Preview(_));
        // A background is seen in previews too.
        let lights = scene.lights.iter().filter(|light| !light.value.has_extent());
        let lights = lights.map(|light| (format!("light `{}`", *light.name), light.name.span));
        let shining = scene.materials.iter().filter_map(|material| {
            let emission = material.value.emission().filter(|emission| !emission.0.is_zero())?;
            Some(("emission".to_string(), emission.span))
        });
        let told = |(what, at): (String, Span)| {
            (at, preview.then(|| unseen(&what, at, scene.integrator.span)))
        };
        lights.chain(shining).map(told).collect()
    }));
}

fn unseen(what: &str, at: Span, integrator: Span) -> Diagnostic {
    Diagnostic::warning(Code::LINT_UNSEEN_LIGHT, format!("no picture shows this {what}"))
        .label(at, "shines for nobody")
        .label(integrator, "shades all by a light at the camera, and knows no other")
        .help("render with `integrator: direct`, or take the light away")
}
