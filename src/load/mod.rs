//! Scene → Stage: every file a scene names, read once into plain data.

mod stage;

pub use stage::{SceneHash, Stage, StagedFile, StagedMesh};
