//! `name/…`: a word that nothing here is called, or that two things are called.

use std::sync::Arc;

use super::{plural, with_article};
use crate::diag::words::{did_you_mean, listed};
use crate::diag::{Code, Diagnostic, Span, near as nearest};
use crate::lang::ast::Word;
use crate::math::units;
use crate::scene::KINDS;
use crate::scene::elsewhere::{self, otherwise};
use crate::scene::schema::{Kind as KindOf, Type};
use crate::scene::spectral::RECORDS;

/// How many names a message lists at most.
const LISTED: usize = 24;

/// "did you mean `a`?" with a mend for each, or the list of all when they are few.
fn offer(told: Diagnostic, found: &str, span: Span, all: &[&str], what: &str) -> Diagnostic {
    let what = what.trim_end_matches(" are");
    let near = nearest(found, all.iter().copied());
    let mut told = match (near.is_empty(), all.len()) {
        (false, _) => told.help(did_you_mean(near.iter().copied())),
        (true, 0) => told,
        (true, _) => {
            let mut words: Vec<_> = all.iter().copied().take(LISTED).collect();
            words.sort_unstable();
            let rest = if all.len() > LISTED { ", and others" } else { "" };
            told.help(format!("{what}: {}{rest}", listed(words, "and")))
        }
    };
    for word in near {
        told = told.mend(format!("write `{word}`"), span, word);
    }
    if all.len() > 1 && all.len() <= LISTED && told.why.is_none() && !told.mends.is_empty() {
        let mut words = all.to_vec();
        words.sort_unstable();
        told = told.why(format!("{}: {}.", capital(what), listed(words, "and")));
    }
    told
}

fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |c| c.to_uppercase().chain(chars).collect())
}

/// A number followed by a word that is no unit.
pub fn unknown_unit(found: &str, span: Span) -> Diagnostic {
    let told = Diagnostic::error(Code::NAME_UNKNOWN_UNIT, format!("`{found}` is no unit"))
        .label(span, "no unit is called so");
    let lower = found.to_lowercase();
    if matches!(lower.as_str(), "c" | "°c" | "celsius" | "f" | "°f" | "fahrenheit") {
        return told
            .why("Temperatures are in kelvin: 273.15 more than in degrees Celsius.")
            .help("write the temperature in `K`");
    }
    let usual = match lower.as_str() {
        "degree" | "degrees" | "°" => Some("deg"),
        "meter" | "meters" | "metre" | "metres" => Some("m"),
        "centimeter" | "centimeters" | "centimetre" | "centimetres" => Some("cm"),
        "millimeter" | "millimeters" | "millimetre" | "millimetres" => Some("mm"),
        "micron" | "microns" | "micrometer" | "micrometre" => Some("um"),
        "nanometer" | "nanometers" | "nanometre" | "nanometres" => Some("nm"),
        "sec" | "second" | "seconds" => Some("s"),
        "minute" | "minutes" => Some("min"),
        "hour" | "hours" => Some("h"),
        "radian" | "radians" => Some("rad"),
        "watt" | "watts" => Some("W"),
        "kelvin" => Some("K"),
        "stop" | "stops" => Some("ev"),
        _ => None,
    };
    if let Some(usual) = usual {
        return told.help(format!("write `{usual}`")).mend(format!("write `{usual}`"), span, usual);
    }
    let all: Vec<_> = units::UNITS.iter().map(|unit| unit.word).collect();
    let told = if nearest(found, all.iter().copied()).is_empty() {
        told
    } else {
        told.why("Units: `nm um mm cm m km`, `deg rad`, `sr`, `ms s min h`, `K`, `mW W kW`, `lm cd lx nit`, `ev`, `%`.")
    };
    offer(told, found, span, &all, "units are")
}

