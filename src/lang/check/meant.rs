//! What may have been meant by a field or a value that does not fit, as far as the vocabulary
//! tells: the field stands further in, or the value belongs into a field of what is expected.

use crate::diag::Span;
use crate::lang::ast::ExprKind;
use crate::lang::errors::quantities::of_a_point;
use crate::lang::eval::Evaluator;
use crate::lang::shelves;
use crate::lang::value::{FieldValue, RecordValue, Thunk, Value, ValueKind};
use crate::math::units::Dimension;
use crate::scene::schema::{Field, Record, Type, Variants};
use crate::scene::spectral::Spectral;
use crate::scene::{MEASURED, elsewhere};

/// How far inside a field is looked for.
const DEEPEST: usize = 2;
/// The most that are offered.
const MOST: usize = 3;
/// The longest text that is repeated in an offer, in bytes.
const LONGEST: usize = 60;

/// What stands at a place, if it is short enough to be repeated.
pub fn said<'e>(ev: &'e Evaluator, span: Span) -> Option<&'e str> {
    ev.written(span).filter(|text| text.len() <= LONGEST && !text.contains(['\n', '"']))
}

/// The variants that may stand in a field.
fn variants(ty: &Type) -> Option<&'static Variants> {
    match ty {
        Type::OneOf(variants) => Some(variants),
        Type::Reference { target: Some(target), .. } | Type::Textured { target, .. } => {
            match target() {
                Type::OneOf(variants) => Some(variants),
                _ => None,
            }
        }
        _ => None,
    }
}

/// Ways from a record to fields called `key` further in, the shortest first: `inside: homogeneous
/// { ior: … }`, with `value` for the dots. No more than a few, or none.
fn further_in(record: &Record, key: &str, value: &str) -> Vec<String> {
    let mut found = Vec::new();
    for depth in 1..=DEEPEST {
        let mut open = Vec::new();
        ways(record, key, value, depth, &mut open, &mut found);
    }
    if found.len() > MOST { Vec::new() } else { found }
}

fn ways(
    record: &Record,
    key: &str,
    value: &str,
    depth: usize,
    open: &mut Vec<&'static str>,
    found: &mut Vec<String>,
) {
    let mut looked_into = Vec::new();
    for field in record.fields {
        let word = field.word;
        let inside = |inner: &Record| inner.fields.iter().any(|field| field.word == key);
        if let Type::Record(inner) = field.ty {
            if depth == 1 && inside(inner) {
                found.push(format!("{word}: {{ {key}: {value} }}"));
            }
            continue;
        }
        let Some(variants) = variants(&field.ty) else { continue };
        // Of several fields of a kind the first stands for all.
        if open.contains(&variants.name) || looked_into.contains(&variants.name) {
            continue;
        }
        looked_into.push(variants.name);
        open.push(variants.name);
        for variant in variants.all {
            if depth == 1 && inside(variant) {
                found.push(format!("{word}: {} {{ {key}: {value} }}", variant.word));
            } else if depth > 1 && !inside(variant) {
                let mut inner = Vec::new();
                ways(variant, key, value, depth - 1, open, &mut inner);
                let within = |way| format!("{word}: {} {{ {way} }}", variant.word);
                found.extend(inner.into_iter().map(within));
            }
        }
        open.pop();
    }
}

/// What may be written instead of a field that a record does not have, whose value is `text`: the
/// field further in, or another one that measures the same. And whether what would be written is
/// stated already.
pub fn instead_of(
    field: &FieldValue,
    text: &str,
    record: &Record,
    found: &RecordValue,
) -> (Vec<String>, bool) {
    let stated = |word: &str| found.fields.iter().any(|field| &*field.key.text == word);
    let begins = |way: &String| stated(way.split(':').next().unwrap_or(""));
    let key = &*field.key.text;
    let mut all = match is_medium(field) {
        true => media(record).map(|field| format!("{}: {text}", field.word)).take(1).collect(),
        false => {
            let mut all = further_in(record, key, text);
            for key in elsewhere::fields(key) {
                all.extend(beside_or_further_in(record, key, text, &stated));
            }
            all
        }
    };
    all.truncate(MOST);
    if all.is_empty()
        && let Some(said) = measured(field)
    {
        let free = record.fields.iter().filter(|field| !stated(field.word));
        all.extend(free.filter_map(|field| {
            let wanted = dimension(field)?;
            match (said == wanted, said, wanted) {
                (true, ..) => Some(format!("{}: {text}", field.word)),
                (_, Dimension::POWER, Dimension::INTENSITY) => {
                    Some(format!("{}: {}", field.word, of_a_point(text)))
                }
                _ => None,
            }
        }));
        all.truncate(MOST);
    }
    let stated = all.iter().any(begins);
    (all, stated)
}

