//! Where one of several may stand: variants, names of declarations, and values in their place.

use std::rc::Rc;

use super::{Checker, meant, position};
use crate::diag::Span;
use crate::lang::ast::Word;
use crate::lang::errors::{self, name as names, types};
use crate::lang::shelves;
use crate::lang::value::{RecordValue, Value, ValueKind};
use crate::scene::schema::{self, Checked, Range, Type, Variants};
use crate::scene::{At, KINDS, elsewhere};

impl Checker<'_> {
    pub(super) fn one_of(
        &self,
        value: &Value,
        variants: &'static Variants,
        place: &str,
    ) -> Option<Checked> {
        let ev = self.ev;
        let kind = KINDS.iter().find(|kind| kind.named && is_type(&kind.ty, variants));
        match &value.kind {
            ValueKind::Word(word) => {
                if let Some(found) = kind.and_then(|kind| self.alias(kind, word)) {
                    return found.and_then(|value| self.aliased(kind?, word, &value, place));
                }
                let Some(which) = position(variants, &word.text) else {
                    self.unknown_variant(word, variants, kind.map(|kind| kind.word), place);
                    return None;
                };
                let none = RecordValue {
                    word: Some(word.clone()),
                    base: None,
                    fields: Vec::new(),
                    braces: value.span,
                    partial: false,
                    shelved: None,
                };
                let fields = self.fields(&none, &variants.all[which], value.span, place)?;
                Some(Checked::Variant(which, fields))
            }
            ValueKind::Text { text, .. } if kind.is_some() => {
                let word = Word { text: (**text).into(), span: value.span };
                let Some(found) = kind.and_then(|kind| self.alias(kind, &word)) else {
                    self.unknown_variant(&word, variants, kind.map(|kind| kind.word), place);
                    return None;
                };
                found.and_then(|value| self.aliased(kind?, &word, &value, place))
            }
            ValueKind::Record(record) => {
                let record = match &record.base {
                    Some(base) => &*self.based(base, record, kind)?,
                    None => record,
                };
                let Some(word) = &record.word else {
                    let all: Vec<_> = variants.all.iter().map(|r| r.word).collect();
                    ev.reports.tell(names::which_variant(
                        place,
                        variants.name,
                        &all,
                        record.braces,
                    ));
                    return None;
                };
                let Some(which) = position(variants, &word.text) else {
                    self.unknown_variant(word, variants, None, place);
                    return None;
                };
                let fields = self.fields(record, &variants.all[which], value.span, place)?;
                Some(Checked::Variant(which, fields))
            }
            _ => {
                let expected = errors::with_article(variants.name);
                let found = value.described();
                ev.reports.tell(types::mismatch(
                    &format!("`{place}`"),
                    &expected,
                    &found,
                    value.span,
                ));
                None
            }
        }
    }

    /// The value of the declaration a word names, if it names one; Some(None): itself, told.
    fn alias(&self, kind: &schema::Kind, word: &Word) -> Option<Option<Value>> {
        let (_, value) = self.declared.get(&(kind.word, word.text.clone()))?;
        if self.open.borrow().iter().any(|(k, n)| *k == kind.word && *n == word.text) {
            self.ev.reports.tell(errors::circle::itself(
                kind.word,
                word,
                is_variant(&kind.ty, &word.text),
            ));
            return Some(None);
        }
        Some(Some(value.clone()))
    }

    fn aliased(
        &self,
        kind: &schema::Kind,
        word: &Word,
        value: &Value,
        place: &str,
    ) -> Option<Checked> {
        self.open.borrow_mut().push((kind.word, word.text.clone()));
        let checked = self.check(value, &kind.ty, &Range::ANY, place);
        self.open.borrow_mut().pop();
        checked
    }

    /// `word with { … }`: the fields of what the word names, changed.
    fn based(
        &self,
        base: &Word,
        record: &RecordValue,
        kind: Option<&schema::Kind>,
    ) -> Option<Rc<RecordValue>> {
        let mut merged = match kind.and_then(|kind| self.alias(kind, base)) {
            Some(found) => match found?.kind {
                ValueKind::Record(found) => (*found).clone(),
                ValueKind::Word(word) => plain(word, record.braces),
                _ => return None,
            },
            None => plain(base.clone(), record.braces),
        };
        for field in &record.fields {
            merged.fields.retain(|other| other.key.text != field.key.text);
            merged.fields.push(field.clone());
        }
        Some(Rc::new(merged))
    }

    fn unknown_variant(
        &self,
        word: &Word,
        variants: &Variants,
        kind: Option<&'static str>,
        place: &str,
    ) {
        if kind.is_some() && self.lenient(word.span) {
            return;
        }
        self.ev.reports.tell_unknown_with(&word.text, word.span, || {
            let all: Vec<_> = variants.all.iter().map(|record| record.word).collect();
            let declared = kind.map_or_else(Vec::new, |kind| self.names_of(kind));
            let meant = elsewhere::meant(variants.name, &word.text);
            let meant = meant.map(|word| (word, self.shape(variants, Some(word))));
            names::unknown_variant(place, variants.name, word, (&all, &declared), meant)
        });
    }

    pub(super) fn reference(
        &self,
        value: &Value,
        kind: &'static str,
        target: Option<Type>,
        place: &str,
    ) -> Option<Checked> {
        let ev = self.ev;
        let name = match &value.kind {
            ValueKind::Word(word) => Some(word.clone()),
            ValueKind::Text { text, .. } => Some(Word { text: (**text).into(), span: value.span }),
            _ => None,
        };
        let variants = match target {
            Some(Type::OneOf(variants)) => Some(variants),
            _ => None,
        };
        if let Some(word) = &name {
            if self.declared.contains_key(&(kind, word.text.clone())) {
                return Some(Checked::Reference(word.text.to_string()));
            }
            let is_text = matches!(value.kind, ValueKind::Text { .. });
            let variant = variants.and_then(|v| position(v, &word.text)).filter(|_| !is_text);
            if variant.is_none() {
                if !self.lenient(word.span) {
                    ev.reports.tell_unknown_with(&word.text, word.span, || {
                        let key = (kind, word.text.clone());
                        if let Some(at) = self.removed.and_then(|all| all.get(&key)) {
                            return names::taken_away(place, kind, word, *at);
                        }
                        let declared = self.names_of(kind);
                        let place = format!("`{place}`");
                        let named = variants.and_then(|v| elsewhere::meant(v.name, &word.text));
                        let shape = variants.map(|variants| self.shape(variants, named));
                        let mut made = made_of_data(variants, word);
                        made.extend(variants.filter(|_| is_text).and_then(|v| of_file(v, word)));
                        let instead = (shape.as_deref().unwrap_or("…"), made.as_slice());
                        names::unknown_declaration(&place, kind, word, &declared, instead)
                    });
                }
                return None;
            }
        } else if !matches!(value.kind, ValueKind::Record(_)) || target.is_none() {
            let said = meant::said(ev, value.span);
            let made = variants.zip(said).map(|(all, text)| meant::made_of(all, value, text));
            let (made, found) = (made.unwrap_or_default(), value.described());
            let place = format!("`{place}`");
            ev.reports.tell(names::no_declaration(
                &place,
                (kind, target.is_some()),
                &found,
                &made,
                value.span,
            ));
            return None;
        }
        // The same value once more: not one level further in.
        let checked = self.landed(value, &target?, &Range::ANY, place)?;
        let mut name = place.to_string();
        let taken = |name: &str| {
            let hoisted = self.hoisted.borrow();
            self.declared.contains_key(&(kind, name.into()))
                || hoisted.iter().any(|(k, n, _)| *k == kind && n.value == name)
        };
        while taken(&name) {
            name.push('\'');
        }
        let item = (kind, At::new(name.clone(), value.span), At::new(checked, value.span));
        self.hoisted.borrow_mut().push(item);
        Some(Checked::Reference(name))
    }
}

