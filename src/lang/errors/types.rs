//! `type/…`: a value that its place cannot take.

use super::{plural, with_article};
use crate::diag::words::listed;
use crate::diag::{Code, Diagnostic, Span};
use crate::lang::ast::Word;
use crate::lang::limits;
use crate::lang::value::digits;
use crate::scene::schema::{Bound, Range};

/// Another kind of value than expected.
pub fn mismatch(what: &str, expected: &str, found: &str, span: Span) -> Diagnostic {
    Diagnostic::error(Code::TYPE_MISMATCH, format!("{what}: expected {expected}, found {found}"))
        .label(span, format!("expected {expected}"))
}

/// Something that is no list where a list belongs.
pub fn list(what: &str, found: &str, span: Span) -> Diagnostic {
    mismatch(what, "a list in square brackets", found, span).help("write `[…]` around it").mend(
        "write `[` before it",
        Span { end: span.start, ..span },
        "[",
    )
}

/// Beyond its bounds.
pub fn out_of_range(
    what: &str,
    found: &str,
    range: &Range,
    show: &dyn Fn(f64) -> String,
    span: Span,
) -> Diagnostic {
    let bounds = bounds(range, show);
    let headline = format!("{what} must be {bounds}, and is {found}");
    let told = Diagnostic::error(Code::TYPE_OUT_OF_RANGE, headline)
        .label(span, format!("must be {bounds}"));
    let told = if range.why.is_empty() { told } else { told.why(range.why) };
    if range.help.is_empty() { told } else { told.help(range.help) }
}

/// "at least 1 and at most 64"; nothing where there are no bounds.
fn bounds(range: &Range, show: &dyn Fn(f64) -> String) -> String {
    let low = match range.low {
        Bound::None => None,
        Bound::Inclusive(low) => Some(format!("at least {}", show(low))),
        Bound::Exclusive(low) => Some(format!("more than {}", show(low))),
    };
    let high = match range.high {
        Bound::None => None,
        Bound::Inclusive(high) => Some(format!("at most {}", show(high))),
        Bound::Exclusive(high) => Some(format!("less than {}", show(high))),
    };
    let bounds: Vec<_> = low.into_iter().chain(high).collect();
    bounds.join(" and ")
}

/// What may stand where a number does: "a length of more than 0 m", "a plain number from 0 to 1".
pub fn number_within(name: &str, range: &Range, show: &dyn Fn(f64) -> String) -> String {
    match (range.low, range.high, bounds(range, show)) {
        (Bound::Inclusive(low), Bound::Inclusive(high), _) => {
            format!("{name} from {} to {}", show(low), show(high))
        }
        (.., bounds) if bounds.is_empty() => name.to_string(),
        (.., bounds) => format!("{name} of {bounds}"),
    }
}

/// The same of a count: "a whole number from 1 to 64".
pub fn count_within(range: &Range) -> String {
    let low = match range.low {
        Bound::None => Bound::Inclusive(0.0),
        low => low,
    };
    number_within("a whole number", &Range { low, ..*range }, &digits)
}

/// A list where a vector belongs; `text`: as written.
pub fn round_brackets(told: Diagnostic, text: Option<&str>, span: Span) -> Diagnostic {
    let inside = text.and_then(|text| text.strip_prefix('[')?.strip_suffix(']'));
    let plain = |inside: &&str| inside.len() <= 60 && !inside.contains(['\n', '[']);
    match inside.filter(plain).filter(|inside| inside.matches(',').count() == 2) {
        None => told.help("a vector stands in round brackets: `(x, y, z)`"),
        Some(inside) => {
            let right = format!("({})", inside.trim().trim_end_matches(',').trim_end());
            told.help(format!("a vector stands in round brackets: `{right}`")).mend(
                format!("write `{right}`"),
                span,
                right,
            )
        }
    }
}

