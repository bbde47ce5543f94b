//! Text → Scene. Knows words, not light; no disk: texts are handed in through a [`Library`].

mod arithmetic;
mod ast;
mod check;
mod comments;
mod data_file;
mod defaults;
mod difference;
mod errors;
mod eval;
mod faults;
pub mod format;
mod functions;
mod import;
mod limits;
mod lower;
mod names;
mod order;
pub mod outline;
mod parse;
mod ranges;
mod report;
mod resolve;
mod scan;
mod sets;
mod shelves;
mod spectra;
mod unused;
mod value;
pub mod words;

use std::cell::RefCell;
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::diag::{Diagnostic, FileId, Sources};
use crate::scene::schema::Kind;
use crate::scene::{At, KINDS, Scene, elsewhere};

pub use comments::comments;
use data_file::DataFiles;
use difference::Composer;
pub use errors::with_article;
use eval::Evaluator;
use resolve::{Plan, TOP};

/// Where the texts of scene files come from.
pub trait Library {
    /// The text of a scene file, or why it cannot be had (one clause).
    fn read(&self, path: &Path) -> Result<String, String>;

    /// One and the same for every path to a file.
    fn identity(&self, path: &Path) -> PathBuf;
}

/// What a scene file says.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The renders without a fault, in the order of the text.
    pub renders: Vec<Render>,
    /// The names of the setups of all files: differences that are not drawn by themselves.
    pub setups: Vec<String>,
    /// All errors of all files in one run, each once.
    pub diagnostics: Vec<Diagnostic>,
    /// What the files declare.
    pub outline: outline::Outline,
}

/// One picture that is asked for.
#[derive(Clone, Debug)]
pub struct Render {
    /// Its name: a file name without folder and ending.
    pub name: At<String>,
    /// Everything it shows.
    pub scene: Arc<Scene>,
}

/// Compiles a scene file. `path`: the main file; its folder is the base of relative names, its
/// stem the name of the single render of a file without `render`. `sets`: the arguments of
/// `--set`, each `path=value`, checked as if written last in the renders named in `only`, or in
/// all of them where `only` is empty.
pub fn compile(
    path: &Path,
    text: &str,
    sets: &[String],
    only: &[String],
    library: &dyn Library,
    sources: &mut Sources,
) -> Compiled {
    let mut ev = Evaluator::default();
    let units = import::gather(path, text, library, sources, &mut ev);
    let main = units[0].id;
    let sets = sets::read(sets, main, path, &mut ev, units[0].tree.unit, sources);
    ev.data = DataFiles::new(library, sources);
    let mut plan = resolve::plan(&ev, &units);
    implicit_render(&mut plan, path, &units[0].tree.items, &units[0].tree.broken_words);
    let outline = outline::outline(&units, &sets);
    let sets = resolve::sets(&ev, &mut plan, sets);
    let readable = ev.reports.errors() == 0;
    let (lowered, missing) = check_renders(&ev, &plan, &sets, only, main);
    tell_missing(&ev, &plan, &missing);
    unused::check(&ev, &plan);
    let renders = if readable { lowered } else { Vec::new() };
    let reports = std::mem::take(&mut ev.reports);
    std::mem::take(&mut ev.data).hand_over(sources);
    let items = units.iter().flat_map(|unit| &unit.tree.items);
    let setups = items.filter_map(|item| match item {
        ast::Item::Setup(setup) => Some(setup.name.text.to_string()),
        _ => None,
    });
    Compiled { renders, setups: setups.collect(), diagnostics: reports.finish(), outline }
}

/// A file without `render` is one render called like the file, unless all it does is to define
/// what others use.
fn implicit_render(plan: &mut Plan, path: &Path, items: &[ast::Item], broken: &HashSet<String>) {
    fn asks(items: &[ast::Item]) -> bool {
        items.iter().any(|item| match item {
            ast::Item::Render(_) => true,
            ast::Item::For(each) => asks(&each.body),
            _ => false,
        })
    }
    let referred =
        |word: &str| KINDS.iter().any(|kind| lower::references(&kind.ty).contains(&word));
    let draws = plan.scopes[TOP].actions.iter().any(|action| !referred(action.kind.word));
    let defines = items.iter().any(|item| !matches!(item, ast::Item::Use(_) | ast::Item::For(_)));
    let asked = asks(items) || broken.contains("render");
    if asked || (defines && !draws) {
        return;
    }
    let allowed = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.');
    let stem = path.file_stem().map_or("scene".into(), |stem| stem.to_string_lossy());
    let name: String = stem.chars().map(|c| if allowed(c) { c } else { '_' }).collect();
    plan.renders.push((At::new(name, plan.scopes[TOP].span), TOP));
}

/// A kind that a render lacks: which render, and the kind.
type Missing = Vec<(usize, &'static Kind)>;

/// Checks every render, and what no render uses.
fn check_renders(
    ev: &Evaluator,
    plan: &Plan,
    sets: &[std::rc::Rc<resolve::Action>],
    only: &[String],
    main: FileId,
) -> (Vec<Render>, Missing) {
    let mut composer = Composer { ev, plan, sets, lenient: false, removed: RefCell::default() };
    let mut used = HashSet::new();
    let mut renders = Vec::new();
    let mut missing = Vec::new();
    for (i, (name, scope)) in plan.renders.iter().enumerate() {
        if ev.spent() {
            break;
        }
        let before = ev.reports.errors();
        composer.sets = if only.is_empty() || only.contains(&name.value) { sets } else { &[] };
        let declared = composer.compose(*scope, &mut used);
        let lowered = lower::lower(ev, (&declared, &composer.removed.borrow()), name.span, None);
        missing.extend(lowered.missing.into_iter().map(|kind| (i, kind)));
        if let Some(scene) = lowered.scene.filter(|_| ev.reports.errors() == before) {
            renders.push(Render { name: name.clone(), scene: Arc::new(scene) });
        }
    }
    composer.lenient = true;
    for (i, scope) in plan.scopes.iter().enumerate() {
        if !ev.spent() && scope.actions.iter().any(|action| !used.contains(&action.path)) {
            let declared = composer.compose(i, &mut HashSet::new());
            lower::lower(ev, (&declared, &composer.removed.borrow()), scope.span, Some(main));
        }
    }
    (renders, missing)
}

/// Tells of kinds that must be stated: once, if no render has one.
fn tell_missing(ev: &Evaluator, plan: &Plan, missing: &Missing) {
    for kind in KINDS {
        let lacking: Vec<_> =
            missing.iter().filter(|(_, k)| k.word == kind.word).map(|(i, _)| *i).collect();
        let all = lacking.len() == plan.renders.len();
        let example = elsewhere::usual(kind.word).unwrap_or("…");
        for i in lacking {
            let (name, _) = &plan.renders[i];
            let span = if all { plan.scopes[TOP].span } else { name.span };
            let told = errors::render::missing_kind(kind.word, name, span, all, example);
            ev.reports.tell_unknown(kind.word, told);
            if all {
                break;
            }
        }
    }
}
