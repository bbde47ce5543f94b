//! Lets that no render needs: they are looked into all the same.

use std::collections::HashSet;
use std::rc::Rc;

use super::arithmetic;
use super::ast::{Expr, Let};
use super::errors::name;
use super::eval::Evaluator;
use super::functions;
use super::names::paths;
use super::resolve::Plan;
use super::shelves;
use super::spectra;
use super::value::{Binding, Bound, Env, Value, ValueKind};
use crate::scene::KINDS;
use crate::scene::schema::{Record, Type};

/// Tells what is wrong with lets whatever they are used for: values that have none, and words that
/// nothing is called.
pub fn check(ev: &Evaluator, plan: &Plan) {
    let bindings = ev.bindings();
    let lets: Vec<_> = bindings.iter().filter_map(|binding| parts(binding)).collect();
    let used = lets.iter().filter(|(_, _, used)| *used).map(|(said, _, _)| said.name.span);
    let mut seen: HashSet<_> = used.collect();
    let mut known = HashSet::new();
    for kind in KINDS {
        known.insert(kind.word);
        schema_words(&kind.ty, &mut known);
    }
    known.extend(plan.blocks.iter().map(|name| &**name));
    let actions = plan.scopes.iter().flat_map(|scope| &scope.actions);
    known.extend(actions.map(|action| &*action.name.text));
    for (said, env, _) in lets {
        if !seen.insert(said.name.span) {
            continue;
        }
        let inner = ev.frame(Some(env));
        for param in said.params.iter().flatten() {
            let what = Bound::Value(Value::broken(param.span));
            let binding = Rc::new(Binding { name: param.clone(), what });
            inner.0.names.borrow_mut().insert(param.text.clone(), binding);
        }
        let value = ev.eval(&said.value, &inner);
        if let ValueKind::Record(record) = &value.kind {
            spectra::from_record(ev, record, value.span);
        }
        words(ev, &said.value, &inner, &known);
    }
}

/// A let, the names it may use, and whether its value was needed.
fn parts(binding: &Binding) -> Option<(&Let, &Env, bool)> {
    match &binding.what {
        Bound::Let(said, env, value) => Some((said, env, value.borrow().is_some())),
        _ => None,
    }
}

/// Tells words that are no name of anything.
fn words(ev: &Evaluator, value: &Expr, env: &Env, known: &HashSet<&str>) {
    let mut found = Vec::new();
    paths(value, &mut |path, called| found.push((path, called)));
    for (path, called) in found {
        let [word] = path else {
            if let (false, [first, .., last]) = (called, path) {
                shelves::named(ev, path, env, first.span.to(last.span));
            }
            continue;
        };
        let text = &*word.text;
        let exists = env.find(text).is_some()
            || functions::ALL.contains(&text)
            || !called && (known.contains(text) || arithmetic::known(text, word.span).is_some());
        if exists {
            continue;
        }
        ev.reports.tell_unknown_with(text, word.span, || match called {
            true => {
                let names = env.functions();
                let names: Vec<_> = names.iter().map(|name| &**name).collect();
                name::unknown_function(text, word.span, &names)
            }
            false => name::unknown_value(text, word.span, &env.all()),
        });
    }
}

/// The words that a type gives a meaning to.
fn schema_words(ty: &Type, found: &mut HashSet<&str>) {
    let records: &'static [Record] = match ty {
        Type::Switch => return found.extend(["on", "off"]),
        Type::Words(words) | Type::Paths(Some(words)) => {
            return found.extend(words.all.iter().map(|(word, _)| *word));
        }
        Type::OneOf(variants) => variants.all,
        Type::Record(record) => std::slice::from_ref(*record),
        Type::List(inner) | Type::Map(inner) => return schema_words(inner, found),
        _ => return,
    };
    for record in records {
        found.insert(record.word);
        record.fields.iter().for_each(|field| schema_words(&field.ty, found));
    }
}
