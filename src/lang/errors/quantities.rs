//! `type/missing-unit`, `type/wrong-dimension`: quantities whose unit is not that of their place.

use crate::diag::words::listed;
use crate::diag::{Code, Diagnostic, Span};
use crate::lang::value::digits;
use crate::math::units::{Dimension, UNITS};
use crate::optics::colour::LUMENS_A_WATT;
use crate::scene::schema::{Bound, Range};

/// Whether a field is a time of hours: of a day, or of a clock.
fn is_of_hours(dimension: Dimension, range: &Range) -> bool {
    let (Bound::Inclusive(high) | Bound::Exclusive(high)) = range.high else { return false };
    dimension == Dimension::TIME && high >= 3600.0
}

/// The likeliest units of a dimension within bounds, as written after a number.
fn units_of(dimension: Dimension, range: &Range) -> Vec<String> {
    match dimension {
        Dimension::TIME if is_of_hours(dimension, range) => vec!["h".into()],
        Dimension::TIME => ["s", "min", "h"].map(String::from).to_vec(),
        Dimension::LENGTH => ["m", "cm", "mm"].map(String::from).to_vec(),
        Dimension::ANGLE => vec!["deg".into(), "rad".into()],
        // Coefficients of dispersion, in the units of catalogues.
        Dimension::AREA => vec!["um^2".into()],
        Dimension::SQUARED_AREA => vec!["um^4".into()],
        _ => {
            let known = UNITS.iter().filter(|unit| unit.dimension == dimension);
            let known: Vec<_> = known.map(|unit| unit.word.to_string()).take(3).collect();
            if known.is_empty() { vec![dimension.unit()] } else { known }
        }
    }
}

/// How a value of a dimension may look, within its bounds.
pub fn example(dimension: Dimension, range: &Range) -> String {
    if dimension == Dimension::NONE {
        return if range.holds(0.5) { "0.5".into() } else { "1".into() };
    }
    if dimension == Dimension::ANGLE {
        return "40 deg".into();
    }
    let unit = units_of(dimension, range).into_iter().next().unwrap_or_default();
    if unit.is_empty() { "1".into() } else { format!("1 {unit}") }
}

/// A quantity of another dimension.
pub fn dimension(what: &str, expected: &str, found: &str, span: Span) -> Diagnostic {
    Diagnostic::error(
        Code::TYPE_WRONG_DIMENSION,
        format!("{what}: expected {expected}, found {found}"),
    )
    .label(span, format!("this is {found}"))
}

/// The mend of [`dimension`], where the unit alone is wrong, or something is to be multiplied:
/// `text` is the value as written.
pub fn with_unit(
    told: Diagnostic,
    text: Option<&str>,
    found: Dimension,
    (expected, range): (Dimension, &Range),
    span: Span,
) -> Diagnostic {
    if found.is_luminous() && expected.is_light() {
        return luminous(told, text, found, expected, span);
    }
    if let Some(right) = text.and_then(|text| turned(text, found, (expected, range))) {
        return told
            .why("The earth turns by 15 deg in an hour.")
            .help(format!("did you mean `{right}`?"))
            .mend(format!("write `{right}`"), span, right);
    }
    let unit = match expected {
        Dimension::NONE => String::new(),
        expected => units_of(expected, range).into_iter().next().unwrap_or_default(),
    };
    let right = text.and_then(|text| super::unit_tail::replaced(text, found, &unit));
    let alike = text.filter(|_| found == Dimension::POWER && expected == Dimension::INTENSITY);
    match (right, alike) {
        (right, Some(text)) => {
            let alike = of_a_point(text);
            let right = right.map_or(String::new(), |right| {
                format!("; or `{right}`, if the number is that of each direction")
            });
            told.help(format!("write `{alike}`, if it is sent out alike in all directions{right}"))
                .mend(format!("write `{alike}`"), span, alike)
        }
        (None, None) => told,
        (Some(right), None) if unit.is_empty() => told
            .help(format!("write `{right}`: a plain number takes no unit"))
            .mend(format!("write `{right}`"), span, right),
        (Some(right), None) => told
            .help(format!("write `{right}`, if the number is meant so"))
            .mend(format!("write `{right}`"), span, right),
    }
}

/// The intensity of a point that sends out a flux, as written, alike in all directions.
pub fn of_a_point(flux: &str) -> String {
    match flux.contains(" + ") || flux.contains(" - ") {
        true => format!("({flux}) / (4 * pi * sr)"),
        false => format!("{flux} / (4 * pi * sr)"),
    }
}

/// An angle where a time of hours belongs, or the other way round: 15 degrees of longitude are an
/// hour.
fn turned(text: &str, found: Dimension, (expected, range): (Dimension, &Range)) -> Option<String> {
    const DEGREES_AN_HOUR: f64 = 15.0;
    let (unit, other, scale, factor) = match (found, expected) {
        (Dimension::ANGLE, _) if is_of_hours(expected, range) => {
            ("deg", "h", 3600.0, 1.0 / DEGREES_AN_HOUR)
        }
        (Dimension::TIME, Dimension::ANGLE) => ("h", "deg", 1.0_f64.to_radians(), DEGREES_AN_HOUR),
        _ => return None,
    };
    let number: f64 = text.strip_suffix(unit)?.trim_end().parse().ok()?;
    let right = number * factor;
    range.holds(right * scale).then(|| format!("{} {other}", digits(right)))
}

