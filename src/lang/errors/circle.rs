//! `name/depends-on-itself`: a name that means something made of what it means.

use super::plural;
use crate::diag::words::listed;
use crate::diag::{Code, Diagnostic};
use crate::lang::ast::Word;

/// Lets that need each other.
pub fn of_lets(words: &[Word]) -> Diagnostic {
    let names: Vec<_> = words.iter().map(|word| &*word.text).collect();
    let headline = match names.as_slice() {
        [one] => format!("`{one}` depends on itself"),
        _ => format!("{} depend on each other in a circle", listed(names.iter().copied(), "and")),
    };
    let mut told = Diagnostic::error(Code::NAME_DEPENDS_ON_ITSELF, headline);
    for (i, word) in words.iter().enumerate() {
        let next = &words[(i + 1) % words.len()].text;
        told = told.label(word.span, format!("`{}` needs `{next}`", word.text));
    }
    told.help("define one of them without the others")
}

/// Declarations that refer to each other in a ring, each by the word that names the next one.
pub fn of_declarations(kind: &str, ring: &[Word]) -> Diagnostic {
    let mut names: Vec<_> = ring.iter().map(|word| &*word.text).collect();
    names.rotate_right(1);
    let all = listed(names.iter().copied(), "and");
    let yields = kind == "object";
    let headline = match (yields, names.len()) {
        (true, 1) => format!("the object {all} yields to itself"),
        (true, 2) => format!("the objects {all} yield to each other"),
        (true, _) => format!("the objects {all} yield to each other in a circle"),
        (false, 1) => format!("the {kind} {all} is made of itself"),
        (false, _) => format!("the {} {all} are made of each other", plural(kind)),
    };
    let told = ring.iter().zip(&names).fold(
        Diagnostic::error(Code::NAME_DEPENDS_ON_ITSELF, headline),
        |told, (word, of)| match yields {
            true => told.label(word.span, format!("`{of}` yields to `{}`", word.text)),
            false => told.label(word.span, format!("`{of}` is made of `{}`", word.text)),
        },
    );
    match (yields, names.len()) {
        (true, 1) => told
            .why("An object that yields ends where another one begins.")
            .help("leave `yields_to` out, or name another object"),
        (true, _) => told
            .why("An object that yields ends where another one begins: of two only one can.")
            .help(format!("leave `yields_to` out of one of them: {}", listed(names, "or"))),
        (false, 1) => told.help(format!("name another {kind}")),
        (false, _) => {
            told.help(format!("make one of them without the others: {}", listed(names, "or")))
        }
    }
}

/// A declaration that names itself.
pub fn itself(kind: &str, word: &Word, variant: bool) -> Diagnostic {
    let name = &word.text;
    let told = Diagnostic::error(Code::NAME_DEPENDS_ON_ITSELF, format!("{kind} `{name}` is made of itself"))
        .label(word.span, format!("the {kind} called `{name}`, not the word of the language"))
        .why("A bare word means a declaration first; before a brace it is always a word of the language.");
    match variant {
        true => told.help(format!("write `{name} {{}}`")).mend(
            format!("write `{name} {{}}`"),
            word.span,
            format!("{name} {{}}"),
        ),
        false => told.help(format!("state what the {kind} is")),
    }
}
