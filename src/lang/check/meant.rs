//! What may have been meant by a field or a value that does not fit, as far as the vocabulary
//! tells: the field stands further in, or the value belongs into a field of what is expected.

use crate::diag::Span;
use crate::lang::ast::ExprKind;
use crate::lang::errors::quantities::of_a_point;
use crate::lang::eval::Evaluator;
use crate::lang::shelves;
use crate::lang::value::{FieldValue, RecordValue, Thunk, Value, ValueKind, digits as shown};
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
    if let Some(right) = elsewhere::half(key)
        && record.fields.iter().any(|field| field.word == right)
    {
        return (vec![format!("{right}: {}", half(text))], stated(right));
    }
    if let Some(right) = elsewhere::field_of(record.word, key) {
        return (vec![format!("{right}: {text}")], stated(right));
    }
    let mut all = match is_medium(field) {
        true => media(record).map(|field| format!("{}: {text}", field.word)).take(1).collect(),
        false => {
            let mut all = further_in(record, key, text);
            for key in elsewhere::fields(key) {
                let text = with_unit(field, record, key).unwrap_or(text.to_string());
                all.extend(beside_or_further_in(record, key, &text, &stated));
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

/// The value of a field as an angle in degrees, if it is a plain number and belongs into the field
/// `key`, which is an angle: too many for radians.
fn with_unit(field: &FieldValue, record: &Record, key: &str) -> Option<String> {
    let Thunk::Lazy(expr, _) = &field.value else { return None };
    let ExprKind::Number { value, unit: None } = expr.kind else { return None };
    let meant = record.fields.iter().find(|field| field.word == key)?;
    let angle = matches!(meant.ty, Type::Number(Dimension::ANGLE));
    let degrees = value > std::f64::consts::TAU && meant.range.holds(value.to_radians());
    (angle && degrees).then(|| format!("{} deg", shown(value)))
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

/// An index that is said by its two parts, each in a field of its own.
pub struct Parts {
    /// The field as it may be written: `ior: complex(0.2, 3.9)`.
    pub right: String,
    /// Where both stand, if nothing else stands between them.
    pub place: Option<Span>,
    /// Whether this field is the one that tells it.
    pub tell: bool,
}

/// The index that a field which a record does not have says together with another one.
pub fn complex_index(
    ev: &Evaluator,
    field: &FieldValue,
    found: &RecordValue,
    schema: &Record,
) -> Option<Parts> {
    let index = schema.fields.iter().find(|field| matches!(field.ty, Type::Index))?.word;
    let is_n = |key: &str| key == index || elsewhere::fields(key).any(|meant| meant == index);
    let is_k = |key: &str| matches!(key, "k" | "kappa");
    let n = found.fields.iter().find(|field| is_n(&field.key.text))?;
    let k = found.fields.iter().find(|field| is_k(&field.key.text))?;
    let here = field.key.span;
    if here != n.key.span && here != k.key.span {
        return None;
    }
    let [n_text, k_text] = [said(ev, n.value.span())?, said(ev, k.value.span())?];
    let (first, second) = if n.key.span.start < k.key.span.start { (n, k) } else { (k, n) };
    let between =
        Span { start: first.value.span().end, end: second.key.span.start, ..first.key.span };
    let place = Span { end: second.value.span().end, ..first.key.span };
    let alone =
        ev.written(between).is_some_and(|text| text.trim_matches([' ', ',', '\n']).is_empty());
    Some(Parts {
        right: format!("{index}: complex({n_text}, {k_text})"),
        place: Some(place).filter(|_| alone),
        tell: here == n.key.span || &*n.key.text == index,
    })
}

/// Half of a value, as it is written.
fn half(text: &str) -> String {
    let digits = |c: char| !c.is_ascii_digit() && c != '.';
    let (number, unit) = text.split_at(text.find(digits).unwrap_or(text.len()));
    let word = |c: char| c.is_ascii_alphabetic() || c == ' ';
    match number.parse::<f64>() {
        Ok(number) if unit.chars().all(word) => format!("{}{unit}", shown(0.5 * number)),
        _ => format!("0.5 * ({text})"),
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