/// Luminous units where radiant ones belong: 683 of one are one of the other.
fn luminous(
    told: Diagnostic,
    text: Option<&str>,
    found: Dimension,
    expected: Dimension,
    span: Span,
) -> Diagnostic {
    let light = found.radiant().unit();
    let eye = units_of(found, &Range::ANY).into_iter().next().unwrap_or_default();
    let told = told.why(format!(
        "No field takes luminous units yet. 1 {light} in a scene is seen as {LUMENS_A_WATT} {eye}."
    ));
    let right = Some(text).flatten().filter(|_| found.radiant() == expected);
    match right.and_then(|text| super::unit_tail::divided(text, found, LUMENS_A_WATT, &light)) {
        Some(right) => told.help(format!("write `{right}`: divided by {LUMENS_A_WATT}")).mend(
            format!("write `{right}`"),
            span,
            right,
        ),
        None if found.radiant() == expected => {
            told.help(format!("divide it by {LUMENS_A_WATT}, and write {light}"))
        }
        None => told.help(format!("write a quantity in {}", expected.unit())),
    }
}

/// A bare number where a unit matters; `text`: the number as written.
pub fn missing_unit(
    what: &str,
    (dimension, range): (Dimension, &Range),
    (number, text): (f64, Option<&str>),
    span: Span,
) -> Diagnostic {
    let value = digits(number);
    let text = text.unwrap_or(&value);
    let literal = |c: char| c.is_ascii_digit() || "._+-eE".contains(c);
    let with = |unit: &str| match (text.chars().all(literal), unit.strip_prefix("1/")) {
        (true, None) => format!("{text} {unit}"),
        // A product or a name; of a sum only the last number would have the unit.
        _ if text.contains(" + ") || text.contains(" - ") => format!("({text}) * {unit}"),
        (_, None) => format!("{text} * {unit}"),
        (_, Some(below)) => format!("{text} / {below}"),
    };
    let mut choices: Vec<_> = units_of(dimension, range).iter().map(|unit| with(unit)).collect();
    if is_of_hours(dimension, range) && text.chars().all(literal) {
        choices.extend(clock(number, text));
    }
    let headline = format!("{what} is {}: `{value}` needs a unit", dimension.name());
    let mut told = Diagnostic::error(Code::TYPE_MISSING_UNIT, headline)
        .label(span, "a unit belongs after this")
        .help(format!("write {}", listed(choices.iter().map(String::as_str), "or")));
    for right in choices {
        told = told.mend(format!("write `{right}`"), span, right);
    }
    told
}

/// A number of hours as a clock shows it: `18:30` for 18.5, and for 18.30, where the decimals are
/// written as minutes.
fn clock(number: f64, text: &str) -> Option<String> {
    let (hours, decimals) = text.split_once('.').unwrap_or((text, ""));
    let minutes = decimals.parse().ok().filter(|minutes| decimals.len() == 2 && *minutes < 60.0);
    let minutes: f64 = minutes.unwrap_or(number.fract() * 60.0);
    let hours: u8 = hours.parse().ok()?;
    (minutes.fract() == 0.0 && hours < 24).then(|| format!("{hours}:{minutes:02}"))
}

/// A bare colour, or a bare spectrum, where a unit matters.
pub fn spectrum_without_unit(
    what: &str,
    dimension: Dimension,
    colour: bool,
    span: Span,
) -> Diagnostic {
    let unit = dimension.unit();
    let after = match unit.strip_prefix("1/") {
        Some(below) => format!("/ {below}"),
        None => format!("* {unit}"),
    };
    let (name, this) = (dimension.name(), if colour { "colour" } else { "spectrum" });
    let headline = format!("{what} is {name}: this {this} needs a unit");
    Diagnostic::error(Code::TYPE_MISSING_UNIT, headline)
        .label(span, "a unit belongs after this")
        .help(format!("write `{after}` after it"))
        .mend(format!("write `{after}`"), span.after(), format!(" {after}"))
}

/// An angle that lies within its bounds if its number counts degrees; `text`: as written.
pub fn degrees_meant(told: Diagnostic, degrees: f64, text: Option<&str>, span: Span) -> Diagnostic {
    let right = format!("{} deg", digits(degrees));
    let told = told.help(format!("did you mean `{right}`?"));
    match text.is_some_and(|text| text.starts_with(|c: char| c.is_ascii_digit())) {
        true => told.mend(format!("write `{right}`"), span, right),
        false => told,
    }
}

/// A radiance where an irradiance belongs: only the solid angle is missing.
pub fn lacks_solid_angle(told: Diagnostic) -> Diagnostic {
    match told.help {
        None => {
            told.help("multiply it by the solid angle of the light: `* 6.8e-5 sr` is the sun's")
        }
        Some(_) => told,
    }
}
