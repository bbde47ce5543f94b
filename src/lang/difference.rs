//! The one rule of difference: what a render says, built from everything it builds on.
//!
//! `kind: value` states the whole, `kind.part: value` changes a part of what is stated, `without`
//! removes. An item wins only over those its setup or render builds on.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashSet};
use std::rc::Rc;
use std::sync::Arc;

use super::ast::Word;
use super::check::{Declared, Removed, default_value, position};
use super::errors::{name as names, render, types};
use super::eval::Evaluator;
use super::resolve::{Action, Plan, TOP, What};
use super::value::{FieldValue, RecordValue, Thunk, Value, ValueKind};
use crate::diag::{Diagnostic, Span};
use crate::scene::KINDS;
use crate::scene::schema::{self, Field, Type};

/// Everything said of one declaration.
type Group = Vec<(usize, Rc<Action>)>;

/// Builds the declarations of a scope.
pub struct Composer<'a> {
    /// Computes values.
    pub ev: &'a Evaluator<'a>,
    /// All scopes.
    pub plan: &'a Plan,
    /// What `--set` says.
    pub sets: &'a [Rc<Action>],
    /// Parts and removals that meet nothing are not told: the setup may be meant to be used with
    /// another one.
    pub lenient: bool,
    /// What the last composition took away, and where that is said.
    pub removed: RefCell<Removed>,
}

