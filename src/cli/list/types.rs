//! Types, ranges and defaults of fields in words.

use super::{FIELD_MARGIN, block, flow, strong};
use crate::diag::print::Look;
use crate::diag::words::grouped;
use crate::lang::with_article;
use crate::math::units::Dimension;
use crate::scene::schema::{Bound, Field, Range, Type};

/// A field: its word, what may stand there, and what it means.
pub fn field(field: &Field, width: usize, look: Look) -> String {
    let mut parts = vec![form(field.ty)];
    parts.extend(range(field));
    parts.push(match field.default {
        Some(default) => format!("default {}", tidy(default)),
        None => without_default(field).to_string(),
    });
    let margin = " ".repeat(FIELD_MARGIN + width + 2);
    let mut text = block(&parts.join("; "), &margin, look);
    let word = format!("    {}  ", strong(field.word, width + FIELD_MARGIN - 4, look));
    text.replace_range(..margin.len(), &word);
    text + &block(&flow(field.doc), &margin, look)
}

/// What becomes of a field without a default that is not given.
pub fn without_default(field: &Field) -> &'static str {
    if field.optional { "may be left out" } else { "must be given" }
}

/// What may stand in a place, in words.
pub fn form(ty: Type) -> String {
    let unit = |dimension: Dimension| match dimension.unit() {
        unit if unit.is_empty() => String::new(),
        unit => format!(" in {unit}"),
    };
    match ty {
        Type::Number(Dimension::NONE) => "number".to_string(),
        Type::Number(dimension) => bare(dimension),
        Type::Count => "whole number".to_string(),
        Type::Switch => "on or off".to_string(),
        Type::Text => "text in quotes".to_string(),
        Type::File => "name of a file, in quotes".to_string(),
        Type::Point => "point (x, y, z)".to_string(),
        Type::Direction => "direction: (x, y, z), or x, -x, y, -y, z, -z".to_string(),
        Type::Size => "pair of whole numbers (columns, rows)".to_string(),
        Type::Step => "scale(…), rotate(…) or move(…)".to_string(),
        Type::Spectrum(spectral) => {
            let unit = unit(spectral.dimension());
            format!("{}: number, colour or spectrum{unit}", spectral.word())
        }
        Type::Textured { of, .. } => {
            format!("{}, or the name of a texture, or a texture itself", form(Type::Spectrum(of)))
        }
        Type::Pair => "pair of numbers (u, v), or one for both".to_string(),
        Type::Index => "index of refraction: number, colour, spectrum or complex".to_string(),
        Type::Words(words) => {
            let all: Vec<_> = words.all.iter().map(|(word, _)| *word).collect();
            format!("one of {}", all.join(", "))
        }
        Type::CountOr(words) => {
            let all: Vec<_> = words.all.iter().map(|(word, _)| *word).collect();
            format!("whole number, or {}", all.join(", "))
        }
        Type::Paths(None) => "path expression in quotes".to_string(),
        Type::Paths(Some(words)) => {
            let all: Vec<_> = words.all.iter().map(|(word, _)| *word).collect();
            format!("path expression in quotes, or {}", all.join(", "))
        }
        Type::OneOf(variants) => {
            let all: Vec<_> = variants.all.iter().map(|variant| variant.word).collect();
            format!("{}: one of {}", variants.name, all.join(", "))
        }
        Type::Record(_) => "fields in braces".to_string(),
        Type::List(inner) => format!("list [ … ] of {}", form(*inner)),
        Type::Map(inner) => format!("record {{ NAME: …, … }}, each {}", form(*inner)),
        Type::Reference { kind, target: None } => format!("the name of {}", with_article(kind)),
        Type::Reference { kind, .. } => {
            format!("the name of {0}, or {0} itself", with_article(kind))
        }
    }
}

/// What a dimension is called, without its article.
pub fn bare(dimension: Dimension) -> String {
    let name = dimension.name();
    name.trim_start_matches("an ").trim_start_matches("a ").to_string()
}

/// The bounds of a field, if it has any.
pub fn range(field: &Field) -> Option<String> {
    let number = |x: f64| match field.ty {
        Type::Number(_) if x == 0.0 => "0".to_string(),
        Type::Number(Dimension::ANGLE) => format!("{} deg", rounded(x.to_degrees())),
        Type::Number(Dimension::TIME) => format!("{} h", rounded(x / 3600.0)),
        _ if x.fract() == 0.0 && (1e4..1e15).contains(&x) => grouped(x as u64),
        _ => x.to_string(),
    };
    let Range { low, high, .. } = match field.ty {
        Type::Spectrum(of) | Type::Textured { of, .. } if field.range == Range::ANY => of.range(),
        _ => field.range,
    };
    if let (Bound::Inclusive(low), Bound::Inclusive(high)) = (low, high) {
        return Some(format!("from {} to {}", number(low), number(high)));
    }
    let low = match low {
        Bound::None => None,
        Bound::Inclusive(x) => Some(format!("{} or more", number(x))),
        Bound::Exclusive(x) => Some(format!("above {}", number(x))),
    };
    let high = match high {
        Bound::None => None,
        Bound::Inclusive(x) => Some(format!("{} or less", number(x))),
        Bound::Exclusive(x) => Some(format!("below {}", number(x))),
    };
    let parts: Vec<_> = low.into_iter().chain(high).collect();
    (!parts.is_empty()).then(|| parts.join(", "))
}

/// Without the digits that a change of unit makes.
fn rounded(x: f64) -> String {
    let x: f64 = format!("{x:.12e}").parse().unwrap_or(x);
    if x.abs() < 1e-4 { format!("{x:e}") } else { x.to_string() }
}

/// A default as a person would write it: no empty braces after a word, no more than six digits.
pub fn tidy(default: &str) -> String {
    let word = match default.strip_suffix(" {}") {
        Some(word) if !word.is_empty() => word,
        _ => default,
    };
    let rounded = word.split(' ').map(|part| match part.parse::<f64>() {
        Ok(x) if part.len() > 8 => {
            let whole = x.abs().log10().floor().max(-1.0) as i32 + 1;
            format!("{x:.*}", (6 - whole).max(0) as usize)
        }
        _ => part.to_string(),
    });
    rounded.collect::<Vec<_>>().join(" ")
}
