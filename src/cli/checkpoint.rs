//! Checkpoints: a render kept beside its picture every so often, and gone on with later.

use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use super::about::Frame;
use super::asked::Asked;
use super::bar::Watcher;
use super::finish::remark;
use super::kept::{Kept, Kind, contradicting};
use super::limits::percent;
use super::log::{self, Event, Log, shown};
use super::options::Render;
use super::output::Output;
use crate::diag::words::{counted, grouped};
use crate::files;
use crate::files::hold::Held;
use crate::render::World;
use crate::render::film::Taken;
use crate::run::{Begin, Outcome, Stopped, Watch};

/// Seconds between two checkpoints, if nothing else is said.
const EVERY: f64 = 60.0;

/// Where a render is kept, if it is.
pub fn path(options: &Render, output: &Output, name: &str) -> Option<PathBuf> {
    let kept = options.checkpoint.is_some() || options.resume;
    let shard = options.shard.map(|shard| shard.suffix("checkpoint"));
    kept.then(|| output.beside(name, shard.as_deref().unwrap_or("checkpoint")))
}

/// Whether the render can be kept, and gone on with if that is wanted: to be asked before the work.
/// Its checkpoint, if it has one, is held for nobody else to write it. Why not, if it cannot be kept.
pub fn hold(options: &Render, output: &Output, asked: &Asked) -> Result<Option<Held>, String> {
    let Some(path) = path(options, output, &asked.about.render) else { return Ok(None) };
    let told = |clause: String| format!("the checkpoint `{}` {clause}", shown(&path));
    let _folders = files::whole::ready(&path).map_err(|failure| told(failure.to_string()))?;
    let held =
        Held::take(&path).map_err(|failure| told(failure.to_string()))?.ok_or_else(|| {
            told(
            "is being written by another render\n  wait for its end, or choose another place with \
             -o"
            .into(),
        )
        })?;
    if files::regular::is_there(&path) {
        if !options.resume {
            return Err(told(
                "is there already, and may hold hours of work\n  --resume goes on from it; to begin \
                 anew, delete it or choose another place with -o"
                    .into(),
            ));
        }
        let (kept, taken) =
            Kept::read(&path, Kind::Checkpoint).map_err(|why| told(why.to_string()))?;
        agree(&kept, &taken, asked).map_err(told)?;
    }
    Ok(Some(held))
}

/// Whether a render that was kept so is the beginning of the one asked for.
fn agree(kept: &Kept, taken: &Taken, asked: &Asked) -> Result<(), String> {
    let mut differences = kept.about.differences(&asked.about);
    if kept.slice != asked.slice {
        let of = |slice: Option<super::shard::Slice>| {
            slice.map_or("all samples".to_string(), |it| format!("{} of {}", it.told(), it.samples))
        };
        differences.push(format!("{}, not {}", of(kept.slice), of(asked.slice)));
    }
    if !differences.is_empty() {
        return Err(format!(
            "is of another render:\n    {}\n  ask for that one, or choose another place with -o",
            differences.join("\n    ")
        ));
    }
    let most = taken.ends().max().unwrap_or(0);
    let (before, now) = (kept.limits, asked.limits);
    if let Some(limit) = now.samples
        && most > limit
    {
        return Err(format!(
            "holds {} a pixel already, more than the limit of {}\n  raise the limit to go on from \
             it",
            counted(most, "sample"),
            grouped(limit),
        ));
    }
    // Time that was spent is spent: with a limit of less, what is there is done.
    // What has ended some tiles ends them once for all.
    let even = taken.ends().all(|end| end == most);
    if !even && (before.error, before.adaptive) != (now.error, now.adaptive) {
        let error = before.error.map_or("another error".to_string(), percent);
        return Err(format!(
            "has parts of the picture which have reached an error of {error}, and ended\n  ask for \
             that error again, adaptive as before"
        ));
    }
    Ok(())
}

