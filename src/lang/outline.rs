//! What the files of a scene declare, and which of it is mentioned anywhere: by words alone,
//! before any has a meaning. For the linter, and whoever asks about names rather than light.

use std::collections::HashSet;

use super::ast::{Expr, ExprKind, File, Item, Let, Name, Piece, Set, Word};
use super::import::Unit;
use super::names::mentioned;
use crate::diag::{FileId, Span};

/// The files of a scene, and their declarations in the order of the texts.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    /// The texts, the main file first.
    pub files: Vec<FileId>,
    /// What they declare.
    pub declared: Vec<Declared>,
    /// Whether the main file has a `render`, even in a loop that makes none.
    pub asks: bool,
}

/// A declaration whose name is plain words.
#[derive(Clone, Debug, PartialEq)]
pub struct Declared {
    /// What it is.
    pub what: What,
    /// What it is called.
    pub name: String,
    /// Where its name stands.
    pub at: Span,
    /// From its name, or the word of its kind, to the end of what is said.
    pub whole: Span,
    /// Whether it stands inside braces.
    pub inside: bool,
    /// Whether some text of the scene mentions the name where it could mean this.
    pub used: bool,
}

/// What a declaration is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// A value named by `let`.
    Let,
    /// A function named by `let`.
    Function,
    /// A parameter of a function.
    Parameter,
    /// The variable of a loop.
    Variable,
    /// A setup.
    Setup,
    /// A render.
    Render,
    /// An item of a kind that has names, by the kind's word.
    Kind(&'static str),
}

/// Reads the trees of all files, the first of which is the main one, and the arguments of `--set`.
pub fn outline(units: &[Unit], sets: &[Set]) -> Outline {
    let mut mentions = Mentions::default();
    sets.iter().for_each(|set| mentions.set(set));
    units.iter().for_each(|unit| mentions.items(&unit.tree.items));
    let mut found = Outline {
        files: units.iter().map(|unit| unit.id).collect(),
        asks: units.first().is_some_and(|unit| asks(&unit.tree)),
        ..Outline::default()
    };
    for unit in units {
        declare(&unit.tree.items, false, &mentions, &mut found.declared);
    }
    found
}

fn asks(file: &File) -> bool {
    fn any(items: &[Item]) -> bool {
        items.iter().any(|item| match item {
            Item::Render(_) => true,
            Item::For(each) => any(&each.body),
            _ => false,
        })
    }
    any(&file.items) || file.broken_words.iter().any(|word| word == "render")
}

/// Names that are mentioned.
#[derive(Default)]
struct Mentions {
    /// In values, called or not, and in the names of bases.
    words: HashSet<String>,
    /// As bases of setups and renders.
    bases: HashSet<String>,
    /// How names with values in them begin, of strings and of bases.
    begun: HashSet<String>,
}

impl Mentions {
    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Use(_) => {}
                Item::Let(said) => self.value(&said.value),
                Item::For(each) => {
                    self.value(&each.head);
                    self.items(&each.body);
                }
                Item::Setup(setup) => {
                    setup.bases.iter().for_each(|base| self.base(base));
                    self.items(&setup.body);
                }
                Item::Render(render) => {
                    self.name(&render.name);
                    render.bases.iter().for_each(|base| self.base(base));
                    self.items(&render.body);
                }
                Item::Without(without) => self.name(&without.name),
                Item::Set(set) => self.set(set),
            }
        }
    }

    fn set(&mut self, set: &Set) {
        set.name.iter().for_each(|name| self.name(name));
        self.value(&set.value);
    }

    fn value(&mut self, value: &Expr) {
        let mut found = Vec::new();
        mentioned(value, &mut found);
        self.words.extend(found.into_iter().map(|(word, _)| word.text.to_string()));
        strings(value, &mut |pieces| match pieces {
            [] => {}
            [Piece::Words(words)] => {
                self.words.insert(words.clone());
            }
            [Piece::Words(words), ..] => {
                self.begun.insert(words.clone());
            }
            [Piece::Value(_), ..] => {
                self.begun.insert(String::new());
            }
        });
    }

    /// Values in a name.
    fn name(&mut self, name: &Name) {
        for piece in &*name.pieces {
            if let Piece::Value(value) = piece {
                self.value(value);
            }
        }
    }

    fn base(&mut self, name: &Name) {
        self.name(name);
        match &*name.pieces {
            [Piece::Words(words)] => {
                // A let or a loop's variable may stand for it.
                self.words.insert(words.clone());
                self.bases.insert(words.clone());
            }
            [Piece::Words(words), ..] => {
                self.begun.insert(words.clone());
            }
            _ => {
                self.begun.insert(String::new());
            }
        }
    }

    fn has(&self, name: &str) -> bool {
        let mut beginnings = name.char_indices().map(|(at, _)| &name[..at]).chain([name]);
        self.words.contains(name)
            || !self.begun.is_empty() && beginnings.any(|begun| self.begun.contains(begun))
    }
}

