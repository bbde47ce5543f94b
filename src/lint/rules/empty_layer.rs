//! A layer that no path can go to.

use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::math::paths::{Automaton, Expression};
use crate::scene::{At, Integrator};

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let scene = &shot.stage.scene;
    let (picture, which) = scene.which_paths();
    let uses = |picture: Option<&Expression>, layer: usize| {
        // What is too large was told.
        Automaton::new(picture, &which).map_or(true, |made| made.layer_is_used(layer as u8))
    };
    let followed = followed(&scene.integrator.value);
    for (number, layer) in scene.layers.iter().enumerate() {
        let why = match &followed {
            _ if !uses(picture, number) => {
                "The first layer that means a path takes it, and those before this one leave none \
                 to it."
            }
            Followed::Nothing => "The integrator follows no light, so there are no paths.",
            Followed::Only(paths) if !uses(Some(paths), number) => {
                "The integrator does not follow light so far."
            }
            Followed::Only(_) | Followed::All => continue,
        };
        found.push(empty(&layer.name, why));
    }
}

/// Which paths an integrator follows.
enum Followed {
    Nothing,
    Only(Expression),
    All,
}

fn followed(integrator: &Integrator) -> Followed {
    let paths = match integrator {
        Integrator::Preview(_) => return Followed::Nothing,
        Integrator::Ambient(_) | Integrator::Direct(_) => "L (D | G)? S* E",
        Integrator::Path(_) => return Followed::All,
    };
    Expression::parse(paths).map_or(Followed::All, Followed::Only)
}

fn empty(name: &At<String>, why: &str) -> Diagnostic {
    let headline = format!("the layer `{}` stays black", **name);
    Diagnostic::warning(Code::LINT_EMPTY_LAYER, headline)
        .label(name.span, "no path comes to this one")
        .why(why)
        .help("take it away, or let other layers stand behind it or mean less")
}
