//! Two lights that are the same: copied, and shining twice as bright.

use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::scene::{Light, Named};

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let lights = &shot.stage.scene.lights;
    for (i, light) in lights.iter().enumerate() {
        if let Some(twin) = lights[..i].iter().find(|other| other.value == light.value) {
            found.push(twins(light, twin));
        }
    }
}

fn twins(light: &Named<Light>, twin: &Named<Light>) -> Diagnostic {
    let headline =
        format!("the lights `{}` and `{}` are the same", twin.name.value, light.name.value);
    Diagnostic::warning(Code::LINT_TWIN_LIGHTS, headline)
        .label(light.name.span, "shines as …")
        .label(twin.name.span, "… this does, and adds to it")
        .help("change one of them, or take it away and make the other twice as bright")
}
