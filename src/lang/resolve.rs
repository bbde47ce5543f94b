//! Items → scopes: lets get their names, loops are run, and what is said stands in the setup or
//! render that says it.

use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;
use std::sync::Arc;

use super::ast::{Expr, ExprKind, For, Item, Name, Piece, Set, Word};
use super::errors::{name as names, render, syntax, types};
use super::eval::Evaluator;
use super::import::Unit;
use super::names::{body, file_names};
use super::value::{Bound, Env, ValueKind};
use super::{limits, order};
use crate::diag::Span;
use crate::scene::schema::Kind;
use crate::scene::{At, KINDS};

/// The number of the scope that holds the top level of all files.
pub const TOP: usize = 0;

/// A setup, a render, the top level, or the arguments of `--set`.
pub struct Scope {
    /// What it is, for messages: "setup `bunny`".
    pub label: String,
    /// Where its name stands.
    pub span: Span,
    /// Itself and what it builds on, each after those it builds on.
    pub lineage: Vec<usize>,
    /// What it says.
    pub actions: Vec<Rc<Action>>,
}

/// One thing said.
pub struct Action {
    /// Of which kind.
    pub kind: &'static Kind,
    /// The declaration's name; empty for kinds without.
    pub name: Word,
    /// The way into the value.
    pub parts: Vec<Word>,
    /// What is said.
    pub what: What,
    /// Where its path stands.
    pub path: Span,
    /// Who says it.
    pub scope: usize,
}

/// What is said of a path.
pub enum What {
    /// A value, with the names it may use.
    State(Arc<Expr>, Env),
    /// It is removed.
    Remove,
}

impl Action {
    /// `kind name.part`
    pub fn text(&self) -> String {
        let name = if self.name.text.is_empty() { "" } else { " " };
        let mut text = format!("{}{name}{}", self.kind.word, self.name.text);
        for part in &self.parts {
            text.push('.');
            text.push_str(&part.text);
        }
        text
    }
}

/// Everything that is said.
#[derive(Default)]
pub struct Plan {
    /// Scopes; [`TOP`] is the first.
    pub scopes: Vec<Scope>,
    /// Renders by their scopes, in the order of the text.
    pub renders: Vec<(At<String>, usize)>,
    /// What setups and renders are called.
    pub blocks: Vec<Arc<str>>,
    /// The names of the main file.
    names: Option<Env>,
    /// Where each scope stands in an order in which all come after what they build on.
    rank: Vec<usize>,
}

impl Plan {
    /// Whether a scope builds on another one.
    pub fn builds_on(&self, upper: usize, lower: usize) -> bool {
        upper != lower
            && self.scopes[upper]
                .lineage
                .binary_search_by_key(&self.rank[lower], |scope| self.rank[*scope])
                .is_ok()
    }
}

/// Where items stand.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    /// A file's top level, or a loop there.
    Top,
    /// Inside a setup or a render.
    Body,
}

/// Reads the items of all files.
pub fn plan(ev: &Evaluator, units: &[Unit]) -> Plan {
    let mut planner = Planner {
        ev,
        plan: Plan::default(),
        bases: Vec::new(),
        named: HashMap::new(),
        folded: HashMap::new(),
        main: true,
    };
    let first_line = units[0].tree.first_line.unwrap_or(Span::new(units[0].id, 0, 0));
    planner.scope("the top level".into(), first_line, (&[], None));
    let envs = file_names(ev, units);
    planner.plan.names = envs.first().cloned();
    for (i, unit) in units.iter().enumerate() {
        planner.main = i == 0;
        planner.items(&unit.tree.items, &envs[i], TOP, Place::Top);
    }
    planner.link();
    planner.plan.blocks = planner.named.into_keys().collect();
    planner.plan
}

