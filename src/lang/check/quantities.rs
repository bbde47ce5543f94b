//! Numbers, points and directions, with their units.

use glam::DVec3;

use super::meant;
use crate::diag::{FileId, Span};
use crate::lang::arithmetic;
use crate::lang::errors::{quantities as errors, types};
use crate::lang::eval::Evaluator;
use crate::lang::value::{Value, ValueKind, shown};
use crate::math::units::Dimension;
use crate::scene::schema::Range;

/// Words that turn things on and off, which some write where a number says how much.
const SWITCHES: [&str; 7] = ["all", "false", "no", "none", "off", "on", "yes"];

/// Largest count that an f64 holds exactly.
const COUNT_MAX: f64 = 9_007_199_254_740_992.0;

/// Tells a word that turns something on or off where numbers belong, if it is one; `expected`:
/// which numbers.
pub fn is_switch(ev: &Evaluator, value: &Value, what: &str, expected: impl Fn() -> String) -> bool {
    let ValueKind::Word(word) = &value.kind else { return false };
    let is = SWITCHES.contains(&&*word.text);
    if is {
        let told = || types::no_switch(what, &expected(), &word.text, value.span);
        ev.reports.tell_unknown_with(&word.text, value.span, told);
    }
    is
}

/// A number of a dimension, in base units.
pub fn number(ev: &Evaluator, value: &Value, dimension: Dimension, what: &str) -> Option<f64> {
    measured(ev, value, (dimension, &Range::ANY), what)
}

/// A number of a dimension within bounds, in base units.
pub fn number_within(
    ev: &Evaluator,
    value: &Value,
    dimension: Dimension,
    range: &Range,
    what: &str,
) -> Option<f64> {
    let x = measured(ev, value, (dimension, range), what)?;
    in_range(ev, value, x, range, dimension, what)?;
    Some(x)
}

/// A number of a dimension; `range` says what was likely meant by one of another.
fn measured(
    ev: &Evaluator,
    value: &Value,
    (dimension, range): (Dimension, &Range),
    what: &str,
) -> Option<f64> {
    let within = || types::number_within(&dimension.name(), range, &|x| shown(x, dimension, None));
    if is_switch(ev, value, what, within) {
        return None;
    }
    let quantity = arithmetic::quantity(ev, value);
    match quantity.kind {
        ValueKind::Number { value: x, dimension: found, .. } if found == dimension => Some(x),
        ValueKind::Number { value: x, dimension: Dimension::NONE, unit: None } => {
            let said = (x, meant::said(ev, value.span));
            ev.reports.tell(errors::missing_unit(what, (dimension, range), said, value.span));
            None
        }
        ValueKind::Number { dimension: found, .. } => {
            let told = errors::dimension(what, &dimension.name(), &found.name(), value.span);
            let text = ev.written(value.span);
            let wanted = (dimension, range);
            ev.reports.tell(errors::with_unit(told, text, found, wanted, value.span));
            None
        }
        ValueKind::Broken => None,
        _ => {
            let found = quantity.described();
            ev.reports.tell(types::mismatch(what, &dimension.name(), &found, value.span));
            None
        }
    }
}

/// A count within bounds.
pub fn count(ev: &Evaluator, value: &Value, range: &Range, what: &str) -> Option<u64> {
    if is_switch(ev, value, what, || types::count_within(range)) {
        return None;
    }
    let n = number(ev, value, Dimension::NONE, what)?;
    if n.fract() != 0.0 || !(0.0..=COUNT_MAX).contains(&n) {
        ev.reports.tell(types::not_whole(what, n, range, value.span));
        return None;
    }
    in_range(ev, value, n, range, Dimension::NONE, what)?;
    Some(n as u64)
}

/// Two plain numbers, or one for both.
pub fn pair(ev: &Evaluator, value: &Value, range: &Range, what: &str) -> Option<[f64; 2]> {
    let one = |value: &Value| number_within(ev, value, Dimension::NONE, range, what);
    match &value.kind {
        ValueKind::Vector { components, .. } if components.len() == 2 => {
            Some([one(&components[0])?, one(&components[1])?])
        }
        ValueKind::Number { .. } => one(value).map(|x| [x, x]),
        ValueKind::Broken => None,
        _ => {
            let expected = "a pair of numbers such as `(2, 1)`, or one for both";
            ev.reports.tell(types::mismatch(what, expected, &value.described(), value.span));
            None
        }
    }
}

