//! Defaults of the schema: written there in the scene language, parsed once a run of the program.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::ast::Expr;
use super::parse;
use crate::diag::{FileId, Span};
use crate::scene::At;
use crate::scene::schema::Checked;

/// The file number of defaults: no text has it. Its places are replaced before anyone sees them.
const NOWHERE: FileId = FileId(u32::MAX);

/// The tree of a default.
pub fn expr(text: &'static str) -> Arc<Expr> {
    static KNOWN: OnceLock<Mutex<HashMap<&'static str, Arc<Expr>>>> = OnceLock::new();
    let known = KNOWN.get_or_init(Mutex::default);
    let mut known = known.lock().unwrap_or_else(PoisonError::into_inner);
    known.entry(text).or_insert_with(|| parse::value(text, NOWHERE).tree).clone()
}

/// Whether a place is in the text of a default.
pub fn is_nowhere(span: Span) -> bool {
    span.file == NOWHERE
}

/// A value in which what a default says is said at `span`.
pub fn settled(checked: At<Checked>, span: Span) -> At<Checked> {
    if is_nowhere(checked.span) {
        return At { usual: checked.usual, ..placed(checked.value, span) };
    }
    let inside = checked.span;
    let all = |fields: Vec<At<Checked>>| -> Vec<_> {
        fields.into_iter().map(|field| settled(field, inside)).collect()
    };
    checked.map(|value| match value {
        Checked::Variant(which, fields) => Checked::Variant(which, all(fields)),
        Checked::Record(fields) => Checked::Record(all(fields)),
        Checked::List(elements) => Checked::List(all(elements)),
        Checked::Map(entries) => Checked::Map(
            entries.into_iter().map(|(name, value)| (name, settled(value, inside))).collect(),
        ),
        other => other,
    })
}

/// A default's value said at `span`, with everything in it.
pub fn placed(checked: Checked, span: Span) -> At<Checked> {
    let all = |fields: Vec<At<Checked>>| -> Vec<_> {
        let placed = |field: At<Checked>| At { usual: field.usual, ..placed(field.value, span) };
        fields.into_iter().map(placed).collect()
    };
    let value = match checked {
        Checked::Variant(which, fields) => Checked::Variant(which, all(fields)),
        Checked::Record(fields) => Checked::Record(all(fields)),
        Checked::List(elements) => Checked::List(all(elements)),
        Checked::Map(entries) => Checked::Map(
            entries
                .into_iter()
                .map(|(name, value)| (At::new(name.value, span), placed(value.value, span)))
                .collect(),
        ),
        other => other,
    };
    At::new(value, span)
}

#[cfg(test)]
mod tests {
    use super::super::check::{Checker, Declared, default_value};
    use super::super::eval::Evaluator;
    use crate::scene::KINDS;
    use crate::scene::schema::{Field, Range, Type};

    fn fields(ty: &Type, found: &mut Vec<Field>) {
        let records = match ty {
            Type::OneOf(variants) => variants.all,
            Type::Record(record) => std::slice::from_ref(*record),
            Type::List(inner) | Type::Map(inner) => return fields(inner, found),
            _ => return,
        };
        for field in records.iter().flat_map(|record| record.fields) {
            found.push(*field);
            fields(&field.ty, found);
        }
    }

    #[test]
    fn every_default_of_the_schema_is_of_its_type_and_within_its_range() {
        let ev = Evaluator::default();
        let declared = Declared::new();
        let checker = Checker::new(&ev, &declared);
        let mut all = Vec::new();
        for kind in KINDS {
            fields(&kind.ty, &mut all);
            if let Some(default) = kind.default {
                let value = default_value(&ev, default);
                let checked = checker.check(&value, &kind.ty, &Range::ANY, kind.word);
                assert!(checked.is_some(), "{}", kind.word);
            }
        }
        let mut defaults = 0;
        for field in all {
            let Some(default) = field.default else { continue };
            let value = default_value(&ev, default);
            let checked = checker.check(&value, &field.ty, &field.range, field.word);
            assert!(checked.is_some(), "{}: {default}", field.word);
            defaults += 1;
        }
        assert!(defaults > 20);
        assert_eq!(ev.reports.errors(), 0);
    }
}
