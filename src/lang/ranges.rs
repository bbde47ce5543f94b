//! Ranges: `1 to 9 step 2`, which include their end.

use super::errors::{quantities, render, types};
use super::eval::Evaluator;
use super::value::{Value, ValueKind};
use super::{arithmetic, limits};
use crate::diag::Span;
use crate::math::units::Dimension;

/// `from to to step step` as a list.
pub fn range(ev: &Evaluator, from: Value, to: Value, step: Option<Value>, span: Span) -> Value {
    let one = match &from.kind {
        ValueKind::Number { dimension, unit, .. } => {
            let scale = unit.map_or(1.0, |unit| unit.scale);
            Value::number(scale, *dimension, span)
        }
        _ => Value::number(1.0, Dimension::NONE, span),
    };
    let step = step.unwrap_or(one);
    let mut numbers = [0.0; 3];
    let mut same = None;
    let mut written = None;
    for (slot, value) in numbers.iter_mut().zip([&from, &to, &step]) {
        let value = arithmetic::quantity(ev, value);
        match value.kind {
            ValueKind::Number { value: x, dimension, unit } => {
                *slot = x;
                written = written.or(unit);
                if *same.get_or_insert(dimension) != dimension {
                    let first = same.map_or_else(String::new, Dimension::name);
                    ev.reports.tell(quantities::dimension(
                        "this range",
                        &first,
                        &dimension.name(),
                        value.span,
                    ));
                    return Value::broken(span);
                }
            }
            ValueKind::Broken => return Value::broken(span),
            _ => {
                let found = value.described();
                ev.reports.tell(types::mismatch("a range", "numbers", &found, value.span));
                return Value::broken(span);
            }
        }
    }
    let [from, to, step] = numbers;
    let steps = (to - from) / step;
    if step == 0.0 || steps < -1e-9 || steps.is_nan() {
        ev.reports.tell(types::empty_range(step == 0.0, span));
        return Value::broken(span);
    }
    if steps >= limits::ELEMENTS as f64 {
        ev.reports.tell(render::too_many_elements(span));
        return Value::broken(span);
    }
    let dimension = same.unwrap_or(Dimension::NONE);
    let element = |i: usize| {
        let value = super::value::neat(from + i as f64 * step);
        Value { kind: ValueKind::Number { value, dimension, unit: written }, span }
    };
    let count = (steps + 1e-9).floor() as usize + 1;
    Value { kind: ValueKind::List((0..count).map(element).collect()), span }
}
