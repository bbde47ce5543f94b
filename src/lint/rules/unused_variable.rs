//! A loop whose body does not mention its variable: it says the same thing every time.

use crate::diag::{Code, Diagnostic};
use crate::lang::outline::{Declared, What};
use crate::lint::Text;

pub(in crate::lint) fn look(text: &Text, found: &mut Vec<Diagnostic>) {
    let variables = text.declared().filter(|said| said.what == What::Variable && !said.used);
    found.extend(variables.map(unused));
}

fn unused(said: &Declared) -> Diagnostic {
    let headline = format!("the loop does not use its variable `{}`", said.name);
    Diagnostic::warning(Code::LINT_UNUSED_VARIABLE, headline)
        .label(said.at, "its body says the same whatever this is")
        .help(format!(
            "write `{0}`, or `{{{0}}}` inside a string, where the repeats should differ",
            said.name
        ))
}
