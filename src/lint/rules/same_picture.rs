//! Two renders of one file that show the same, pixel for pixel, whatever their captions say: a
//! difference was forgotten, or changes nothing.

use std::collections::HashMap;

use crate::diag::words::few;
use crate::diag::{Code, Diagnostic};
use crate::lint::NAMES;
use crate::lint::Shot;
use crate::scene::{At, Scene, Text};

pub(in crate::lint) fn look(shots: &[Shot], found: &mut Vec<Diagnostic>) {
    let mut groups: Vec<Vec<&Shot>> = Vec::new();
    let mut known: HashMap<Vec<u8>, usize> = HashMap::new();
    for shot in shots {
        let Some(picture) = picture(shot) else { continue };
        let group = *known.entry(picture).or_insert(groups.len());
        if group == groups.len() {
            groups.push(Vec::new());
        }
        groups[group].push(shot);
    }
    found.extend(groups.iter().filter(|group| group.len() > 1).map(|group| same(group)));
}

/// What the picture depends on. One file has one content in a run.
fn picture(shot: &Shot) -> Option<Vec<u8>> {
    let silent = Scene {
        caption: At::new(Text(String::new()), shot.stage.scene.caption.span),
        ..(*shot.stage.scene).clone()
    };
    let paths: Vec<_> = shot.stage.files.iter().map(|file| file.path.to_string_lossy()).collect();
    serde_json::to_vec(&(silent, paths)).ok()
}

fn same(group: &[&Shot]) -> Diagnostic {
    let (first, second) = (group[0], group[1]);
    let names: Vec<&str> = group.iter().map(|shot| shot.name()).collect();
    let headline = format!("the renders {} are the same picture", few(names, NAMES));
    let fault = Diagnostic::warning(Code::LINT_SAME_PICTURE, headline);
    let fault = if first.name.span == second.name.span {
        fault.label(second.name.span, "what changes from one to the next is not seen")
    } else {
        fault.label(second.name.span, "shows the same …").label(first.name.span, "… as this")
    };
    fault
        .why("All are computed from the same scene; at most their captions differ.")
        .help("say what should differ, or take all but one of them away")
}
