//! `--replay`: a picture rendered once more, with the seed and the samples it was made of.

use std::path::Path;

use super::about::VERSION;
use super::log::shown;
use super::options::{self, Render};
use super::paths::DRAWING;
use crate::diag::words::counted;
use crate::files::{self, Failure};
use crate::load::Stage;

/// How a picture was made.
#[derive(Debug)]
pub struct Replay {
    /// Its file.
    picture: String,
    scene: String,
    light_hash: String,
    /// The most samples that a pixel has.
    pub samples: u64,
    /// One past the last sample of each tile, where they differ.
    pub schedule: Option<Vec<u64>>,
}

/// The options with which a picture was made, beside those given; and how it was made. Why not, if
/// that is not known.
pub fn asked(given: &Render, picture: &Path) -> Result<(Render, Replay), String> {
    let name = shown(picture);
    let told = |why: &str| format!("the picture `{name}` {why}");
    let words = read(picture).map_err(|failure| told(&failure.to_string()))?;
    let word = |key: &str| {
        let found = words.iter().find(|(k, _)| k.strip_prefix("scn:") == Some(key));
        found.map(|(_, value)| value.as_str())
    };
    if word(DRAWING).is_some() {
        return Err(told("is a drawing of paths of light, and no render"));
    }
    let needed = |key: &str| {
        let why = "does not tell how it was made: it has no";
        word(key).ok_or_else(|| told(&format!("{why} `scn:{key}`")))
    };
    let strange = |key: &str, value: &str| told(&format!("has a strange `scn:{key}`: `{value}`"));
    let number = |key: &str, value: &str| value.parse().map_err(|_| strange(key, value));

    let (scene, light_hash) = (needed("scene")?.to_string(), needed("light_hash")?.to_string());
    let version = needed("version")?;
    if version != VERSION {
        return Err(told(&format!(
            "was made by scn {version}, and this is scn {VERSION}, which may give other bits"
        )));
    }
    let mut all = given.clone();
    all.only = vec![needed("render")?.to_string()];
    all.seed = number("seed", needed("seed")?)?;
    if let Some(scale) = word("scale") {
        all.scale = options::scale(scale).map_err(|_| strange("scale", scale))?;
    }
    if let Some(crop) = word("crop") {
        all.crop = Some(options::crop(crop).map_err(|_| strange("crop", crop))?);
    }
    if let (Some(set), true) = (word("set"), given.set.is_empty()) {
        all.set = set.split('\n').map(str::to_string).collect();
    }
    let schedule = word("schedule").map(|text| {
        let ends: Result<Vec<u64>, _> =
            text.split(',').map(|end| number("schedule", end)).collect();
        ends
    });
    let schedule = schedule.transpose()?;
    let samples = match &schedule {
        Some(ends) => ends.iter().copied().max().unwrap_or(0),
        None => number("samples", needed("samples")?)?,
    };
    if !(1..=options::MAX_SAMPLES).contains(&samples) {
        return Err(told(&format!("has {} a pixel", counted(samples, "sample"))));
    }
    Ok((all, Replay { picture: name, scene, light_hash, samples, schedule }))
}

/// The words of a picture, EXR or PNG.
fn read(path: &Path) -> Result<files::Metadata, Failure> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        Some("png") => files::png::read_metadata(path),
        Some("exr") => files::exr::read(path).map(|(_, words)| words),
        _ => Err(Failure::new("is neither .exr nor .png")),
    }
}

impl Replay {
    /// Whether the picture was made of this scene; why not.
    pub fn check(&self, scene: &str, stage: &Stage) -> Result<(), String> {
        let now = stage.light_hash.to_string();
        if now == self.light_hash {
            return Ok(());
        }
        let (picture, before) = (&self.picture, &self.scene);
        Err(format!(
            "the picture `{picture}` is of another scene:\n    `{before}` of hash {:.12}…, not \
             `{scene}` of hash {now:.12}…\n  the scene, a file it names, or --set has changed since",
            self.light_hash,
        ))
    }

    /// Whether it tells of so many tiles; why not.
    pub fn fits(&self, tiles: usize) -> Result<(), String> {
        match &self.schedule {
            Some(ends) if ends.len() != tiles => Err(format!(
                "the picture `{}` tells the samples of {}, but has {tiles}",
                self.picture,
                counted(ends.len() as u64, "tile"),
            )),
            _ => Ok(()),
        }
    }
}