/// What may be written of a field called `key`, if the record has one that is free or one further in.
fn beside_or_further_in(
    record: &Record,
    key: &str,
    text: &str,
    stated: &impl Fn(&str) -> bool,
) -> Vec<String> {
    match record.fields.iter().any(|field| field.word == key) {
        true if stated(key) => Vec::new(),
        true => vec![format!("{key}: {text}")],
        false => further_in(record, key, text),
    }
}

/// Whether a field's value is a medium of the shelf.
fn is_medium(field: &FieldValue) -> bool {
    let Thunk::Lazy(expr, _) = &field.value else { return false };
    matches!(&expr.kind, ExprKind::Name(path) if shelves::is_matter(path))
}

/// The fields of a record that take a medium.
fn media(record: &Record) -> impl Iterator<Item = &Field> {
    record.fields.iter().filter(|field| {
        let known = |v: &Variants| v.all.iter().any(|record| record.word == MEASURED.medium);
        variants(&field.ty).is_some_and(known)
    })
}

/// The dimension of a field's value, if it is a number with a unit as it stands.
fn measured(field: &FieldValue) -> Option<Dimension> {
    let Thunk::Lazy(expr, _) = &field.value else { return None };
    match &expr.kind {
        ExprKind::Number { unit: Some((unit, exponent)), .. } => {
            Some(unit.dimension.power(*exponent)).filter(|found| *found != Dimension::NONE)
        }
        _ => None,
    }
}

/// What a field measures.
fn dimension(field: &Field) -> Option<Dimension> {
    match &field.ty {
        Type::Number(dimension) => Some(*dimension),
        Type::Spectrum(of) | Type::Textured { of, .. } => Some(of.dimension()),
        _ => None,
    }
}

/// What of some variants a value makes, as their first field and with no other one: `homogeneous
/// { ior: 1.5 }` of `1.5`.
pub fn made_of(variants: &Variants, value: &Value, text: &str) -> Vec<String> {
    let makes = |variant: &&Record| {
        let [first, rest @ ..] = variant.fields else { return false };
        takes(first, value) && rest.iter().all(|field| field.default.is_some() || field.optional)
    };
    let made = |variant: &Record| {
        let first = variant.fields.first().map_or("", |field| field.word);
        format!("{} {{ {first}: {text} }}", variant.word)
    };
    variants.all.iter().filter(makes).map(made).collect()
}

/// Whether a value may well stand in a field: an index below 1 or a reflectance above are legal,
/// but not what a number alone means.
fn takes(field: &Field, value: &Value) -> bool {
    let spectral = match field.ty {
        Type::Index => None,
        Type::Spectrum(of) | Type::Textured { of, .. } => Some(of),
        _ => return false,
    };
    match (&value.kind, spectral) {
        (ValueKind::Number { value, dimension: Dimension::NONE, .. }, None) => *value >= 1.0,
        (ValueKind::Index { .. }, None) => true,
        (ValueKind::Spectrum(_, dimension), None) => *dimension == Dimension::NONE,
        (ValueKind::Number { value, dimension, .. }, Some(of)) => {
            *dimension == of.dimension() && (of != Spectral::Reflectance || *value <= 1.0)
        }
        (ValueKind::Colour(_, dimension) | ValueKind::Spectrum(_, dimension), Some(of)) => {
            *dimension == of.dimension()
        }
        _ => false,
    }
}
