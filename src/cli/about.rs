//! What a picture is of: all that its samples depend on, and what its files tell of it. It stands
//! in checkpoints and parts too, so that they are gone on from and joined by nothing else.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::bias::{self, Told};
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
    /// Names of the layers beside the picture.
    pub layers: Vec<String>,
    /// What makes the picture systematically wrong.
    pub biases: Vec<Told>,
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
            layers: stage.scene.layers.iter().map(|layer| layer.name.value.clone()).collect(),
            biases: bias::told(stage),
        }
    }

    /// In what its samples are others than those of `other`: "seed 1, not 2" for each.
    pub fn differences(&self, other: &Self) -> Vec<String> {
        let mut all = Vec::new();
        let mut differ = |what: &str, of: &dyn Fn(&Self) -> String| {
            let (mine, others) = (of(self), of(other));
            if mine != others {
                all.push(format!("{what}{mine}, not {others}"));
            }
        };
        differ("render ", &|it| format!("`{}`", it.render));
        differ("seed ", &|it| it.seed.to_string());
        differ("", &|it| match it.size {
            [width, height] => format!("a film of {width} × {height}"),
        });
        differ("scale ", &|it| it.scale.to_string());
        differ("", &|it| match it.crop {
            None => "the whole film".to_string(),
            Some(crop) => format!("the crop {}", comma(crop)),
        });
        // The film is part of the scene, and told above.
        if self.light_hash != other.light_hash && self.size == other.size {
            differ("", &|it| format!("the scene `{}` of hash {:.12}…", it.scene, it.light_hash));
            differ("", &|it| match &*it.set.iter().filter(|set| counts(set)).collect::<Vec<_>>() {
                [] => "made without --set".to_string(),
                all => format!(
                    "made with {}",
                    all.iter().map(|set| format!("--set `{set}`")).collect::<Vec<_>>().join(" ")
                ),
            });
        }
        all
    }
}

/// Whether the samples can depend on what an argument of --set says.
fn counts(set: &str) -> bool {
    let path = set.split('=').next().unwrap_or(set).trim();
    !["caption", "film.exposure", "stop"].contains(&path) && !path.starts_with("stop.")
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

    /// Whether it can be of a world: to be asked of what was read from a file.
    pub fn is_sound(&self) -> bool {
        let [width, height] = self.film;
        self.window.x1 <= width && self.window.y1 <= height && self.light_unit > 0.0
    }
}
