//! Two names of one kind that differ only by capital letters: easily taken for each other.
//! Names of one letter are left alone: R and r are two quantities.

use std::collections::HashMap;

use crate::diag::{Code, Diagnostic};
use crate::lang::outline::{Declared, What};
use crate::lint::Text;

pub(in crate::lint) fn look(text: &Text, found: &mut Vec<Diagnostic>) {
    let main = text.outline.files.first();
    let mut first: HashMap<(&str, String), &Declared> = HashMap::new();
    for said in &text.outline.declared {
        if said.name.chars().count() < 2 {
            continue;
        }
        let other = *first.entry((shelf(said.what), said.name.to_lowercase())).or_insert(said);
        let here = Some(&said.at.file) == main || Some(&other.at.file) == main;
        if other.name != said.name && here {
            // What stands in the main file is where to look first.
            let (said, other) =
                if Some(&said.at.file) == main { (said, other) } else { (other, said) };
            found.push(alike(said, other));
        }
    }
}

/// Names that cannot stand for each other may look alike.
fn shelf(what: What) -> &'static str {
    match what {
        What::Let | What::Function | What::Parameter | What::Variable => "name",
        What::Setup | What::Render => "setup or render",
        What::Kind(kind) => kind,
    }
}

fn alike(said: &Declared, other: &Declared) -> Diagnostic {
    let headline = format!("`{}` and `{}` differ only by capital letters", said.name, other.name);
    Diagnostic::warning(Code::LINT_NAMES_BY_CASE, headline)
        .label(said.at, "one of them")
        .label(other.at, "the other")
        .help("give them names that cannot be taken for each other, or one name if they are one")
}
