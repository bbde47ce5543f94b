//! Every word of the schema with the places it stands in.

use crate::scene::KINDS;
use crate::scene::schema::{Field, Kind, Record, Type, Variants};

/// What a word may be. A path says where it stands: `object mesh.unit`.
pub enum Entry {
    /// A kind of item.
    Kind(&'static Kind),
    /// A set of variants that is no kind: `filter`.
    Choice { variants: &'static Variants, path: String },
    /// A variant.
    Variant { record: &'static Record, path: String },
    /// A field.
    Field { field: &'static Field, path: String },
    /// A word that stands for itself.
    Word { word: &'static str, doc: &'static str, path: String },
}

impl Entry {
    pub fn word(&self) -> &'static str {
        match self {
            Self::Kind(kind) => kind.word,
            Self::Choice { variants, .. } => variants.name,
            Self::Variant { record, .. } => record.word,
            Self::Field { field, .. } => field.word,
            Self::Word { word, .. } => word,
        }
    }
}

impl Entry {
    /// Where it stands, itself last.
    pub fn path(&self) -> String {
        match self {
            Self::Kind(kind) => kind.word.to_string(),
            Self::Choice { path, .. }
            | Self::Variant { path, .. }
            | Self::Field { path, .. }
            | Self::Word { path, .. } => path.clone(),
        }
    }
}

/// All of them, in the order of the schema.
pub fn entries() -> Vec<Entry> {
    let mut found = Vec::new();
    for kind in KINDS {
        found.push(Entry::Kind(kind));
        inside(kind.ty, kind.word, true, &mut found);
    }
    found
}

fn inside(ty: Type, path: &str, of_kind: bool, found: &mut Vec<Entry>) {
    match ty {
        Type::OneOf(variants) => {
            if !of_kind {
                found.push(Entry::Choice { variants, path: path.to_string() });
            }
            for record in variants.all {
                let path = format!("{path} {}", record.word);
                found.push(Entry::Variant { record, path: path.clone() });
                record_fields(record, &path, found);
            }
        }
        Type::Record(record) => record_fields(record, path, found),
        Type::Words(words) | Type::CountOr(words) | Type::Paths(Some(words)) => {
            for (word, doc) in words.all {
                let path = format!("{path}: {word}");
                found.push(Entry::Word { word, doc, path });
            }
        }
        // What a reference names is a kind of its own.
        Type::List(inner) | Type::Map(inner) => inside(*inner, path, false, found),
        _ => {}
    }
}

fn record_fields(record: &'static Record, path: &str, found: &mut Vec<Entry>) {
    for field in record.fields {
        let path = format!("{path}.{}", field.word);
        found.push(Entry::Field { field, path: path.clone() });
        inside(field.ty, &path, false, found);
    }
}