/// Where the render begins: where its checkpoint ends, or from the first sample. Why not, if it
/// cannot.
pub fn begin(
    options: &Render,
    output: &Output,
    asked: &Asked,
    world: &World,
    log: Log,
) -> Result<Begin, String> {
    let anew = Begin::at(world, asked.first());
    let name = &asked.about.render;
    let Some(path) = path(options, output, name).filter(|_| options.resume) else {
        return Ok(anew);
    };
    let resumed = |samples: u64, seconds: f64| Event::Resumed {
        render: name.clone(),
        file: log::name(&path),
        samples,
        seconds,
    };
    if !files::regular::is_there(&path) {
        log.tell(&resumed(0, 0.0));
        return Ok(anew);
    }
    // It was looked at before, but that may be hours ago.
    let told = |clause: String| format!("the checkpoint `{}` {clause}", shown(&path));
    let (kept, taken) = Kept::read(&path, Kind::Checkpoint).map_err(|why| told(why.to_string()))?;
    agree(&kept, &taken, asked).map_err(told)?;
    let fits = taken.first() == asked.first()
        && kept.frame == Frame::of(world)
        && taken.fits(&world.film.window, world.film.layers, world.sampler.rhythm());
    if !fits {
        return Err(told(contradicting().to_string()));
    }
    let samples = taken.ends().max().unwrap_or(0) - taken.first();
    log.tell(&resumed(samples, kept.seconds));
    Ok(Begin { taken, seconds: kept.seconds })
}

/// Watches one render, and keeps it every so often.
pub struct Keeper<'a> {
    watcher: Watcher<'a>,
    log: Log,
    /// Where it is kept, if it is, and the words of what is kept.
    keeps: Option<(PathBuf, Kept)>,
    /// Seconds between two checkpoints.
    every: f64,
    state: Mutex<State>,
}

/// How the keeping goes.
struct State {
    /// When it was kept last, or began.
    last: f64,
    /// Whether it was told that it cannot be kept.
    told: bool,
}

impl<'a> Keeper<'a> {
    /// Of a render that is asked for so.
    pub fn new(
        options: &Render,
        output: &Output,
        asked: &Asked,
        frame: &Frame,
        watcher: Watcher<'a>,
        log: Log,
    ) -> Self {
        let words = || Kept {
            kind: Kind::Checkpoint,
            about: asked.about.clone(),
            frame: frame.clone(),
            limits: asked.limits,
            slice: asked.slice,
            seconds: 0.0,
            first: None,
        };
        let state = State { last: watcher.now(), told: false };
        Self {
            keeps: path(options, output, &asked.about.render).map(|path| (path, words())),
            every: options.checkpoint.flatten().unwrap_or(EVERY),
            watcher,
            log,
            state: Mutex::new(state),
        }
    }

    /// Whether anything is kept.
    pub fn keeps(&self) -> bool {
        self.keeps.is_some()
    }

    /// Keeps what a render came to, but for one that was stopped within its first pass: there is
    /// nothing to go on from, which is told.
    pub fn end(&self, outcome: &Outcome) {
        let Some((path, words)) = &self.keeps else { return };
        if matches!(outcome.stopped, Stopped::Interrupted { tiles: Some(_) }) {
            let text = format!(
                "the checkpoint `{}` is not written: nothing is kept before every pixel has its \
                 first sample",
                shown(path)
            );
            remark(self.log, &words.about.render, text);
        } else {
            self.keep(&outcome.taken, outcome.seconds, true);
        }
    }

    fn keep(&self, taken: &Taken, seconds: f64, ended: bool) {
        let Some((path, words)) = &self.keeps else { return };
        let kept = Kept { seconds, ..words.clone() };
        let written = kept.write(path, taken);
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        state.last = self.watcher.now();
        match written {
            Ok(()) => {
                self.log.tell(&Event::Checkpoint {
                    render: words.about.render.clone(),
                    file: log::name(path),
                    samples: taken.ends().max().unwrap_or(0) - taken.first(),
                    seconds,
                    ended,
                });
            }
            Err(failure) if !state.told => {
                state.told = true;
                let older =
                    if files::regular::is_there(path) { "; the older one stays" } else { "" };
                let text = format!("the checkpoint `{}` {failure}{older}", shown(path));
                remark(self.log, &words.about.render, text);
            }
            Err(_) => {}
        }
    }
}

impl Watch for Keeper<'_> {
    fn cancelled(&self) -> bool {
        self.watcher.cancelled()
    }

    fn now(&self) -> f64 {
        self.watcher.now()
    }

    fn progress(&self, done: u64, total: u64) {
        self.watcher.progress(done, total);
    }

    fn passed(&self, taken: &Taken, seconds: f64) {
        let last = self.state.lock().unwrap_or_else(PoisonError::into_inner).last;
        if self.keeps() && self.watcher.now() - last >= self.every {
            self.keep(taken, seconds, false);
        }
    }
}
