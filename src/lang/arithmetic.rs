//! Sums, products and powers of quantities, with their dimensions.

use std::rc::Rc;

use super::ast::Operator;
use super::errors::{name, types};
use super::eval::Evaluator;
use super::spectra;
use super::value::{Value, ValueKind};
use crate::diag::{FileId, Span};
use crate::math::units::{self, Dimension};

/// A word that stands for a quantity becomes it: units, `pi`, `x y z`; so does a record that is a
/// spectrum. Other words are told to be unknown.
pub fn quantity(ev: &Evaluator, value: &Value) -> Value {
    let span = value.span;
    let word = match &value.kind {
        ValueKind::Word(word) => word,
        ValueKind::Record(record) => {
            return spectra::from_record(ev, record, span).unwrap_or_else(|| value.clone());
        }
        _ => return value.clone(),
    };
    if let Some(found) = known(&word.text, span) {
        return found;
    }
    ev.reports.tell_unknown(&word.text, name::unknown_value(&word.text, word.span, &[]));
    Value::broken(span)
}

/// What a word of the language is worth.
pub fn known(word: &str, span: Span) -> Option<Value> {
    if let Some(unit) = units::find(word) {
        let (value, dimension) = (unit.scale, unit.dimension);
        return Some(Value {
            kind: ValueKind::Number { value, dimension, unit: Some(unit) },
            span,
        });
    }
    let axis = match word {
        "pi" => return Some(Value::number(std::f64::consts::PI, Dimension::NONE, span)),
        "x" => [1.0, 0.0, 0.0],
        "y" => [0.0, 1.0, 0.0],
        "z" => [0.0, 0.0, 1.0],
        _ => return None,
    };
    let components = axis.map(|x| Value::number(x, Dimension::NONE, span));
    Some(Value { kind: ValueKind::Vector { components: components.into(), file: span.file }, span })
}

/// `-value`
pub fn negated(ev: &Evaluator, value: Value, span: Span) -> Value {
    let minus = Value::number(-1.0, Dimension::NONE, span);
    binary(ev, minus, Operator::Multiply, span, value, span)
}

/// `left operator right`
pub fn binary(
    ev: &Evaluator,
    left: Value,
    operator: Operator,
    place: Span,
    right: Value,
    span: Span,
) -> Value {
    if left.is_broken() || right.is_broken() {
        return Value::broken(span);
    }
    let (left, right) = (quantity(ev, &left), quantity(ev, &right));
    let kind = match (&left.kind, &right.kind) {
        (ValueKind::Broken, _) | (_, ValueKind::Broken) => return Value::broken(span),
        (ValueKind::Vector { .. }, _) | (_, ValueKind::Vector { .. }) => {
            return vectors(ev, &left, operator, place, &right, span);
        }
        _ => match [&left, &right].into_iter().find(|value| parts(value).is_none()) {
            Some(odd) => {
                ev.reports.tell(types::no_arithmetic(&odd.described(), odd.span, place));
                None
            }
            None => scalars(ev, &left, operator, place, &right),
        },
    };
    match kind {
        Some(kind) => ev.finite(Value { kind, span }),
        None => Value::broken(span),
    }
}

/// What scalars are made of.
enum Parts {
    /// A number.
    Number(f64),
    /// Channels.
    Colour([f64; 3]),
    /// Values by wavelength.
    Spectrum,
}

/// What a value is made of, and its dimension; None if it is no number, colour or spectrum.
fn parts(value: &Value) -> Option<(Parts, Dimension)> {
    match &value.kind {
        ValueKind::Number { value, dimension, .. } => Some((Parts::Number(*value), *dimension)),
        ValueKind::Colour(components, dimension) => Some((Parts::Colour(*components), *dimension)),
        ValueKind::Spectrum(_, dimension) => Some((Parts::Spectrum, *dimension)),
        _ => None,
    }
}

