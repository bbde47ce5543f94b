//! A render as a sequence of passes: World and a stop rule → picture, and how wrong it is.
//!
//! Clocks and observers are handed in. A render can be cancelled between passes and tiles, and in
//! the middle of a long sample, which is dropped; how it is cut into passes shows in nothing but
//! the time it takes to answer. What was taken can be kept between passes and gone on from later, to
//! the same bits.

mod judge;
mod pace;
mod paired;
mod pilot;
mod rule;

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use crate::math::Picture;
use crate::measure::noise::Noise;
use crate::render::World;
use crate::render::film::{self, Taken, Window};
use crate::render::integrators::Integrator;
use crate::render::tiles::{Invalid, Job};

pub use paired::{Difference, difference};
pub use pilot::{Pilot, pilot};
pub use rule::{LEAST_FOR_ERROR, MOST_DOUBTFUL, Rule, Until, first_check};

use judge::Judgement;
use pace::Pace;
use rule::Decision;

/// What a picture depends on beside the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Chooses all random numbers.
    pub seed: u64,
    /// When the picture is done.
    pub until: Until,
}

impl Settings {
    /// So many samples of each pixel, at least 1.
    pub fn samples(seed: u64, samples: u64) -> Self {
        Self { seed, until: Until::Rule(Rule { samples: Some(samples), ..Rule::default() }) }
    }
}

/// Where a render goes on from.
#[derive(Clone, Debug)]
pub struct Begin {
    /// What was taken before; nothing, for a new render.
    pub taken: Taken,
    /// Seconds that it took.
    pub seconds: f64,
}

impl Begin {
    /// From the first sample.
    pub fn new(world: &World) -> Self {
        Self::at(world, 0)
    }

    /// From that sample, which begins a block.
    pub fn at(world: &World, first: u64) -> Self {
        Self { taken: Taken::new(&world.film, world.sampler.rhythm(), first), seconds: 0.0 }
    }
}

/// A sample that has followed so many rays, or those taken together with it, may never end: once the
/// time is over, they are given up.
const ENDLESS: u64 = 1 << 18;

/// Whoever watches a render. Called from any thread.
pub trait Watch: Sync {
    /// Whether to stop as soon as possible. Asked often: before each tile, and every thousand rays
    /// of a sample.
    fn cancelled(&self) -> bool;
    /// Seconds since any fixed moment; never goes back.
    fn now(&self) -> f64;
    /// `done` of about `total` samples, of all pixels together, are taken. Called after each tile.
    /// The total is a guess where time or error decide.
    fn progress(&self, done: u64, total: u64);
    /// A pass is over: what is taken so far, in that many seconds. It can be gone on from.
    fn passed(&self, _taken: &Taken, _seconds: f64) {}
}

/// What a render came to.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Radiance in W/m²/sr, finite, of the film's window alone.
    pub picture: Picture,
    /// Standard error of each pixel, likewise; None where nothing is known of it: it takes two
    /// samples.
    pub standard_error: Option<Picture>,
    /// How wrong the picture is by its noise; None where nothing is known of it.
    pub noise: Option<Noise>,
    /// Whether the errors are only bounds from above: the sampler spread all samples together.
    pub bound: bool,
    /// Samples of each pixel; of the pixels that have most, if tiles differ. 0: cancelled before
    /// each pixel had its first.
    pub samples: u64,
    /// Samples of a pixel, on average.
    pub mean_samples: f64,
    /// Samples of each tile's pixels, where tiles differ.
    pub schedule: Option<Vec<u64>>,
    /// Why it ended.
    pub stopped: Stopped,
    /// Seconds of rendering, of earlier parts too.
    pub seconds: f64,
    /// Rays from the camera that went into the picture.
    pub rays: u64,
    /// Rays to lamps that went into the picture.
    pub shadow_rays: u64,
    /// Samples that were not finite and count as black.
    pub invalid: Option<Invalid>,
    /// Pixels too bright for f32, which stand at its largest number.
    pub clipped: u64,
    /// What was taken, to go on from; tiles without a sample stand at its first.
    pub taken: Taken,
}

/// Why a render ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stopped {
    /// All samples that were asked for are taken.
    Samples,
    /// The time is over.
    Time,
    /// The error is small enough.
    Error,
    /// It was cancelled.
    Interrupted {
        /// Tiles with light in them, when it was cancelled in the first pass: the others are
        /// black. None if every pixel has `Outcome::samples` samples.
        tiles: Option<Finished>,
    },
}

