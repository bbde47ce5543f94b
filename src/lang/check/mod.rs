//! Values land on types: the one place where words, records and quantities get their meaning.

mod choices;
mod meant;
mod paths;
mod quantities;
mod spectral;
mod textured;

use crate::diag::words::listed;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use super::ast::Word;
use super::errors::{name as names, quantities as measures, syntax, types};
use super::eval::Evaluator;
use super::value::{FieldValue, RecordValue, Value, ValueKind};
use super::{defaults, limits};
use crate::diag::{FileId, Span};
use crate::scene::schema::{self, Checked, Range, Type, Variants};
use crate::scene::{At, FileName, elsewhere, examples};
pub use quantities::{coordinates, direction, in_range, number, number_within, point};
use quantities::{count, pair};
pub use spectral::complex;

/// The declarations of a render before they are checked: kind and name → value.
pub type Declared = BTreeMap<(&'static str, Arc<str>), (Word, Value)>;

/// Declarations that a render takes away, by kind and name: where.
pub type Removed = BTreeMap<(&'static str, Arc<str>), Span>;

/// A declaration that was checked.
pub type Item = (&'static str, At<String>, At<Checked>);

/// Checks the values of one render.
pub struct Checker<'a> {
    ev: &'a Evaluator<'a>,
    declared: &'a Declared,
    /// What the render takes away.
    pub removed: Option<&'a Removed>,
    /// Values that stood where a name was expected, as declarations of their own.
    hoisted: RefCell<Vec<Item>>,
    /// Files whose unknown names are not missed: they are there for others to complete.
    pub lenient_beyond: Option<FileId>,
    /// Declarations that are being looked into.
    open: RefCell<Vec<(&'static str, Arc<str>)>>,
    depth: Cell<usize>,
    /// What fields are when they are left out, by where the schema describes them.
    usual: RefCell<HashMap<*const schema::Field, Option<At<Checked>>>>,
}

impl<'a> Checker<'a> {
    /// A checker for a render with these declarations.
    pub fn new(ev: &'a Evaluator<'a>, declared: &'a Declared) -> Self {
        Self {
            ev,
            declared,
            removed: None,
            hoisted: RefCell::default(),
            lenient_beyond: None,
            open: RefCell::default(),
            depth: Cell::new(0),
            usual: RefCell::default(),
        }
    }

    /// The declarations made of inline values.
    pub fn into_hoisted(self) -> Vec<Item> {
        self.hoisted.into_inner()
    }

    /// Checks a declaration as a whole.
    pub fn declaration(&self, kind: &schema::Kind, name: &Word, value: &Value) -> Option<Checked> {
        let place = match kind.named {
            true => format!("{} {}", kind.word, name.text),
            false => kind.word.to_string(),
        };
        self.open.borrow_mut().push((kind.word, name.text.clone()));
        let checked = self.check(value, &kind.ty, &Range::ANY, &place);
        self.open.borrow_mut().pop();
        checked
    }

    /// Checks a value against a type; None if something was told. `place`: the path to it.
    pub fn check(&self, value: &Value, ty: &Type, range: &Range, place: &str) -> Option<Checked> {
        if value.is_broken() || !self.ev.spend(value.span) {
            return None;
        }
        self.depth.set(self.depth.get() + 1);
        let checked = if self.depth.get() > limits::DEPTH {
            self.ev.reports.tell(types::too_deep(value.span));
            None
        } else {
            self.landed(value, ty, range, place)
        };
        self.depth.set(self.depth.get() - 1);
        checked
    }

    fn landed(&self, value: &Value, ty: &Type, range: &Range, place: &str) -> Option<Checked> {
        let ev = self.ev;
        let what = format!("`{place}`");
        let span = value.span;
        let mismatch = |expected: &str| {
            ev.reports.tell(types::mismatch(&what, expected, &value.described(), span));
        };
        match ty {
            Type::Number(dimension) => {
                number_within(ev, value, *dimension, range, &what).map(Checked::Number)
            }
            Type::Count => count(ev, value, range, &what).map(Checked::Count),
            Type::Switch => match &value.kind {
                ValueKind::Word(word) if &*word.text == "on" => Some(Checked::Switch(true)),
                ValueKind::Word(word) if &*word.text == "off" => Some(Checked::Switch(false)),
                _ => {
                    mismatch("`on` or `off`");
                    None
                }
            },
            Type::Text => match &value.kind {
                ValueKind::Text { text, .. } => Some(Checked::Text(text.to_string())),
                _ => {
                    mismatch("a text in quotes");
                    None
                }
            },
            Type::File => match &value.kind {
                ValueKind::Text { text, file } if !text.is_empty() => {
                    let path = ev.folder(*file).join(&**text);
                    Some(Checked::File(FileName { text: text.to_string(), path }))
                }
                ValueKind::Text { .. } => {
                    ev.reports.tell(types::mismatch(
                        &what,
                        "the name of a file",
                        "an empty text",
                        span,
                    ));
                    None
                }
                _ => {
                    mismatch("the name of a file in quotes");
                    None
                }
            },
            Type::Point => Some(Checked::Vector(point(ev, value, &what)?)),
            Type::Direction => Some(Checked::Vector(direction(ev, value, &what)?)),
            Type::Size => match &value.kind {
                ValueKind::Vector { components, .. } if components.len() == 2 => {
                    let mut size = [0; 2];
                    for (slot, component) in size.iter_mut().zip(components.iter()) {
                        *slot = count(ev, component, range, &what)?;
                    }
                    Some(Checked::Size(size))
                }
                _ => {
                    mismatch("a pair such as `(512, 512)`");
                    None
                }
            },
            Type::Step => match &value.kind {
                ValueKind::Step(step) => Some(Checked::Step(*step)),
                _ => {
                    mismatch("`scale(…)`, `rotate(…)` or `move(…)`");
                    None
                }
            },
            Type::Pair => Some(Checked::Pair(pair(ev, value, range, &what)?)),
            Type::Spectrum(spectral) => match self.named_elsewhere(value) {
                Some(found) => {
                    let expected = spectral::expected(*spectral);
                    ev.reports.tell(types::mismatch(&what, &expected, &found, span));
                    None
                }
                None => spectral::spectrum(ev, value, *spectral, range, &what),
            },
            Type::Textured { of, kind, target } => {
                self.textured(value, (*of, range), kind, target(), place)
            }
            Type::Index => spectral::index(ev, value, range, &what),
            Type::Words(words) => match &value.kind {
                ValueKind::Word(word) => {
                    let found = words.all.iter().position(|(known, _)| *known == &*word.text);
                    if found.is_none() {
                        let all: Vec<_> = words.all.iter().map(|(word, _)| *word).collect();
                        ev.reports.tell(names::unknown_word(&what, &word.text, &all, span));
                    }
                    found.map(Checked::Word)
                }
                _ => {
                    let all = words.all.iter().map(|(word, _)| *word);
                    mismatch(&listed(all, "or"));
                    None
                }
            },
            Type::CountOr(words) => {
                let all = words.all.iter().map(|(word, _)| *word);
                let expected = format!("{} or {}", types::count_within(range), listed(all, "or"));
                let told = || quantities::is_switch(ev, value, &what, || expected.clone());
                let known = |word: &Word| words.all.iter().any(|(known, _)| *known == &*word.text);
                match &value.kind {
                    ValueKind::Word(word) if !known(word) && told() => None,
                    ValueKind::Word(_) => self.landed(value, &Type::Words(words), range, place),
                    ValueKind::Number { .. } => self.landed(value, &Type::Count, range, place),
                    _ => {
                        mismatch(&expected);
                        None
                    }
                }
            }
            Type::Paths(words) => paths::paths(ev, value, *words, &what),
            Type::OneOf(variants) => self.one_of(value, variants, place),
            Type::Record(record) => match &value.kind {
                ValueKind::Record(found) if found.word.is_none() && found.base.is_none() => {
                    Some(Checked::Record(self.fields(found, record, span, place)?))
                }
                _ => {
                    mismatch("fields in braces");
                    None
                }
            },
            Type::List(element) => match &value.kind {
                ValueKind::List(all) => {
                    let mut checked = Vec::with_capacity(all.len());
                    let mut whole = true;
                    for (i, value) in all.iter().enumerate() {
                        let place = format!("{place}[{}]", i + 1);
                        match self.check(value, element, range, &place) {
                            Some(found) => checked.push(At::new(found, value.span)),
                            None => whole = false,
                        }
                    }
                    whole.then_some(Checked::List(checked))
                }
                _ => {
                    ev.reports.tell(types::list(&what, &value.described(), span));
                    None
                }
            },
            Type::Map(element) => match &value.kind {
                ValueKind::Record(found) if found.word.is_none() && found.base.is_none() => {
                    self.map(found, element, place)
                }
                _ => {
                    mismatch("names with values in braces");
                    None
                }
            },
            Type::Reference { kind, target } => {
                self.reference(value, kind, target.map(|target| target()), place)
            }
        }
    }

    fn lenient(&self, span: Span) -> bool {
        self.lenient_beyond.is_some_and(|main| span.file != main)
    }

    fn names_of(&self, kind: &'static str) -> Vec<&str> {
        self.declared.keys().filter(|(k, _)| *k == kind).map(|(_, name)| &**name).collect()
    }

    /// The same without those that are being looked into: nothing is made of itself.
    fn others(&self, kind: &'static str) -> Vec<&str> {
        let open = self.open.borrow();
        let is_open = |name: &str| open.iter().any(|(k, n)| *k == kind && &**n == name);
        self.names_of(kind).into_iter().filter(|name| !is_open(name)).collect()
    }

    fn map(&self, found: &RecordValue, element: &'static Type, place: &str) -> Option<Checked> {
        let mut all = BTreeMap::new();
        let mut whole = !found.partial;
        for field in &found.fields {
            if field.quantity.is_some() {
                self.ev.reports.tell(syntax::number_key(&field.key.text, field.key.span));
                whole = false;
                continue;
            }
            let place = format!("{place}.{}", field.key.text);
            let value = self.field_value(field, element, &Range::ANY, &place);
            let key = At::new(field.key.text.to_string(), field.key.span);
            match value {
                Some(value) => {
                    let entry = (key, At::new(value, field.value.span()));
                    if let Some((first, _)) = all.insert(field.key.text.clone(), entry) {
                        self.ev.reports.tell(names::field_twice(
                            &field.key,
                            first.span,
                            place.as_str(),
                        ));
                        whole = false;
                    }
                }
                None => whole = false,
            }
        }
        whole.then(|| Checked::Map(all.into_values().collect()))
    }

    /// The fields of a record in the order of the schema.
    pub fn fields(
        &self,
        found: &RecordValue,
        schema: &'static schema::Record,
        span: Span,
        place: &str,
    ) -> Option<Vec<At<Checked>>> {
        let ev = self.ev;
        let mut whole = !found.partial;
        let owner = match schema.word {
            "" => place.to_string(),
            word => word.to_string(),
        };
        for (i, field) in found.fields.iter().enumerate() {
            let earlier = found.fields[..i].iter().find(|e| e.key.text == field.key.text);
            if field.quantity.is_some() {
                ev.reports.tell(syntax::number_key(&field.key.text, field.key.span));
                whole = false;
            } else if let Some(earlier) = earlier {
                ev.reports.tell(names::field_twice(&field.key, earlier.key.span, &owner));
                whole = false;
            } else if !schema.fields.iter().any(|known| known.word == &*field.key.text) {
                self.unknown_field(&owner, field, found, schema);
                whole = false;
            }
        }
        let mut checked = Vec::with_capacity(schema.fields.len());
        let mut missing = Vec::new();
        for field in schema.fields {
            let place = format!("{place}.{}", field.word);
            let said = found.fields.iter().find(|said| &*said.key.text == field.word);
            match (said, field.default) {
                (Some(said), _) => match self.field_value(said, &field.ty, &field.range, &place) {
                    Some(value) => {
                        let default = self.default(field, &place);
                        let usual = default.is_some_and(|default| default.value == value);
                        checked.push(At { usual, ..At::new(value, said.value.span()) });
                    }
                    None => whole = false,
                },
                (None, Some(_)) => {
                    let default = defaults::placed(self.default(field, &place)?.value, span);
                    checked.push(At { usual: true, ..default });
                }
                (None, None) if field.optional => {
                    checked.push(At { usual: true, ..At::new(Checked::Absent, span) })
                }
                (None, None) => missing.push(field),
            }
        }
        if !missing.is_empty() {
            // A misspelt field is not missing as well, nor is one that an unknown word may mean.
            let unknown = |key: &str| !schema.fields.iter().any(|known| known.word == key);
            let keys = found.fields.iter().map(|said| &*said.key.text);
            let mut strangers: Vec<&str> = keys.filter(|key| unknown(key)).collect();
            let misspelt = |field: &schema::Field, strangers: &mut Vec<&str>| {
                let near = |key: &&str| crate::diag::near(key, [field.word]).len() == 1;
                let at = strangers.iter().position(near);
                at.map(|at| strangers.remove(at)).is_some()
            };
            let missed: Vec<&schema::Field> =
                missing.into_iter().filter(|field| !misspelt(field, &mut strangers)).collect();
            if missed.len() > strangers.len() && !found.partial {
                let at = found.word.as_ref().map_or(found.braces, |word| word.span);
                let wanted: Vec<_> =
                    missed.iter().map(|field| (field.word, self.example(schema, field))).collect();
                ev.reports.tell(types::missing_fields(&owner, place, &wanted, at, found.braces));
            }
            whole = false;
        }
        whole.then_some(checked)
    }

    fn unknown_field(
        &self,
        owner: &str,
        field: &FieldValue,
        found: &RecordValue,
        schema: &'static schema::Record,
    ) {
        let known: Vec<_> = schema.fields.iter().map(|field| field.word).collect();
        let key = &field.key;
        if let Some(pair) = meant::complex_index(self.ev, field, found, schema) {
            if pair.tell {
                let meant = (&[pair.right][..], pair.place);
                let told = names::unknown_field(owner, key, &known, meant, true);
                self.ev.reports.tell(told);
            }
            return;
        }
        if let Some((right, unlike)) = elsewhere::unlike(&key.text)
            && known.contains(&right)
        {
            self.ev.reports.tell(names::unlike_field(owner, key, right, unlike));
            return;
        }
        let said = meant::said(self.ev, field.value.span());
        let (meant, stated) = meant::instead_of(field, said.unwrap_or("…"), schema, found);
        // What a word stands for elsewhere is surer than what it looks like.
        let sure = elsewhere::is_known(schema.word, &key.text);
        let place = Span { end: field.value.span().end, ..key.span };
        let place = Some(place).filter(|_| said.is_some() && !stated);
        self.ev.reports.tell(names::unknown_field(owner, key, &known, (&meant, place), sure));
    }

    fn field_value(
        &self,
        field: &FieldValue,
        ty: &Type,
        range: &Range,
        place: &str,
    ) -> Option<Checked> {
        let said = field.value.span();
        let value = self.ev.force(&field.value);
        let outer = self.ev.reports.used_at(Some(said));
        let checked = self.check(&value, ty, range, place);
        self.ev.reports.used_at(outer);
        checked
    }

    /// What a field is when it is left out; its place is nowhere.
    fn default(&self, field: &'static schema::Field, place: &str) -> Option<At<Checked>> {
        let text = field.default?;
        let key: *const schema::Field = field;
        if let Some(known) = self.usual.borrow().get(&key) {
            return known.clone();
        }
        let value = default_value(self.ev, text);
        let checked = self.check(&value, &field.ty, &field.range, place);
        let checked = checked.map(|checked| At::new(checked, value.span));
        self.usual.borrow_mut().insert(key, checked.clone());
        checked
    }

    /// How a value of a field may look.
    fn example(&self, record: &schema::Record, field: &schema::Field) -> String {
        if let Some(example) = examples::of_field(record, field) {
            return example.into();
        }
        let range = &field.range;
        match &field.ty {
            Type::Number(dimension) => measures::example(*dimension, range),
            Type::Spectrum(of) | Type::Textured { of, .. } => {
                measures::example(of.dimension(), range)
            }
            Type::Pair => "(1, 1)".into(),
            Type::Index => "1.5".into(),
            Type::Count | Type::CountOr(_) => "1".into(),
            Type::Switch => "on".into(),
            Type::Text => "\"…\"".into(),
            Type::Paths(_) => "\"L .* E\"".into(),
            Type::File => "\"…\"".into(),
            Type::Point => "(0, 0, 0)".into(),
            Type::Direction => "y".into(),
            Type::Size => "(512, 512)".into(),
            Type::Step => "scale(1)".into(),
            Type::Words(words) => words.all.first().map_or("", |(word, _)| word).into(),
            Type::OneOf(variants) => variants.all.first().map_or("", |record| record.word).into(),
            Type::Record(_) | Type::Map(_) => "{ … }".into(),
            Type::List(_) => "[ … ]".into(),
            Type::Reference { kind, target } => match (self.others(kind).first(), target) {
                (Some(name), _) => (*name).into(),
                (None, Some(target)) if let Type::OneOf(variants) = target() => {
                    self.shape(variants, None)
                }
                _ => (*kind).into(),
            },
        }
    }

    /// How one of some variants may look, the one of this word or else the simplest: with the
    /// fields it must have, or with its first one.
    fn shape(&self, variants: &Variants, word: Option<&str>) -> String {
        let chosen = match word {
            Some(word) => variants.all.iter().find(|record| record.word == word),
            None => examples::simplest(variants),
        };
        let Some(record) = chosen else { return String::new() };
        let field =
            |field: &&schema::Field| format!("{}: {}", field.word, self.example(record, field));
        let fields: Vec<_> = examples::shown(record).iter().map(field).collect();
        match fields.is_empty() {
            true => record.word.to_string(),
            false => format!("{} {{ {} }}", record.word, fields.join(", ")),
        }
    }
}

/// The value of a default.
pub fn default_value(ev: &Evaluator, text: &'static str) -> Value {
    ev.eval(&defaults::expr(text), &ev.frame(None))
}

/// Which variant a word is.
pub fn position(variants: &Variants, word: &str) -> Option<usize> {
    variants.all.iter().position(|record| record.word == word)
}
