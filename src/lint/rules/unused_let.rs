//! A `let` that nothing mentions. At the top of a file without renders it is there for others.

use crate::diag::{Code, Diagnostic};
use crate::lang::outline::{Declared, What};
use crate::lint::Text;

pub(in crate::lint) fn look(text: &Text, found: &mut Vec<Diagnostic>) {
    for said in text.unused() {
        let what = match said.what {
            What::Let => "value",
            What::Function => "function",
            _ => continue,
        };
        found.push(unused(said, what));
    }
}

fn unused(said: &Declared, what: &str) -> Diagnostic {
    Diagnostic::warning(Code::LINT_UNUSED_LET, format!("nothing uses the {what} `{}`", said.name))
        .label(said.at, "is mentioned nowhere else")
        .help("use it where it was meant to be used, or take the `let` away")
}
