//! Files that were read, each once a run, by the name the system knows them by.

use std::collections::HashMap;
use std::path::{Component, Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

use sha2::{Digest, Sha256};

use super::errors::{and_more, file, mesh, mtl, texture};
use super::tidy;
use crate::diag::{Diagnostic, FileId, Sources, Span};
use crate::files::{Failure, regular};
use crate::files::{mtl as mtl_file, obj, texture as texture_file};
use crate::math::{Mesh, Progress, Reach, Texels};

/// A mesh that was read.
pub(super) struct ObjFile {
    /// Its triangles without degenerate and repeated ones.
    pub mesh: Arc<Mesh>,
    /// How far it reaches.
    pub reach: Arc<Reach>,
    /// For each slot of the mesh, where the file names it.
    pub slots: Vec<obj::Excerpt>,
    /// The .mtl files it names, and where.
    pub libraries: Vec<(String, obj::Excerpt)>,
    /// Its length, and the digest of its bytes.
    pub bytes: u64,
    pub digest: [u8; 32],
}

/// A .mtl file that was read.
pub(super) struct MtlFile {
    pub library: mtl_file::Library,
    /// As it is named, and where it is.
    pub name: String,
    pub path: PathBuf,
    /// Its text among the sources.
    pub source: FileId,
    /// Its length, and the digest of its bytes.
    pub bytes: u64,
    pub digest: [u8; 32],
}

/// A picture that was read.
pub(super) struct PictureFile {
    pub texels: Arc<Texels>,
    /// Its length, and the digest of its bytes.
    pub bytes: u64,
    pub digest: [u8; 32],
}

/// Everything read so far; None: it could not be read, and that was told.
pub(super) struct Shelf<'a> {
    progress: &'a dyn Progress,
    objs: HashMap<PathBuf, Option<Rc<ObjFile>>>,
    mtls: HashMap<PathBuf, Option<Rc<MtlFile>>>,
    pictures: HashMap<PathBuf, Option<Rc<PictureFile>>>,
}

/// Who names a file: as written, where it is, and the place that says so.
#[derive(Clone, Copy)]
pub(super) struct Asked<'a> {
    pub name: &'a str,
    pub path: &'a Path,
    pub span: Span,
}

impl<'a> Shelf<'a> {
    pub fn new(progress: &'a dyn Progress) -> Self {
        Self { progress, objs: HashMap::new(), mtls: HashMap::new(), pictures: HashMap::new() }
    }

    /// The mesh in a file. Its faults are told when it is first read.
    pub fn obj(
        &mut self,
        asked: Asked,
        sources: &mut Sources,
        found: &mut Vec<Diagnostic>,
    ) -> Option<Rc<ObjFile>> {
        let identity = regular::identity(asked.path);
        if let Some(known) = self.objs.get(&identity) {
            return known.clone();
        }
        let read = self.read_obj(asked, sources, found).map(Rc::new);
        self.objs.insert(identity, read.clone());
        read
    }

    /// The materials in a file. Its faults are told when it is first read.
    pub fn mtl(
        &mut self,
        asked: Asked,
        sources: &mut Sources,
        found: &mut Vec<Diagnostic>,
    ) -> Option<Rc<MtlFile>> {
        let identity = regular::identity(asked.path);
        if let Some(known) = self.mtls.get(&identity) {
            return known.clone();
        }
        let read = read_mtl(asked, sources, found).map(Rc::new);
        self.mtls.insert(identity, read.clone());
        read
    }

    /// The picture in a file. Its faults are told when it is first read.
    pub fn picture(
        &mut self,
        asked: Asked,
        found: &mut Vec<Diagnostic>,
    ) -> Option<Rc<PictureFile>> {
        let identity = regular::identity(asked.path);
        if let Some(known) = self.pictures.get(&identity) {
            return known.clone();
        }
        let read = self.read_picture(asked, found).map(Rc::new);
        self.pictures.insert(identity, read.clone());
        read
    }

    fn read_picture(&self, asked: Asked, found: &mut Vec<Diagnostic>) -> Option<PictureFile> {
        let bytes = match regular::read(asked.path, texture_file::LIMIT) {
            Ok(bytes) => bytes,
            Err(failure) => return unreadable(asked, &failure, found),
        };
        let reading = match texture_file::parse(&bytes, self.progress) {
            Ok(reading) => reading,
            Err(failure) => {
                found.push(texture::unreadable(asked.name, asked.span, &failure));
                return None;
            }
        };
        if reading.transparent {
            found.push(texture::transparent(asked.name, asked.span));
        }
        let digest = Sha256::digest(&bytes).into();
        let texels = Arc::new(reading.texels);
        Some(PictureFile { texels, bytes: bytes.len() as u64, digest })
    }

