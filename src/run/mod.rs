//! A render as a sequence of passes: World and a number of samples → picture.
//!
//! Clocks and observers are handed in. Between passes and tiles a render can be cancelled; how it
//! is cut into passes shows in nothing but the time it takes to answer.

mod pace;

use std::sync::atomic::{AtomicU64, Ordering};

use crate::math::Picture;
use crate::render::World;
use crate::render::film::{self, BLOCK, Sums, Total};
use crate::render::integrators::Integrator;
use crate::render::tiles::{Invalid, Job, TileSums};

use pace::Pace;

/// What a picture depends on beside the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Chooses all random numbers.
    pub seed: u64,
    /// Samples of each pixel, at least 1.
    pub samples: u64,
}

/// Whoever watches a render. Called from any thread.
pub trait Watch: Sync {
    /// Whether to stop as soon as possible. Asked often: before each tile.
    fn cancelled(&self) -> bool;
    /// Seconds since any fixed moment; never goes back.
    fn now(&self) -> f64;
    /// `done` of `total` samples, of all pixels together, are taken. Called after each tile.
    fn progress(&self, done: u64, total: u64);
}

/// What a render came to.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Radiance in W/m²/sr, finite, of the film's window alone; the mean of `samples` samples.
    pub picture: Picture,
    /// Samples of each pixel in the picture. 0: cancelled before each pixel had its first.
    pub samples: u64,
    /// Set if it was cancelled before all samples were taken.
    pub interrupted: Option<Interrupted>,
    /// Rays from the camera that went into the picture.
    pub rays: u64,
    /// Rays to lamps that went into the picture.
    pub shadow_rays: u64,
    /// Samples that were not finite and count as black.
    pub invalid: Option<Invalid>,
    /// Pixels too bright for f32, which stand at its largest number.
    pub clipped: u64,
}

/// How far a cancelled render came beyond whole passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interrupted {
    /// Tiles with light in them, when it was cancelled in the first pass: the others are black.
    /// None if every pixel has `Outcome::samples` samples.
    pub tiles: Option<Finished>,
}

/// How many of some are finished.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Finished {
    /// So many are.
    pub done: usize,
    /// So many there are.
    pub of: usize,
}

/// Takes all samples of all pixels of the film's window, or as many as there is time for.
pub fn render(
    world: &World,
    integrator: &Integrator,
    settings: &Settings,
    watch: &dyn Watch,
) -> Outcome {
    let pixels = world.film.window.pixels();
    let total = pixels.saturating_mul(settings.samples);
    let taken = AtomicU64::new(0);
    let advance = |samples: u64| {
        let before = taken.fetch_add(samples, Ordering::Relaxed);
        watch.progress((before + samples).min(total), total);
    };
    let cancelled = || watch.cancelled();

    let mut blocks = Total::default();
    let mut begun: Option<Sums> = None;
    let mut done = 0;
    let mut pace = Pace::new();
    while done < settings.samples {
        let left = (settings.samples - done).min(BLOCK - done % BLOCK);
        let samples = done..done + pace.samples().min(left);
        let start = watch.now();
        let job = Job {
            seed: settings.seed,
            samples: samples.clone(),
            from: begun.as_deref(),
            cancelled: &cancelled,
            advance: &advance,
        };
        let tiles = integrator.pass(world, &job);
        if tiles.iter().any(Option::is_none) {
            if done == 0 {
                return first_pass_alone(world, tiles, samples.end);
            }
            // The tiles that were finished are dropped: each pixel has the same samples.
            break;
        }
        pace.took(samples.end - done, watch.now() - start);
        done = samples.end;
        let sums = tiles.into_iter().flatten().collect();
        if done % BLOCK == 0 {
            blocks.push(sums);
            begun = None;
        } else {
            begun = Some(sums);
        }
    }

    let sums = blocks.with(begun.as_ref()).unwrap_or_default();
    let tiles: Vec<_> = sums.into_iter().map(Some).collect();
    let interrupted = (done < settings.samples).then_some(Interrupted { tiles: None });
    outcome(world, &tiles, done, done, interrupted)
}

/// The finished tiles of a first pass, which took so many samples.
fn first_pass_alone(world: &World, tiles: Vec<Option<TileSums>>, samples: u64) -> Outcome {
    let done = tiles.iter().flatten().count();
    let finished = Finished { done, of: tiles.len() };
    outcome(world, &tiles, samples, 0, Some(Interrupted { tiles: Some(finished) }))
}

fn outcome(
    world: &World,
    tiles: &[Option<TileSums>],
    taken: u64,
    samples: u64,
    interrupted: Option<Interrupted>,
) -> Outcome {
    let counts = film::counts(tiles.iter().flatten());
    let developed = world.film.develop(tiles.iter().map(Option::as_ref), taken, world.light_unit);
    Outcome {
        picture: developed.picture,
        samples,
        interrupted,
        rays: counts.rays,
        shadow_rays: counts.shadow_rays,
        invalid: counts.invalid,
        clipped: developed.clipped,
    }
}
