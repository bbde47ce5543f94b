//! A flat lamp whose front looks away from everything: lamps shine from their front alone.

use crate::bodies::Flat;
use crate::bodies::{Body, Placed};
use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::scene::{Integrator, Object};

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let Some((eye, _)) = shot.eye() else { return };
    if matches!(shot.stage.scene.integrator.value, Integrator::Preview(_)) || shot.things.len() < 2
    {
        return;
    }
    for lamp in shot.things.iter().filter(|thing| thing.shines() && !thing.shines_both_ways()) {
        let Some(flat) = Flat::of(lamp) else { continue };
        let height = |p: glam::DVec3| (p - flat.point).dot(flat.normal);
        let others = shot.things.iter().filter(|other| !std::ptr::eq(*other, lamp));
        let least = 1e-9 * lamp.bounds().size();
        let lit = others.into_iter().any(|other| match &other.body {
            // It rises somewhere, unless it is parallel.
            Body::Plane { point, normal, .. } => {
                normal.cross(flat.normal).length() > 1e-9 || height(*point) > least
            }
            _ => other.bounds().corners().into_iter().any(|corner| height(corner) > least),
        });
        // Who looks at its front sees it shine: then it is there to be seen.
        if !lit && height(eye) <= 0.0 {
            found.push(away(lamp));
        }
    }
}

fn away(lamp: &Placed) -> Diagnostic {
    let name = &lamp.name().value;
    let turn = match &lamp.object.value.value {
        Object::Quad(_) => "swap its `u` and `v`",
        Object::Triangle(_) => "swap two of its corners",
        _ => "turn its `normal` round",
    };
    Diagnostic::warning(
        Code::LINT_LAMP_FACES_AWAY,
        format!("the lamp `{name}` faces away from all there is"),
    )
    .label(lamp.name().span, "nothing is on its front side, and the camera is not either")
    .why("A lamp shines from its front alone. The front of a quad is where u × v points.")
    .help(format!("{turn}, to have it shine to the other side"))
}
