//! A light whose radiance or irradiance is zero in every render that has it.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::{Shot, everywhere};
use crate::scene::Light;

pub(in crate::lint) fn look(shots: &[Shot], found: &mut Vec<Diagnostic>) {
    found.extend(everywhere(shots, |shot| {
        let lights = shot.stage.scene.lights.iter().filter_map(|light| {
            let (zero, what, at) = match &light.value.value {
                Light::Constant(it) => (it.radiance.0.is_zero(), "radiance", it.radiance.span),
                Light::Directional(it) => {
                    (it.irradiance.0.is_zero(), "irradiance", it.irradiance.span)
                }
                // Dark at night alone, of which there is word already.
                Light::Preetham(_) => return None,
            };
            Some((light.name.span, zero.then(|| dark(&light.name.value, what, at))))
        });
        lights.collect()
    }));
}

fn dark(name: &str, what: &str, at: Span) -> Diagnostic {
    Diagnostic::warning(Code::LINT_DARK_LIGHT, format!("the light `{name}` shines in no render"))
        .label(at, format!("no {what} at all"))
        .help(format!("give it one, or take it away: `without light {name}` does in one render"))
}
