//! `syntax/unexpected` in an argument of `--set`.

use super::syntax::clipped;
use crate::diag::{Code, Diagnostic, Span};

const EXAMPLE: &str = "write for example `--set 'film.exposure=1 ev'`";

/// Nothing that parts path and value; `colon`: where the sign of scene files stands instead.
pub fn no_equals(text: &str, colon: Option<usize>, span: Span) -> Diagnostic {
    let headline = match text.is_empty() {
        true => "this `--set` says nothing".to_string(),
        false => format!("`{}` is no `path=value`", clipped(text)),
    };
    let told = Diagnostic::error(Code::SYNTAX_UNEXPECTED, headline);
    match colon {
        Some(at) => {
            let start = span.start + at as u32;
            let colon = Span { start, end: start + 1, ..span };
            told.label(colon, "expected `=`").help("write `=` instead of `:`")
        }
        None => told.label(span, "expected a path, `=` and a value").help(EXAMPLE),
    }
}

/// Nothing before the `=`.
pub fn no_path(equals: Span) -> Diagnostic {
    Diagnostic::error(Code::SYNTAX_UNEXPECTED, "nothing stands before the `=` of this `--set`")
        .label(equals, "a path belongs before this")
        .help(EXAMPLE)
}

/// Several changes in one, as each is said alone; `comma`: what parts the first two.
pub fn several(said: &[String], comma: Span) -> Diagnostic {
    let quoted = said.iter().map(|text| match text.contains('\'') {
        true => format!("--set \"{text}\""),
        false => format!("--set '{text}'"),
    });
    let right = quoted.collect::<Vec<_>>().join(" ");
    Diagnostic::error(Code::SYNTAX_UNEXPECTED, "one `--set` says one thing, and this says more")
        .label(comma, "what follows belongs into a `--set` of its own")
        .help(format!("write `{right}`"))
}

/// What begins with a word that begins items of other forms.
pub fn keyword(word: &str, span: Span) -> Diagnostic {
    let headline = format!("`--set` cannot say `{word}`");
    let instead = match word {
        "render" | "setup" => "change what the renders show; `--only NAME` chooses among them",
        "let" => "change the items that use the value, or the value in the file",
        "use" => "write it into the file",
        "without" => "write it into a render of the file",
        _ => EXAMPLE,
    };
    Diagnostic::error(Code::SYNTAX_UNEXPECTED, headline)
        .label(span, "expected the path of a value")
        .why(
            "It changes a part of an item, as in `film.exposure=1 ev` and `material \
             clay.albedo=0.5`, or states an item anew, as in `integrator=path`.",
        )
        .help(instead)
}