fn scalars(
    ev: &Evaluator,
    left: &Value,
    operator: Operator,
    place: Span,
    right: &Value,
) -> Option<ValueKind> {
    let ((a, dim_a), (b, dim_b)) = (parts(left)?, parts(right)?);
    let additive = matches!(operator, Operator::Add | Operator::Subtract);
    if additive && dim_a != dim_b {
        ev.reports.tell(types::sum_of(&dim_a.name(), left.span, &dim_b.name(), right.span, place));
        return None;
    }
    let of = |a: f64, b: f64| match operator {
        Operator::Add => a + b,
        Operator::Subtract => a - b,
        Operator::Multiply => a * b,
        Operator::Divide => a / b,
    };
    let dimension = match operator {
        Operator::Multiply => dim_a.times(dim_b),
        Operator::Divide => dim_a.over(dim_b),
        _ => dim_a,
    };
    let channels = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|i| of(a[i], b[i]));
    let value = match (a, b) {
        (Parts::Number(a), Parts::Number(b)) => of(a, b),
        (Parts::Spectrum, _) | (_, Parts::Spectrum) => {
            return spectra::binary(ev, left, operator, right, dimension, place);
        }
        (Parts::Colour(a), Parts::Colour(b)) => {
            return Some(ValueKind::Colour(channels(a, b), dimension));
        }
        (Parts::Colour(a), Parts::Number(b)) => {
            return Some(ValueKind::Colour(channels(a, [b; 3]), dimension));
        }
        (Parts::Number(a), Parts::Colour(b)) => {
            return Some(ValueKind::Colour(channels([a; 3], b), dimension));
        }
    };
    let written = |v: &Value| match v.kind {
        ValueKind::Number { unit, .. } => unit,
        _ => None,
    };
    let unit = written(left).or(written(right)).filter(|unit| unit.dimension == dimension);
    Some(ValueKind::Number { value, dimension, unit })
}

fn vectors(
    ev: &Evaluator,
    left: &Value,
    operator: Operator,
    place: Span,
    right: &Value,
    span: Span,
) -> Value {
    let apply = |a: &Value, b: &Value| binary(ev, a.clone(), operator, place, b.clone(), span);
    let (components, file): (Rc<[Value]>, FileId) = match (&left.kind, &right.kind, operator) {
        (
            ValueKind::Vector { components: a, file },
            ValueKind::Vector { components: b, file: other },
            Operator::Add | Operator::Subtract,
        ) if a.len() == b.len() => {
            // Bare coordinates of two files are lengths before they meet.
            let length =
                |v: &Value, file: FileId| metres(ev, v, file, *file_of(left) != *file_of(right));
            (
                a.iter()
                    .zip(b.iter())
                    .map(|(a, b)| apply(&length(a, *file), &length(b, *other)))
                    .collect(),
                *file,
            )
        }
        (
            ValueKind::Vector { components, file },
            ValueKind::Number { .. },
            Operator::Multiply | Operator::Divide,
        ) => (components.iter().map(|c| apply(c, right)).collect(), *file),
        (ValueKind::Number { .. }, ValueKind::Vector { components, file }, Operator::Multiply) => {
            (components.iter().map(|c| apply(left, c)).collect(), *file)
        }
        _ => {
            ev.reports.tell(types::no_arithmetic("a vector", left.span, place));
            return Value::broken(span);
        }
    };
    if components.iter().any(Value::is_broken) {
        return Value::broken(span);
    }
    Value { kind: ValueKind::Vector { components, file }, span }
}

fn file_of(vector: &Value) -> &FileId {
    match &vector.kind {
        ValueKind::Vector { file, .. } => file,
        _ => &vector.span.file,
    }
}

/// A bare coordinate as a length, where `wanted`.
fn metres(ev: &Evaluator, value: &Value, file: FileId, wanted: bool) -> Value {
    match value.kind {
        ValueKind::Number { value: x, dimension: Dimension::NONE, .. } if wanted => {
            match ev.unit(file, value.span) {
                Some(unit) => Value::number(x * unit, Dimension::LENGTH, value.span),
                None => Value::broken(value.span),
            }
        }
        _ => value.clone(),
    }
}

/// `value^exponent`
pub fn power(ev: &Evaluator, value: Value, exponent: i8, span: Span) -> Value {
    let value = quantity(ev, &value);
    let raised = |x: f64| x.powi(i32::from(exponent));
    let kind = match &value.kind {
        ValueKind::Broken => return Value::broken(span),
        ValueKind::Number { value, dimension, .. } => ValueKind::Number {
            value: raised(*value),
            dimension: dimension.power(exponent),
            unit: None,
        },
        ValueKind::Colour(c, dimension) => {
            ValueKind::Colour(c.map(raised), dimension.power(exponent))
        }
        ValueKind::Spectrum(spectrum, dimension) => match spectra::power(spectrum, exponent) {
            Some(raised) => ValueKind::Spectrum(raised, dimension.power(exponent)),
            None => return Value::broken(span),
        },
        _ => {
            ev.reports.tell(types::no_arithmetic(&value.described(), value.span, span));
            return Value::broken(span);
        }
    };
    ev.finite(Value { kind, span })
}
