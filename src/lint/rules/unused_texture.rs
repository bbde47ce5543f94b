//! A texture that no material names: often the material has a plain colour by a slip.

use crate::diag::{Code, Diagnostic};
use crate::lang::outline::{Declared, What};
use crate::lint::Text;

pub(in crate::lint) fn look(text: &Text, found: &mut Vec<Diagnostic>) {
    let textures = text.unused().filter(|said| said.what == What::Kind("texture"));
    found.extend(textures.map(unused));
}

fn unused(said: &Declared) -> Diagnostic {
    let headline = format!("nothing has the texture `{}`", said.name);
    Diagnostic::warning(Code::LINT_UNUSED_TEXTURE, headline)
        .label(said.at, "is mentioned nowhere else")
        .help(format!(
            "give it to a material, such as `albedo: {}`, or take the declaration away",
            said.name
        ))
}
