//! A material that no object names: often the object has another one by a slip.

use crate::diag::{Code, Diagnostic};
use crate::lang::outline::{Declared, What};
use crate::lint::Text;

pub(in crate::lint) fn look(text: &Text, found: &mut Vec<Diagnostic>) {
    let materials = text.unused().filter(|said| said.what == What::Kind("material"));
    found.extend(materials.map(unused));
}

fn unused(said: &Declared) -> Diagnostic {
    let headline = format!("nothing has the material `{}`", said.name);
    Diagnostic::warning(Code::LINT_UNUSED_MATERIAL, headline)
        .label(said.at, "is mentioned nowhere else")
        .help(format!(
            "give it to an object, `material: {}`, or take the declaration away",
            said.name
        ))
}
