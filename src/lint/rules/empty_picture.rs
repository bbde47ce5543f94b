//! A picture of chosen paths that there cannot be, in any render.

use super::empty_layer::why;
use crate::diag::{Code, Diagnostic};
use crate::lint::{Shot, everywhere};
use crate::plan::{Chosen, Unmet};
use crate::scene::{At, Paths};

pub(in crate::lint) fn look(shots: &[Shot], found: &mut Vec<Diagnostic>) {
    found.extend(everywhere(shots, |shot| {
        let Some(shown) = shot.stage.scene.integrator.paths() else { return Vec::new() };
        let unmet = Chosen::of(shot.stage).and_then(|chosen| chosen.picture);
        vec![(shown.span, unmet.map(|unmet| black(shown, &unmet)))]
    }));
}

fn black(shown: At<&Paths>, unmet: &Unmet) -> Diagnostic {
    let headline = format!("the picture of the paths `{}` stays black", shown.text.trim());
    Diagnostic::warning(Code::LINT_EMPTY_PICTURE, headline)
        .label(shown.span, "no light takes such a path here")
        .why(why(unmet))
        .help("write paths that there are, or take `paths` away to see all light")
}
