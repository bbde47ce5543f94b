//! Reads what scenes name, each file once a run, and joins it to them.

use std::collections::HashSet;
use std::sync::Arc;

use sha2::{Digest, Sha256};

use super::files::Shelf;
use super::{SceneHash, Stage, StagedFile, StagedTexture, meshes, textures};
use crate::diag::{Diagnostic, Level, Sources};
use crate::math::Progress;
use crate::scene::{At, Exposure, Object, Scene, Switch};

/// Stages the scenes of a run.
pub struct Loader<'a> {
    shelf: Shelf<'a>,
    /// What was told: the renders of a file share their faults.
    told: HashSet<String>,
}

/// A file a stage rests on, and the digest of its bytes.
pub(super) struct Used {
    pub file: StagedFile,
    pub digest: [u8; 32],
}

impl Used {
    /// Notes a file, once.
    pub fn note(all: &mut Vec<Self>, file: StagedFile, digest: [u8; 32]) {
        let known = |used: &Self| used.digest == digest && used.file.name == file.name;
        if !all.iter().any(known) {
            all.push(Self { file, digest });
        }
    }
}

impl<'a> Loader<'a> {
    /// Nothing is read yet. `progress` is told the bytes of each mesh as they are read.
    pub fn new(progress: &'a dyn Progress) -> Self {
        Self { shelf: Shelf::new(progress), told: HashSet::new() }
    }

    /// Reads what the scene names. No stage if there is an error; a fault that was told for an
    /// earlier scene of the run is not told again.
    pub fn stage(
        &mut self,
        scene: &Arc<Scene>,
        sources: &mut Sources,
    ) -> (Option<Stage>, Vec<Diagnostic>) {
        let mut found = Vec::new();
        let mut used: Vec<Used> = Vec::new();
        let mut media = Vec::new();
        let mut staged = Vec::new();
        let mut desk =
            textures::Desk { shelf: &mut self.shelf, found: &mut found, used: &mut used };
        let mut textures: Vec<StagedTexture> =
            scene.textures.iter().filter_map(|texture| desk.stage(texture)).collect();
        // A file that could not be read is told once, and fails every scene.
        let mut whole = textures.len() == scene.textures.len();
        for object in &scene.objects {
            let Object::Mesh(mesh) = &object.value.value else {
                staged.push(None);
                continue;
            };
            let mut desk = meshes::Desk {
                shelf: &mut self.shelf,
                sources,
                scene,
                found: &mut found,
                used: &mut used,
                textures: &mut textures,
                media: &mut media,
            };
            let mesh = desk.stage(&object.name.value, mesh);
            whole &= mesh.is_some();
            staged.push(mesh);
        }
        whole &= found.iter().all(|diagnostic| diagnostic.level < Level::Error);
        let stage = whole.then(|| Stage {
            scene: scene.clone(),
            meshes: staged,
            textures,
            media,
            hash: hash(scene, &used),
            light_hash: hash(&light(scene), &used),
            files: used.into_iter().map(|used| used.file).collect(),
        });
        found.retain(|diagnostic| self.told.insert(fingerprint(diagnostic, sources)));
        (stage, found)
    }
}

/// The same for faults that say the same of the same places: an excerpt of a file may be among
/// the sources several times.
fn fingerprint(diagnostic: &Diagnostic, sources: &Sources) -> String {
    let mut print = format!("{} {}", diagnostic.code, diagnostic.headline);
    for label in &diagnostic.labels {
        let (line, column) = sources.line_column(label.span);
        let name = &sources.get(label.span.file).name;
        print.push_str(&format!("\n{name}:{line}:{column} {}", label.text));
    }
    print
}

/// The scene with nothing said of what no sample depends on: limits, caption and exposure.
fn light(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    let stop = &mut scene.stop.value;
    let at = scene.stop.span;
    (stop.samples, stop.time) = (At::new(None, at), At::new(None, at));
    (stop.error, stop.adaptive) = (At::new(None, at), At::new(Switch(false), at));
    scene.caption.value.0.clear();
    scene.film.value.exposure = At::new(Exposure(0.0), at);
    scene
}

/// SHA-256 of the scene as JSON, then of each file's name and digest, in the order of first use.
fn hash(scene: &Scene, used: &[Used]) -> SceneHash {
    let mut hasher = Sha256::new();
    let mut add = |bytes: &[u8]| {
        // The length before the bytes: no two lists of parts read the same.
        hasher.update((bytes.len() as u64).to_le_bytes());
        hasher.update(bytes);
    };
    add(&serde_json::to_vec(scene).expect("a scene is plain data"));
    for used in used {
        add(used.file.name.as_bytes());
        add(&used.digest);
    }
    SceneHash(hasher.finalize().into())
}
