//! What a picture is of: all that its samples depend on, and what its files tell of it. It stands
//! in checkpoints and parts too, so that they are gone on from and joined by nothing else.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::options::Render;
use crate::load::Stage;
use crate::render::World;
use crate::render::film::Window;

/// The version of the program: another one may give other bits.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// A picture that is to be made.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct About {
    /// Name of the scene file.
    pub scene: String,
    /// Of the whole scene and its files.
    pub hash: String,
    /// Of what the samples depend on.
    pub light_hash: String,
    /// Name of the render.
    pub render: String,
    /// What is told below the picture; may be empty.
    pub caption: String,
    /// Brightness of the PNG, in stops.
    pub exposure: f64,
    /// Columns and rows in the scene.
    pub size: [u64; 2],
    /// --seed.
    pub seed: u64,
    /// --scale.
    pub scale: f64,
    /// --crop.
    pub crop: Option<[u64; 4]>,
    /// --set.
    pub set: Vec<String>,
}

impl About {
    /// The render of that name.
    pub fn new(name: &str, stage: &Stage, options: &Render) -> Self {
        let file = options.file.file_name().map(Path::new).unwrap_or(&options.file);
        let film = &stage.scene.film;
        Self {
            scene: file.to_string_lossy().into_owned(),
            hash: stage.hash.to_string(),
            light_hash: stage.light_hash.to_string(),
            render: name.to_string(),
            caption: stage.scene.caption.0.clone(),
            exposure: film.exposure.0,
            size: film.size.0.map(u64::from),
            seed: options.seed,
            scale: options.scale,
            crop: options.crop,
            set: options.set.clone(),
        }
    }
}

/// x0,y0,x1,y1, as --crop has it.
pub fn comma(crop: [u64; 4]) -> String {
    crop.map(|n| n.to_string()).join(",")
}

/// What a picture needs of the world when its samples are taken.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Frame {
    /// Columns and rows of the whole film.
    pub film: [u64; 2],
    /// The part of it that is wanted.
    pub window: Window,
    /// As in [`World`].
    pub light_unit: f64,
}

impl Frame {
    /// Of this world.
    pub fn of(world: &World) -> Self {
        let film = &world.film;
        Self { film: film.size, window: film.window, light_unit: world.light_unit }
    }
}
