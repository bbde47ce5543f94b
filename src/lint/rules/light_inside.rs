//! A point or a spot inside of a closed object that lets no light through: it lights nothing that
//! is seen.

use crate::bodies::Placed;
use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::lint::inside::{Side, side};
use crate::scene::{Light, PointLight, SpotLight};

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let scene = &shot.stage.scene;
    let integrator = &scene.integrator.value;
    let Some((eye, _)) = shot.eye() else { return };
    if !integrator.follows_light() || integrator.shadows().is_err() {
        return;
    }
    for light in &scene.lights {
        let (Light::PointLight(PointLight { position, .. })
        | Light::SpotLight(SpotLight { position, .. })) = &light.value.value
        else {
            continue;
        };
        // Who is in there too sees it light the walls.
        let around = shot.things.iter().find(|thing| {
            let inside = |p| side(thing, &thing.bounds(), p) != Side::Outside;
            !thing.transmits() && inside(position.0) && !inside(eye)
        });
        if let Some(around) = around {
            found.push(hidden(&light.name.value, position.span, around));
        }
    }
}

fn hidden(name: &str, at: Span, around: &Placed) -> Diagnostic {
    let headline = format!("the light `{name}` is inside of `{}`", around.name().value);
    Diagnostic::warning(Code::LINT_LIGHT_INSIDE, headline)
        .label(at, "is in there")
        .label(around.name().span, "is closed, and lets no light through")
        .help("move the light out of it; for a lamp that has a surface, give the object an `emission`")
}
