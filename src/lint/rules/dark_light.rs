//! A light whose radiance, irradiance or intensity is zero in every render that has it.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::{Shot, everywhere};

pub(in crate::lint) fn look(shots: &[Shot], found: &mut Vec<Diagnostic>) {
    found.extend(everywhere(shots, |shot| {
        let lights = shot.stage.scene.lights.iter().filter_map(|light| {
            let shine = light.value.shine()?;
            let zero = shine.spectrum.is_zero();
            Some((light.name.span, zero.then(|| dark(&light.name.value, shine.what, shine.at))))
        });
        lights.collect()
    }));
}

fn dark(name: &str, what: &str, at: Span) -> Diagnostic {
    Diagnostic::warning(Code::LINT_DARK_LIGHT, format!("the light `{name}` shines in no render"))
        .label(at, format!("no {what} at all"))
        .help(format!("give it one, or take it away: `without light {name}` does in one render"))
}