/// What of some variants may be made of the data that have a name: `conductor { ior: metal.gold }`
/// of `gold`.
fn made_of_data(variants: Option<&'static Variants>, word: &Word) -> Vec<String> {
    let data = shelves::called(&word.text, word.span);
    let made = |(text, kind): (String, ValueKind)| {
        let value = Value { kind, span: word.span };
        variants.map(|all| meant::made_of(all, &value, &text)).unwrap_or_default()
    };
    data.into_iter().flat_map(made).collect()
}

/// What of some variants a text that names a file makes: `image { file: "wood.png" }`.
fn of_file(variants: &Variants, word: &Word) -> Option<String> {
    let made = |record: &&schema::Record| {
        let [first, rest @ ..] = record.fields else { return false };
        matches!(first.ty, Type::File)
            && rest.iter().all(|field| field.default.is_some() || field.optional)
    };
    let record = variants.all.iter().find(made).filter(|_| word.text.contains('.'))?;
    let first = record.fields.first()?.word;
    (!word.text.contains(['"', '\\']))
        .then(|| format!("{} {{ {first}: \"{}\" }}", record.word, word.text))
}

fn plain(word: Word, braces: Span) -> RecordValue {
    RecordValue {
        word: Some(word),
        base: None,
        fields: Vec::new(),
        braces,
        partial: false,
        shelved: None,
    }
}

fn is_variant(ty: &Type, word: &str) -> bool {
    matches!(ty, Type::OneOf(variants) if position(variants, word).is_some())
}

fn is_type(ty: &Type, variants: &'static Variants) -> bool {
    matches!(ty, Type::OneOf(other) if other.name == variants.name)
}
