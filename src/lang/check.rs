//! Values land on types: the one place where words, records and quantities get their meaning.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::sync::Arc;

use glam::DVec3;

use super::ast::Word;
use super::errors::{name as names, types};
use super::eval::Evaluator;
use super::value::{FieldValue, RecordValue, Value, ValueKind, shown};
use super::{arithmetic, defaults, limits};
use crate::diag::{FileId, Span};
use crate::math::Spectrum;
use crate::math::units::Dimension;
use crate::scene::schema::{self, Checked, Range, Type, Variants};
use crate::scene::{At, FileName, KINDS};

/// Largest count that an f64 holds exactly.
const COUNT_MAX: f64 = 9_007_199_254_740_992.0;

/// The declarations of a render before they are checked: kind and name → value.
pub type Declared = BTreeMap<(&'static str, Arc<str>), (Word, Value)>;

/// A declaration that was checked.
pub type Item = (&'static str, At<String>, At<Checked>);

/// Checks the values of one render.
pub struct Checker<'a> {
    ev: &'a Evaluator,
    declared: &'a Declared,
    /// Values that stood where a name was expected, as declarations of their own.
    hoisted: RefCell<Vec<Item>>,
    /// Files whose unknown names are not missed: they are there for others to complete.
    pub lenient_beyond: Option<FileId>,
    /// Declarations that are being looked into.
    open: RefCell<Vec<(&'static str, Arc<str>)>>,
    depth: Cell<usize>,
}

impl<'a> Checker<'a> {
    /// A checker for a render with these declarations.
    pub fn new(ev: &'a Evaluator, declared: &'a Declared) -> Self {
        Self {
            ev,
            declared,
            hoisted: RefCell::default(),
            lenient_beyond: None,
            open: RefCell::default(),
            depth: Cell::new(0),
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
                let x = number(ev, value, *dimension, &what)?;
                in_range(ev, value, x, range, *dimension, &what)?;
                Some(Checked::Number(x))
            }
            Type::Count => {
                let n = count(ev, value, &what)?;
                in_range(ev, value, n, range, Dimension::NONE, &what)?;
                Some(Checked::Count(n as u64))
            }
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
                        let n = count(ev, component, &what)?;
                        in_range(ev, component, n, range, Dimension::NONE, &what)?;
                        *slot = n as u64;
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
            Type::Spectrum(dimension) => self.spectrum(value, *dimension, range, &what),
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
                    mismatch(&super::errors::listed(all, "or"));
                    None
                }
            },
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
            Type::Reference { kind, target } => self.reference(value, kind, target, place),
        }
    }

    fn spectrum(
        &self,
        value: &Value,
        dim: Dimension,
        range: &Range,
        what: &str,
    ) -> Option<Checked> {
        let ev = self.ev;
        let quantity = arithmetic::quantity(ev, value);
        match &quantity.kind {
            ValueKind::Colour(components, found) if *found == dim => {
                for component in components {
                    in_range(ev, value, *component, range, dim, what)?;
                }
                Some(Checked::Spectrum(Spectrum::Rgb(*components)))
            }
            ValueKind::Colour(_, Dimension::NONE) => {
                ev.reports.tell(types::colour_without_unit(what, dim, value.span));
                None
            }
            ValueKind::Colour(_, found) => {
                let (expected, found) = (dim.name(), found.name());
                ev.reports.tell(types::dimension(what, &expected, &found, value.span));
                None
            }
            ValueKind::Number { .. } => {
                let x = number(ev, &quantity, dim, what)?;
                in_range(ev, &quantity, x, range, dim, what)?;
                Some(Checked::Spectrum(Spectrum::Constant(x)))
            }
            ValueKind::Broken => None,
            _ => {
                let expected = match dim {
                    Dimension::NONE => "a number or a colour".to_string(),
                    _ => format!("{} or a colour of it", dim.name()),
                };
                ev.reports.tell(types::mismatch(
                    what,
                    &expected,
                    &quantity.described(),
                    value.span,
                ));
                None
            }
        }
    }

    fn one_of(&self, value: &Value, variants: &'static Variants, place: &str) -> Option<Checked> {
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
                let expected = super::errors::with_article(variants.name);
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
            self.ev.reports.tell(names::itself(kind.word, word));
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
    ) -> Option<std::rc::Rc<RecordValue>> {
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
        Some(std::rc::Rc::new(merged))
    }

    fn unknown_variant(
        &self,
        word: &Word,
        variants: &Variants,
        kind: Option<&'static str>,
        place: &str,
    ) {
        let all: Vec<_> = variants.all.iter().map(|record| record.word).collect();
        let declared: Vec<_> = match kind {
            Some(kind) => self.names_of(kind),
            None => Vec::new(),
        };
        if kind.is_some() && self.lenient(word.span) {
            return;
        }
        let told = names::unknown_variant(place, variants.name, word, &all, &declared);
        self.ev.reports.tell_unknown(&word.text, told);
    }

    fn lenient(&self, span: Span) -> bool {
        self.lenient_beyond.is_some_and(|main| span.file != main)
    }

    fn names_of(&self, kind: &'static str) -> Vec<&str> {
        self.declared.keys().filter(|(k, _)| *k == kind).map(|(_, name)| &**name).collect()
    }

    fn reference(
        &self,
        value: &Value,
        kind: &'static str,
        target: &'static Type,
        place: &str,
    ) -> Option<Checked> {
        let ev = self.ev;
        let name = match &value.kind {
            ValueKind::Word(word) => Some(word.clone()),
            ValueKind::Text { text, .. } => Some(Word { text: (**text).into(), span: value.span }),
            _ => None,
        };
        let variants = match target {
            Type::OneOf(variants) => Some(*variants),
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
                    let words: Vec<_> =
                        variants.iter().flat_map(|v| v.all).map(|record| record.word).collect();
                    let declared = self.names_of(kind);
                    let place = format!("`{place}`");
                    let told = names::unknown_declaration(&place, kind, word, &declared, &words);
                    ev.reports.tell_unknown(&word.text, told);
                }
                return None;
            }
        } else if !matches!(value.kind, ValueKind::Record(_)) {
            let expected = format!("the name of a {kind}, or a {kind}");
            let found = value.described();
            ev.reports.tell(types::mismatch(&format!("`{place}`"), &expected, &found, value.span));
            return None;
        }
        let checked = self.check(value, target, &Range::ANY, place)?;
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

    fn map(&self, found: &RecordValue, element: &'static Type, place: &str) -> Option<Checked> {
        let mut all = BTreeMap::new();
        let mut whole = !found.partial;
        for field in &found.fields {
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
    fn fields(
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
            if let Some(earlier) = earlier {
                ev.reports.tell(names::field_twice(&field.key, earlier.key.span, &owner));
                whole = false;
            } else if !schema.fields.iter().any(|known| known.word == &*field.key.text) {
                let known: Vec<_> = schema.fields.iter().map(|field| field.word).collect();
                ev.reports.tell(names::unknown_field(&owner, &field.key, &known));
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
                    Some(value) => checked.push(At::new(value, said.value.span())),
                    None => whole = false,
                },
                (None, Some(default)) => checked.push(self.default(default, field, span, &place)?),
                (None, None) if field.optional => checked.push(At::new(Checked::Absent, span)),
                (None, None) => missing.push(field),
            }
        }
        if !missing.is_empty() {
            // A misspelt field is not missing as well.
            let misspelt = |field: &schema::Field| {
                found.fields.iter().any(|said| {
                    !schema.fields.iter().any(|known| known.word == &*said.key.text)
                        && super::errors::nearest(&said.key.text, [field.word]).len() == 1
                })
            };
            let missed: Vec<&schema::Field> =
                missing.into_iter().filter(|field| !misspelt(field)).collect();
            if !missed.is_empty() && !found.partial {
                let at = found.word.as_ref().map_or(found.braces, |word| word.span);
                let wanted: Vec<_> =
                    missed.iter().map(|field| (field.word, self.example(&field.ty))).collect();
                ev.reports.tell(types::missing_fields(&owner, place, &wanted, at, found.braces));
            }
            whole = false;
        }
        whole.then_some(checked)
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

    fn default(
        &self,
        text: &'static str,
        field: &schema::Field,
        span: Span,
        place: &str,
    ) -> Option<At<Checked>> {
        let value = default_value(self.ev, text);
        let checked = self.check(&value, &field.ty, &field.range, place)?;
        Some(defaults::placed(checked, span))
    }

    /// How a value of a type may look.
    fn example(&self, ty: &Type) -> String {
        match ty {
            Type::Number(dimension) | Type::Spectrum(dimension) => types::example(*dimension),
            Type::Count => "1".into(),
            Type::Switch => "on".into(),
            Type::Text => "\"…\"".into(),
            Type::File => "\"…\"".into(),
            Type::Point => "(0, 0, 0)".into(),
            Type::Direction => "y".into(),
            Type::Size => "(512, 512)".into(),
            Type::Step => "scale(1)".into(),
            Type::Words(words) => words.all.first().map_or("", |(word, _)| word).into(),
            Type::OneOf(variants) => variants.all.first().map_or("", |record| record.word).into(),
            Type::Record(_) | Type::Map(_) => "{ … }".into(),
            Type::List(_) => "[ … ]".into(),
            Type::Reference { kind, target } => match (self.names_of(kind).first(), target) {
                (Some(name), _) => (*name).into(),
                (None, Type::OneOf(variants)) => {
                    variants.all.first().map_or(String::new(), |r| format!("{} {{ … }}", r.word))
                }
                _ => (*kind).into(),
            },
        }
    }
}

