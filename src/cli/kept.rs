//! What stands in a checkpoint or in a part: the samples taken, and all that must agree before
//! they are gone on from or joined.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::about::{About, Frame, VERSION};
use super::shard::Slice;
use super::stop;
use crate::diag::words::grouped;
use crate::files::{self, Failure};
use crate::render::film::Taken;
use crate::run::Rule;

/// What kind of file it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// A render to go on with.
    Checkpoint,
    /// All samples of a shard.
    Part,
}

/// The words about samples that are kept.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Kept {
    pub kind: Kind,
    pub about: About,
    pub frame: Frame,
    /// When the picture was to be done.
    pub limits: Rule,
    /// Which samples of it, if not all.
    pub slice: Option<Slice>,
    /// Seconds of rendering.
    pub seconds: f64,
    /// The object which the first sample met that was not finite, in words; in a part alone.
    pub first: Option<String>,
}

impl Kept {
    /// Writes it with its samples.
    pub fn write(&self, path: &Path, taken: &Taken) -> Result<(), Failure> {
        let _writing = stop::writing();
        files::checkpoint::write(path, VERSION, self, taken)
    }

    /// Reads a file of that kind. The samples are as somebody wrote them: whether they fit is to be
    /// asked.
    pub fn read(path: &Path, kind: Kind) -> Result<(Self, Taken), Failure> {
        let (kept, taken): (Self, Taken) = files::checkpoint::read(path, VERSION)?;
        if kept.kind != kind {
            return Err(Failure::new(match kind {
                Kind::Checkpoint => "is a part of a render, not a checkpoint",
                Kind::Part => {
                    "is a checkpoint, not a part: the render that wrote it makes the part when it \
                     is resumed to its end"
                }
            }));
        }
        // The render's name becomes that of files.
        let name = Path::new(&kept.about.render);
        let sound = kept.seconds >= 0.0
            && kept.slice.is_none_or(|slice| slice.is_sound())
            && kept.frame.is_sound()
            && name.file_name() == Some(name.as_os_str());
        if sound { Ok((kept, taken)) } else { Err(contradicting()) }
    }
}

impl Kept {
    /// In what it is not of one picture with `other`: "seed 1, not 2" for each.
    pub fn differences(&self, other: &Self) -> Vec<String> {
        let mut all = self.about.differences(&other.about);
        let samples = |it: &Self| it.limits.samples.map_or("any".to_string(), grouped);
        if self.limits.samples != other.limits.samples {
            all.push(format!("{} samples a pixel, not {}", samples(self), samples(other)));
        }
        let (mine, others) = (&self.about, &other.about);
        if mine.exposure != others.exposure {
            all.push(format!("exposure {} ev, not {} ev", mine.exposure, others.exposure));
        }
        if mine.caption != others.caption {
            all.push(format!("the caption `{}`, not `{}`", mine.caption, others.caption));
        }
        // What is left shows in the words of the pictures alone.
        if all.is_empty() && (mine != others || self.limits != other.limits) {
            all.push(format!(
                "made from the file `{}` with {}, not from `{}` with {}",
                mine.scene,
                told(&mine.set),
                others.scene,
                told(&others.set)
            ));
        }
        if all.is_empty() && self.frame != other.frame {
            all.push("another part of the film".to_string());
        }
        all
    }
}

/// The arguments of --set.
fn told(set: &[String]) -> String {
    match set {
        [] => "no --set".to_string(),
        all => format!("--set `{}`", all.join("` --set `")),
    }
}

/// Words and samples do not fit together.
pub fn contradicting() -> Failure {
    Failure::new("contradicts itself, so it was not written by this scn")
}