/// Tells a number beyond the bounds of its field.
pub fn in_range(
    ev: &Evaluator,
    value: &Value,
    x: f64,
    range: &Range,
    dimension: Dimension,
    what: &str,
) -> Option<()> {
    if range.holds(x) {
        return Some(());
    }
    let unit = match value.kind {
        ValueKind::Number { unit, .. } => unit,
        _ => None,
    };
    let radians = unit.filter(|unit| dimension == Dimension::ANGLE && unit.scale == 1.0);
    let found = shown(x, dimension, unit);
    // Nobody knows the bounds of angles in radians.
    let show = |x: f64| shown(x, dimension, unit.filter(|_| radians.is_none()));
    let told = types::out_of_range(what, &found, range, &show, value.span);
    let degrees = radians.filter(|_| range.holds(x.to_radians())).map(|_| x);
    ev.reports.tell(match degrees {
        Some(degrees) => errors::degrees_meant(told, degrees, ev.written(value.span), value.span),
        None => told,
    });
    None
}

/// A point in metres.
pub fn point(ev: &Evaluator, value: &Value, what: &str) -> Option<DVec3> {
    match &value.kind {
        ValueKind::Vector { components, file } => {
            coordinates(ev, components, value.span, *file, what)
        }
        ValueKind::Broken => None,
        _ => {
            let expected = "a point such as `(0, 1, 2)`";
            tell_no_vector(ev, value, expected, what);
            None
        }
    }
}

/// Three coordinates in metres; bare ones are in the unit of `file`.
pub fn coordinates(
    ev: &Evaluator,
    components: &[Value],
    span: Span,
    file: FileId,
    what: &str,
) -> Option<DVec3> {
    if components.len() != 3 {
        ev.reports.tell(types::three_coordinates(
            what,
            components.len(),
            computed(components),
            span,
        ));
        return None;
    }
    let mut metres = [0.0; 3];
    for (slot, component) in metres.iter_mut().zip(components) {
        let quantity = arithmetic::quantity(ev, component);
        *slot = match quantity.kind {
            ValueKind::Number { value, dimension: Dimension::NONE, .. } => {
                value * ev.unit(file, component.span)?
            }
            ValueKind::Broken => return None,
            _ => number(ev, &quantity, Dimension::LENGTH, &format!("a coordinate of {what}"))?,
        };
    }
    Some(DVec3::from_array(metres))
}

/// A direction of unit length.
pub fn direction(ev: &Evaluator, value: &Value, what: &str) -> Option<DVec3> {
    let quantity = match &value.kind {
        ValueKind::Word(word) => arithmetic::known(&word.text, value.span),
        _ => None,
    };
    let quantity = quantity.as_ref().unwrap_or(value);
    let ValueKind::Vector { components, .. } = &quantity.kind else {
        if !quantity.is_broken() {
            let expected = "a direction: `x`, `-y` or a vector";
            tell_no_vector(ev, value, expected, what);
        }
        return None;
    };
    if components.len() != 3 {
        ev.reports.tell(types::three_coordinates(
            what,
            components.len(),
            computed(components),
            value.span,
        ));
        return None;
    }
    let lengths = components.iter().any(|c| match c.kind {
        ValueKind::Number { dimension, .. } => dimension == Dimension::LENGTH,
        _ => false,
    });
    let dimension = if lengths { Dimension::LENGTH } else { Dimension::NONE };
    let mut found = [0.0; 3];
    for (slot, component) in found.iter_mut().zip(components.iter()) {
        *slot = number(ev, component, dimension, &format!("a component of {what}"))?;
    }
    // Scaled first: squares of very large or small components would leave the range of f64.
    let largest = found.iter().fold(0.0_f64, |so_far, c| so_far.max(c.abs()));
    if largest == 0.0 {
        ev.reports.tell(types::zero_direction(what, value.span));
        return None;
    }
    Some((DVec3::from_array(found) / largest).normalize())
}

/// Tells what stands where a vector belongs.
fn tell_no_vector(ev: &Evaluator, value: &Value, expected: &str, what: &str) {
    let told = types::mismatch(what, expected, &value.described(), value.span);
    ev.reports.tell(match value.kind {
        ValueKind::List(_) => types::round_brackets(told, ev.written(value.span), value.span),
        _ => told,
    });
}

/// Whether a component covers more text than a number alone does, blanks and a sign included.
fn computed(components: &[Value]) -> bool {
    components.iter().any(|component| match component.kind {
        ValueKind::Number { value, .. } => {
            let length = (component.span.end - component.span.start) as usize;
            length > format!("{value}").len() + 2
        }
        _ => false,
    })
}
