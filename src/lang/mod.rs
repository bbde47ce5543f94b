//! Text → Scene. Knows words, not light; no disk: texts are handed in through a [`Library`].

use std::path::Path;
use std::sync::Arc;

use crate::diag::{Diagnostic, Sources};
use crate::scene::{At, Scene};

/// Where the texts of scene files come from.
pub trait Library {
    /// The text of a scene file, or why it cannot be had (one clause).
    fn read(&self, path: &Path) -> Result<String, String>;
}

/// What a scene file says.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The renders without a fault, in the order of the text.
    pub renders: Vec<Render>,
    /// All errors of all files in one run, each once.
    pub diagnostics: Vec<Diagnostic>,
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
/// `--set`, each `path=value`, checked as if written in the file.
pub fn compile(
    path: &Path,
    text: &str,
    sets: &[String],
    library: &dyn Library,
    sources: &mut Sources,
) -> Compiled {
    let _ = (sets, library);
    sources.add(path.to_string_lossy(), text);
    Compiled { renders: Vec::new(), diagnostics: Vec::new() }
}
