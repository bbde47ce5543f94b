//! A finished picture: what is to be said of it, and the files it goes to.

use std::path::PathBuf;

use super::about::{About, Frame, VERSION, comma};
use super::bias;
use super::log::Error;
use super::output::Paths;
use crate::diag::words::counted;
use crate::files::{self, Failure, Metadata};
use crate::render::film;
use crate::run::{LEAST_FOR_ERROR, MOST_DOUBTFUL, Outcome, Rule, Stopped};

/// A picture with everything its files tell about it.
pub struct Done<'a> {
    pub about: &'a About,
    pub frame: &'a Frame,
    /// When it was to be done.
    pub rule: Rule,
    pub outcome: Outcome,
}

impl Done<'_> {
    /// Writes the files side by side, each whole or not at all.
    pub fn write(self, paths: &Paths) -> Result<(), (PathBuf, Failure)> {
        let metadata = self.metadata();
        let Self { about, frame: Frame { film, window, light_unit }, outcome, .. } = self;
        let Outcome { picture, standard_error, taken, .. } = outcome;
        let error = standard_error.into_iter().map(|error| ("error".to_string(), error));
        let layers = film::layers(window, &taken, *light_unit);
        let mut named: Vec<_> = error.chain(about.layers.iter().cloned().zip(layers)).collect();
        named.sort_by(|(a, _), (b, _)| a.cmp(b));
        let layers = files::exr::Layers {
            film: film.map(|n| n as usize),
            origin: [window.x0 as usize, window.y0 as usize],
            main: picture,
            named,
            scalars: vec![("samples".to_string(), film::samples(window, &taken))],
        };
        // It is larger than all that is written, which takes more of its own.
        drop(taken);
        let (png, exr) = files::both(
            || match &paths.png {
                Some(path) => {
                    files::png::write(path, &layers.main, about.exposure.exp2(), &metadata)
                        .map_err(|failure| (path.clone(), failure))
                }
                None => Ok(()),
            },
            || match &paths.exr {
                Some(path) => files::exr::write(path, &layers, &metadata)
                    .map_err(|failure| (path.clone(), failure)),
                None => Ok(()),
            },
        );
        png.and(exr)
    }

    /// What made the picture, so that it can be made again.
    fn metadata(&self) -> Metadata {
        let mut all: Metadata = Vec::new();
        let mut put = |key: &str, value: String| all.push((format!("scn:{key}"), value));
        let about = self.about;
        put("scene", about.scene.clone());
        put("hash", about.hash.clone());
        put("light_hash", about.light_hash.clone());
        put("render", about.render.clone());
        put("seed", about.seed.to_string());
        put("samples", self.outcome.samples.to_string());
        put("version", VERSION.to_string());
        put("time", format!("{:.3}", self.outcome.seconds));
        if !about.caption.is_empty() {
            put("caption", about.caption.clone());
        }
        if about.scale != 1.0 {
            put("scale", about.scale.to_string());
        }
        if let Some(crop) = about.crop {
            put("crop", comma(crop));
        }
        if !about.set.is_empty() {
            put("set", about.set.join("\n"));
        }
        put("stopped_by", stopped_by(&self.outcome.stopped).to_string());
        let biases = about.biases.iter().cloned().chain(bias::of_outcome(&self.outcome));
        let biases: Vec<String> = biases.map(|told| told.line()).collect();
        if !biases.is_empty() {
            put("bias", biases.join("\n"));
        }
        if let Some(noise) = self.outcome.noise {
            let Error { error, low, high, .. } = Error::new(&noise, self.outcome.bound);
            put("error", format!("{error:e}"));
            put("error_interval", format!("{low:e},{high:e}"));
            put("error_epsilon", format!("{:e}", noise.epsilon));
        }
        if let Some(schedule) = &self.outcome.schedule {
            let ends: Vec<String> = schedule.iter().map(u64::to_string).collect();
            put("schedule", ends.join(","));
        }
        if let Stopped::Interrupted { tiles } = self.outcome.stopped {
            put(
                "interrupted",
                match (tiles, self.rule.samples) {
                    (None, Some(of)) => format!("{} of {of} samples", self.outcome.samples),
                    (None, None) => format!("after {} samples", self.outcome.samples),
                    (Some(tiles), _) => {
                        format!("{} of {} tiles, the others black", tiles.done, tiles.of)
                    }
                },
            );
        }
        all
    }
}

/// Why a render ended, in a word.
pub fn stopped_by(stopped: &Stopped) -> &'static str {
    match stopped {
        Stopped::Samples => "samples",
        Stopped::Time => "time",
        Stopped::Error => "error",
        Stopped::Interrupted { .. } => "interruption",
    }
}

/// What is strange about a picture though its scene has no fault. `first` is the object which the
/// first sample met that was not finite, in words.
pub fn remarks(outcome: &Outcome, first: Option<&str>) -> Vec<String> {
    let mut all = Vec::new();
    if let Some(invalid) = outcome.invalid {
        let on = first.map(|object| format!(", on {object}")).unwrap_or_default();
        let first = invalid.first;
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
    if let Some(noise) = outcome.noise
        && outcome.samples >= LEAST_FOR_ERROR
        && noise.doubtful_part > MOST_DOUBTFUL
    {
        let pixels = match noise.doubtful {
            1 => "1 pixel owes".to_string(),
            many => counted(many, "pixel") + " owe",
        };
        all.push(format!(
            "{pixels} over a fifth of the light to one sample, and most of the error is theirs: \
             rare bright samples, of which others may be still to come"
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
