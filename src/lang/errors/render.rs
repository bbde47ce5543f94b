//! `render/…`: differences that do not fit together, and limits of what a file may ask for.

use super::with_article;
use crate::diag::near;
use crate::diag::words::{did_you_mean, listed};
use crate::diag::{Code, Diagnostic, Span};
use crate::lang::ast::Word;
use crate::lang::limits;

/// An item of a clash: its path, its place, who says it.
pub struct Said {
    /// `film.exposure`
    pub path: String,
    /// Where.
    pub span: Span,
    /// "setup `bunny`"
    pub by: String,
}

/// Two items on one path, or on a path and its part, neither of which builds on the other.
pub fn clash(first: &Said, second: &Said, same: bool) -> Diagnostic {
    let (whole, part) = match first.path.len() <= second.path.len() {
        true => (first, second),
        false => (second, first),
    };
    let path = &whole.path;
    if first.span == second.span {
        return Diagnostic::error(
            Code::RENDER_CLASH,
            format!("`{path}` is stated anew at each turn of a loop"),
        )
        .label(first.span, format!("stated more than once {}", first.by))
        .why("Order never matters: of two items in one place, neither wins.")
        .help("put the loop's variable into the name, as `{i}` in `\"ball_{i}\"`");
    }
    let headline = match (same, whole.path == part.path) {
        (true, true) => format!("`{path}` is stated twice"),
        (true, false) => format!("`{path}` is stated whole, and `{}` beside it", part.path),
        (false, _) => format!("`{path}` is stated by two bases, and neither builds on the other"),
    };
    let told = Diagnostic::error(Code::RENDER_CLASH, headline)
        .label(second.span, format!("stated {}", second.by))
        .label(first.span, format!("stated {}", first.by));
    match (same, whole.path == part.path) {
        (true, true) => told
            .why("Order never matters: of two items in one place, neither wins.")
            .help("keep one of them"),
        (true, false) => told
            .why("A path changes what an earlier setup or the top level states, not its neighbour.")
            .help(format!("write it inside `{path}`")),
        (false, _) => told
            .why("Order never matters: an item wins only over those its setup or render builds on.")
            .help(format!(
                "state `{path}` where both are used, or let one setup build on the other"
            )),
    }
}

/// A part changed of something that nothing states.
pub fn nothing_to_change(kind: &str, path: &str, span: Span) -> Diagnostic {
    let headline = format!("`{path}` changes {}, and nothing states one", with_article(kind));
    Diagnostic::error(Code::RENDER_NOTHING_TO_CHANGE, headline)
        .label(span, format!("no {kind} to change"))
        .why("A path with a dot changes one part of what is stated already.")
        .help(format!("state it as a whole: `{kind}: …`"))
}

/// A key of a map that is not there.
pub fn no_such_key(path: &str, word: &Word, all: &[&str]) -> Diagnostic {
    let headline = format!("`{path}` has no `{}` to change", word.text);
    let told = Diagnostic::error(Code::RENDER_NOTHING_TO_CHANGE, headline)
        .label(word.span, "nothing states it");
    let near = near(&word.text, all.iter().copied());
    match (near.is_empty(), all) {
        (_, []) => told.help(format!("state `{path}` as a whole")),
        (false, _) => told.help(did_you_mean(near)),
        (true, _) => told.help(format!("stated are {}", listed(all.iter().copied(), "and"))),
    }
}

/// An unnamed kind without default that no item states.
pub fn missing_kind(kind: &str, render: &str, span: Span, all: bool, example: &str) -> Diagnostic {
    let headline = match all {
        true => format!("nothing states {}", with_article(kind)),
        false => format!("render `{render}` has no {kind}"),
    };
    Diagnostic::error(Code::RENDER_MISSING_KIND, headline)
        .label(span, format!("needs {}", with_article(kind)))
        .why(format!("There is no default for the {kind}: it decides what the picture means."))
        .help(format!("add `{kind}: {example}` at the top of the file, or in the render"))
}

/// A render's name that is no file name.
pub fn bad_name(name: &str, span: Span) -> Diagnostic {
    let headline = match name {
        "" => "the name of a render is empty".to_string(),
        _ => format!("`{}` cannot be the name of a render", name.escape_debug()),
    };
    Diagnostic::error(Code::RENDER_NAME, headline)
        .label(span, "pictures are files of this name")
        .why("Letters, digits, `_`, `-` and `.` are allowed, not `.` in front; up to 100 of them.")
        .help("choose a name such as `day_7`")
}

/// Two renders of one name.
pub fn duplicate(name: &str, span: Span, first: (&str, Span)) -> Diagnostic {
    let headline = match first.0 == name {
        true => format!("two renders are called `{name}`"),
        false => format!("the renders `{name}` and `{}` differ in case only", first.0),
    };
    let told = Diagnostic::error(Code::RENDER_DUPLICATE, headline)
        .label(span, "this would overwrite the other's picture");
    let told = match first.1 == span {
        true => told.help("write a value of the loop into the name: `\"view_{i}\"`"),
        false => told.label(first.1, "the first").help("give one of them another name"),
    };
    match first.0 == name {
        true => told.why("Pictures are files of these names."),
        false => told.why("Pictures are files, and some systems do not tell `A` from `a`."),
    }
}

/// Setups that build on each other.
pub fn circle(words: &[Word]) -> Diagnostic {
    let names: Vec<_> = words.iter().map(|word| &*word.text).collect();
    let headline = match names.as_slice() {
        [one] => format!("`{one}` builds on itself"),
        _ => format!("{} build on each other in a circle", listed(names.iter().copied(), "and")),
    };
    let mut told = Diagnostic::error(Code::RENDER_CIRCLE, headline);
    for word in words {
        told = told.label(word.span, format!("builds on `{}`", word.text));
    }
    told.help("let one of them stand alone")
}

/// Too much work.
pub fn too_many_items(span: Span) -> Diagnostic {
    let headline = format!("this scene needs more than {} values", limits::ITEMS);
    Diagnostic::error(Code::RENDER_TOO_MUCH, headline)
        .label(span, "the last one that was computed")
        .help("shorten a loop, or move what it makes into a mesh file")
}

/// Too many renders.
pub fn too_many_renders(span: Span) -> Diagnostic {
    let headline = format!("this file asks for more than {} renders", limits::RENDERS);
    Diagnostic::error(Code::RENDER_TOO_MUCH, headline)
        .label(span, "one too many")
        .help("shorten a loop, or part the file")
}

/// A list that is too long.
pub fn too_many_elements(span: Span) -> Diagnostic {
    let headline = format!("a list may have {} elements, and this has more", limits::ELEMENTS);
    Diagnostic::error(Code::RENDER_TOO_MUCH, headline)
        .label(span, "too long")
        .help("shorten it, or take larger steps")
}