/// More on a medium of the shelf where only a part of one belongs.
pub fn whole_medium(told: Diagnostic, word: &str) -> Diagnostic {
    told.why(format!("`matter.{word}` is a whole medium, its index included."))
        .help(format!("write `medium {word}: matter.{word}`, and name that medium instead"))
}

/// Components of `srgb` beyond 0 to 1. `literal`: all of them are written as numbers.
pub fn encoded_range(components: [f64; 3], literal: bool, span: Span) -> Diagnostic {
    let shown = components.map(digits).join(", ");
    let headline = format!("the components of `srgb` go from 0 to 1, and these are {shown}");
    let told = Diagnostic::error(Code::TYPE_OUT_OF_RANGE, headline)
        .label(span, "each must be at least 0 and at most 1");
    let byte = |x: &f64| x.fract() == 0.0 && (0.0..=255.0).contains(x);
    let bytes = components.iter().all(byte) && components.iter().any(|x| *x > 1.0);
    if !bytes {
        return told.help("write what lies within, or `rgb(…)`, which is linear and has no bound");
    }
    let right = components.map(|x| digits((x / 255.0 * 1e3).round() / 1e3)).join(", ");
    let right = format!("srgb({right})");
    let told = told
        .why("Programs that paint count from 0 to 255; here 1 is the most that a screen shows.")
        .help(format!("did you mean `{right}`?"));
    match literal {
        true => told.mend(format!("write `{right}`"), span, right),
        false => told,
    }
}

/// A word that turns things on and off where a number belongs; `expected`: which numbers may stand
/// there.
pub fn no_switch(what: &str, expected: &str, found: &str, span: Span) -> Diagnostic {
    let headline = format!("{what} is {expected}, and `{found}` is none");
    Diagnostic::error(Code::TYPE_MISMATCH, headline).label(span, format!("expected {expected}"))
}

/// Fields that must be given.
pub fn missing_fields(
    owner: &str,
    place: &str,
    missing: &[(&str, String)],
    at: Span,
    braces: Span,
) -> Diagnostic {
    let names = listed(missing.iter().map(|(word, _)| *word), "and");
    let texts: Vec<_> =
        missing.iter().map(|(word, example)| format!("{word}: {example}")).collect();
    let headline = match owner == place {
        true => format!("`{place}` lacks {names}"),
        false => format!("`{place}`: `{owner}` lacks {names}"),
    };
    let plural = if missing.len() == 1 { "it" } else { "they" };
    let told = Diagnostic::error(Code::TYPE_MISSING_FIELD, headline)
        .label(at, format!("{names} must be given here"))
        .why(format!("There is no default for what {plural} should be."));
    if at == braces && owner != place {
        return told.help(format!("write `{owner} {{ {} }}`", texts.join(", ")));
    }
    told.help(format!("add `{}`", texts.join(", ")))
}

/// A count that is none.
pub fn not_whole(what: &str, found: f64, range: &Range, span: Span) -> Diagnostic {
    let found = digits(found);
    Diagnostic::error(Code::TYPE_NOT_WHOLE, format!("{what} is a count, and `{found}` is none"))
        .label(span, format!("expected {}", count_within(range)))
}

/// Two or four coordinates. `difference`: one of them was computed.
pub fn three_coordinates(what: &str, found: usize, difference: bool, span: Span) -> Diagnostic {
    let headline = format!("{what} has three coordinates, and here {}", stand(found));
    let told = Diagnostic::error(Code::TYPE_VECTOR_SIZE, headline)
        .label(span, "expected x, y and z")
        .help("write `(x, y, z)`");
    match difference {
        true => told.why("Without a comma, `1 -2` is a difference and one number."),
        false => told,
    }
}

/// Four or more components.
pub fn long_vector(found: usize, span: Span) -> Diagnostic {
    Diagnostic::error(
        Code::TYPE_VECTOR_SIZE,
        format!("a vector has two or three components, not {found}"),
    )
    .label(span, "too many")
    .help("write a list in square brackets: `[1, 2, 3, 4]`")
}

