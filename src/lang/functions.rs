//! The functions of the language itself.

use glam::DVec3;

use super::ast::Word;
use super::errors::types;
use super::eval::Evaluator;
use super::value::{Value, ValueKind, neat};
use super::words::FUNCTIONS;
use super::{check, spectra};
use crate::diag::Span;
use crate::math::units::Dimension;
use crate::math::{Formula, Spectrum, srgb};
use crate::optics;
use crate::scene::Step;
use crate::scene::schema::Range;

/// Their names.
pub const ALL: &[&str] = &{
    let mut all = [""; FUNCTIONS.len()];
    let mut i = 0;
    while i < all.len() {
        all[i] = FUNCTIONS[i].word;
        i += 1;
    }
    all
};

/// Calls one; None if there is none of that name.
pub fn call(ev: &Evaluator, word: &Word, values: Vec<Value>, span: Span) -> Option<Value> {
    let params = FUNCTIONS.iter().find(|function| function.word == &*word.text)?.params;
    if values.iter().any(Value::is_broken) {
        return Some(Value::broken(span));
    }
    if !params.iter().any(|params| params.len() == values.len()) {
        ev.reports.tell(types::arguments(&word.text, params, values.len(), span));
        return Some(Value::broken(span));
    }
    let kind = match &*word.text {
        "rgb" => colour(ev, &values, |c| c),
        "srgb" => encoded(ev, &values, span),
        "scale" => scale(ev, &values),
        "rotate" => rotate(ev, &values, span),
        "blackbody" => blackbody(ev, &values[0]),
        "complex" => check::complex(ev, &values[0], &values[1]),
        "data" => data(ev, &values, span),
        "upsample" => upsample(ev, &values[0], span),
        _ => moved(ev, &values, span).map(|v| ValueKind::Step(Step::Move(v))),
    };
    Some(Value { kind: kind.unwrap_or(ValueKind::Broken), span })
}

/// Plain numbers, told where they are not.
fn numbers<const N: usize>(ev: &Evaluator, what: &str, values: &[Value]) -> Option<[f64; N]> {
    let mut found = [0.0; N];
    for (slot, value) in found.iter_mut().zip(values) {
        *slot = check::number(ev, value, Dimension::NONE, what)?;
    }
    Some(found)
}

fn colour(ev: &Evaluator, values: &[Value], decode: impl Fn(f64) -> f64) -> Option<ValueKind> {
    let components = numbers::<3>(ev, "a component of a colour", values)?;
    Some(ValueKind::Colour(components.map(decode), Dimension::NONE))
}

fn encoded(ev: &Evaluator, values: &[Value], span: Span) -> Option<ValueKind> {
    let components = numbers::<3>(ev, "a component of a colour", values)?;
    if components.iter().all(|component| (0.0..=1.0).contains(component)) {
        return Some(ValueKind::Colour(components.map(srgb::decode), Dimension::NONE));
    }
    // Only what stands there as numbers is written anew.
    let literal = |text: &str| !text.contains(|c: char| c.is_ascii_alphabetic() || c == '"');
    let arguments = ev.written(span).and_then(|text| text.strip_prefix("srgb"));
    ev.reports.tell(types::encoded_range(components, arguments.is_some_and(literal), span));
    None
}

fn scale(ev: &Evaluator, values: &[Value]) -> Option<ValueKind> {
    if let [Value { kind: ValueKind::Vector { components, .. }, span }] = values {
        let plain: Option<Vec<_>> = components
            .iter()
            .map(|component| match component.kind {
                ValueKind::Number { value, .. } => Some(neat(value).to_string()),
                _ => None,
            })
            .collect();
        let components = plain.unwrap_or_else(|| ["x", "y", "z"].map(String::from).to_vec());
        ev.reports.tell(types::vector_as_arguments("scale", &components.join(", "), *span));
        return None;
    }
    let factors = match values {
        [one] => DVec3::splat(numbers::<1>(ev, "a factor", std::slice::from_ref(one))?[0]),
        _ => DVec3::from_array(numbers::<3>(ev, "a factor", values)?),
    };
    if factors.to_array().contains(&0.0) {
        ev.reports.tell(types::zero_scale(values[0].span));
        return None;
    }
    Some(ValueKind::Step(Step::Scale(factors)))
}

