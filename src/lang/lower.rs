//! Declarations → Scene: each render is checked whole, and keeps what it needs.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use super::ast::Word;
use super::check::{Checker, Declared, Item, Removed, default_value};
use super::errors::{circle, types};
use super::eval::Evaluator;
use super::{defaults, limits};
use crate::diag::{FileId, Span};
use crate::scene::schema::{Checked, Kind, Type};
use crate::scene::{At, KINDS, NAMED_BY_FILES, SEEN, Scene};

/// What became of a render.
pub struct Lowered {
    /// The scene, if nothing is wrong with it.
    pub scene: Option<Scene>,
    /// Kinds that must be stated and are not.
    pub missing: Vec<&'static Kind>,
}

/// Checks the declarations of a render, which stands at `span`.
pub fn lower(
    ev: &Evaluator,
    (declared, removed): (&Declared, &Removed),
    span: Span,
    lenient_beyond: Option<FileId>,
) -> Lowered {
    let before = ev.reports.errors();
    let mut checker = Checker::new(ev, declared);
    checker.removed = Some(removed);
    checker.lenient_beyond = lenient_beyond;
    let mut items: Vec<Item> = Vec::new();
    let mut missing = Vec::new();
    let mut whole = true;
    for kind in KINDS.iter().filter(|kind| !kind.named) {
        let value = match (declared.get(&(kind.word, Arc::from(""))), kind.default) {
            (Some((_, value)), _) => value.clone(),
            (None, Some(default)) => default_value(ev, default),
            (None, None) if kind.optional => {
                let absent = At { usual: true, ..At::new(Checked::Absent, span) };
                items.push((kind.word, At::new(String::new(), span), absent));
                continue;
            }
            (None, None) => {
                missing.push(kind);
                continue;
            }
        };
        let name = Word { text: Arc::from(""), span };
        match checker.declaration(kind, &name, &value) {
            Some(checked) => {
                items.push(item(kind.word, "", span, At::new(checked, value.span), span))
            }
            None => whole = false,
        }
    }
    for ((word, _), (name, value)) in declared {
        let kind = KINDS.iter().find(|kind| kind.word == *word && kind.named);
        let Some(kind) = kind else { continue };
        match checker.declaration(kind, name, value) {
            Some(checked) => {
                let checked = At::new(checked, value.span);
                items.push(item(kind.word, &name.text, name.span, checked, span));
            }
            None => whole = false,
        }
    }
    items.extend(checker.into_hoisted());
    whole &= circles(ev, &items);
    let faultless = whole && missing.is_empty() && ev.reports.errors() == before;
    let scene = faultless.then(|| Scene::lower(&needed(items)));
    Lowered { scene, missing }
}

fn item(kind: &'static str, name: &str, place: Span, checked: At<Checked>, span: Span) -> Item {
    let checked = match defaults::is_nowhere(checked.span) {
        true => defaults::placed(checked.value, span),
        false => defaults::settled(checked, span),
    };
    (kind, At::new(name.to_string(), place), checked)
}

/// Without declarations that only names would lead to, and none does: a scene is the same scene
/// whatever its file declares beside. What files may name is kept.
fn needed(items: Vec<Item>) -> Vec<Item> {
    let referred: HashSet<&str> = KINDS.iter().flat_map(|kind| references(&kind.ty)).collect();
    let index: HashMap<(&str, &str), usize> =
        items.iter().enumerate().map(|(i, (kind, name, _))| ((*kind, name.as_str()), i)).collect();
    let mut kept = vec![false; items.len()];
    let kept_anyway = |kind: &str| NAMED_BY_FILES.contains(&kind) || SEEN.contains(&kind);
    let wanted = |kind: &str| !referred.contains(kind) || kept_anyway(kind);
    let mut open: Vec<usize> = (0..items.len()).filter(|i| wanted(items[*i].0)).collect();
    while let Some(at) = open.pop() {
        if std::mem::replace(&mut kept[at], true) {
            continue;
        }
        let (kind, _, checked) = &items[at];
        let kind = KINDS.iter().find(|known| known.word == *kind).expect("a kind of the schema");
        let mut names = Vec::new();
        named(checked, &kind.ty, &mut names);
        open.extend(names.iter().filter_map(|(key, _)| index.get(key)));
    }
    drop(index);
    let mut kept = kept.into_iter();
    items.into_iter().filter(|_| kept.next().unwrap_or(false)).collect()
}

