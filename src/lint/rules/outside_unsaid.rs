//! A body of clear matter inside of another, before whose surface a vacuum is taken.

use crate::bodies::Placed;
use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::lint::inside::{Side, side};
use crate::scene::Material;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let boxes: Vec<_> = shot.things.iter().map(|thing| (thing, thing.bounds())).collect();
    for (thing, bounds) in boxes.iter().filter(|(_, bounds)| !bounds.is_empty()) {
        let Some(at) = unsaid(thing) else { continue };
        let around = boxes.iter().find(|(outer, space)| {
            let inside = |p| side(outer, space, p) == Side::Behind;
            !std::ptr::eq(*thing, *outer)
                && outer.transmits()
                && bounds.corners().into_iter().all(inside)
        });
        if let Some((outer, _)) = around {
            found.push(in_a_vacuum(thing, outer, at));
        }
    }
}

/// Where a material of clear matter stands that does not say what is before it.
fn unsaid(thing: &Placed) -> Option<Span> {
    thing.materials.iter().find_map(|material| match &material.value.value {
        Material::Dielectric(dielectric) if dielectric.outside.is_none() => {
            Some(material.value.span)
        }
        _ => None,
    })
}

fn in_a_vacuum(thing: &Placed, outer: &Placed, at: Span) -> Diagnostic {
    let (name, around) = (&thing.name().value, &outer.name().value);
    let headline = format!("`{name}` is inside of `{around}`, and before its surface is a vacuum");
    Diagnostic::warning(Code::LINT_OUTSIDE_UNSAID, headline)
        .label(at, "says nothing of what is outside")
        .label(outer.name().span, "is around it")
        .why("Light is bent by the ratio of two indices, and a vacuum is taken for the one that is not said.")
        .help(format!("write `outside`, with the medium that is inside of `{around}`"))
}
