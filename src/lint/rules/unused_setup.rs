//! A setup that no render of the file builds on. A file without renders has setups for others.

use crate::diag::{Code, Diagnostic};
use crate::lang::outline::{Declared, What};
use crate::lint::Text;

pub(in crate::lint) fn look(text: &Text, found: &mut Vec<Diagnostic>) {
    found.extend(text.unused().filter(|said| said.what == What::Setup).map(unused));
}

fn unused(said: &Declared) -> Diagnostic {
    let headline = format!("nothing builds on the setup `{}`", said.name);
    Diagnostic::warning(Code::LINT_UNUSED_SETUP, headline)
        .label(said.at, "a setup alone draws nothing")
        .help(format!(
            "build a render on it, `render NAME: {} {{ … }}`, or take it away",
            said.name
        ))
}
