//! Family `paths`: layers that cannot be made together.

use crate::diag::{Code, Diagnostic, Span};
use crate::math::paths::{MOST_LAYERS, MOST_LETTERS, MOST_STATES, TooLarge};
use crate::scene::At;

/// A name that no channel of a file can have.
pub fn bad_name(name: &At<String>) -> Diagnostic {
    let headline = format!("`{}` cannot be the name of a layer", **name);
    Diagnostic::error(Code::PATHS_LAYER_NAME, headline)
        .label(name.span, "the name of channels in the EXR")
        .help(
            "write letters from a to z, digits, `_`, `-` and `.`, a hundred at most, and no `.` at \
             the ends",
        )
}

/// A name that the EXR has for something else.
pub fn taken_name(name: &At<String>, taken: &str) -> Diagnostic {
    let headline = format!("a layer cannot be called `{}`", **name);
    Diagnostic::error(Code::PATHS_LAYER_NAME, headline)
        .label(name.span, "taken")
        .why(match taken {
            "error" => "In the EXR of every render, `error` is the standard error of its pixels.",
            _ => "In the EXR of every render, `samples` are the samples of its pixels.",
        })
        .help("choose another name")
}

/// A name with a part that names channels.
pub fn channel_name(name: &At<String>, channel: &str) -> Diagnostic {
    let headline = format!("a layer cannot be called `{}`", **name);
    Diagnostic::error(Code::PATHS_LAYER_NAME, headline)
        .label(name.span, format!("`{channel}` is a channel"))
        .why(format!(
            "The channels of a layer are `NAME.R`, `NAME.G` and `NAME.B` in the EXR: programs that \
             read it would take `{channel}` for one of them."
        ))
        .help("choose another name")
}

/// Two names that differ by case alone.
pub fn names_alike(second: &At<String>, first: &At<String>) -> Diagnostic {
    let headline = format!("the layers `{}` and `{}` differ by case alone", **first, **second);
    Diagnostic::error(Code::PATHS_LAYER_NAME, headline)
        .label(second.span, "the same, for some programs")
        .label(first.span, "one")
        .why("Programs that read the EXR do not all tell them apart.")
        .help("choose another name")
}

/// Two layers of `others`.
pub fn others_twice(second: Span, first: Span) -> Diagnostic {
    Diagnostic::error(Code::PATHS_OTHERS_TWICE, "two layers take the paths that no other takes")
        .label(second, "nothing is left for this one")
        .label(first, "takes all others already")
        .help("take one of them away, or say which paths it shows")
}

/// Expressions that no automaton of bounded size can tell apart.
pub fn too_large(what: TooLarge, at: Span) -> Diagnostic {
    let told = |headline: String| {
        Diagnostic::error(Code::PATHS_TOO_LARGE, headline).label(at, "with this one, too much")
    };
    match what {
        TooLarge::Layers => {
            told(format!("there are more than {MOST_LAYERS} layers")).help("render some at a time")
        }
        TooLarge::Letters => told(format!(
            "the path expressions of all layers have more than {MOST_LETTERS} letters"
        ))
        .help("write shorter ones, or render some layers at a time"),
        TooLarge::States => told(format!(
            "to tell these paths apart takes more than {MOST_STATES} states"
        ))
        .why(
            "Paths are followed from the eye. An expression that asks what happened at a certain \
             place counted from the light must remember all places that could be it, which doubles \
             with each.",
        )
        .help("count scatterings from the eye, or use fewer of them"),
    }
}
