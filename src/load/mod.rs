//! Scene → Stage: every file a scene names, read once into plain data.

mod errors;
mod files;
mod illum;
mod loader;
mod materials;
mod meshes;
mod stage;
mod textures;
mod tidy;

pub use loader::Loader;
pub use stage::{SceneHash, Stage, StagedFile, StagedMesh, StagedTexture};