/// What `--set` arguments say, as if at the end of the main file.
pub fn sets(ev: &Evaluator, plan: &mut Plan, sets: Vec<Set>) -> Vec<Rc<Action>> {
    let Some(env) = plan.names.clone() else { return Vec::new() };
    let scope = plan.scopes.len();
    let mut actions = Vec::new();
    for set in sets {
        actions.extend(statement(ev, &set, &env, scope).map(Rc::new));
    }
    actions
}

/// `path: value`.
fn statement(ev: &Evaluator, set: &Set, env: &Env, scope: usize) -> Option<Action> {
    action(ev, &set.kind, set.name.as_ref(), env, |kind, name| Action {
        kind,
        name,
        parts: set.parts.clone(),
        what: What::State(set.value.clone(), env.clone()),
        path: set.path,
        scope,
    })
}

/// An item on a path: its kind and name are found, or told.
fn action(
    ev: &Evaluator,
    kind: &Word,
    name: Option<&Name>,
    env: &Env,
    build: impl FnOnce(&'static Kind, Word) -> Action,
) -> Option<Action> {
    let reports = &ev.reports;
    if !ev.spend(kind.span) {
        return None;
    }
    let found = KINDS.iter().find(|known| known.word == &*kind.text);
    let name = match name {
        Some(name) => Some(ev.name(name, env)?),
        None => None,
    };
    match (found, name) {
        (None, name) => {
            reports.tell_with(kind.span, || names::unknown_kind(kind));
            reports.poison(name.map(|name| name.text.to_string()));
            // It may be meant to be any of the kinds that must be stated.
            if reports.is_no_kind(&kind.text) {
                reports.poison(
                    crate::diag::near(&kind.text, KINDS.iter().map(|k| k.word))
                        .into_iter()
                        .chain(crate::scene::elsewhere::kind(&kind.text))
                        .map(String::from),
                );
            }
            None
        }
        (Some(kind_found), Some(name)) if !kind_found.named => {
            reports.tell(names::unwanted_name(kind, &name.text, name.span));
            reports.poison([kind.text.to_string()]);
            None
        }
        (Some(kind_found), None) if kind_found.named => {
            reports.tell(names::missing_name(kind));
            None
        }
        (Some(found), Some(name)) if name.text.is_empty() => {
            reports.tell(names::empty_name(found.word, name.span));
            None
        }
        (Some(found), Some(name)) => Some(build(found, name)),
        (Some(found), None) => Some(build(found, Word { text: Arc::from(""), span: kind.span })),
    }
}

struct Planner<'a> {
    ev: &'a Evaluator<'a>,
    plan: Plan,
    /// What each scope builds on, by name, until all names are known.
    bases: Vec<(Vec<Word>, Span)>,
    named: HashMap<Arc<str>, (usize, Span)>,
    /// Render names without case.
    folded: HashMap<String, (String, Span)>,
    /// The file read is the main one: its renders are drawn.
    main: bool,
}