    fn read_obj(
        &self,
        asked: Asked,
        sources: &mut Sources,
        found: &mut Vec<Diagnostic>,
    ) -> Option<ObjFile> {
        let bytes = match regular::read(asked.path, obj::LIMIT) {
            Ok(bytes) => bytes,
            Err(failure) => return unreadable(asked, &failure, found),
        };
        let reading = match obj::parse(&bytes, self.progress) {
            Ok(reading) => reading,
            Err(failure) => {
                found.push(mesh::other_format(asked.name, asked.span, &failure));
                return None;
            }
        };
        let name = shown(asked.path);
        let mut place = |excerpt: &obj::Excerpt| place(sources, &name, excerpt);
        for fault in &reading.faults {
            let at = (place(&fault.place), asked.span);
            found.push(mesh::fault(asked.name, fault, at));
        }
        tell_more(asked, reading.more, found);
        for notice in &reading.notices {
            let at = (place(&notice.place), asked.span);
            found.push(mesh::notice(asked.name, notice, at));
        }
        let obj = reading.obj?;
        let all = obj.mesh.triangles.len();
        let tidy = tidy::tidy(obj.mesh, &obj.lines);
        let mut dropped = |dropped: Option<tidy::Dropped>, told: fn(&_, _, _, _) -> Diagnostic| {
            let Some(dropped) = dropped else { return };
            let excerpt = obj::excerpt(&bytes, dropped.first_line);
            let at = excerpt.map_or(asked.span, |excerpt| place(&excerpt));
            found.push(told(asked.name, dropped.count, at, asked.span));
        };
        dropped(tidy.degenerate, mesh::degenerate);
        dropped(tidy.repeated, mesh::repeated);
        if tidy.mesh.triangles.is_empty() {
            found.push(mesh::no_faces(asked.name, all, asked.span));
            return None;
        }
        Some(ObjFile {
            reach: Arc::new(Reach::of(&tidy.mesh)),
            mesh: Arc::new(tidy.mesh),
            slots: tidy.slots.iter().map(|slot| obj.slots[*slot as usize].clone()).collect(),
            libraries: obj.libraries,
            bytes: bytes.len() as u64,
            digest: Sha256::digest(&bytes).into(),
        })
    }
}

fn read_mtl(asked: Asked, sources: &mut Sources, found: &mut Vec<Diagnostic>) -> Option<MtlFile> {
    let bytes = match regular::read(asked.path, mtl_file::LIMIT) {
        Ok(bytes) => bytes,
        Err(failure) => return unreadable(asked, &failure, found),
    };
    let library = match mtl_file::parse(&bytes) {
        Ok(library) => library,
        Err(failure) => {
            found.push(mtl::other_format(asked.name, asked.span, &failure));
            return None;
        }
    };
    let source = sources.add(shown(asked.path), library.text.as_str());
    let at = |range: &std::ops::Range<usize>| Span::new(source, range.start, range.end);
    for fault in &library.faults {
        found.push(mtl::fault(asked.name, fault, &at, asked.span));
    }
    tell_more(asked, library.more, found);
    for unknown in &library.unknown {
        found.push(mtl::unknown(asked.name, &unknown.value, at(&unknown.at)));
    }
    let digest = Sha256::digest(&bytes).into();
    let whole = library.faults.is_empty();
    let (name, path) = (asked.name.to_string(), asked.path.to_path_buf());
    whole.then_some(MtlFile { library, name, path, source, bytes: bytes.len() as u64, digest })
}

/// Faults beyond those told one by one are counted with the last of these.
fn tell_more(asked: Asked, more: u64, found: &mut Vec<Diagnostic>) {
    if more > 0
        && let Some(last) = found.pop()
    {
        found.push(and_more(last, asked.name, more));
    }
}

fn unreadable<T>(asked: Asked, failure: &Failure, found: &mut Vec<Diagnostic>) -> Option<T> {
    let neighbours = regular::neighbours(asked.path);
    found.push(file::unreadable(asked.name, asked.path, asked.span, failure, &neighbours));
    None
}

/// Keeps an excerpt among the sources.
pub(super) fn place(sources: &mut Sources, name: &str, excerpt: &obj::Excerpt) -> Span {
    let source = sources.add_excerpt(name, excerpt.text.as_str(), excerpt.first_line);
    Span::new(source, excerpt.range.start, excerpt.range.end)
}

/// A path for people: `a/../b` is `b`.
pub(super) fn shown(path: &Path) -> String {
    let mut parts: Vec<Component> = Vec::new();
    for part in path.components() {
        match (part, parts.last()) {
            (Component::CurDir, _) => {}
            (Component::ParentDir, Some(Component::Normal(_))) => {
                parts.pop();
            }
            _ => parts.push(part),
        }
    }
    parts.iter().collect::<PathBuf>().display().to_string()
}
