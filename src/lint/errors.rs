//! What is wrong with a comment that allows.

use crate::diag::words::did_you_mean;
use crate::diag::{CODES, Code, Diagnostic, Span, near};

/// The form of such a comment.
const FORM: &str = "// lint: allow(rule) because \"…\"";

/// A comment that begins with `lint:` and goes on otherwise.
pub fn form(comment: Span) -> Diagnostic {
    Diagnostic::warning(Code::LINT_ALLOW_FORM, "a comment for the linter is not understood")
        .label(comment, "allows nothing")
        .help(format!("write `{FORM}`, or let the comment begin with another word than `lint:`"))
}

/// A name that is no code.
pub fn unknown(name: &str, at: Span) -> Diagnostic {
    let fault = Diagnostic::warning(
        Code::LINT_ALLOW_UNKNOWN,
        format!("there is no lint `{name}` to allow"),
    )
    .label(at, "no rule, and no code of a warning");
    // As they are written in a comment.
    let short = |name: &'static str| name.strip_prefix("lint/").unwrap_or(name);
    let all = CODES.iter().map(|code| short(code.name));
    let near = near(name.strip_prefix("lint/").unwrap_or(name), all);
    match near.as_slice() {
        [] => fault.help("`scn lint --list` shows all rules"),
        [one] => {
            fault.help(did_you_mean(near.iter().copied())).mend(format!("write `{one}`"), at, *one)
        }
        some => fault.help(did_you_mean(some.iter().copied())),
    }
}

/// A rule that is allowed where it finds nothing. `without` is the change that takes the name, or
/// all of the comment, away.
pub fn unused(name: &str, at: Span, (place, without): (Span, String)) -> Diagnostic {
    let headline = format!("`{name}` is allowed here, and is not found");
    Diagnostic::warning(Code::LINT_ALLOW_UNUSED, headline)
        .label(at, "allows nothing")
        .why("It speaks of the line it ends, or of the line or item below it.")
        .help("take it away: what it allowed is no longer there, or stands elsewhere")
        .safe_mend("take away what is not needed", place, without)
}

/// No reason, or an empty one.
pub fn without_reason(comment: Span) -> Diagnostic {
    Diagnostic::warning(
        Code::LINT_ALLOW_WITHOUT_REASON,
        "what is allowed here has no reason beside it",
    )
    .label(comment, "why?")
    .help(format!("tell the next reader why it is meant: `{FORM}`"))
}