/// A word where a value belongs that is no unit and none of the names `defined` here.
pub fn unknown_value(found: &str, span: Span, defined: &[Arc<str>]) -> Diagnostic {
    let told =
        Diagnostic::error(Code::NAME_UNKNOWN_NAME, format!("nothing is called `{found}` here"))
            .label(span, "no value has this name");
    let power = found.trim_end_matches(|c: char| c.is_ascii_digit());
    if power != found && units::find(power).is_some() {
        let power = format!("{power}^{}", &found[power.len()..]);
        return told.help(format!("write `{power}` for the power of a unit")).mend(
            format!("write `{power}`"),
            span,
            power,
        );
    }
    let mut near: Vec<&str> = nearest(found, defined.iter().map(|name| &**name));
    // Units are too short for more than their capitals to be mistaken.
    let units = units::UNITS.iter().map(|unit| unit.word).chain(["pi"]);
    near.extend(units.filter(|unit| unit.eq_ignore_ascii_case(found)));
    if !near.is_empty() {
        return offer(told, found, span, &near, "names are");
    }
    let shelved: Vec<String> =
        crate::lang::shelves::called(found, span).into_iter().map(|(text, _)| text).collect();
    if !shelved.is_empty() {
        return meant(told, &shelved, span);
    }
    match found.contains('.') {
        true => told.help("write a number, a text, or the name of a `let`"),
        false => told.help(format!("write a number, or define it: `let {found} = …`")),
    }
}

/// "did you mean `a`?" of whole values; with a mend for each.
fn meant(told: Diagnostic, all: &[String], span: Span) -> Diagnostic {
    let words = all.iter().map(String::as_str);
    let told = told.help(did_you_mean(words));
    all.iter().fold(told, |told, right| told.mend(format!("write `{right}`"), span, right))
}

/// A name with a dot whose first word is no shelf.
pub fn unknown_shelf(word: &Word, all: &[&str]) -> Diagnostic {
    let headline = format!("there is no shelf called `{}`", word.text);
    let told = Diagnostic::error(Code::NAME_UNKNOWN_DATUM, headline)
        .label(word.span, "a name with a dot is a datum on a shelf");
    offer(told, &word.text, word.span, all, "shelves are")
}

/// A datum that a shelf does not have.
pub fn unknown_datum(shelf: &str, found: &str, all: &[&str], span: Span) -> Diagnostic {
    let headline = format!("there is no `{found}` on the shelf `{shelf}`");
    let told = Diagnostic::error(Code::NAME_UNKNOWN_DATUM, headline).label(span, "not there");
    let told = offer(told, found, span, all, "it has");
    match told.mends.is_empty() && all.len() > LISTED {
        true => told.help(format!("`scn list {shelf}` shows what it has")),
        false => told,
    }
}

/// A dot after the name of a value.
pub fn dot_after_value(word: &Word, defined: Span, span: Span) -> Diagnostic {
    let headline = format!("`{}` is a value, and has no parts to be named", word.text);
    Diagnostic::error(Code::NAME_UNKNOWN_DATUM, headline)
        .label(span, "a name with a dot is a datum on a shelf")
        .label(defined, "defined here")
        .help(format!("write `{}` alone", word.text))
}

/// A function that does not exist.
pub fn unknown_function(found: &str, span: Span, defined: &[&str]) -> Diagnostic {
    let mut all = crate::lang::functions::ALL.to_vec();
    all.extend_from_slice(defined);
    let told =
        Diagnostic::error(Code::NAME_UNKNOWN_FUNCTION, format!("no function is called `{found}`"))
            .label(span, "not known");
    let variant = KINDS.iter().any(|kind| match kind.ty {
        crate::scene::schema::Type::OneOf(v) => v.all.iter().any(|record| record.word == found),
        _ => false,
    });
    if variant || RECORDS.iter().any(|record| record.word == found) {
        return told.help(format!("fields stand in braces: `{found} {{ … }}`"));
    }
    match found {
        "translate" => told.help("write `move`").mend("write `move`", span, "move"),
        "color" | "colour" => told.help("write `rgb`").mend("write `rgb`", span, "rgb"),
        _ => offer(told, found, span, &all, "functions are"),
    }
}

/// Words that begin an item without being a kind.
const KEYWORDS: [&str; 6] = ["setup", "render", "let", "for", "use", "without"];

/// A name in quotes with nothing in it.
pub fn empty_name(kind: &str, span: Span) -> Diagnostic {
    Diagnostic::error(Code::NAME_MISSING_NAME, format!("the name of this {kind} is empty"))
        .label(span, "a name belongs between the quotes")
        .help(format!("write `{kind} NAME: …`"))
}

