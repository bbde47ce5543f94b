//! Layers of the scene → the automaton that says to which of them a path belongs.

use super::errors::paths as errors;
use crate::diag::Diagnostic;
use crate::math::paths::Automaton;
use crate::plan::{Feature, Plan};
use crate::scene::{Layer, Named, Only, Scene};

/// What the EXR calls something beside the layers.
const TAKEN: [&str; 2] = ["error", "samples"];
/// What channels are called within a layer, by the conventions of the EXR.
const CHANNELS: [&str; 8] = ["R", "G", "B", "A", "X", "Y", "Z", "L"];

/// Says of each path where its light goes. None where the plan leaves it out, and all light goes to
/// the picture alone; or something is wrong, which is told.
pub(super) fn automaton(
    scene: &Scene,
    plan: &Plan,
    found: &mut Vec<Diagnostic>,
) -> Option<Automaton> {
    let before = found.len();
    names(scene, found);
    let (picture, which) = scene.which_paths();
    let only = scene.layers.iter().map(|layer| {
        let Layer::PathsLayer(layer) = &*layer.value;
        &layer.only
    });
    let mut others = only.clone().filter(|only| only.value == Only::Others);
    if let (Some(first), Some(second)) = (others.next(), others.next()) {
        found.push(errors::others_twice(second.span, first.span));
    }
    if found.len() > before || !plan.builds(Feature::Paths) {
        return None;
    }
    let made = Automaton::new(picture, &which);
    made.map_err(|what| {
        // The first one with which it is too much.
        let fails = |count: &usize| Automaton::new(picture, &which[..*count]).is_err();
        let count = (0..which.len()).find(fails).unwrap_or(which.len());
        let at = match count.checked_sub(1) {
            None => scene.integrator.paths().map(|shown| shown.span),
            Some(last) => only.clone().nth(last).map(|only| only.span),
        };
        let at = at.unwrap_or(scene.integrator.span);
        found.push(errors::too_large(what, at));
    })
    .ok()
}

/// Layers are channels of a file, which has no two of one name, whatever the case.
fn names(scene: &Scene, found: &mut Vec<Diagnostic>) {
    for (number, layer) in scene.layers.iter().enumerate() {
        let name = &layer.name;
        let allowed = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.');
        let sound = !name.is_empty()
            && name.len() <= 100
            && name.chars().all(allowed)
            && !name.starts_with('.')
            && !name.ends_with('.')
            && !name.contains("..");
        let mut parts = name.split('.');
        let first = parts.clone().next().unwrap_or("");
        let same = |word: &&&'static str| word.eq_ignore_ascii_case(first);
        let channel = |part: &str| CHANNELS.iter().find(|it| it.eq_ignore_ascii_case(part));
        let alike = |other: &&Named<Layer>| other.name.eq_ignore_ascii_case(name);
        if !sound {
            found.push(errors::bad_name(name));
        } else if let Some(taken) = TAKEN.iter().find(same) {
            found.push(errors::taken_name(name, taken));
        } else if let Some(channel) = parts.find_map(channel) {
            found.push(errors::channel_name(name, channel));
        } else if let Some(other) = scene.layers[..number].iter().find(alike) {
            found.push(errors::names_alike(name, &other.name));
        }
    }
}
