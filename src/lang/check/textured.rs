//! Where a quantity or a texture may stand: a bare word is a texture first.

use super::{Checker, position, spectral};
use crate::lang::arithmetic;
use crate::lang::errors::name as names;
use crate::lang::value::{Value, ValueKind};
use crate::scene::schema::{Checked, Range, Type};
use crate::scene::spectral::Spectral;

impl Checker<'_> {
    /// A quantity, the name of a texture, or a texture.
    pub(super) fn textured(
        &self,
        value: &Value,
        (of, range): (Spectral, &Range),
        kind: &'static str,
        target: Type,
        place: &str,
    ) -> Option<Checked> {
        let declared = |name: &str| self.declared.contains_key(&(kind, name.into()));
        let is_texture = match &value.kind {
            ValueKind::Text { .. } => true,
            ValueKind::Word(word) if declared(&word.text) => true,
            ValueKind::Word(word) if arithmetic::known(&word.text, value.span).is_none() => {
                let all = self.names_of(kind);
                if !self.lenient(word.span) {
                    self.ev.reports.tell_unknown_with(&word.text, word.span, || {
                        names::no_value_nor(kind, &word.text, word.span, &all)
                    });
                }
                return None;
            }
            ValueKind::Record(record) => match (&record.base, &record.word, target) {
                (Some(_), ..) => true,
                (None, Some(word), Type::OneOf(all)) => position(all, &word.text).is_some(),
                _ => false,
            },
            _ => false,
        };
        match is_texture {
            true => self.reference(value, kind, Some(target), place),
            false => spectral::spectrum(self.ev, value, of, range, &format!("`{place}`")),
        }
    }

    /// What a word is the name of, if it is none of a quantity's: "the texture `planks`".
    pub(super) fn named_elsewhere(&self, value: &Value) -> Option<String> {
        let ValueKind::Word(word) = &value.kind else { return None };
        if arithmetic::known(&word.text, value.span).is_some() {
            return None;
        }
        let (kind, _) = self.declared.keys().find(|(_, name)| *name == word.text)?;
        Some(format!("the {kind} `{}`", word.text))
    }
}
