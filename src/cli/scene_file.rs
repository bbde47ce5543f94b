//! From the scene file's name to its renders, with the texts it imports.

use std::io::Read;
use std::path::{Path, PathBuf};

use super::log::shown;
use super::{End, terminal};
use crate::cli::words::NAMES;
use crate::diag::near;
use crate::diag::words::{did_you_mean, few};
use crate::diag::{self, Diagnostic, Level, Sources};
use crate::files;
use crate::lang::{self, Compiled, Library};

/// Scene files from the disk.
pub struct Disk;

impl Library for Disk {
    fn read(&self, path: &Path) -> Result<String, String> {
        files::text::read(path).map_err(|failure| failure.to_string())
    }

    fn identity(&self, path: &Path) -> PathBuf {
        files::regular::identity(path)
    }
}

/// Reads and compiles a scene file, with the arguments of `--set` and of `--only`. None if it
/// could not be read; why has been told.
pub fn compile(
    path: &Path,
    sets: &[String],
    only: &[String],
    sources: &mut Sources,
) -> Option<Compiled> {
    Some(lang::compile(path, &read(path)?, sets, only, &Disk, sources))
}

/// The text of a scene file. None if it could not be read; why has been told.
pub fn read(path: &Path) -> Option<String> {
    files::text::read(path).map_err(|failure| terminal::fail(&unread(path, &failure))).ok()
}

/// The renders that --only names, or all of them, in the order of the file; or why there are none.
pub fn chosen(
    renders: Vec<lang::Render>,
    setups: &[String],
    only: &[String],
    file: &Path,
) -> Result<Vec<lang::Render>, String> {
    if renders.is_empty() {
        let why = "asks for no picture: it only defines things for others";
        return Err(format!("`{}` {why}", shown(file)));
    }
    let names: Vec<String> = renders.iter().map(|render| render.name.value.clone()).collect();
    let all: Vec<&str> = names.iter().map(String::as_str).collect();
    if let Some(unknown) = only.iter().find(|name| !names.contains(name)) {
        let mut text = format!("{} has no render `{unknown}`", shown(file));
        let nearest = near(unknown, all.iter().copied());
        if setups.contains(unknown) {
            let example = format!("render {unknown}_alone: {unknown} {{}}");
            text.push_str(&format!(
                "; `{unknown}` is a setup, which is not drawn by itself: a render builds on it, as \
                 in `{example}`"
            ));
        } else if !nearest.is_empty() {
            text.push_str(&format!("; {}", did_you_mean(nearest)));
        }
        text.push_str(&format!("\n  it has: {}", few(all, NAMES)));
        return Err(text);
    }
    let wanted = |render: &lang::Render| only.is_empty() || only.contains(&render.name.value);
    Ok(renders.into_iter().filter(wanted).collect())
}

/// Tells errors; warnings are `scn lint`'s.
pub fn no_errors(found: Vec<Diagnostic>, sources: &Sources, scene: &str) -> Result<(), End> {
    let errors: Vec<_> = found.into_iter().filter(|fault| fault.level == Level::Error).collect();
    if errors.is_empty() {
        return Ok(());
    }
    let errors = diag::in_order(errors, sources);
    terminal::tell(&diag::print::report(&errors, sources, scene, terminal::stderr_look()));
    Err(End::SceneErrors)
}

/// The name that stands for stdin and stdout.
pub const STREAMS: &str = "-";

/// The text that comes by stdin.
pub fn from_stdin() -> Result<String, files::Failure> {
    let limit = files::text::LIMIT;
    let mut bytes = Vec::new();
    std::io::stdin().lock().take(limit + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > limit {
        return Err(files::Failure::new("holds more than 8 MB, the most that is read"));
    }
    files::text::decode(bytes)
}

/// Why a scene file could not be read, with what was probably meant.
pub fn unread(path: &Path, failure: &files::Failure) -> String {
    let mut text = format!("the scene file `{}` {failure}", shown(path));
    if let Ok(whole) = std::path::absolute(path)
        && whole != path
    {
        text.push_str(&format!("\n  looked for: {}", shown(&whole)));
    }
    // The ending is easily forgotten.
    let mut longer = PathBuf::from(path).into_os_string();
    longer.push(".scn");
    if files::text::read(Path::new(&longer)).is_ok() {
        let longer = longer.to_string_lossy();
        text.push_str(&format!("\n  {}", did_you_mean([&*longer])));
    }
    text
}