impl Planner<'_> {
    fn scope(&mut self, label: String, span: Span, (bases, env): (&[Name], Option<&Env>)) -> usize {
        let bases = bases.iter().filter_map(|base| self.base(base, env?)).collect();
        self.bases.push((bases, span));
        self.plan.scopes.push(Scope { label, span, lineage: Vec::new(), actions: Vec::new() });
        self.plan.scopes.len() - 1
    }

    /// The name of a base: a let or a loop's variable may stand for it.
    fn base(&self, name: &Name, env: &Env) -> Option<Word> {
        if let [Piece::Words(word)] = &*name.pieces
            && env.find(word).is_some()
        {
            let path = vec![Word { text: word.as_str().into(), span: name.span }];
            let expr = Expr { kind: ExprKind::Name(path), span: name.span };
            let value = self.ev.eval(&expr, env);
            let text: Arc<str> = match &value.kind {
                ValueKind::Word(word) => word.text.clone(),
                ValueKind::Text { text, .. } => (**text).into(),
                ValueKind::Broken => return None,
                _ => {
                    let (expected, found) = ("the name of a setup or a render", value.described());
                    let what = format!("`{word}`");
                    self.ev.reports.tell(types::mismatch(&what, expected, &found, name.span));
                    return None;
                }
            };
            return Some(Word { text, span: name.span });
        }
        self.ev.name(name, env)
    }

    fn items(&mut self, items: &[Item], env: &Env, scope: usize, place: Place) {
        for item in items {
            match item {
                Item::Use(name) if place == Place::Body => {
                    let help =
                        "write `use` at the top of the file: it brings names, and draws nothing";
                    let told = syntax::misplaced("`use`", "inside braces", help, name.span);
                    self.ev.reports.tell(told);
                }
                Item::Use(_) | Item::Let(_) => {}
                Item::For(each) => self.each(each, env, scope, place),
                Item::Setup(setup) if place == Place::Top => self.setup(setup, env),
                Item::Render(render) if place == Place::Top => {
                    if self.main {
                        self.render(render, env);
                    }
                }
                Item::Setup(setup) => self.inner("a setup", setup.name.span),
                Item::Render(render) => self.inner("a render", render.name.span),
                Item::Without(without) if place == Place::Top => {
                    let help =
                        "take away what states it, or write `without` in a setup or a render";
                    let told =
                        syntax::misplaced("`without`", "at the top level", help, without.span);
                    self.ev.reports.tell(told);
                }
                Item::Without(without) => {
                    let kind = KINDS.iter().find(|kind| kind.word == &*without.kind.text);
                    if !kind.is_some_and(|kind| kind.named) {
                        let told = match kind {
                            Some(_) => names::without_kind(&without.kind),
                            None => names::unknown_kind(&without.kind),
                        };
                        self.ev.reports.tell(told);
                        continue;
                    }
                    let action =
                        action(self.ev, &without.kind, Some(&without.name), env, |kind, name| {
                            Action {
                                kind,
                                name,
                                parts: Vec::new(),
                                what: What::Remove,
                                path: without.span,
                                scope,
                            }
                        });
                    self.plan.scopes[scope].actions.extend(action.map(Rc::new));
                }
                Item::Set(set) => {
                    let action = statement(self.ev, set, env, scope);
                    self.plan.scopes[scope].actions.extend(action.map(Rc::new));
                }
            }
        }
    }

    fn inner(&self, what: &str, span: Span) {
        let help = "write it at the top level of the file, and build it on what it needs: `render a: b { … }`";
        self.ev.reports.tell(syntax::misplaced(what, "inside braces", help, span));
    }

    fn each(&mut self, each: &For, env: &Env, scope: usize, place: Place) {
        let head = self.ev.eval(&each.head, env);
        let all = match &head.kind {
            ValueKind::List(all) => all.clone(),
            ValueKind::Broken => return,
            ValueKind::Word(word) => {
                let told = names::unknown_value(&word.text, word.span, &env.all());
                return self.ev.reports.tell_unknown(&word.text, told);
            }
            _ => return self.ev.reports.tell(types::no_list(&head.described(), head.span)),
        };
        for value in all.iter() {
            if !self.ev.spend(each.span) {
                return;
            }
            let inner = self.ev.frame(Some(env));
            self.ev.define(&inner, &each.variable, Bound::Value(value.clone()));
            let inner = body(self.ev, &each.body, &inner);
            self.items(&each.body, &inner, scope, place);
        }
    }

    fn setup(&mut self, setup: &super::ast::Setup, env: &Env) {
        let label = format!("setup `{}`", setup.name.text);
        let scope = self.scope(label, setup.name.span, (&setup.bases, Some(env)));
        self.register(&setup.name, scope);
        let env = body(self.ev, &setup.body, env);
        self.items(&setup.body, &env, scope, Place::Body);
    }

    fn render(&mut self, said: &super::ast::Render, env: &Env) {
        let Some(name) = self.ev.name(&said.name, env) else { return };
        if self.plan.renders.len() == limits::RENDERS {
            return self.ev.reports.tell(render::too_many_renders(name.span));
        }
        let allowed = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.');
        let text = &name.text;
        if text.is_empty()
            || text.starts_with('.')
            || text.len() > 100
            || !text.chars().all(allowed)
        {
            return self.ev.reports.tell(render::bad_name(text, name.span));
        }
        let folded = text.to_ascii_lowercase();
        if let Some((first, span)) = self.folded.get(&folded) {
            return self.ev.reports.tell(render::duplicate(text, name.span, (first, *span)));
        }
        self.folded.insert(folded, (text.to_string(), name.span));
        let label = format!("render `{text}`");
        let scope = self.scope(label, name.span, (&said.bases, Some(env)));
        self.register(&name, scope);
        self.plan.renders.push((At::new(text.to_string(), name.span), scope));
        let env = body(self.ev, &said.body, env);
        self.items(&said.body, &env, scope, Place::Body);
    }

    fn register(&mut self, name: &Word, scope: usize) {
        match self.named.get(&name.text) {
            Some((_, first)) => {
                self.ev.reports.tell(names::defined_twice("setup or render", name, *first));
            }
            None => {
                self.named.insert(name.text.clone(), (scope, name.span));
            }
        }
    }

    /// Finds the bases of all scopes, and an order in which each comes after its bases.
    fn link(&mut self) {
        let mut wants: Vec<Vec<usize>> = Vec::new();
        for (i, (bases, _)) in self.bases.iter().enumerate() {
            let mut found = if i == TOP { Vec::new() } else { vec![TOP] };
            for base in bases {
                match self.named.get(&base.text) {
                    Some((scope, _)) => found.push(*scope),
                    None => {
                        self.ev.reports.tell_unknown_with(&base.text, base.span, || {
                            let others = self.named.iter().filter(|(_, (scope, _))| *scope != i);
                            let mut all: Vec<_> = others.map(|(name, _)| &**name).collect();
                            all.sort_unstable();
                            names::unknown_setup(base, &all)
                        });
                    }
                }
            }
            found.sort_unstable();
            found.dedup();
            wants.push(found);
        }
        for circle in order::circles(&wants) {
            let word = |i: &usize| {
                let (from, to) = (circle[*i], circle[(*i + 1) % circle.len()]);
                let named =
                    |base: &&Word| self.named.get(&base.text).is_some_and(|(s, _)| *s == to);
                self.bases[from].0.iter().find(named).cloned()
            };
            let words: Vec<_> = (0..circle.len()).filter_map(|i| word(&i)).collect();
            self.ev.reports.tell(render::circle(&words));
            circle.iter().for_each(|scope| wants[*scope] = vec![TOP]);
        }
        self.order(&wants);
    }

    fn order(&mut self, wants: &[Vec<usize>]) {
        let order = order::sorted(wants, &vec![false; wants.len()]);
        let mut rank = vec![0; wants.len()];
        order.iter().enumerate().for_each(|(at, scope)| rank[*scope] = at);
        let mut depth = vec![1; wants.len()];
        for &scope in &order {
            depth[scope] = 1 + wants[scope].iter().map(|base| depth[*base]).max().unwrap_or(0);
            let mut lineage = BTreeMap::from([(rank[scope], scope)]);
            if depth[scope] == limits::DEPTH + 1 {
                self.ev.reports.tell(types::too_deep(self.plan.scopes[scope].span));
            }
            let far = depth[scope] > limits::DEPTH;
            for base in wants[scope].iter().filter(|base| !far || **base == TOP) {
                let all = &self.plan.scopes[*base].lineage;
                lineage.extend(all.iter().map(|scope| (rank[*scope], *scope)));
            }
            self.plan.scopes[scope].lineage = lineage.into_values().collect();
        }
        self.plan.rank = rank;
    }
}
