//! What is wrong with a comment that allows.

use crate::diag::{CODES, Code, Diagnostic, Span};

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
    match nearest(name).as_slice() {
        [] => fault.help("`scn lint --list` shows all rules"),
        [near] => {
            fault.help(format!("did you mean `{near}`?")).mend(format!("write `{near}`"), at, *near)
        }
        [first, others @ ..] => fault.help(format!(
            "did you mean `{first}`{}?",
            others.iter().map(|near| format!(" or `{near}`")).collect::<String>()
        )),
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

/// The rules and warnings nearest to a name, best first, as they are written in a comment.
fn nearest(name: &str) -> Vec<&'static str> {
    const NEAR: f64 = 0.85;
    let short = name.strip_prefix("lint/").unwrap_or(name);
    let mut all: Vec<(f64, &'static str)> = CODES
        .iter()
        .map(|code| code.name.strip_prefix("lint/").unwrap_or(code.name))
        .map(|candidate| (strsim::jaro_winkler(short, candidate), candidate))
        .filter(|(likeness, _)| *likeness >= NEAR)
        .collect();
    all.sort_by(|a, b| b.0.total_cmp(&a.0).then_with(|| a.1.cmp(b.1)));
    // Beside one that is much nearer the others only distract.
    let best = all.first().map_or(0.0, |(likeness, _)| *likeness);
    all.into_iter().filter(|it| it.0 > best - 0.03).take(3).map(|it| it.1).collect()
}
