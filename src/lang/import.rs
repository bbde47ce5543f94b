//! `use`: the files of a scene, each read once.

use std::path::{Path, PathBuf};

use super::ast::{File, Item, Word};
use super::errors::import;
use super::eval::{Evaluator, FileFacts};
use super::{Library, limits, parse};
use crate::diag::{Code, FileId, Sources, Span};

/// A file of the scene.
pub struct Unit {
    /// Its number.
    pub id: FileId,
    /// What it says.
    pub tree: File,
    /// The files it uses, directly or through others, itself included.
    pub reach: Vec<usize>,
    path: PathBuf,
    identity: PathBuf,
    uses: Vec<(usize, Word)>,
}

/// Reads the main file and all it uses; the main file is the first.
pub fn gather(
    path: &Path,
    text: &str,
    library: &dyn Library,
    sources: &mut Sources,
    ev: &mut Evaluator,
) -> Vec<Unit> {
    let identity = library.identity(path);
    let mut units = vec![read(path.to_path_buf(), identity, text, sources, ev)];
    let mut bytes = text.len();
    let mut at = 0;
    'all: while at < units.len() {
        let wanted = units[at].tree.items.iter().filter_map(|item| match item {
            Item::Use(name) => Some(name.clone()),
            _ => None,
        });
        for name in wanted.collect::<Vec<_>>() {
            let folder = units[at].path.parent().unwrap_or(Path::new("")).to_path_buf();
            let path = folder.join(&*name.text);
            let identity = library.identity(&path);
            let known = units.iter().position(|unit| unit.identity == identity);
            if let Some(known) = known {
                units[at].uses.push((known, name));
                continue;
            }
            if units.len() == limits::FILES {
                ev.reports.tell(import::too_many(name.span));
                ev.reports.file_is_missing();
                break 'all;
            }
            match library.read(&path) {
                Ok(text) if bytes + text.len() > limits::ALL_BYTES => {
                    ev.reports.tell(import::too_much(&name.text, name.span));
                    ev.reports.file_is_missing();
                }
                Ok(text) => {
                    bytes += text.len();
                    units.push(read(path, identity, &text, sources, ev));
                    let new = units.len() - 1;
                    units[at].uses.push((new, name));
                }
                Err(cause) => {
                    let shown = path.to_string_lossy();
                    ev.reports.tell(import::unreadable(&name.text, &shown, &cause, name.span));
                    ev.reports.file_is_missing();
                }
            }
        }
        at += 1;
    }
    tell_circles(&units, ev);
    for i in 0..units.len() {
        units[i].reach = reach(&units, i);
    }
    units
}

fn read(
    path: PathBuf,
    identity: PathBuf,
    text: &str,
    sources: &mut Sources,
    ev: &mut Evaluator,
) -> Unit {
    let id = sources.add_file(&path, text);
    let parsed = parse::file(text, id);
    // A unit that could not be read is not missing as well.
    let unreadable = parsed.faults.kept.iter().any(|told| told.code == Code::SYNTAX_FILE_UNIT);
    ev.reports.tell_text(id, parsed.faults);
    ev.reports.mute(parsed.muted);
    ev.reports.poison(parsed.tree.broken_words.iter().cloned());
    let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
    let first_line = parsed.tree.first_line.filter(|_| !unreadable);
    let text = sources.get(id).text.clone();
    ev.add_file(id, FileFacts { folder, text, unit: parsed.tree.unit, first_line });
    Unit { id, tree: parsed.tree, reach: Vec::new(), path, identity, uses: Vec::new() }
}

fn reach(units: &[Unit], start: usize) -> Vec<usize> {
    let mut found = vec![start];
    let mut at = 0;
    while at < found.len() {
        for (next, _) in &units[found[at]].uses {
            if !found.contains(next) {
                found.push(*next);
            }
        }
        at += 1;
    }
    found
}

fn tell_circles(units: &[Unit], ev: &Evaluator) {
    let wants: Vec<Vec<usize>> =
        units.iter().map(|unit| unit.uses.iter().map(|(to, _)| *to).collect()).collect();
    for circle in super::order::circles(&wants) {
        let place = |i: usize| -> (String, Span) {
            let (from, to) = (circle[i], circle[(i + 1) % circle.len()]);
            let name = &units[from].uses.iter().find(|(used, _)| *used == to).expect("a use").1;
            (name.text.to_string(), name.span)
        };
        ev.reports.tell(import::circle(&(0..circle.len()).map(place).collect::<Vec<_>>()));
    }
}