/// (0, 0, 0) as a direction.
pub fn zero_direction(what: &str, span: Span) -> Diagnostic {
    Diagnostic::error(Code::TYPE_ZERO_DIRECTION, format!("{what}: zero is no direction"))
        .label(span, "points nowhere")
        .help("write a vector with a length, or one of `x`, `-x`, `y`, `-y`, `z`, `-z`")
}

/// scale(0).
pub fn zero_scale(span: Span) -> Diagnostic {
    Diagnostic::error(Code::TYPE_OUT_OF_RANGE, "a scale by zero leaves nothing to be seen")
        .label(span, "must not be 0")
        .help("write a factor above 0, or below for a mirror image")
}

/// Bare coordinates in a file without a unit.
pub fn no_file_unit(span: Span, first_line: Option<Span>) -> Diagnostic {
    let told =
        Diagnostic::error(Code::TYPE_NO_FILE_UNIT, "a bare coordinate, and the file names no unit")
            .label(span, "metres or millimetres?");
    let help = "write the unit of the file's coordinates in its first line: `scn 1 in m`";
    match first_line {
        Some(line) => {
            told.label(line, "no unit here").help(help).mend("write `in m`", line.after(), " in m")
        }
        None => told.help(help),
    }
}

/// `1 m + 1 s`
pub fn sum_of(left: &str, a: Span, right: &str, b: Span, operator: Span) -> Diagnostic {
    Diagnostic::error(
        Code::TYPE_WRONG_DIMENSION,
        format!("{left} and {right} have no sum or difference"),
    )
    .label(operator, "between two kinds of quantities")
    .label(a, left)
    .label(b, right)
    .help("give both the same kind of unit")
}

/// Arithmetic with something that has none.
pub fn no_arithmetic(found: &str, span: Span, operator: Span) -> Diagnostic {
    Diagnostic::error(Code::TYPE_NO_ARITHMETIC, format!("no arithmetic is made with {found} here"))
        .label(operator, "this operator")
        .label(span, found)
        .why("Numbers, colours and spectra have sums, products and quotients; vectors have sums, and products with a number.")
}

/// Overflow.
pub fn not_finite(span: Span) -> Diagnostic {
    Diagnostic::error(Code::TYPE_NOT_FINITE, "this has no finite value")
        .label(span, "too large, or divided by zero")
        .help("look for a division by zero, or a number that grows beyond 1.8e308")
}

/// Deeper than the limit.
pub fn too_deep(span: Span) -> Diagnostic {
    let headline = format!("this needs more than {} values inside each other", limits::DEPTH);
    Diagnostic::error(Code::TYPE_TOO_DEEP, headline)
        .label(span, "one too many")
        .help("shorten the chain of definitions")
}

/// A chain of declarations, each made of the next, that is longer than the limit.
pub fn long_chain(kind: &str, span: Span) -> Diagnostic {
    let (verb, help) = match kind {
        "object" => ("yield to", "let fewer objects yield".to_string()),
        _ => ("are made of", format!("make the {kind} of fewer others")),
    };
    let (most, several) = (limits::DEPTH, plural(kind));
    let headline = format!("more than {most} {several} {verb} each other in a row");
    Diagnostic::error(Code::TYPE_TOO_DEEP, headline).label(span, "one too many").help(help)
}

/// A function without arguments in parentheses.
pub fn function_as_value(used: &Word, defined: &Word) -> Diagnostic {
    let headline = format!("`{}` is a function: it wants arguments", used.text);
    Diagnostic::error(Code::TYPE_ARGUMENTS, headline)
        .label(used.span, "arguments in parentheses belong after this")
        .label(defined.span, "defined here")
        .help(format!("write `{}(…)`", used.text))
}

/// A value called like a function.
pub fn not_a_function(used: &Word, defined: Span) -> Diagnostic {
    Diagnostic::error(Code::TYPE_ARGUMENTS, format!("`{}` is a value, no function", used.text))
        .label(used.span, "takes no arguments")
        .label(defined, "defined here")
        .help(format!("write `{}` alone", used.text))
}

