//! Makes the files of models/: the Cornell box from the published measurements, an elephant, a
//! ball and a board of wood from nothing, and the bunny from the scan.
//!
//! `cargo run --release --example models -- models [StanfordBunny.ply]`
//!
//! Without a scan all but the bunny is written.

mod bunny;
mod cornell;
mod elephant;
mod field;
mod mesh;
mod nets;
mod obj;
mod ply;
mod sculpt;
mod simplify;
mod sphere;
mod wood;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let result = match arguments.as_slice() {
        [folder] => write_own(folder),
        [folder, scan] => bunny_files(scan).and_then(|bunny| {
            write_own(folder)?;
            bunny.iter().try_for_each(|(name, text)| write(&folder.join(name), text.as_bytes()))
        }),
        _ => Err("usage: cargo run --release --example models -- FOLDER [BUNNY.ply]".into()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// Writes those that need no scan.
fn write_own(folder: &Path) -> Result<(), String> {
    for (name, text) in [cornell::files(), elephant::files(), sphere::files()].concat() {
        write(&folder.join(name), text.as_bytes())?;
    }
    let wood = wood::png().map_err(|error| error.to_string())?;
    write(&folder.join("wood.png"), &wood)
}

fn bunny_files(scan: &Path) -> Result<Vec<(&'static str, String)>, String> {
    let in_file = |error: String| format!("{}: {error}", scan.display());
    let bytes = std::fs::read(scan).map_err(|error| in_file(error.to_string()))?;
    let surface = ply::read(&bytes).map_err(in_file)?;
    Ok(bunny::files(&surface))
}

/// Writes a file, and tells which.
fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    std::fs::write(path, bytes).map_err(|error| format!("{}: {error}", path.display()))?;
    println!("{} ({} bytes)", path.display(), bytes.len());
    Ok(())
}
