//! A finished picture: what is to be said of it, and the files it goes to.

use std::path::{Path, PathBuf};

use super::options::Render;
use super::output::Paths;
use super::words::counted;
use crate::files::{self, Failure, Metadata};
use crate::load::Stage;
use crate::prepare::ObjectNote;
use crate::render::film::Film;
use crate::run::Outcome;

/// A picture with everything its files tell about it.
pub struct Done<'a> {
    pub name: &'a str,
    pub stage: &'a Stage,
    pub seed: u64,
    /// Samples that were asked for.
    pub samples: u64,
    pub outcome: Outcome,
    /// How long the rendering took.
    pub seconds: f64,
}

impl Done<'_> {
    /// Writes the files, each whole or not at all.
    pub fn write(
        self,
        paths: &Paths,
        film: &Film,
        options: &Render,
    ) -> Result<(), (PathBuf, Failure)> {
        let metadata = self.metadata(options);
        if let Some(path) = &paths.png {
            let factor = self.stage.scene.film.exposure.0.exp2();
            files::png::write(path, &self.outcome.picture, factor, &metadata)
                .map_err(|failure| (path.clone(), failure))?;
        }
        if let Some(path) = &paths.exr {
            let layers = files::exr::Layers {
                film: film.size.map(|n| n as usize),
                origin: [film.window.x0 as usize, film.window.y0 as usize],
                main: self.outcome.picture,
                named: Vec::new(),
            };
            files::exr::write(path, &layers, &metadata).map_err(|f| (path.clone(), f))?;
        }
        Ok(())
    }

    /// What made the picture, so that it can be made again.
    fn metadata(&self, options: &Render) -> Metadata {
        let mut all: Metadata = Vec::new();
        let mut put = |key: &str, value: String| all.push((format!("scn:{key}"), value));
        let file = options.file.file_name().map(Path::new).unwrap_or(&options.file);
        put("scene", file.to_string_lossy().into_owned());
        put("hash", self.stage.hash.to_string());
        put("render", self.name.to_string());
        put("seed", self.seed.to_string());
        put("samples", self.outcome.samples.to_string());
        put("version", env!("CARGO_PKG_VERSION").to_string());
        put("time", format!("{:.3}", self.seconds));
        let caption = &self.stage.scene.caption.0;
        if !caption.is_empty() {
            put("caption", caption.clone());
        }
        if options.scale != 1.0 {
            put("scale", options.scale.to_string());
        }
        if let Some([x0, y0, x1, y1]) = options.crop {
            put("crop", format!("{x0},{y0},{x1},{y1}"));
        }
        if !options.set.is_empty() {
            put("set", options.set.join("\n"));
        }
        if let Some(interrupted) = self.outcome.interrupted {
            put(
                "interrupted",
                match interrupted.tiles {
                    None => format!("{} of {} samples", self.outcome.samples, self.samples),
                    Some(tiles) => {
                        format!("{} of {} tiles, the others black", tiles.done, tiles.of)
                    }
                },
            );
        }
        all
    }
}

/// What is strange about a picture though its scene has no fault.
pub fn remarks(outcome: &Outcome, objects: &[ObjectNote]) -> Vec<String> {
    let mut all = Vec::new();
    if let Some(invalid) = outcome.invalid {
        let first = invalid.first;
        let on = first.object.and_then(|number| objects.get(number as usize));
        let on = on.map(|object| format!(", on object `{}`", object.name)).unwrap_or_default();
        all.push(format!(
            "{} not finite and count as black; the first is sample {} of pixel ({}, {}){on}",
            if invalid.count == 1 {
                "1 sample is".into()
            } else {
                counted(invalid.count, "sample") + " are"
            },
            first.sample,
            first.x,
            first.y,
        ));
    }
    if outcome.clipped > 0 {
        all.push(format!(
            "{} too bright for single precision and stand at its largest number",
            if outcome.clipped == 1 {
                "1 pixel is".into()
            } else {
                counted(outcome.clipped, "pixel") + " are"
            },
        ));
    }
    all
}