/// How many of some are finished.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Finished {
    /// So many are.
    pub done: usize,
    /// So many there are.
    pub of: usize,
}

/// Takes samples of all pixels of the film's window until the rule binds, or it is cancelled.
pub fn render(
    world: &World,
    integrator: &Integrator,
    settings: &Settings,
    begin: Begin,
    watch: &dyn Watch,
) -> Outcome {
    let Begin { mut taken, seconds: before } = begin;
    let tiles = world.film.tiles();
    let begun = watch.now();
    let seconds = || before + (watch.now() - begun);
    let mut pace = Pace::new();
    let mut judged: Option<Judgement> = None;
    let stopped = loop {
        let left = match settings.until.decide(world, &taken, &mut judged, seconds()) {
            Decision::Stop(stopped) => break stopped,
            Decision::Take(left) => left,
        };
        let rhythm = world.sampler.rhythm();
        let start = taken.end(left.tiles[0]);
        let longest = left.until.min((start / rhythm.block + 1) * rhythm.block) - start;
        let samples = start..start + pace.samples(left.seconds).min(longest);

        let pixels = |tile: &usize| tiles[*tile].pixels();
        let all: u64 = (0..tiles.len()).map(|i| (taken.end(i) - taken.first()) * pixels(&i)).sum();
        let here: u64 = left.tiles.iter().map(pixels).sum();
        let total = all.saturating_add(here.saturating_mul(left.expected.saturating_sub(start)));
        let done = AtomicU64::new(all);
        let advance = |samples: u64| {
            let done = done.fetch_add(samples, Ordering::Relaxed) + samples;
            watch.progress(done, total.max(done));
        };
        let pass_begun = watch.now();
        // A sample that is done soon is waited for.
        let late = AtomicBool::new(false);
        let over = || settings.until.time().is_some_and(|time| seconds() >= time);
        let job = Job {
            seed: settings.seed,
            samples: samples.clone(),
            tiles: &left.tiles,
            taken: &taken,
            cancelled: &|followed| {
                let is_late = followed >= ENDLESS && over();
                late.fetch_or(is_late, Ordering::Relaxed);
                watch.cancelled() || late.load(Ordering::Relaxed)
            },
            advance: &advance,
        };
        let sums = integrator.pass(world, &job);
        let finished = sums.iter().flatten().count();
        let first = start == taken.first();
        // The tiles that were finished are dropped, so that those at work have the same samples;
        // but not in the first pass, where they are all there is.
        if finished < sums.len() && !first {
            break match late.into_inner() {
                true => Stopped::Time,
                false => Stopped::Interrupted { tiles: None },
            };
        }
        for (tile, sums) in left.tiles.iter().zip(sums) {
            if let Some(sums) = sums {
                taken.put(*tile, sums, samples.end);
            }
        }
        if finished < left.tiles.len() {
            let tiles = Finished { done: finished, of: left.tiles.len() };
            break Stopped::Interrupted { tiles: Some(tiles) };
        }
        pace.took(samples.end - start, watch.now() - pass_begun);
        watch.passed(&taken, seconds());
    };
    outcome(&world.film.window, world.light_unit, taken, stopped, seconds())
}

/// What was taken, as a picture: of a render that ended so after that many seconds. `light_unit` as
/// in [`World`].
pub fn outcome(
    window: &Window,
    light_unit: f64,
    taken: Taken,
    stopped: Stopped,
    seconds: f64,
) -> Outcome {
    let counts = taken.counts();
    let developed = film::develop(window, &taken, light_unit);
    let judged = judge::judge(window, light_unit, &taken);
    let most = taken.ends().max().unwrap_or(0) - taken.first();
    let least = taken.ends().min().unwrap_or(0) - taken.first();
    let pixels: u64 = window.pixels();
    Outcome {
        mean_samples: counts.rays as f64 / pixels.max(1) as f64,
        picture: developed.picture,
        standard_error: developed.standard_error,
        noise: judged.as_ref().map(Judgement::whole),
        bound: judged.is_some_and(|judged| judged.bound),
        samples: if least == 0 { 0 } else { most },
        schedule: (least != most).then(|| taken.ends().map(|end| end - taken.first()).collect()),
        stopped,
        seconds,
        rays: counts.rays,
        shadow_rays: counts.shadow_rays,
        invalid: counts.invalid,
        clipped: developed.clipped,
        taken,
    }
}
