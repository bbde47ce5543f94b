//! The functions of the language itself.

use glam::DVec3;

use super::ast::Word;
use super::check;
use super::errors::types;
use super::eval::Evaluator;
use super::value::{Value, ValueKind, neat};
use super::words::FUNCTIONS;
use crate::diag::Span;
use crate::math::srgb;
use crate::math::units::Dimension;
use crate::scene::Step;

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
        ev.reports.tell(types::arguments(&word.text, params[0], values.len(), span));
        return Some(Value::broken(span));
    }
    let kind = match &*word.text {
        "rgb" => colour(ev, &values, |c| c),
        "srgb" => colour(ev, &values, srgb::decode),
        "scale" => scale(ev, &values),
        "rotate" => rotate(ev, &values),
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

fn rotate(ev: &Evaluator, values: &[Value]) -> Option<ValueKind> {
    let axis = check::direction(ev, &values[0], "the first argument of `rotate`");
    let angle = check::number(ev, &values[1], Dimension::ANGLE, "the second argument of `rotate`");
    Some(ValueKind::Step(Step::Rotate(axis?, angle?)))
}

fn moved(ev: &Evaluator, values: &[Value], span: Span) -> Option<DVec3> {
    match values {
        [vector] => check::point(ev, vector, "`move`"),
        _ => check::coordinates(ev, values, span, span.file, "`move`"),
    }
}
