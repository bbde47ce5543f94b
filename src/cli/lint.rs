//! `scn lint`: everything that can be found wrong without rendering.

use std::path::Path;

use super::log::shown;
use super::options::{Form, Lint};
use super::words::counted;
use super::{End, scene_file, terminal, whose};
use crate::diag::{self, Diagnostic, Sources};
use crate::load::Loader;
use crate::math::NoProgress;
use crate::prepare;

pub fn run(options: &Lint) -> End {
    let mut sources = Sources::new();
    let mut all = Vec::new();
    let mut unread = false;
    let look = terminal::stdout_look();
    for file in &options.files {
        let Some((renders, found)) = check(file, &options.set, &mut sources) else {
            unread = true;
            continue;
        };
        if options.format == Form::Human {
            let subject = shown(file);
            terminal::say(&if found.is_empty() {
                format!("{subject}: {}, no faults\n", counted(renders as u64, "render"))
            } else {
                diag::print::report(&found, &sources, &subject, look)
            });
        }
        all.extend(found);
    }
    let (errors, _) = diag::count(&all);
    if options.format == Form::Json {
        let all = diag::in_order(all, &sources);
        terminal::say(&format!("{:#}\n", diag::json::report(&all, &sources)));
    }
    match (unread, errors) {
        (true, _) => End::NotDone,
        (false, 0) => End::Well,
        (false, _) => End::SceneErrors,
    }
}

/// The number of renders of a file, and its faults. None if it could not be read.
fn check(file: &Path, sets: &[String], sources: &mut Sources) -> Option<(usize, Vec<Diagnostic>)> {
    let compiled = scene_file::compile(file, sets, &[], sources)?;
    let mut found = compiled.diagnostics;
    let mut loader = Loader::new(&NoProgress);
    let mut checked = Vec::new();
    for render in &compiled.renders {
        let (stage, faults) = loader.stage(&render.scene, sources);
        found.extend(faults);
        if let Some(stage) = stage {
            let faults = prepare::check(&stage, &prepare::Settings::default());
            checked.push((render.name.value.clone(), faults));
        }
    }
    found.extend(whose::told(checked));
    Some((compiled.renders.len(), diag::in_order(found, sources)))
}
