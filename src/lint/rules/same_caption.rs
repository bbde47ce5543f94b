//! A caption that two different pictures share, in a file whose pictures have captions of their
//! own: inherited from a base, and forgotten.

use std::collections::{HashMap, HashSet};

use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;

pub(in crate::lint) fn look(shots: &[Shot], found: &mut Vec<Diagnostic>) {
    let caption = |shot: &Shot| shot.stage.scene.caption.value.0.clone();
    let said: HashSet<String> = shots.iter().map(caption).filter(|it| !it.is_empty()).collect();
    // One caption for all is a title.
    if said.len() < 2 {
        return;
    }
    let mut first: HashMap<String, &Shot> = HashMap::new();
    for shot in shots.iter().filter(|shot| !shot.stage.scene.caption.0.is_empty()) {
        match first.get(&caption(shot)) {
            Some(other) => found.push(same(shot, other)),
            None => {
                first.insert(caption(shot), shot);
            }
        }
    }
}

fn same(shot: &Shot, other: &Shot) -> Diagnostic {
    let (name, first) = (shot.name(), other.name());
    let headline = format!("the renders `{first}` and `{name}` have the same caption");
    Diagnostic::warning(Code::LINT_SAME_CAPTION, headline)
        .label(shot.name.span, "shows something else, under the same caption")
        .label(other.stage.scene.caption.span, format!("the caption of `{first}` and of `{name}`"))
        .why("A render has the caption of what it builds on, unless it states its own.")
        .help(format!("say what `{name}` shows: `caption: \"…\"`"))
}
