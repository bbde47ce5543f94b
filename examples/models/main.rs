//! Makes the files of models/: the Cornell box from the published measurements, and the bunny
//! from the scan.
//!
//! `cargo run --release --example models -- models [StanfordBunny.ply]`
//!
//! Without a scan only the Cornell files are written.

mod bunny;
mod cornell;
mod obj;
mod ply;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let result = match arguments.as_slice() {
        [folder] => write(folder, &cornell::files()),
        [folder, scan] => bunny_files(scan).and_then(|bunny| {
            write(folder, &cornell::files())?;
            write(folder, &bunny)
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

fn bunny_files(scan: &Path) -> Result<Vec<(&'static str, String)>, String> {
    let in_file = |error: String| format!("{}: {error}", scan.display());
    let bytes = std::fs::read(scan).map_err(|error| in_file(error.to_string()))?;
    let surface = ply::read(&bytes).map_err(in_file)?;
    Ok(bunny::files(&surface))
}

/// Writes files by name into a folder, and tells which.
fn write(folder: &Path, files: &[(&str, String)]) -> Result<(), String> {
    for (name, text) in files {
        let path = folder.join(name);
        std::fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
        println!("{} ({} bytes)", path.display(), text.len());
    }
    Ok(())
}
