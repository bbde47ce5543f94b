//! Lets: which names a file or a body may use, and that none depends on itself.

use std::collections::{HashMap, HashSet};
use std::rc::Rc;
use std::sync::Arc;

use super::ast::{Expr, ExprKind, Item, Let, Piece, Word};
use super::errors::circle;
use super::eval::Evaluator;
use super::import::Unit;
use super::order;
use super::value::{Binding, Bound, Env, Value};
use crate::diag::Span;

/// The names each file may use: its own lets, and those of the files it uses.
pub fn file_names(ev: &Evaluator, units: &[Unit]) -> Vec<Env> {
    let envs: Vec<Env> = units.iter().map(|_| ev.frame(None)).collect();
    let all: Vec<(usize, &Arc<Let>)> = units
        .iter()
        .enumerate()
        .flat_map(|(i, unit)| {
            unit.tree.items.iter().filter_map(move |item| match item {
                Item::Let(definition) => Some((i, definition)),
                _ => None,
            })
        })
        .collect();
    let everything = ev.frame(None);
    let lets: Vec<_> = all.iter().map(|(_, definition)| (*definition).clone()).collect();
    let broken = tell_circles(ev, &lets);
    for (i, definition) in &all {
        let what = || bound(definition, &envs[*i], &broken);
        ev.define(&everything, &definition.name, what());
        let taken = everything.find(&definition.name.text);
        if taken.is_none_or(|binding| binding.name.span != definition.name.span) {
            continue;
        }
        let binding = Rc::new(Binding { name: definition.name.clone(), what: what() });
        for (unit, env) in units.iter().zip(&envs) {
            if unit.reach.contains(i) {
                env.0.names.borrow_mut().insert(definition.name.text.clone(), binding.clone());
            }
        }
    }
    for (i, definition) in &all {
        params(ev, definition, &envs[*i]);
    }
    envs
}

/// Names of a body's own lets, inside `env`.
pub fn body(ev: &Evaluator, items: &[Item], env: &Env) -> Env {
    let lets: Vec<_> = items
        .iter()
        .filter_map(|item| match item {
            Item::Let(definition) => Some(definition.clone()),
            _ => None,
        })
        .collect();
    if lets.is_empty() {
        return env.clone();
    }
    let inner = ev.frame(Some(env));
    let broken = tell_circles(ev, &lets);
    for definition in &lets {
        ev.define(&inner, &definition.name, bound(definition, &inner, &broken));
    }
    lets.iter().for_each(|definition| params(ev, definition, &inner));
    inner
}

fn bound(definition: &Arc<Let>, env: &Env, broken: &HashSet<Span>) -> Bound {
    match broken.contains(&definition.name.span) {
        true => Bound::Broken,
        false => Bound::Let(definition.clone(), env.clone(), Default::default()),
    }
}

/// Parameters may not be called like anything visible.
fn params(ev: &Evaluator, definition: &Let, env: &Env) {
    let inner = ev.frame(Some(env));
    for param in definition.params.iter().flatten() {
        ev.define(&inner, param, Bound::Value(Value::broken(param.span)));
    }
}

/// Tells lets that depend on themselves; gives the places of their names.
fn tell_circles(ev: &Evaluator, lets: &[Arc<Let>]) -> HashSet<Span> {
    let index: HashMap<&str, usize> =
        lets.iter().enumerate().map(|(i, definition)| (&*definition.name.text, i)).collect();
    let needs = |definition: &Arc<Let>| {
        let mut words = Vec::new();
        mentioned(&definition.value, &mut words);
        let params = definition.params.iter().flatten();
        let params: HashSet<&str> = params.map(|param| &*param.text).collect();
        let mut needs: Vec<_> = words
            .into_iter()
            .map(|(word, _)| &*word.text)
            .filter(|word| !params.contains(word))
            .filter_map(|word| index.get(word).copied())
            .collect();
        needs.sort_unstable();
        needs.dedup();
        needs
    };
    let wants: Vec<_> = lets.iter().map(needs).collect();
    let mut broken = HashSet::new();
    for circle in order::circles(&wants) {
        let words: Vec<_> = circle.iter().map(|i| lets[*i].name.clone()).collect();
        ev.reports.tell(circle::of_lets(&words));
        broken.extend(words.iter().map(|word| word.span));
    }
    broken
}

/// The words an expression may look up, and whether each is called as a function.
pub fn mentioned<'e>(expr: &'e Expr, found: &mut Vec<(&'e Word, bool)>) {
    paths(expr, &mut |path, called| {
        if let [word] = path {
            found.push((word, called));
        }
    });
}

/// The names an expression may look up, those with dots included, and whether each is called as a
/// function.
pub fn paths<'e>(expr: &'e Expr, found: &mut dyn FnMut(&'e [Word], bool)) {
    let mut records = Vec::new();
    match &expr.kind {
        ExprKind::Number { .. } | ExprKind::Broken => {}
        ExprKind::Text(pieces) => pieces.iter().for_each(|piece| {
            if let Piece::Value(expr) = piece {
                paths(expr, found);
            }
        }),
        ExprKind::Vector(all) | ExprKind::List(all) => {
            all.iter().for_each(|expr| paths(expr, found));
        }
        ExprKind::Call { function, arguments } => {
            found(function, true);
            arguments.iter().for_each(|expr| paths(expr, found));
        }
        ExprKind::Record(record) => records.push(&**record),
        ExprKind::Name(path) => found(path, false),
        ExprKind::Negated(inner) | ExprKind::Power(inner, _) => paths(inner, found),
        ExprKind::Chain { first, rest } => {
            paths(first, found);
            rest.iter().for_each(|(_, _, expr)| paths(expr, found));
        }
        ExprKind::With { base, changes } => {
            paths(base, found);
            records.extend(changes.iter());
        }
        ExprKind::Range { from, to, step } => {
            paths(from, found);
            paths(to, found);
            if let Some(step) = step {
                paths(step, found);
            }
        }
    }
    for entry in records.into_iter().flat_map(|record| &record.entries) {
        paths(&entry.value, found);
    }
}
