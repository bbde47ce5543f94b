//! A parameter that its function does not mention: whatever is passed changes nothing.

use crate::diag::{Code, Diagnostic};
use crate::lang::outline::{Declared, What};
use crate::lint::Text;

pub(in crate::lint) fn look(text: &Text, found: &mut Vec<Diagnostic>) {
    let parameters = text.declared().filter(|said| said.what == What::Parameter && !said.used);
    found.extend(parameters.map(unused));
}

fn unused(said: &Declared) -> Diagnostic {
    let headline = format!("the function does not use its parameter `{}`", said.name);
    Diagnostic::warning(Code::LINT_UNUSED_PARAMETER, headline)
        .label(said.at, "what is passed here changes nothing")
        .help("use it in what the function gives, or take it away, here and in the calls")
}