/// The value of a default.
pub fn default_value(ev: &Evaluator, text: &'static str) -> Value {
    ev.eval(&defaults::expr(text), &ev.frame(None))
}

fn plain(word: Word, braces: Span) -> RecordValue {
    RecordValue { word: Some(word), base: None, fields: Vec::new(), braces, partial: false }
}

/// Which variant a word is.
pub fn position(variants: &Variants, word: &str) -> Option<usize> {
    variants.all.iter().position(|record| record.word == word)
}

fn is_type(ty: &Type, variants: &'static Variants) -> bool {
    matches!(ty, Type::OneOf(other) if other.name == variants.name)
}

/// A number of a dimension, in base units.
pub fn number(ev: &Evaluator, value: &Value, dimension: Dimension, what: &str) -> Option<f64> {
    let quantity = arithmetic::quantity(ev, value);
    match quantity.kind {
        ValueKind::Number { value: x, dimension: found, .. } if found == dimension => Some(x),
        ValueKind::Number { value: x, dimension: Dimension::NONE, unit: None } => {
            ev.reports.tell(types::missing_unit(what, dimension, x, value.span));
            None
        }
        ValueKind::Number { dimension: found, .. } => {
            ev.reports.tell(types::dimension(what, &dimension.name(), &found.name(), value.span));
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

fn count(ev: &Evaluator, value: &Value, what: &str) -> Option<f64> {
    let n = number(ev, value, Dimension::NONE, what)?;
    if n.fract() != 0.0 || !(0.0..=COUNT_MAX).contains(&n) {
        ev.reports.tell(types::not_whole(what, n, value.span));
        return None;
    }
    Some(n)
}

fn in_range(
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
    let show = |x: f64| shown(x, dimension, unit);
    ev.reports.tell(types::out_of_range(what, &show(x), range, &show, value.span));
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
            let found = value.described();
            ev.reports.tell(types::mismatch(
                what,
                "a point such as `(0, 1, 2)`",
                &found,
                value.span,
            ));
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
            ev.reports.tell(types::mismatch(what, expected, &value.described(), value.span));
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
