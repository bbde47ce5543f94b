//! Everything that can be found in a scene file without rendering.

use std::path::Path;

use super::{Disk, whose};
use crate::diag::{self, Diagnostic, FileId, Level, Sources};
use crate::lang::outline::Outline;
use crate::lint::{self, Seen, Shot, Text};
use crate::load::{Loader, Stage};
use crate::math::NoProgress;
use crate::scene::At;
use crate::{lang, prepare};

/// What was found in a scene file.
pub struct Checked {
    /// The text of the file itself.
    pub main: FileId,
    /// Errors and warnings, in the order of the texts, without those that comments allow.
    pub found: Vec<Diagnostic>,
}

/// A render whose files were read.
pub struct Staged<'a> {
    /// Its name.
    pub name: &'a At<String>,
    /// What it shows.
    pub stage: &'a Stage,
    /// Whether the scene's limits end it, and not those of the command line in their place.
    pub own_limits: bool,
    /// What was found wrong with it alone.
    pub faults: Vec<Diagnostic>,
}

/// How the renders that are looked at differ from those of the file.
#[derive(Clone, Copy)]
pub struct Asked {
    /// They are changed by `--set`. Rules look at them as changed; a comment that allows what is
    /// not there any more may be right in the file.
    pub changed: bool,
    /// They are not all: what counts in all of them cannot be told.
    pub part: bool,
}

/// Checks the text of a scene file: what the language, the files it names, and the rules of the
/// linter have to say. `sets` are arguments of `--set`.
pub fn check(path: &Path, text: &str, sets: &[String], sources: &mut Sources) -> Checked {
    let compiled = lang::compile(path, text, sets, &[], &Disk, sources);
    let mut found = compiled.diagnostics;
    let mut loader = Loader::new(&NoProgress);
    let mut stages = Vec::new();
    for render in &compiled.renders {
        let (stage, faults) = loader.stage(&render.scene, sources);
        found.extend(faults);
        stages.extend(stage.map(|stage| (&render.name, stage)));
    }
    let staged = stages.iter().map(|(name, stage)| Staged {
        name,
        stage,
        own_limits: true,
        faults: prepare::check(stage, &prepare::Settings::default()),
    });
    let asked = Asked { changed: !sets.is_empty(), part: false };
    let found = judged(found, staged.collect(), &compiled.outline, sources, asked);
    let main = compiled.outline.files.first().copied().unwrap_or(FileId(0));
    Checked { main, found: diag::in_order(found, sources) }
}

/// What was `found` so far and in each render, and what the rules find where there is no error: a
/// rule that looks at half a scene tells consequences.
pub fn judged(
    mut found: Vec<Diagnostic>,
    mut renders: Vec<Staged>,
    outline: &Outline,
    sources: &Sources,
    asked: Asked,
) -> Vec<Diagnostic> {
    let faults = renders.iter().flat_map(|render| &render.faults);
    let whole = found.iter().chain(faults).all(|fault| fault.level < Level::Error);
    let draws = !renders.is_empty();
    let as_stated = !asked.changed && !asked.part && renders.iter().all(|render| render.own_limits);
    if whole {
        let mut shots = Vec::new();
        for render in &mut renders {
            let shot = Shot::new(render.name.clone(), render.stage, render.own_limits);
            render.faults.extend(lint::of_render(&shot));
            shots.push(shot);
        }
        found.extend(lint::of_file(&Text { outline, draws }, &shots, !asked.part));
    }
    let by_name = renders.into_iter().map(|render| (render.name.value.clone(), render.faults));
    found.extend(whose::told(by_name.collect()));
    let seen = Seen { whole: whole && as_stated, renders: draws };
    lint::allowed(found, outline, sources, seen)
}
