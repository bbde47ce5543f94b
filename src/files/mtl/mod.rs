//! Wavefront .mtl files: what programs say of materials, each value with its place.
//!
//! As with .obj files, every statement is checked here and tobj reads the clean text: alone it
//! panics on `Kd 1`, which is a grey, and tells no line.

mod faults;
mod map;
mod scan;

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::Failure;
pub use faults::{Fault, What};
pub use map::Map;

/// The longest file, in bytes.
pub const LIMIT: u64 = 8_000_000;

/// The statements whose values mean something here, for guessing which one was meant.
pub const STATEMENTS: [&str; 11] =
    ["newmtl", "Ka", "Kd", "Ks", "Ke", "Ns", "Ni", "d", "Tr", "illum", "map_Kd"];

/// A value, and where it is said, in bytes of [`Library::text`].
#[derive(Clone, Debug, PartialEq)]
pub struct Said<T> {
    /// The value.
    pub value: T,
    /// The place: the words of the statement from the first to the last.
    pub at: Range<usize>,
}

/// What a file says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Library {
    /// The file as it can be shown: very long lines clipped, other than UTF-8 read as Latin-1.
    pub text: String,
    /// Its materials, in the order of the file.
    pub materials: Vec<Material>,
    /// The first faults, in the order of the file; a material with faults is incomplete.
    pub faults: Vec<Fault>,
    /// How many more there are.
    pub more: u64,
    /// Words that are no statements, each once.
    pub unknown: Vec<Said<String>>,
}

/// What is said of a material. Colours are linear; they and all numbers are finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name.
    pub name: Said<String>,
    /// Ka: whatever the program that wrote it took it for.
    pub ambient: Option<Said<[f64; 3]>>,
    /// Kd: diffuse reflectance.
    pub diffuse: Option<Said<[f64; 3]>>,
    /// map_Kd: the picture that Kd is multiplied by.
    pub diffuse_map: Option<Said<Map>>,
    /// Ks: specular reflectance.
    pub specular: Option<Said<[f64; 3]>>,
    /// Ke: emission.
    pub emissive: Option<Said<[f64; 3]>>,
    /// Ns: exponent of the highlight.
    pub exponent: Option<Said<f64>>,
    /// Ni: index of refraction.
    pub index: Option<Said<f64>>,
    /// d: opacity, from 0 to 1; `Tr t` is `d 1-t`.
    pub dissolve: Option<Said<f64>>,
    /// illum: the model of illumination.
    pub illum: Option<Said<u8>>,
    /// Further statements of the format, by their word: textures, Tf, physically based ones.
    pub others: Vec<Said<String>>,
}

/// Reads the text of a .mtl file. Err: it is nothing of the kind.
pub fn parse(bytes: &[u8]) -> Result<Library, Failure> {
    if bytes.contains(&0) {
        return Err(Failure::new("is no text: it holds zero bytes"));
    }
    let mut scan = scan::Scan::new(bytes);
    scan.run();
    let orphans = |fault: &Fault| fault.what == What::NoMaterial;
    let says = !scan.library.unknown.is_empty() || scan.library.faults.iter().any(orphans);
    if scan.library.materials.is_empty() && says {
        return Err(Failure::new("is no .mtl file: it has no newmtl"));
    }
    let mut clean = scan.clean.as_bytes();
    let read = catch_unwind(AssertUnwindSafe(|| tobj::load_mtl_buf(&mut clean)));
    let not_understood = || Failure::new("cannot be understood by the .mtl reader");
    let (read, _) = read.map_err(|_| not_understood())?.map_err(|_| not_understood())?;
    let mut library = scan.library;
    if read.len() != library.materials.len() {
        return Err(not_understood());
    }
    for (material, read) in library.materials.iter_mut().zip(read) {
        take(&mut material.ambient, read.ambient);
        take(&mut material.diffuse, read.diffuse);
        take(&mut material.specular, read.specular);
        take(&mut material.emissive, read.emissive);
        take(&mut material.exponent, read.shininess);
        take(&mut material.index, read.optical_density);
        take(&mut material.dissolve, read.dissolve);
        take(&mut material.illum, read.illumination_model);
    }
    Ok(library)
}

/// Puts the value read in the place the scan found.
fn take<T>(said: &mut Option<Said<T>>, read: Option<T>) {
    if let (Some(said), Some(value)) = (said, read) {
        said.value = value;
    }
}

#[cfg(test)]
mod tests;
