//! Clear matter whose surface is open: light goes in, and is inside for ever.

use crate::bodies::{Body, Placed};
use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::lint::inside::is_closed;
use crate::scene::Material;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    for thing in &shot.things {
        let Some(medium) = media(thing).next() else { continue };
        let open = match &thing.body {
            Body::Face { .. } | Body::Disk { .. } => true,
            Body::Mesh { mesh, .. } => !is_closed(mesh),
            // A plane has all beyond it behind its face.
            Body::Plane { .. } | Body::Sphere { .. } => false,
        };
        // Several surfaces may close together; whether they do is not looked at.
        let mut others = shot.things.iter().filter(|other| !std::ptr::eq(*other, thing));
        if open && !others.any(|other| media(other).any(|name| name == medium)) {
            let headline = format!("light that goes into `{}` never comes out", thing.name().value);
            let label = format!("is open, and the only surface around the medium `{medium}`");
            found.push(
                Diagnostic::warning(Code::LINT_OPEN_GLASS, headline)
                    .label(thing.name().span, label)
                    .why("A face parts what is behind it from what is before it. Clear matter needs faces on all sides.")
                    .help("for a pane write two faces, each turned outward; for a mesh, close its holes"),
            );
        }
    }
}

/// The media that surfaces of a thing have on a side.
fn media<'a>(thing: &Placed<'a>) -> impl Iterator<Item = &'a str> {
    let sides = thing.all_parts().filter_map(|part| match &part.value.value {
        Material::Dielectric(it) => Some([Some(&it.inside.value), it.outside.value.as_ref()]),
        _ => None,
    });
    let names = sides.flatten().flatten().map(|medium| medium.name.as_str());
    names.collect::<Vec<_>>().into_iter()
}
