//! The Stage: a scene with every file it names read into plain data.

use std::path::PathBuf;
use std::sync::Arc;

use crate::diag::Span;
use crate::math::{Mesh, Reach, Texels, Values};
use crate::scene::{Encoding, Material, Medium, Named, Ref, Scene, Texture};

/// A scene, and what its files hold. Nothing is placed or scaled yet.
#[derive(Clone, Debug)]
pub struct Stage {
    /// What the author said.
    pub scene: Arc<Scene>,
    /// One for each of `scene.objects`, in their order; None for objects that need no file.
    pub meshes: Vec<Option<StagedMesh>>,
    /// The textures that materials may name, by their names.
    pub textures: Vec<StagedTexture>,
    /// Media of materials in files, which the scene does not declare.
    pub media: Vec<Named<Medium>>,
    /// The files read, each once, in the order of first use.
    pub files: Vec<StagedFile>,
    /// What the picture depends on beside settings and seed.
    pub hash: SceneHash,
    /// What its samples depend on beside settings and seed: the same without limits, caption and
    /// exposure.
    pub light_hash: SceneHash,
}

/// A mesh with the materials of its slots.
#[derive(Clone, Debug)]
pub struct StagedMesh {
    /// The triangles, in file units; no duplicated and no degenerate ones.
    pub mesh: Arc<Mesh>,
    /// How far the mesh reaches.
    pub reach: Arc<Reach>,
    /// One for each of `mesh.material_names`: what the .mtl says or the scene says in its place.
    pub materials: Vec<Named<Material>>,
}

/// A texture with what its file holds.
#[derive(Clone, Debug)]
pub struct StagedTexture {
    /// As it is declared.
    pub texture: Named<Texture>,
    /// The picture it names, if it names one.
    pub texels: Option<Arc<Texels>>,
}

impl StagedTexture {
    /// Whether its texels are to be decoded from sRGB.
    pub fn is_encoded(&self) -> bool {
        let floats = |texels: &Arc<Texels>| matches!(texels.values, Values::Float(_));
        match &self.texture.value.value {
            Texture::Checker(_) => false,
            Texture::Image(image) => match image.encoding.value {
                Some(encoding) => encoding == Encoding::Srgb,
                None => !self.texels.as_ref().is_some_and(floats),
            },
        }
    }
}

impl Stage {
    /// The texture a reference names.
    pub fn texture(&self, name: &Ref<Texture>) -> &StagedTexture {
        let mut all = self.textures.iter();
        let found = all.find(|staged| staged.texture.name.value == name.name);
        found.expect("checked: references name declarations")
    }

    /// The medium a reference names.
    pub fn medium(&self, name: &Ref<Medium>) -> &Named<Medium> {
        let mut all = self.scene.media.iter().chain(&self.media);
        let found = all.find(|medium| medium.name.value == name.name);
        found.expect("checked: references name declarations")
    }
}

/// A file that was read.
#[derive(Clone, Debug)]
pub struct StagedFile {
    /// As the author named it.
    pub name: String,
    /// Where it is.
    pub path: PathBuf,
    /// Where the author named it; for a .mtl, where the object stands that led to it.
    pub span: Span,
    /// Its length in bytes.
    pub bytes: u64,
    /// Triangles kept, for a mesh.
    pub triangles: Option<u64>,
}

/// SHA-256 of the evaluated scene without places in texts, and of the bytes of its files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SceneHash(pub [u8; 32]);

impl std::fmt::Display for SceneHash {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}
