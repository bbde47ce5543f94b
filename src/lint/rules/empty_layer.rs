//! A layer that no path can go to in any render.

use crate::diag::words::few;
use crate::diag::{Code, Diagnostic};
use crate::lint::NAMES;
use crate::lint::{Shot, everywhere};
use crate::plan::{Chosen, Unmet};
use crate::scene::{At, Layer, Only};

pub(in crate::lint) fn look(shots: &[Shot], found: &mut Vec<Diagnostic>) {
    found.extend(everywhere(shots, |shot| {
        // What cannot be told apart was told, and a black picture is.
        let chosen = Chosen::of(shot.stage).filter(|chosen| chosen.picture.is_none());
        let unmet = chosen.map(|chosen| chosen.layers).unwrap_or_default();
        let layers = shot.stage.scene.layers.iter().zip(unmet);
        let told = layers.map(|(layer, unmet)| {
            let Layer::PathsLayer(paths) = &*layer.value;
            // What is left may be nothing.
            let rest = *paths.only == Only::Others;
            let unmet = unmet.filter(|unmet| !rest || *unmet == Unmet::Taken);
            (layer.name.span, unmet.map(|unmet| empty(&layer.name, &unmet)))
        });
        told.collect()
    }));
}

fn empty(name: &At<String>, unmet: &Unmet) -> Diagnostic {
    let help = match unmet {
        Unmet::Taken => "take it away, or let other layers stand behind it or mean less",
        Unmet::NotFollowed => "take it away, or follow light further: `integrator: path`",
        Unmet::NoSurface(_) => "take it away, or write what surfaces do",
    };
    Diagnostic::warning(Code::LINT_EMPTY_LAYER, format!("the layer `{}` stays black", **name))
        .label(name.span, "no path comes to this one")
        .why(why(unmet))
        .help(help)
}

/// Why nothing comes, in a sentence.
pub(super) fn why(unmet: &Unmet) -> String {
    match unmet {
        Unmet::Taken => "The first layer that means a path takes it, and those before this one \
                         leave none to it, or the picture shows none of its paths."
            .to_string(),
        Unmet::NotFollowed => "The integrator does not follow light so far.".to_string(),
        Unmet::NoSurface(events) if events.is_empty() => "The scene has no surfaces.".to_string(),
        Unmet::NoSurface(events) => {
            let all = few(events.iter().map(|event| event.letter()), NAMES);
            format!("No surface scatters so: what surfaces here do with light is {all}.")
        }
    }
}