/// An item of a kind that does not exist.
pub fn unknown_kind(word: &Word) -> Diagnostic {
    let found = &word.text;
    let told = Diagnostic::error(
        Code::NAME_UNKNOWN_KIND,
        format!("there is no kind of item called `{found}`"),
    )
    .label(word.span, "not known");
    if let Some(right) = elsewhere::kind(found) {
        return told.help(did_you_mean([right])).mend(format!("write `{right}`"), word.span, right);
    }
    let variant_of = |kind: &&KindOf| match kind.ty {
        Type::OneOf(variants) => variants.all.iter().any(|record| record.word == &**found),
        _ => false,
    };
    if let Some(kind) = KINDS.iter().find(variant_of) {
        let name = if kind.named { " NAME" } else { "" };
        let (what, shape) =
            (with_article(kind.word), format!("{}{name}: {found} {{ … }}", kind.word));
        return told.help(format!("it is what {what} may be: write `{shape}`"));
    }
    let all: Vec<_> = KINDS.iter().map(|kind| kind.word).chain(KEYWORDS).collect();
    offer(told, found, word.span, &all, "an item is one of")
}

/// `without` of a kind that has no names, or does not exist.
pub fn without_kind(word: &Word) -> Diagnostic {
    let named: Vec<_> = KINDS.iter().filter(|k| k.named).map(|k| k.word).collect();
    let headline =
        format!("`without` takes no `{}`: only what has a name can be removed", word.text);
    Diagnostic::error(Code::NAME_UNKNOWN_KIND, headline)
        .label(word.span, "has no name")
        .help(format!("what can be removed is {}", listed(named, "or")))
}

/// A kind whose items have names, without one.
pub fn missing_name(kind: &Word) -> Diagnostic {
    let what = with_article(&kind.text);
    Diagnostic::error(Code::NAME_MISSING_NAME, format!("{what} has a name, and this has none"))
        .label(kind.span, "a name belongs after this word")
        .why(format!("A scene may have more than one {}; names tell them apart.", kind.text))
        .help(format!("write `{} NAME: …`", kind.text))
}

/// A name where the kind has none.
pub fn unwanted_name(kind: &Word, name: &str, span: Span) -> Diagnostic {
    let what = &kind.text;
    let blank = Span { start: kind.span.end, end: span.end, file: span.file };
    Diagnostic::error(
        Code::NAME_UNWANTED_NAME,
        format!("`{what}` has no name, and this is called `{name}`"),
    )
    .label(span, "no name belongs here")
    .why(format!("A picture has one {what}."))
    .help(format!("write `{what}: …`"))
    .mend("take the name away", blank, "")
}

/// A field a record does not have. `meant`: what may be written instead, with its value, and
/// where that stands, if it may replace it; `sure`: rather than a field that looks alike.
pub fn unknown_field(
    owner: &str,
    key: &Word,
    all: &[&str],
    (meant, said): (&[String], Option<Span>),
    sure: bool,
) -> Diagnostic {
    let told = Diagnostic::error(
        Code::NAME_UNKNOWN_FIELD,
        format!("`{owner}` has no field `{}`", key.text),
    )
    .label(key.span, "no such field");
    if all.is_empty() {
        return told.help("it has no fields: write `{}` or nothing");
    }
    if meant.is_empty() || !sure && !nearest(&key.text, all.iter().copied()).is_empty() {
        return offer(told, &key.text, key.span, all, "its fields are");
    }
    let mut words = all.to_vec();
    words.sort_unstable();
    let told = told
        .why(format!("Its fields: {}.", listed(words, "and")))
        .help(format!("write {}", listed(meant.iter().map(String::as_str), "or")));
    match (meant, said) {
        ([right], Some(place)) => told.mend(format!("write `{right}`"), place, right),
        _ => told,
    }
}

/// A field a record does not have, which looks like one that measures something else: `how` one
/// follows from the other.
pub fn unlike_field(owner: &str, key: &Word, right: &str, how: &str) -> Diagnostic {
    let headline = format!("`{owner}` has no field `{}`", key.text);
    Diagnostic::error(Code::NAME_UNKNOWN_FIELD, headline)
        .label(key.span, "no such field")
        .why(format!(
            "`{right}` is another angle, from the lower to the upper edge of the picture."
        ))
        .help(format!("write `{right}`: {how}"))
}

/// A field twice in a record.
pub fn field_twice(key: &Word, first: Span, owner: &str) -> Diagnostic {
    Diagnostic::error(
        Code::NAME_FIELD_TWICE,
        format!("`{}` is stated twice in `{owner}`", key.text),
    )
    .label(key.span, "stated again")
    .label(first, "stated first")
    .help("keep one of them")
}