/// Too many or too few arguments.
pub fn arguments(function: &str, params: &[&[&str]], found: usize, span: Span) -> Diagnostic {
    let counts: Vec<String> = params.iter().map(|params| params.len().to_string()).collect();
    let s = if counts == ["1"] { "" } else { "s" };
    let takes = format!("{} argument{s}", counts.join(" or "));
    let calls: Vec<String> =
        params.iter().map(|params| format!("`{function}({})`", params.join(", "))).collect();
    let headline = format!("`{function}` takes {takes}, and here {}", stand(found));
    Diagnostic::error(Code::TYPE_ARGUMENTS, headline)
        .label(span, format!("expected {takes}"))
        .help(format!("write {}", calls.join(" or ")))
}

/// "stands 1", "stand 2"
fn stand(count: usize) -> String {
    format!("{} {count}", if count == 1 { "stands" } else { "stand" })
}

/// `scale((1, 2, 1))`
pub fn vector_as_arguments(function: &str, components: &str, span: Span) -> Diagnostic {
    let right = format!("{function}({components})");
    Diagnostic::error(Code::TYPE_MISMATCH, format!("`{function}` takes numbers, not a vector"))
        .label(span, "its components are the arguments")
        .help(format!("write `{right}`"))
}

/// `rotate(45 deg, y)`; `right`: the same with the axis first.
pub fn turned_round(right: Option<String>, span: Span) -> Diagnostic {
    let told = Diagnostic::error(Code::TYPE_ARGUMENTS, "`rotate` takes the axis first")
        .label(span, "here the angle is first");
    match right {
        Some(right) => {
            told.help(format!("write `{right}`")).mend(format!("write `{right}`"), span, right)
        }
        None => told.help("write `rotate(axis, angle)`"),
    }
}

/// Three numbers where a colour belongs; `inside`: as written, within its brackets.
pub fn colour_meant(told: Diagnostic, inside: &str, span: Span) -> Diagnostic {
    let right = match inside.split(',').map(str::trim).collect::<Vec<_>>()[..] {
        [r, g, b] => format!("rgb({r}, {g}, {b})"),
        _ => return told,
    };
    told.help(format!("write `{right}`")).mend(format!("write `{right}`"), span, right)
}

/// A range that holds nothing or never ends.
pub fn empty_range(standstill: bool, span: Span) -> Diagnostic {
    let (headline, help) = match standstill {
        true => ("a range with step 0 never ends", "write a step other than 0"),
        false => (
            "this range goes the wrong way and is empty",
            "write the smaller bound first, or a negative `step`",
        ),
    };
    Diagnostic::error(Code::TYPE_EMPTY_RANGE, headline).label(span, "holds nothing").help(help)
}

/// The head of a loop that is no list.
pub fn no_list(found: &str, span: Span) -> Diagnostic {
    let headline = format!("a loop runs over a list or a range, not over {found}");
    Diagnostic::error(Code::TYPE_MISMATCH, headline)
        .label(span, format!("this is {found}"))
        .help("write a list such as `[1, 2]`, or a range such as `1 to 9`")
}

/// A path that goes on into something without parts.
pub fn no_parts(path: &str, found: &str, span: Span) -> Diagnostic {
    Diagnostic::error(Code::TYPE_NO_PARTS, format!("`{path}` has no parts: it is {found}"))
        .label(span, "nothing to be found inside")
        .help(format!("state `{path}` as a whole"))
}

/// A path that goes on through a name.
pub fn part_of_named(path: &str, kind: &str, name: &str, rest: &str, span: Span) -> Diagnostic {
    let headline = format!("`{path}` is only the name of {}", with_article(kind));
    Diagnostic::error(Code::TYPE_NO_PARTS, headline)
        .label(span, format!("this would change {kind} `{name}`, wherever it is used"))
        .help(format!(
            "write `{kind} {name}.{rest}: …` to change it everywhere, or state another {kind} here"
        ))
}