impl Composer<'_> {
    /// The declarations of a scope. `used` collects the places of the items that took part.
    pub fn compose(&self, scope: usize, used: &mut HashSet<Span>) -> Declared {
        let mut groups: BTreeMap<(&'static str, Arc<str>), Group> = BTreeMap::new();
        let lineage = &self.plan.scopes[scope].lineage;
        let said = lineage.iter().flat_map(|scope| &self.plan.scopes[*scope].actions);
        let sets = self.sets.iter().filter(|_| !self.lenient);
        for (order, action) in said.chain(sets).enumerate() {
            let key = (action.kind.word, action.name.text.clone());
            groups.entry(key).or_default().push((order, action.clone()));
        }
        let stated: Vec<_> = groups
            .iter()
            .filter(|(_, group)| group.iter().any(|(_, a)| states(a)))
            .map(|(key, _)| key.clone())
            .collect();
        let mut declared = Declared::new();
        let mut removed = Removed::new();
        for (key, group) in groups {
            let named = |kind: &str| -> Vec<&str> {
                stated.iter().filter(|(k, _)| *k == kind).map(|(_, name)| &**name).collect()
            };
            match self.declaration(&group, used, &named) {
                Some(found) => {
                    declared.insert(key, found);
                }
                // What is stated and wrong is not missing.
                None if key.1.is_empty() => self.ev.reports.poison([key.0.to_string()]),
                None => {
                    let taken = group.iter().find(|(_, it)| matches!(it.what, What::Remove));
                    removed.extend(taken.map(|(_, action)| (key, action.path)));
                }
            }
        }
        self.removed.replace(removed);
        declared
    }

    /// Whether an item of one scope wins over an item of another.
    fn wins(&self, upper: &Action, lower: &Action) -> bool {
        let sets = self.plan.scopes.len();
        match (upper.scope == sets, lower.scope == sets) {
            (true, lower_too) => !lower_too,
            (false, true) => false,
            _ => self.plan.builds_on(upper.scope, lower.scope),
        }
    }

    fn declaration<'n>(
        &self,
        group: &Group,
        used: &mut HashSet<Span>,
        named: &dyn Fn(&str) -> Vec<&'n str>,
    ) -> Option<(Word, Value)> {
        let covered = |lower: &Action| {
            group.iter().any(|(_, upper)| self.wins(upper, lower) && covers(upper, lower))
        };
        let standing: Vec<_> = group.iter().filter(|(_, action)| !covered(action)).collect();
        let mut clashing = HashSet::new();
        for (i, (_, a)) in standing.iter().enumerate() {
            for (j, (_, b)) in standing.iter().enumerate().skip(i + 1) {
                let meet = covers(a, b) || covers(b, a);
                if meet && !self.wins(a, b) && !self.wins(b, a) && !clashing.contains(&i) {
                    self.tell_clash(a, b);
                    // What states the whole goes on to be looked at.
                    clashing.insert(if states(b) && !states(a) { i } else { j });
                }
            }
        }
        let mut value: Option<(Word, Value)> = None;
        for (i, (_, action)) in standing.iter().enumerate() {
            if clashing.contains(&i) {
                continue;
            }
            used.insert(action.path);
            value = self.applied(value, action, group, named)?;
        }
        value
    }

    fn tell_clash(&self, a: &Action, b: &Action) {
        let said = |action: &Action| render::Said {
            path: action.text(),
            span: action.path,
            by: match self.plan.scopes.get(action.scope) {
                Some(_) if action.scope == TOP => "at the top level".to_string(),
                Some(scope) => format!("in {}", scope.label),
                None => "by `--set`".to_string(),
            },
        };
        self.ev.reports.tell(render::clash(&said(a), &said(b), a.scope == b.scope));
    }

    /// The value after an action; None: something was told.
    fn applied<'n>(
        &self,
        before: Option<(Word, Value)>,
        action: &Action,
        group: &Group,
        named: &dyn Fn(&str) -> Vec<&'n str>,
    ) -> Option<Option<(Word, Value)>> {
        let kind = action.kind;
        let said = match &action.what {
            What::State(expr, env) => self.ev.eval(expr, env),
            What::Remove => {
                let there =
                    group.iter().any(|(_, lower)| states(lower) && self.wins(action, lower));
                if !there && !self.lenient {
                    let name = &action.name;
                    self.ev.reports.tell_unknown_with(&name.text, name.span, || {
                        let all = named(kind.word);
                        names::unknown_target(kind.word, &name.text, name.span, &all, "remove")
                    });
                }
                return Some(None);
            }
        };
        if action.parts.is_empty() {
            let lower = group.iter().any(|(_, lower)| states(lower) && self.wins(action, lower));
            let told = lower.then(|| self.part_as_whole(action, &said)).flatten();
            let said = match told {
                Some(told) => {
                    self.ev.reports.tell(told);
                    Value::broken(said.span)
                }
                None => said,
            };
            return Some(Some((action.name.clone(), said)));
        }
        let before = match (before, kind.default) {
            (Some(before), _) => before,
            (None, Some(default)) => (action.name.clone(), default_value(self.ev, default)),
            (None, None) => {
                if !self.lenient {
                    self.tell_nothing(action, &|| named(kind.word));
                }
                return None;
            }
        };
        // What is there and wrong is there: those who name it are told nothing.
        if said.is_broken() || before.1.is_broken() {
            return Some(Some((before.0, Value::broken(said.span))));
        }
        let root =
            Action { parts: Vec::new(), what: What::Remove, name: action.name.clone(), ..*action };
        let value =
            self.change(&before.1, &kind.ty, &action.parts, said, &root.text(), action.path)?;
        Some(Some((before.0, value)))
    }

    /// What is wrong with fields alone that state a declaration anew, where a few paths would say
    /// what is meant.
    fn part_as_whole(&self, action: &Action, said: &Value) -> Option<Diagnostic> {
        let (Type::OneOf(variants), ValueKind::Record(record)) = (&action.kind.ty, &said.kind)
        else {
            return None;
        };
        if record.word.is_some() || record.base.is_some() || record.fields.is_empty() {
            return None;
        }
        let root = action.text();
        let path = |field: &FieldValue| {
            let text = self.ev.written(field.value.span())?;
            (!text.contains('\n')).then(|| format!("{root}.{}: {text}", field.key.text))
        };
        let paths: Option<Vec<_>> = record.fields.iter().map(path).collect();
        let item = action.path.to(said.span);
        Some(names::whole_for_part(&root, variants.name, record.braces, &paths?.join(", "), item))
    }

    fn tell_nothing<'n>(&self, action: &Action, all: &dyn Fn() -> Vec<&'n str>) {
        let (kind, name) = (action.kind.word, &action.name);
        if action.kind.named {
            self.ev.reports.tell_unknown_with(&name.text, name.span, || {
                names::unknown_target(kind, &name.text, name.span, &all(), "change")
            });
        } else {
            let told = render::nothing_to_change(kind, &action.text(), action.path);
            self.ev.reports.tell_unknown(kind, told);
        }
    }

    /// `value` with the part at `parts` replaced by `new`. `path`: the way so far.
    fn change(
        &self,
        value: &Value,
        ty: &Type,
        parts: &[Word],
        new: Value,
        path: &str,
        place: Span,
    ) -> Option<Value> {
        let Some((part, rest)) = parts.split_first() else { return Some(new) };
        if value.is_broken() {
            return None;
        }
        let reports = &self.ev.reports;
        match ty {
            Type::OneOf(variants) => {
                let record = as_record(value);
                let word = record.as_ref().and_then(|record| record.word.clone());
                let which = word.as_ref().and_then(|word| position(variants, &word.text));
                // Anything else is told when the value itself is checked.
                let (record, schema) = (record?, &variants.all[which?]);
                self.change_field(value, &record, schema, parts, new, path, place)
            }
            Type::Record(schema) => {
                let record = as_record(value)?;
                self.change_field(value, &record, schema, parts, new, path, place)
            }
            Type::Map(element) => {
                let mut record = as_record(value)?;
                let Some(at) = record.fields.iter().position(|field| field.key.text == part.text)
                else {
                    if !self.lenient {
                        let all: Vec<_> = record.fields.iter().map(|f| &*f.key.text).collect();
                        reports.tell(render::no_such_key(path, part, &all));
                    }
                    return None;
                };
                let inner = self.ev.force(&record.fields[at].value);
                let path = format!("{path}.{}", part.text);
                let changed = self.change(&inner, element, rest, new, &path, place)?;
                record.fields[at].value = Thunk::Ready(changed);
                Some(rebuilt(value, record))
            }
            Type::Reference { kind, .. } | Type::Textured { kind, .. } => {
                let target = match ty {
                    Type::Reference { target, .. } => *target,
                    Type::Textured { target, .. } => Some(*target),
                    _ => None,
                };
                match (&value.kind, target) {
                    (ValueKind::Record(_), Some(target)) => {
                        self.change(value, &target(), parts, new, path, place)
                    }
                    _ => {
                        let name = match &value.kind {
                            ValueKind::Word(word) => word.text.to_string(),
                            ValueKind::Text { text, .. } => text.to_string(),
                            _ => return None,
                        };
                        let rest: Vec<_> = parts.iter().map(|part| &*part.text).collect();
                        reports.tell(types::part_of_named(
                            path,
                            kind,
                            &name,
                            &rest.join("."),
                            part.span,
                        ));
                        None
                    }
                }
            }
            _ => {
                reports.tell(types::no_parts(path, &value.described(), part.span));
                None
            }
        }
    }

    #[allow(clippy::too_many_arguments)]
    fn change_field(
        &self,
        value: &Value,
        record: &RecordValue,
        schema: &'static schema::Record,
        parts: &[Word],
        new: Value,
        path: &str,
        place: Span,
    ) -> Option<Value> {
        let (part, rest) = parts.split_first()?;
        let Some(field) = schema.fields.iter().find(|field| field.word == &*part.text) else {
            if !(self.lenient && is_somewhere(&part.text)) {
                let all: Vec<_> = schema.fields.iter().map(|field| field.word).collect();
                let owner = if schema.word.is_empty() { path } else { schema.word };
                let told = names::unknown_field(owner, part, &all, (&[], None), false);
                self.ev.reports.tell(told.label(value.span, format!("`{owner}` is stated here")));
            }
            return None;
        };
        let mut record = record.clone();
        let said = record.fields.iter().position(|said| said.key.text == part.text);
        let inner = format!("{path}.{}", part.text);
        let changed = match (said, rest.is_empty()) {
            (_, true) => new,
            (Some(at), false) => {
                let before = self.ev.force(&record.fields[at].value);
                self.change(&before, &field.ty, rest, new, &inner, place)?
            }
            (None, false) => {
                let before = self.absent(field, &inner, place)?;
                self.change(&before, &field.ty, rest, new, &inner, place)?
            }
        };
        let field = FieldValue { key: part.clone(), quantity: None, value: Thunk::Ready(changed) };
        match said {
            Some(at) => record.fields[at] = field,
            None => record.fields.push(field),
        }
        Some(rebuilt(value, record))
    }

    /// The value of a field that is not said.
    fn absent(&self, field: &Field, path: &str, place: Span) -> Option<Value> {
        if let Some(default) = field.default {
            return Some(default_value(self.ev, default));
        }
        if !self.lenient {
            self.ev.reports.tell(render::nothing_to_change(field.word, path, place));
        }
        None
    }
}