/// Fields without the word that says of what.
pub fn which_variant(place: &str, name: &str, all: &[&str], braces: Span) -> Diagnostic {
    let mut all = all.to_vec();
    all.sort_unstable();
    let example = all.first().copied().unwrap_or("");
    Diagnostic::error(
        Code::NAME_WHICH_VARIANT,
        format!("`{place}` does not say which {name} it is"),
    )
    .label(
        Span { end: braces.start, ..braces },
        format!("the word for {} belongs before the brace", with_article(name)),
    )
    .help(format!("write {} before the brace, as in `{example} {{ … }}`", listed(all, "or")))
}

/// Fields alone where a base states something whole: they would be all of it. `paths`: the same
/// as changes of what is stated.
pub fn whole_for_part(
    place: &str,
    name: &str,
    braces: Span,
    paths: &str,
    item: Span,
) -> Diagnostic {
    Diagnostic::error(
        Code::NAME_WHICH_VARIANT,
        format!("`{place}` does not say which {name} it is"),
    )
    .label(
        Span { end: braces.start, ..braces },
        format!("the word for {} belongs before the brace", with_article(name)),
    )
    .why(format!("This states the {name} anew, and keeps nothing of what is stated already."))
    .help(format!("write `{paths}` to change what is stated already"))
    .mend(format!("write `{paths}`"), item, paths)
}

/// A variant that does not exist. `meant`: what it is called here, and how that may look.
pub fn unknown_variant(
    place: &str,
    name: &str,
    word: &Word,
    (all, declared): (&[&str], &[&str]),
    meant: Option<(&str, String)>,
) -> Diagnostic {
    let headline = format!("`{place}`: the language has no {name} `{}`", word.text);
    let told = Diagnostic::error(Code::NAME_UNKNOWN_VARIANT, headline)
        .label(word.span, format!("no {name} is called so"));
    let near_declared = nearest(&word.text, declared.iter().copied());
    let near = nearest(&word.text, all.iter().copied());
    // What a word stands for elsewhere is surer than what it looks like.
    match (meant, near.is_empty(), near_declared.is_empty()) {
        (Some((right, shape)), _, true) => {
            let mut words = all.to_vec();
            words.sort_unstable();
            told.why(format!("The choices of {name}: {}.", listed(words, "and")))
                .help(format!("did you mean `{right}`, as in `{shape}`?"))
                .mend(format!("write `{right}`"), word.span, right)
        }
        (None, _, true) if otherwise(name, &word.text).is_some() => {
            let choices = listed(all.iter().copied(), "and");
            told.why(format!("The choices of {name}: {choices}."))
                .help(otherwise(name, &word.text).unwrap_or_default())
        }
        (_, true, false) => offer(told, &word.text, word.span, declared, "declared are"),
        _ => offer(told, &word.text, word.span, all, &format!("the choices of {name} are")),
    }
}

/// A plain word that is none of those expected.
pub fn unknown_word(what: &str, found: &str, all: &[&str], span: Span) -> Diagnostic {
    let told = Diagnostic::error(Code::NAME_UNKNOWN_WORD, format!("{what} cannot be `{found}`"))
        .label(span, "none of its words");
    let others: Vec<_> = all.iter().filter(|word| **word != "off").collect();
    if let ("on" | "yes" | "true", [right], true) = (found, &others[..], all.len() > 1) {
        return told.help(did_you_mean([**right])).mend(format!("write `{right}`"), span, **right);
    }
    offer(told, found, span, all, "its words are")
}

/// A word that is neither a value nor the name of a declaration of a kind, where both may stand.
pub fn no_value_nor(kind: &str, found: &str, span: Span, declared: &[&str]) -> Diagnostic {
    if nearest(found, declared.iter().copied()).is_empty() {
        return unknown_value(found, span, &[]);
    }
    let headline = format!("nothing is called `{found}` here");
    let told = Diagnostic::error(Code::NAME_UNKNOWN_NAME, headline)
        .label(span, format!("no {kind} and no value has this name"));
    offer(told, found, span, declared, &format!("the {} declared are", plural(kind)))
}

