//! Spectra as values: from records such as `spectrum { 400 nm: 0.1 }`, and their arithmetic.

use super::arithmetic;
use super::ast::{Operator, Quantity};
use super::check::{Checker, Declared};
use super::errors::{name as names, quantities, render, spectrum as errors, types};
use super::eval::Evaluator;
use super::limits;
use super::value::{RecordValue, Value, ValueKind, neat};
use crate::data::cie;
use crate::diag::Span;
use crate::math::units::{Dimension, Unit};
use crate::math::{Formula, Spectrum, Table};
use crate::optics;
use crate::scene::schema::Checked;
use crate::scene::spectral::{CAUCHY, RECORDS, SELLMEIER, SPECTRUM};

/// Nodes of tables that count as one value, wherever a table is computed or lands: each scene has
/// its own.
const NODES_A_VALUE: usize = 16;

/// The spectrum that a record stands for; None: it is a record of something else.
pub fn from_record(ev: &Evaluator, record: &RecordValue, span: Span) -> Option<Value> {
    let word = record.word.as_ref()?;
    let kind = match *RECORDS.iter().find(|known| known.word == &*word.text)? {
        known if known.word == SPECTRUM.word => tabled(ev, record),
        known if known.word == SELLMEIER.word => sellmeier(ev, record, span),
        _ => cauchy(ev, record, span),
    };
    Some(Value { kind: kind.unwrap_or(ValueKind::Broken), span })
}

/// `spectrum { 400 nm: 0.1, … }`
fn tabled(ev: &Evaluator, record: &RecordValue) -> Option<ValueKind> {
    if record.fields.len() > limits::ELEMENTS {
        ev.reports.tell(render::too_many_elements(record.braces));
        return None;
    }
    let mut whole = !record.partial;
    let mut nodes: Vec<(f64, f64, usize)> = Vec::with_capacity(record.fields.len());
    let mut same: Option<(Dimension, Span)> = None;
    for (i, field) in record.fields.iter().enumerate() {
        let nm = match field.quantity.map(in_nm) {
            Some(Some(nm)) => nm,
            found => {
                let bare = field.quantity.is_some_and(|q| q.unit.is_none());
                ev.reports.tell(errors::no_wavelength(&field.key, found.is_some(), bare));
                whole = false;
                continue;
            }
        };
        let value = ev.force(&field.value);
        let what = format!("`spectrum` at {}", field.key.text);
        match number(ev, &value, &what) {
            Some((value_at, dimension)) => {
                let (first, place) = *same.get_or_insert((dimension, value.span));
                if first != dimension {
                    let told =
                        quantities::dimension(&what, &first.name(), &dimension.name(), value.span);
                    ev.reports.tell(told.label(place, format!("this is {}", first.name())));
                    whole = false;
                }
                nodes.push((nm, value_at, i));
            }
            None => whole = false,
        }
    }
    if record.fields.is_empty() && whole {
        ev.reports.tell(errors::empty(record.braces));
        return None;
    }
    nodes.sort_by(|a, b| a.0.total_cmp(&b.0));
    for pair in nodes.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        let (first, again) = (&record.fields[pair[0].2].key, &record.fields[pair[1].2].key);
        ev.reports.tell(names::field_twice(again, first.span, SPECTRUM.word));
        whole = false;
    }
    if !whole {
        return None;
    }
    let table = Table::new(nodes.into_iter().map(|(nm, value, _)| (nm, value)).collect())?;
    seen(ev, &table, record.word.as_ref().map_or(record.braces, |word| word.span))?;
    let dimension = same.map_or(Dimension::NONE, |(dimension, _)| dimension);
    Some(ValueKind::Spectrum(Spectrum::Table(table), dimension))
}

