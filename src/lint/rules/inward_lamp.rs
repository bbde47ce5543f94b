//! A closed mesh that shines, and whose fronts look inward: it lights its own inside.

use crate::bodies::{Body, Placed};
use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::lint::inside::{Side, is_closed, side, volume};
use crate::scene::Integrator;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let Some((eye, _)) = shot.eye() else { return };
    if matches!(shot.stage.scene.integrator.value, Integrator::Preview(_)) {
        return;
    }
    for lamp in shot.things.iter().filter(|thing| thing.shines() && !thing.shines_both_ways()) {
        let Body::Mesh { mesh, to_metres } = &lamp.body else { continue };
        if volume(mesh, *to_metres) >= 0.0 || !is_closed(mesh) {
            continue;
        }
        // A room or a sky of light is there for what is inside.
        let bounds = lamp.bounds();
        let others = shot.things.iter().filter(|other| !std::ptr::eq(*other, lamp));
        let centres = others.map(Placed::bounds).filter(|it| !it.is_empty()).map(|it| it.centre());
        let inside = |p| side(lamp, &bounds, p) != Side::Outside;
        if !centres.chain([eye]).any(inside) {
            found.push(inward(lamp));
        }
    }
}

fn inward(lamp: &Placed) -> Diagnostic {
    let headline = format!("the lamp `{}` shines inward", lamp.name().value);
    Diagnostic::warning(Code::LINT_INWARD_LAMP, headline)
        .label(lamp.name().span, "is closed, and the fronts of its faces look inward")
        .why("A lamp shines from the front of its faces, from which their corners are counter-clockwise.")
        .help("turn its faces round in the program that made it, or let both sides shine: `emits: both`")
}
