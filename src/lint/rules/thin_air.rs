//! A sky of a turbidity below 2: the model was not fitted to air that thin.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::scene::Light;

/// From here on skies darken towards the horizon as air gets thinner, as they do in nature.
const CLEAREST: f64 = 2.0;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    for light in &shot.stage.scene.lights {
        if let Light::Preetham(sky) = &light.value.value
            && sky.turbidity.0 < CLEAREST
        {
            found.push(thin(&light.name.value, sky.turbidity.span));
        }
    }
}

fn thin(name: &str, turbidity: Span) -> Diagnostic {
    let headline = format!("the air of `{name}` is thinner than its model holds for");
    Diagnostic::warning(Code::LINT_THIN_AIR, headline)
        .label(turbidity, "below 2 the horizon grows brighter the thinner the air is")
        .why("At 1.7 it may be 28 times as bright as the zenith, and the ground gets twice the light that it gets at 2.")
        .help("write `turbidity: 2`: very clear air")
}