/// A declaration that does not exist in a render. `shape`: how one may look; `made`: what of its
/// kind may be made of what else has the name.
pub fn unknown_declaration(
    place: &str,
    kind: &str,
    word: &Word,
    declared: &[&str],
    (shape, made): (&str, &[String]),
) -> Diagnostic {
    let headline = format!("there is no {kind} called `{}`", word.text);
    let told = Diagnostic::error(Code::NAME_UNKNOWN_DECLARATION, headline)
        .label(word.span, format!("{place} names {}", with_article(kind)));
    let near = nearest(&word.text, declared.iter().copied());
    if near.is_empty() && !made.is_empty() {
        return meant(told, made, word.span);
    }
    if near.is_empty() && declared.is_empty() {
        let shape = format!("`{kind} {}: {shape}`", word.text);
        return told.why(format!("No {kind} is declared.")).help(format!("declare it: {shape}"));
    }
    let told = match near.is_empty() {
        false => told,
        true => told.why(format!(
            "{} is declared by `{kind} {}: …`.",
            capital(&with_article(kind)),
            word.text
        )),
    };
    offer(told, &word.text, word.span, declared, &format!("the {} declared are", plural(kind)))
}

/// The name of a declaration that the same render takes away; `place`: what names it.
pub fn taken_away(place: &str, kind: &str, word: &Word, at: Span) -> Diagnostic {
    let headline = format!("`{place}` names the {kind} `{}`, which is taken away", word.text);
    Diagnostic::error(Code::NAME_UNKNOWN_DECLARATION, headline)
        .label(word.span, "is still named here …")
        .label(at, "… where this takes it away")
        .help(format!(
            "beside it let `{place}` name another {kind}; or say `{place}` only in the renders that \
             have `{}`",
            word.text
        ))
}

/// A value where the name of a declaration belongs, or one in its place. `made`: what of its kind
/// may be made of it.
pub fn no_declaration(
    place: &str,
    (kind, or_itself): (&str, bool),
    found: &str,
    made: &[String],
    span: Span,
) -> Diagnostic {
    let expected = match or_itself {
        true => format!("the name of {0}, or {0}", with_article(kind)),
        false => format!("the name of {}", with_article(kind)),
    };
    let told = super::types::mismatch(place, &expected, found, span);
    if made.is_empty() {
        return told;
    }
    let words = made.iter().map(String::as_str);
    let told = told.help(format!("write {}", listed(words, "or")));
    made.iter().fold(told, |told, right| told.mend(format!("write `{right}`"), span, right))
}

/// A part of a declaration that does not exist.
pub fn unknown_target(
    kind: &str,
    name: &str,
    span: Span,
    declared: &[&str],
    verb: &str,
) -> Diagnostic {
    let headline = format!("there is no {kind} called `{name}` to {verb}");
    let told = Diagnostic::error(Code::NAME_UNKNOWN_DECLARATION, headline)
        .label(span, format!("nothing before this states {kind} `{name}`"));
    if declared.contains(&name) {
        return told.help(format!("it was removed before: state it anew by `{kind} {name}: …`"));
    }
    match declared {
        [] => told.help(format!("state it first: `{kind} {name}: …`")),
        _ => offer(told, name, span, declared, &format!("the {} stated are", plural(kind))),
    }
}

/// A base that does not exist.
pub fn unknown_setup(word: &Word, all: &[&str]) -> Diagnostic {
    let headline = format!("no setup or render is called `{}`", word.text);
    let told = Diagnostic::error(Code::NAME_UNKNOWN_SETUP, headline).label(word.span, "not known");
    match all {
        [] => told.help(format!("write it: `setup {} {{ … }}`", word.text)),
        _ => offer(told, &word.text, word.span, all, "setups and renders are"),
    }
}

/// A name for two things.
pub fn defined_twice(what: &str, word: &Word, first: Span) -> Diagnostic {
    let headline = format!("the {what} `{}` is defined twice", word.text);
    Diagnostic::error(Code::NAME_DEFINED_TWICE, headline)
        .label(word.span, "defined again")
        .label(first, "defined first")
        .why("No name hides another, so that each means one thing wherever it is read.")
        .help("give one of them another name")
}

/// A name that the language has taken.
pub fn taken(word: &Word, what: &str) -> Diagnostic {
    let headline = format!("`{}` cannot be a name: it is {what}", word.text);
    Diagnostic::error(Code::NAME_TAKEN, headline)
        .label(word.span, format!("{what} already"))
        .help("choose another name")
}