/// Tells a table that says nothing of light that can be seen.
pub fn seen(ev: &Evaluator, table: &Table, place: Span) -> Option<()> {
    let (observed, nodes) = (cie::observer(), table.nodes());
    let (low, high) = (observed[0][0], observed[observed.len() - 1][0]);
    let (first, last) = (nodes[0].0, nodes[nodes.len() - 1].0);
    if last < low || first > high {
        ev.reports.tell(errors::unseen((first, last), (low, high), place));
        return None;
    }
    Some(())
}

/// A wavelength in nm; None if it is none.
fn in_nm(quantity: Quantity) -> Option<f64> {
    let (unit, exponent): (&Unit, i8) = quantity.unit?;
    let nm = neat(quantity.value * (unit.scale / 1e-9));
    let length = exponent == 1 && unit.dimension == Dimension::LENGTH;
    (length && nm > 0.0 && nm.is_finite()).then_some(nm)
}

/// A number of any dimension.
fn number(ev: &Evaluator, value: &Value, what: &str) -> Option<(f64, Dimension)> {
    let quantity = arithmetic::quantity(ev, value);
    match quantity.kind {
        ValueKind::Number { value, dimension, .. } => Some((value, dimension)),
        ValueKind::Broken => None,
        _ => {
            let found = quantity.described();
            ev.reports.tell(types::mismatch(what, "a number", &found, value.span));
            None
        }
    }
}

fn sellmeier(ev: &Evaluator, record: &RecordValue, span: Span) -> Option<ValueKind> {
    let declared = Declared::new();
    let fields = Checker::new(ev, &declared).fields(record, &SELLMEIER, span, SELLMEIER.word)?;
    let numbers = |checked: &Checked| -> Vec<f64> {
        let Checked::List(all) = checked else { return Vec::new() };
        all.iter().filter_map(|at| number_of(&at.value)).collect()
    };
    let (b, c) = (numbers(&fields[0].value), numbers(&fields[1].value));
    if b.len() != c.len() || b.is_empty() {
        ev.reports.tell(errors::uneven_terms(b.len(), c.len(), fields[1].span));
        return None;
    }
    let terms: Vec<_> = b.into_iter().zip(c).map(|(b, c)| (b, neat(c * 1e12))).collect();
    let (low, high) = optics::VISIBLE;
    let inside = |um2: f64| (f64::from(low)..=f64::from(high)).contains(&(um2.sqrt() * 1e3));
    if let Some((_, c)) = terms.iter().find(|(b, c)| *b != 0.0 && inside(*c)) {
        ev.reports.tell(errors::resonance(c.sqrt() * 1e3, fields[1].span));
        return None;
    }
    index(ev, Formula::Sellmeier(terms), span)
}

fn cauchy(ev: &Evaluator, record: &RecordValue, span: Span) -> Option<ValueKind> {
    let declared = Declared::new();
    let fields = Checker::new(ev, &declared).fields(record, &CAUCHY, span, CAUCHY.word)?;
    let term = |i: usize, scale: f64| number_of(&fields[i].value).map(|x| neat(x * scale));
    index(ev, Formula::Cauchy([term(0, 1.0)?, term(1, 1e12)?, term(2, 1e24)?]), span)
}

fn number_of(checked: &Checked) -> Option<f64> {
    match checked {
        Checked::Number(x) => Some(*x),
        _ => None,
    }
}

/// A real index by a formula; told where it is none.
fn index(ev: &Evaluator, formula: Formula, span: Span) -> Option<ValueKind> {
    let (low, high) = optics::VISIBLE;
    let of = |nm: u32| optics::value(&formula, f64::from(nm));
    if let Some(nm) = (low..=high).find(|nm| !(of(*nm) > 0.0 && of(*nm).is_finite())) {
        ev.reports.tell(errors::no_real_index(nm, of(nm), span));
        return None;
    }
    Some(ValueKind::Index { n: Spectrum::of(formula), k: None })
}

