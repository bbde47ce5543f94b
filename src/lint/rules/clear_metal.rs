//! A metal that absorbs nothing: that is the index of glass.

use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::scene::Material;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    for material in &shot.stage.scene.materials {
        let Material::Conductor(conductor) = &material.value.value else { continue };
        if !conductor.ior.absorbs() {
            let headline = format!("the metal `{}` absorbs no light", *material.name);
            found.push(
                Diagnostic::warning(Code::LINT_CLEAR_METAL, headline)
                    .label(conductor.ior.span, "has no imaginary part: this is clear matter, such as glass")
                    .why("What a metal does not reflect it absorbs, by the k of its index n + ik.")
                    .help("write `metal.gold` or `complex(n, k)`; for glass, `dielectric` with a medium inside"),
            );
        }
    }
}
