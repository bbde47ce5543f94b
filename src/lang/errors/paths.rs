//! `paths/…`: expressions over paths of light that are none.

use crate::diag::words::listed;
use crate::diag::{Code, Diagnostic, Span};
use crate::math::paths::{Fault, MOST_DEPTH, MOST_LENGTH, Wrong};

/// The letters, for those who look for one.
const LETTERS: &str = "the letters are `L` (light), `D` (diffuse), `G` (glossy), `S` (specular), \
                       `E` (eye), and `.` for any scattering";

/// Something that is no text.
pub fn no_text(what: &str, found: &str, words: &[&str], span: Span) -> Diagnostic {
    let words = match words {
        [] => String::new(),
        all => format!(", or {}", listed(all.iter().copied(), "or")),
    };
    let headline = format!("{what}: expected a path expression in quotes{words}, found {found}");
    Diagnostic::error(Code::TYPE_MISMATCH, headline)
        .label(span, format!("this is {found}"))
        .help("write an expression such as `\"L S+ D E\"`, from the light to the eye")
}

/// `"others"`
pub fn word_in_quotes(what: &str, word: &str, span: Span) -> Diagnostic {
    let headline = format!("{what}: `{word}` is a word, and stands without quotes");
    Diagnostic::error(Code::TYPE_MISMATCH, headline)
        .label(span, "in quotes it is a path expression")
        .help(format!("write `{word}`"))
        .mend(format!("write `{word}`"), span, word)
}

/// A text that is no expression. `place`: the text with its quotes, and where in it the fault is,
/// if it stands there as it is.
pub fn unreadable(
    what: &str,
    fault: &Fault,
    text: &str,
    (whole, inside): (Span, Option<Span>),
) -> Diagnostic {
    let found = &text[fault.at.clone()];
    let (headline, label, help) = told(fault.wrong, found);
    let code = match fault.wrong {
        Wrong::NoPath => Code::PATHS_NO_PATH,
        Wrong::Dead => Code::PATHS_DEAD_PART,
        _ => Code::PATHS_UNREADABLE,
    };
    let at = inside.filter(|span| span.start < span.end).unwrap_or(whole);
    let mut told = Diagnostic::error(code, format!("{what}: {headline}")).label(at, label);
    if matches!(fault.wrong, Wrong::NoPath | Wrong::Dead) {
        told = told.why(
            "A path begins at the light, `L`, and ends at the eye, `E`; all between them are \
             scatterings.",
        );
    }
    match &fault.instead {
        Some(right) => {
            let right = right.trim_start();
            told = told.help(format!("did you mean `{right}`?"));
            match (inside, &fault.instead) {
                (Some(span), Some(right)) => {
                    told.mend(format!("write `{}`", right.trim_start()), span, right)
                }
                _ => told,
            }
        }
        None => told.help(help),
    }
}

/// Headline, label and help.
fn told(wrong: Wrong, found: &str) -> (String, &'static str, String) {
    let letters = || LETTERS.to_string();
    match wrong {
        Wrong::Unknown => {
            (format!("`{found}` means nothing in a path expression"), "no letter", letters())
        }
        Wrong::Side => (
            format!("there is no `{found}`"),
            "no side of a surface",
            "write `_r` for what is reflected and `_t` for what is transmitted, as in `S_r`; `L` \
             and `E` have no sides"
                .to_string(),
        ),
        Wrong::Empty if found.trim().is_empty() => (
            "this path expression is empty".to_string(),
            "paths belong here, from the light to the eye",
            "write what light goes through, such as `\"L S+ D E\"`; `\"L .* E\"` is all of it"
                .to_string(),
        ),
        Wrong::Empty => (
            format!("nothing stands beside or within this `{found}`"),
            "something is missing here",
            "write `D?` for a scattering that may be missing".to_string(),
        ),
        Wrong::NothingRepeated => (
            format!("`{found}` says how often, and nothing stands before it"),
            "nothing to repeat",
            "write a letter or a group before it: `D*`, `(S | G)+`".to_string(),
        ),
        Wrong::EndRepeated => (
            format!("`{found}` says how often, of a light or an eye"),
            "a path has one light and one eye",
            "write `*`, `+` and `?` behind scatterings".to_string(),
        ),
        Wrong::TwoSigns => (
            format!("`{found}` says twice how often"),
            "one sign is enough",
            "write `*`, `+` or `?`".to_string(),
        ),
        Wrong::Unclosed => (
            "this `(` is not closed".to_string(),
            "opened here",
            "write a `)` where the group ends".to_string(),
        ),
        Wrong::Unopened => (
            "this `)` closes nothing".to_string(),
            "nothing was opened",
            "write a `(` where the group begins, or take this away".to_string(),
        ),
        Wrong::TooDeep => (
            format!("more than {MOST_DEPTH} groups stand in each other"),
            "one too many",
            "write a simpler expression".to_string(),
        ),
        Wrong::TooLong => (
            format!("this path expression is longer than {MOST_LENGTH} bytes"),
            "too long",
            "write several layers, or a simpler expression".to_string(),
        ),
        Wrong::Dead => (
            format!("`{found}` is on no path from `L` to `E`"),
            "no path comes by here",
            "take it away, or write its `L` and its `E`: `L (D | S) E` is `L D E | L S E`"
                .to_string(),
        ),
        Wrong::NoPath => {
            ("no path of light is of this form".to_string(), "means no path", letters())
        }
    }
}