/// Whether an action states a declaration whole.
fn states(action: &Action) -> bool {
    action.parts.is_empty() && matches!(action.what, What::State(..))
}

/// Whether a path is another one, or leads to it.
fn covers(upper: &Action, lower: &Action) -> bool {
    upper.parts.len() <= lower.parts.len()
        && upper.parts.iter().zip(&lower.parts).all(|(a, b)| a.text == b.text)
}

/// A value as a record: a word alone is one without fields.
fn as_record(value: &Value) -> Option<RecordValue> {
    match &value.kind {
        ValueKind::Record(record) if record.base.is_none() => Some((**record).clone()),
        ValueKind::Word(word) => Some(RecordValue {
            word: Some(word.clone()),
            base: None,
            fields: Vec::new(),
            braces: value.span,
            partial: false,
            shelved: None,
        }),
        _ => None,
    }
}

fn rebuilt(value: &Value, record: RecordValue) -> Value {
    Value { kind: ValueKind::Record(Rc::new(record)), span: value.span }
}

/// Whether any variant of the schema has a field of that name.
fn is_somewhere(word: &str) -> bool {
    fn inside(ty: &Type, word: &str) -> bool {
        let records = match ty {
            Type::OneOf(variants) => variants.all,
            Type::Record(record) => std::slice::from_ref(*record),
            Type::List(inner) | Type::Map(inner) => return inside(inner, word),
            _ => return false,
        };
        let mut fields = records.iter().flat_map(|record| record.fields);
        fields.any(|field| field.word == word || inside(&field.ty, word))
    }
    KINDS.iter().any(|kind| inside(&kind.ty, word))
}