/// Every string in a value.
fn strings(value: &Expr, found: &mut dyn FnMut(&[Piece])) {
    let mut records = Vec::new();
    match &value.kind {
        ExprKind::Text(pieces) => found(pieces),
        ExprKind::Vector(all) | ExprKind::List(all) => {
            all.iter().for_each(|value| strings(value, found));
        }
        ExprKind::Call { arguments, .. } => {
            arguments.iter().for_each(|value| strings(value, found));
        }
        ExprKind::Record(record) => records.push(&**record),
        ExprKind::With { base, changes } => {
            strings(base, found);
            records.extend(changes.iter());
        }
        _ => {}
    }
    for entry in records.into_iter().flat_map(|record| &record.entries) {
        strings(&entry.value, found);
    }
}

fn declare(items: &[Item], inside: bool, mentions: &Mentions, found: &mut Vec<Declared>) {
    let plain = |name: &Name| match &*name.pieces {
        [Piece::Words(words)] => Some(words.clone()),
        _ => None,
    };
    for item in items {
        match item {
            Item::Use(_) | Item::Without(_) => {}
            Item::Let(said) => define(said, inside, mentions, found),
            Item::For(each) => {
                let mut own = Mentions::default();
                own.items(&each.body);
                let used = own.has(&each.variable.text);
                found.push(declared(What::Variable, &each.variable, each.span, used));
                declare(&each.body, inside, mentions, found);
            }
            Item::Setup(setup) => {
                let used = mentions.has(&setup.name.text);
                found.push(declared(What::Setup, &setup.name, setup.name.span, used));
                declare(&setup.body, true, mentions, found);
            }
            Item::Render(render) => {
                if let Some(name) = plain(&render.name) {
                    let word = Word { text: name.as_str().into(), span: render.name.span };
                    let used = mentions.bases.contains(&name);
                    found.push(declared(What::Render, &word, word.span, used));
                }
                declare(&render.body, true, mentions, found);
            }
            Item::Set(set) => {
                let kind = crate::scene::KINDS.iter().find(|kind| kind.word == &*set.kind.text);
                let name = set.name.as_ref().filter(|_| set.parts.is_empty());
                let (Some(kind), Some(name)) = (kind, name) else { continue };
                if let Some(text) = plain(name) {
                    let word = Word { text: text.as_str().into(), span: name.span };
                    let whole = set.path.to(set.value.span);
                    let used = mentions.has(&text);
                    let what = What::Kind(kind.word);
                    found.push(Declared { inside, ..declared(what, &word, whole, used) });
                }
            }
        }
    }
}

fn define(said: &Let, inside: bool, mentions: &Mentions, found: &mut Vec<Declared>) {
    let what = if said.params.is_some() { What::Function } else { What::Let };
    let whole = said.name.span.to(said.value.span);
    let used = mentions.words.contains(&*said.name.text);
    found.push(Declared { inside, ..declared(what, &said.name, whole, used) });
    let mut own = Mentions::default();
    own.value(&said.value);
    for parameter in said.params.iter().flatten() {
        let used = own.words.contains(&*parameter.text);
        found.push(declared(What::Parameter, parameter, parameter.span, used));
    }
}

fn declared(what: What, name: &Word, whole: Span, used: bool) -> Declared {
    let (name, at) = (name.text.to_string(), name.span);
    Declared { what, name, at, whole, inside: false, used }
}