/// A spectrum between two others, or another and a number; the dimension is `dimension`.
pub fn binary(
    ev: &Evaluator,
    left: &Value,
    operator: Operator,
    right: &Value,
    dimension: Dimension,
    place: Span,
) -> Option<ValueKind> {
    let (a, b) = (spectrum(left)?, spectrum(right)?);
    let spectrum = match (&a, operator, &b) {
        (Spectrum::Rgb(_), ..) | (.., Spectrum::Rgb(_)) => {
            let colour = if matches!(a, Spectrum::Rgb(_)) { left } else { right };
            ev.reports.tell(errors::mixed(colour.span, place));
            return None;
        }
        (Spectrum::Constant(factor), Operator::Multiply, other)
        | (other, Operator::Multiply, Spectrum::Constant(factor)) => other.scaled(*factor),
        (other, Operator::Divide, Spectrum::Constant(divisor)) => match other {
            Spectrum::Table(table) => Spectrum::Table(table.map(|x| x / divisor)),
            other => other.scaled(1.0 / divisor),
        },
        _ => {
            let f = match operator {
                Operator::Add => |a, b| a + b,
                Operator::Subtract => |a, b| a - b,
                Operator::Multiply => |a: f64, b: f64| a * b,
                Operator::Divide => |a, b| a / b,
            };
            tables(ev, &a, &b, f, place)?
        }
    };
    spend(ev, &spectrum, place)?;
    Some(ValueKind::Spectrum(spectrum, dimension))
}

fn tables(
    ev: &Evaluator,
    a: &Spectrum,
    b: &Spectrum,
    f: impl Fn(f64, f64) -> f64,
    place: Span,
) -> Option<Spectrum> {
    // A number has no wavelengths of its own.
    let joined = match (a, b) {
        (Spectrum::Constant(a), b) => optics::tabulated(b)?.map(|b| f(*a, b)),
        (a, Spectrum::Constant(b)) => optics::tabulated(a)?.map(|a| f(a, *b)),
        (a, b) => optics::tabulated(a)?.with(&optics::tabulated(b)?, f),
    };
    if joined.nodes().len() > limits::ELEMENTS {
        ev.reports.tell(render::too_many_elements(place));
        return None;
    }
    Some(Spectrum::Table(joined))
}

/// Counts the work of a table, or of a formula that has to be looked into.
pub fn spend(ev: &Evaluator, spectrum: &Spectrum, place: Span) -> Option<()> {
    let nodes = match spectrum {
        Spectrum::Table(table) => table.nodes().len(),
        Spectrum::Formula { .. } => (optics::VISIBLE.1 - optics::VISIBLE.0) as usize,
        _ => 0,
    };
    ev.spend_many(nodes / NODES_A_VALUE, place).then_some(())
}

/// `spectrum^exponent`
pub fn power(spectrum: &Spectrum, exponent: i8) -> Option<Spectrum> {
    let table = optics::tabulated(spectrum)?;
    Some(Spectrum::Table(table.map(|x| x.powi(i32::from(exponent)))))
}

/// A number, a colour or a spectrum as a spectrum.
pub fn spectrum(value: &Value) -> Option<Spectrum> {
    match &value.kind {
        ValueKind::Number { value, .. } => Some(Spectrum::Constant(*value)),
        ValueKind::Colour(components, _) => Some(Spectrum::Rgb(*components)),
        ValueKind::Spectrum(spectrum, _) => Some(spectrum.clone()),
        _ => None,
    }
}

/// Whether no value is infinite or no number.
pub fn is_finite(spectrum: &Spectrum) -> bool {
    match spectrum {
        Spectrum::Constant(value) => value.is_finite(),
        Spectrum::Rgb(components) => components.iter().all(|c| c.is_finite()),
        Spectrum::Table(table) => table.nodes().iter().all(|(_, value)| value.is_finite()),
        Spectrum::Formula { scale, .. } => {
            let table = optics::tabulated(spectrum);
            scale.is_finite() && table.is_some_and(|t| t.nodes().iter().all(|n| n.1.is_finite()))
        }
    }
}
