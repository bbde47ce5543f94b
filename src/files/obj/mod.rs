//! Wavefront .obj files: polygons, their normals, and the names of their materials.
//!
//! Every statement is checked here first, with the place of each fault; tobj then reads the clean
//! text that is left. Alone it panics on some input, accepts NaN, makes triangles of points and
//! lines, and tells no line. Texture coordinates go past it: they need no more than the scan knows.

mod assemble;
mod faults;
mod fan;
mod pipe;
mod scan;

use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::math::{Mesh, Progress};

pub use super::lines::Excerpt;
use super::{Failure, lines};
pub use faults::{Fault, Notice, Of, Reading, Unread, What};

/// The longest file, in bytes. Below it every count fits into 32 bits.
pub const LIMIT: u64 = 2_000_000_000;

/// The statements whose meaning is read, for guessing which one was meant.
pub const STATEMENTS: [&str; 7] = ["v", "vt", "vn", "f", "usemtl", "mtllib", "s"];

/// A mesh as its file says it, and where in the file things are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Obj {
    /// Its triangles, with degenerate and repeated ones; it may have none.
    pub mesh: Mesh,
    /// For each triangle, the number of the line of its face.
    pub lines: Vec<u32>,
    /// For each material slot, where the file first names it; for faces that name none, the first
    /// of them.
    pub slots: Vec<Excerpt>,
    /// The .mtl files it names, as written, each once.
    pub libraries: Vec<(String, Excerpt)>,
}

/// Reads the text of an .obj file. Err: it is nothing of the kind.
pub fn parse(bytes: &[u8], progress: &dyn Progress) -> Result<Reading, Failure> {
    if let Some(other) = stranger(bytes) {
        return Err(Failure::new(other));
    }
    let scan = scan::Scan::new(bytes, progress);
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    let no_materials = |_: &std::path::Path| Ok(Default::default());
    let (read, found) = pipe::side_by_side(scan, |clean| {
        catch_unwind(AssertUnwindSafe(|| tobj::load_obj_buf(clean, &options, no_materials)))
    })?;
    if found.understood == 0 && found.unknown > 0 {
        let materials = |n: &Notice| n.what == Unread::Unknown("newmtl".into());
        return Err(Failure::new(if found.notices.iter().any(materials) {
            "is a .mtl file, not an .obj file"
        } else {
            "is no Wavefront .obj file: no line of it is a statement of one"
        }));
    }
    if !found.faults.is_empty() {
        let (faults, more) = (found.faults, found.more);
        return Ok(Reading { obj: None, faults, more, notices: found.notices });
    }
    let read = read.map_err(|_| Failure::new("cannot be understood by the .obj reader"))?;
    let (models, _) = read.map_err(|error| {
        Failure::new(format!("cannot be understood by the .obj reader: {error}"))
    })?;
    let notices = found.notices;
    let obj = assemble::assemble(
        models,
        found.triangles,
        found.coordinates,
        found.slots,
        found.libraries,
    )?;
    Ok(Reading { obj: Some(obj), faults: Vec::new(), more: 0, notices })
}

/// The lines around line `number`.
pub fn excerpt(bytes: &[u8], number: u32) -> Option<Excerpt> {
    lines::excerpt_of_line(bytes, number as usize)
}

/// What the bytes are when they are clearly something else.
fn stranger(bytes: &[u8]) -> Option<&'static str> {
    const HEAD: usize = 4096;
    let starts: [(&[u8], &str); 10] = [
        (b"ply\n", "is a PLY file"),
        (b"ply\r", "is a PLY file"),
        (b"solid ", "is an STL file"),
        (b"glTF", "is a glTF file"),
        (b"Kaydara FBX", "is an FBX file"),
        (b"BLENDER", "is a Blender file"),
        (b"\x89PNG", "is a PNG picture, not a mesh"),
        (b"PK\x03\x04", "is a zip archive"),
        (b"\x1f\x8b", "is compressed by gzip"),
        (b"<?xml", "is an XML file"),
    ];
    if let Some((_, what)) = starts.iter().find(|(start, _)| bytes.starts_with(start)) {
        return Some(what);
    }
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Some("is text in UTF-16, not in UTF-8");
    }
    let head = &bytes[..bytes.len().min(HEAD)];
    head.contains(&0).then_some("is no text: it holds zero bytes")
}

#[cfg(test)]
mod tests;
