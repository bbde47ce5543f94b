//! The end of a render: what came of it is told, and its pictures are written.

use std::path::Path;

use super::about::{About, Frame};
use super::asked::Asked;
use super::kept::{Kept, Kind};
use super::log::{Error, Event, Log, name, shown};
use super::output::Paths;
use super::{End, bias, picture, stop, terminal};
use crate::diag::harmless_text;
use crate::files;
use crate::run::{Outcome, Rule};

/// A render that has ended.
pub struct Finish<'a> {
    pub log: Log,
    pub about: &'a About,
    pub frame: &'a Frame,
    /// When it was to be done.
    pub rule: Rule,
}

impl Finish<'_> {
    /// Tells what came of it. `first` is the object which the first sample met that
    /// was not finite, in words.
    pub fn tell(&self, outcome: &Outcome, first: Option<&str>) {
        let render = &self.about.render;
        self.log.tell(&Event::Rendered {
            render: render.clone(),
            samples: outcome.samples,
            mean_samples: outcome.mean_samples,
            rays: outcome.rays,
            shadow_rays: outcome.shadow_rays,
            seconds: outcome.seconds,
            rays_per_second: (outcome.rays + outcome.shadow_rays) as f64
                / outcome.seconds.max(1e-9),
            peak_memory: files::memory::peak(),
            error: outcome.noise.map(|noise| Error::new(&noise, outcome.bound)),
            limits: self.rule,
            stopped_by: picture::stopped_by(&outcome.stopped),
        });
        let biases = self.about.biases.iter().cloned();
        for told in biases.chain(bias::of_outcome(outcome)) {
            self.log.tell(&Event::Bias { render: render.clone(), told });
        }
        for text in picture::remarks(outcome, first) {
            self.remark(text);
        }
    }

    /// Warns of something that is no fault of the scene.
    pub fn remark(&self, text: String) {
        remark(self.log, &self.about.render, text);
    }

    /// Writes its pictures.
    pub fn write(&self, outcome: Outcome, paths: Paths) -> Result<(), End> {
        let _writing = stop::writing();
        let done = picture::Done { about: self.about, frame: self.frame, rule: self.rule, outcome };
        done.write(&paths).map_err(|(path, failure)| {
            terminal::fail(&format!("the picture `{}` {failure}", shown(&path)));
            End::NotDone
        })?;
        for path in paths {
            let render = self.about.render.clone();
            self.log.tell(&Event::Written { render, file: name(&path) });
        }
        Ok(())
    }
}

impl Finish<'_> {
    /// Writes its part: all samples of a shard.
    pub fn write_part(
        &self,
        asked: &Asked,
        outcome: &Outcome,
        first: Option<&str>,
        path: &Path,
    ) -> Result<(), End> {
        let kept = Kept {
            kind: Kind::Part,
            about: self.about.clone(),
            frame: self.frame.clone(),
            limits: asked.limits,
            slice: asked.slice,
            seconds: outcome.seconds,
            first: first.map(str::to_string),
        };
        kept.write(path, &outcome.taken).map_err(|failure| {
            terminal::fail(&format!("the part `{}` {failure}", shown(path)));
            End::NotDone
        })?;
        let render = self.about.render.clone();
        self.log.tell(&Event::Written { render, file: name(path) });
        Ok(())
    }
}

/// Warns of something about a render that is no fault of its scene.
pub fn remark(log: Log, render: &str, text: String) {
    if !log.quiet {
        let text = harmless_text(&text);
        terminal::tell(&format!("warning: render `{render}`: {text}\n"));
    }
    log.tell(&Event::Remark { render: render.to_string(), text });
}
