//! Scene files as the command reads them: compiled, loaded, prepared, rendered.
//! Each test uses a part of this.

#![allow(dead_code)]

use std::path::{Path, PathBuf};

use scn::cli::Disk;
use scn::diag::{Diagnostic, Level, Sources, print};
use scn::lang;
use scn::load::{Loader, Stage};
use scn::math::{NoProgress, Picture};
use scn::prepare::{self, Prepared};
use scn::run::{self, Begin, Outcome, Watch};

/// A render of a scene file, with all that it needs read.
pub struct Shot {
    /// Its name.
    pub name: String,
    /// What it shows, with its files.
    pub stage: Stage,
}

/// A file of the project.
pub fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// The renders of a text that stands in `path`, each compiled, loaded and checked; or the report
/// of its faults, as the command prints it. `sets` are arguments of `--set`.
pub fn open_text(path: &Path, text: &str, sets: &[String]) -> Result<Vec<Shot>, String> {
    let mut sources = Sources::new();
    let compiled = lang::compile(path, text, sets, &[], &Disk, &mut sources);
    let mut faults = compiled.diagnostics;
    let mut loader = Loader::new(&NoProgress);
    let mut shots = Vec::new();
    for render in compiled.renders {
        let (stage, found) = loader.stage(&render.scene, &mut sources);
        faults.extend(found);
        if let Some(stage) = stage {
            faults.extend(prepare::check(&stage, &prepare::Settings::default()));
            shots.push(Shot { name: render.name.value.clone(), stage });
        }
    }
    if faults.is_empty() { Ok(shots) } else { Err(report(&faults, &sources, path)) }
}

fn report(faults: &[Diagnostic], sources: &Sources, path: &Path) -> String {
    let subject = path.file_name().unwrap_or_default().to_string_lossy();
    print::report(faults, sources, &subject, print::Look::PLAIN)
}

/// The renders of a scene file of the project, which has no faults.
pub fn open(name: &str) -> Vec<Shot> {
    open_with(name, &[])
}

/// The same with arguments of `--set`.
pub fn open_with(name: &str, sets: &[String]) -> Vec<Shot> {
    let path = path(name);
    let text = std::fs::read_to_string(&path).unwrap();
    open_text(&path, &text, sets).unwrap_or_else(|report| panic!("{report}"))
}

impl Shot {
    /// What it says of itself.
    pub fn caption(&self) -> &str {
        &self.stage.scene.caption.0
    }

    /// The world, with a film of `scale` times its size.
    pub fn prepare(&self, scale: f64) -> Prepared {
        let settings = prepare::Settings { scale, ..prepare::Settings::default() };
        let (prepared, faults) = prepare::prepare(&self.stage, &settings, &NoProgress);
        let errors = faults.iter().filter(|fault| fault.level == Level::Error);
        assert_eq!(errors.count(), 0, "{}: {faults:?}", self.name);
        prepared.unwrap()
    }

    /// A picture of as many samples as the scene says.
    pub fn picture(&self, prepared: &Prepared, seed: u64) -> Picture {
        let samples = self.stage.scene.stop.most_samples().expect("a limit of samples");
        self.outcome(prepared, seed, samples).picture
    }

    /// What so many samples come to.
    pub fn outcome(&self, prepared: &Prepared, seed: u64, samples: u64) -> Outcome {
        let settings = run::Settings::samples(seed, samples);
        let Prepared { world, integrator, .. } = prepared;
        let outcome = run::render(world, integrator, &settings, Begin::new(world), &Untimed);
        assert!(outcome.invalid.is_none(), "{}: samples that are not finite", self.name);
        outcome
    }
}

/// Nobody watches, and no time passes.
struct Untimed;

impl Watch for Untimed {
    fn cancelled(&self) -> bool {
        false
    }

    fn now(&self) -> f64 {
        0.0
    }

    fn progress(&self, _done: u64, _total: u64) {}
}