/// The kinds that a type refers to.
pub fn references(ty: &Type) -> Vec<&'static str> {
    let records = match ty {
        Type::Reference { kind, .. } | Type::Textured { kind, .. } => return vec![*kind],
        Type::List(inner) | Type::Map(inner) => return references(inner),
        Type::OneOf(variants) => variants.all,
        Type::Record(record) => std::slice::from_ref(*record),
        _ => return Vec::new(),
    };
    records.iter().flat_map(|record| record.fields).flat_map(|f| references(&f.ty)).collect()
}

/// Whether no declaration refers to others that lead back to it. Those that do are told, and
/// so are chains that are too long.
fn circles(ev: &Evaluator, items: &[Item]) -> bool {
    let mut walk = Walk {
        ev,
        items,
        index: items
            .iter()
            .enumerate()
            .map(|(i, (kind, name, _))| ((*kind, &*name.value), i))
            .collect(),
        known: vec![Known::Nothing; items.len()],
        chain: Vec::new(),
        good: true,
    };
    (0..items.len()).for_each(|i| walk.look(i, 1));
    walk.good
}

/// What is known of a declaration.
#[derive(Clone, Copy, PartialEq)]
enum Known {
    Nothing,
    /// It is being looked into.
    Open,
    /// No declarations in a longer chain lead on from it.
    Chain(usize),
}

/// A walk along references.
struct Walk<'a> {
    ev: &'a Evaluator<'a>,
    items: &'a [Item],
    index: HashMap<(&'static str, &'a str), usize>,
    known: Vec<Known>,
    /// What is being looked into, and where the last of it is named.
    chain: Vec<(usize, Span)>,
    good: bool,
}

impl Walk<'_> {
    /// Looks into a declaration, the last of a chain of so many.
    fn look(&mut self, at: usize, depth: usize) {
        let (word, _, checked) = &self.items[at];
        let kind = KINDS.iter().find(|kind| kind.word == *word).expect("a kind of the schema");
        let mut names = Vec::new();
        named(checked, &kind.ty, &mut names);
        self.known[at] = Known::Open;
        let mut longest = 1;
        for ((kind, name), span) in names {
            let Some(next) = self.index.get(&(kind, name)).copied() else { continue };
            self.chain.push((next, span));
            match self.known[next] {
                Known::Open => {
                    self.ev.reports.tell(circle::of_declarations(kind, &self.ring()));
                    self.good = false;
                }
                Known::Nothing if depth < limits::DEPTH => self.look(next, depth + 1),
                Known::Chain(length) if depth + length <= limits::DEPTH => {}
                // What is before it in the chain has too much behind it as well.
                _ if self.good => {
                    self.ev.reports.tell(types::long_chain(kind, span));
                    self.good = false;
                }
                _ => {}
            }
            self.chain.pop();
            if let Known::Chain(length) = self.known[next] {
                longest = longest.max(length + 1);
            }
        }
        self.known[at] = Known::Chain(longest);
    }

    /// The names in the ring that the last name closes, each where another of the ring names it.
    fn ring(&self) -> Vec<Word> {
        let last = self.chain.last().map(|(at, _)| *at);
        let earlier = self.chain.iter().rev().skip(1).take_while(|(at, _)| Some(*at) != last);
        let start = self.chain.len() - 1 - earlier.count();
        let word = |(at, span): &(usize, Span)| Word {
            text: Arc::from(self.items[*at].1.value.as_str()),
            span: *span,
        };
        self.chain[start..].iter().map(word).collect()
    }
}

/// A declaration that is named: its kind and name, and where.
type Mention<'c> = ((&'static str, &'c str), Span);

/// The declarations that a checked value names.
fn named<'c>(checked: &'c At<Checked>, ty: &Type, found: &mut Vec<Mention<'c>>) {
    let mut all = |fields: &'c [At<Checked>], record: &'static crate::scene::schema::Record| {
        for (field, schema) in fields.iter().zip(record.fields) {
            named(field, &schema.ty, found);
        }
    };
    match (&checked.value, ty) {
        (Checked::Reference(name), Type::Reference { kind, .. } | Type::Textured { kind, .. }) => {
            found.push(((kind, name), checked.span));
        }
        (Checked::Variant(which, fields), Type::OneOf(variants)) => {
            all(fields, &variants.all[*which])
        }
        (Checked::Record(fields), Type::Record(record)) => all(fields, record),
        (Checked::List(elements), Type::List(inner)) => {
            elements.iter().for_each(|element| named(element, inner, found));
        }
        (Checked::Map(entries), Type::Map(inner)) => {
            entries.iter().for_each(|(_, value)| named(value, inner, found));
        }
        _ => {}
    }
}