fn rotate(ev: &Evaluator, values: &[Value], span: Span) -> Option<ValueKind> {
    let [first, second] = values else { return None };
    let angle = matches!(first.kind, ValueKind::Number { dimension: Dimension::ANGLE, .. });
    let axis = !matches!(second.kind, ValueKind::Number { .. });
    if angle && axis {
        let text = ev.written(span).and_then(|text| {
            let (angle, axis) = text.strip_prefix("rotate(")?.strip_suffix(')')?.split_once(',')?;
            Some(format!("rotate({}, {})", axis.trim(), angle.trim()))
        });
        ev.reports.tell(types::turned_round(text, span));
        return None;
    }
    let axis = check::direction(ev, &values[0], "the first argument of `rotate`");
    let angle = check::number(ev, &values[1], Dimension::ANGLE, "the second argument of `rotate`");
    Some(ValueKind::Step(Step::Rotate(axis?, angle?)))
}

fn blackbody(ev: &Evaluator, value: &Value) -> Option<ValueKind> {
    let what = "the temperature of `blackbody`";
    let kelvin = check::number_within(ev, value, Dimension::TEMPERATURE, &Range::above(0.0), what)?;
    let radiance = Spectrum::of(Formula::Blackbody(kelvin));
    Some(ValueKind::Spectrum(radiance, Dimension::SPECTRAL_RADIANCE))
}

fn data(ev: &Evaluator, values: &[Value], span: Span) -> Option<ValueKind> {
    let ValueKind::Text { text, file } = &values[0].kind else {
        let what = "the first argument of `data`";
        let found = values[0].described();
        let expected = "the name of a file in quotes";
        ev.reports.tell(types::mismatch(what, expected, &found, values[0].span));
        return None;
    };
    let unit = match values.get(1) {
        Some(unit) => {
            let what = "the unit of `data`";
            let metres =
                check::number_within(ev, unit, Dimension::LENGTH, &Range::above(0.0), what)?;
            neat(metres / 1e-9)
        }
        None => 1.0,
    };
    let asked = values[0].span;
    let path = ev.folder(*file).join(&**text);
    let file = ev.data.get(&ev.reports, &path, text, asked)?;
    if !ev.spend_many(file.cost(unit), span) {
        return None;
    }
    let columns = file.columns(&ev.reports, text, unit, asked)?;
    spectra::seen(ev, &columns.value, span)?;
    let value = Spectrum::Table(columns.value);
    Some(match columns.k {
        Some(k) => ValueKind::Index { n: value, k: Some(Spectrum::Table(k)) },
        None => ValueKind::Spectrum(value, Dimension::NONE),
    })
}

/// Values that computing a smooth spectrum counts as.
const UPSAMPLING: usize = 100;

fn upsample(ev: &Evaluator, value: &Value, span: Span) -> Option<ValueKind> {
    let what = "the argument of `upsample`";
    let ValueKind::Colour(components, dimension) = value.kind else {
        let expected = "a colour such as `rgb(0.8, 0.4, 0.2)`";
        ev.reports.tell(types::mismatch(what, expected, &value.described(), value.span));
        return None;
    };
    for component in components {
        check::in_range(ev, value, component, &Range::at_least(0.0), dimension, what)?;
    }
    if !ev.spend_many(UPSAMPLING, span) {
        return None;
    }
    let spectrum = match dimension.is_light() {
        true => optics::upsampled_light(components),
        false => optics::upsampled_reflectance(components),
    };
    Some(ValueKind::Spectrum(Spectrum::Table(spectrum), dimension))
}

fn moved(ev: &Evaluator, values: &[Value], span: Span) -> Option<DVec3> {
    match values {
        [vector] => check::point(ev, vector, "`move`"),
        _ => check::coordinates(ev, values, span, span.file, "`move`"),
    }
}
