//! A render as it is asked for: what it is of, when it is done, and which of its samples.

use super::about::About;
use super::limits::{self, limits};
use super::options::Render;
use super::replay::Replay;
use super::shard::Slice;
use crate::load::Stage;
use crate::prepare;
use crate::run::{Rule, Until};

/// What the scene and the command line ask for, brought together.
pub struct Asked {
    pub about: About,
    /// When the picture is done.
    pub limits: Rule,
    /// Which of its samples are wanted, if not all.
    pub slice: Option<Slice>,
    /// Samples of each tile, in place of the limits.
    schedule: Option<Vec<u64>>,
}

impl Asked {
    /// The render of that name; why not, if it cannot be so.
    pub fn new(
        name: &str,
        stage: &Stage,
        options: &Render,
        replay: Option<&Replay>,
    ) -> Result<Self, String> {
        let about = About::new(name, stage, options);
        if let Some(replay) = replay {
            replay.check(&about.scene, stage)?;
            let limits = Rule { samples: Some(replay.samples), ..Rule::default() };
            return Ok(Self { about, limits, slice: None, schedule: replay.schedule.clone() });
        }
        let limits = limits(options, &stage.scene.stop);
        let slice = options.shard.map(|shard| match limits {
            Rule { samples: Some(samples), time: None, error: None, .. } => {
                shard.slice(samples, prepare::rhythm(stage).block)
            }
            _ => Err(format!(
                "it is done after {}: whoever renders a shard must know beforehand which samples \
                 are its own\n  give --samples N, which counts in place of other limits",
                limits::told(&limits),
            )),
        });
        let slice = slice.transpose()?;
        Ok(Self { about, limits, slice, schedule: None })
    }

    /// When its samples are taken.
    pub fn until(&self) -> Until {
        if let Some(ends) = &self.schedule {
            return Until::Schedule(ends.clone());
        }
        let samples = self.slice.map(|slice| slice.end).or(self.limits.samples);
        Until::Rule(Rule { samples, ..self.limits })
    }

    /// Its first sample.
    pub fn first(&self) -> u64 {
        self.slice.map_or(0, |slice| slice.first)
    }

    /// How many samples of each pixel are wanted at most.
    pub fn samples(&self) -> Option<u64> {
        self.slice.map(|slice| slice.end - slice.first).or(self.limits.samples)
    }
}
