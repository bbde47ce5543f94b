//! A surface with the same medium on both sides: nothing is there.

use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::scene::Material;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    for material in &shot.stage.scene.materials {
        let Material::Dielectric(dielectric) = &material.value.value else { continue };
        if dielectric.outside.as_ref() == Some(&dielectric.inside.value) {
            let name = &dielectric.inside.name;
            let headline = format!("`{}` has `{name}` on both of its sides", *material.name);
            found.push(
                Diagnostic::warning(Code::LINT_SAME_MEDIUM, headline)
                    .label(dielectric.inside.span, "behind the face …")
                    .label(dielectric.outside.span, "… and before it")
                    .help("such a surface cannot be seen: name another medium, or leave `outside` out for what is around the body"),
            );
        }
    }
}
