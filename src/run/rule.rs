//! Stop rules: after so many samples, so much time, or when the error is small enough.
//!
//! The error is looked at only when the number of samples has doubled, from [`LEAST_FOR_ERROR`] on:
//! whoever looks all the time stops at the first lucky moment. It counts by the upper end of its
//! interval, and not as long as most of it hangs on pixels that owe much of their light to one
//! sample. Where tiles end one by one, a tile ends only together with all that touch it: a tile
//! that has missed some rare light looks done, but its neighbours may know better.

use serde::{Deserialize, Serialize};

use super::Stopped;
use super::judge::{self, Judgement};
use crate::measure::noise::Noise;
use crate::render::World;
use crate::render::film::Taken;
use crate::render::samplers::Rhythm;

/// The error decides nothing before each pixel has so many samples.
pub const LEAST_FOR_ERROR: u64 = 256;

/// Doubtful pixels may make no more than this part of an error that is believed.
pub const MOST_DOUBTFUL: f64 = 0.5;

/// When a picture is done.
#[derive(Clone, Debug, PartialEq)]
pub enum Until {
    /// When one of several limits is reached.
    Rule(Rule),
    /// When each tile of the film has so many samples: a picture made once more.
    Schedule(Vec<u64>),
}

/// Limits: the first that is reached ends the render. Without any it never ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Rule {
    /// One past the last sample of each pixel.
    pub samples: Option<u64>,
    /// Seconds of rendering. Each pixel has one sample at least.
    pub time: Option<f64>,
    /// Upper end of the interval of √relMSE.
    pub error: Option<f64>,
    /// Whether tiles end one by one as they reach the error.
    pub adaptive: bool,
}

/// What to do next.
pub(super) enum Decision {
    /// Nothing: the picture is done.
    Stop(Stopped),
    /// To take samples.
    Take(Left),
}

/// What is left to do before the next decision.
pub(super) struct Left {
    /// The tiles that need samples, at least one; all have the same number.
    pub tiles: Vec<usize>,
    /// One past the last sample before the next decision.
    pub until: u64,
    /// One past the last sample of all, as far as can be guessed.
    pub expected: u64,
    /// Seconds that are left.
    pub seconds: Option<f64>,
}

impl Until {
    /// What to do after what was taken in so many seconds. `judged` is the last judgement.
    pub(super) fn decide(
        &self,
        world: &World,
        taken: &Taken,
        judged: &mut Option<Judgement>,
        seconds: f64,
    ) -> Decision {
        match self {
            Self::Rule(rule) => rule.decide(world, taken, judged, seconds),
            Self::Schedule(ends) => follow(ends, taken),
        }
    }

    /// Seconds after which the picture is done, if they count.
    pub(super) fn time(&self) -> Option<f64> {
        match self {
            Self::Rule(rule) => rule.time,
            Self::Schedule(_) => None,
        }
    }
}

/// The tiles that are furthest behind take samples up to the next number that ends a tile.
fn follow(ends: &[u64], taken: &Taken) -> Decision {
    let unfinished = || (0..ends.len()).filter(|&tile| taken.end(tile) < ends[tile]);
    let Some(from) = unfinished().map(|tile| taken.end(tile)).min() else {
        return Decision::Stop(Stopped::Samples);
    };
    let tiles: Vec<usize> = unfinished().filter(|&tile| taken.end(tile) == from).collect();
    let until = tiles.iter().map(|&tile| ends[tile]).min().unwrap_or(from);
    let expected = tiles.iter().map(|&tile| ends[tile]).max().unwrap_or(from);
    Decision::Take(Left { tiles, until, expected, seconds: None })
}

impl Rule {
    fn decide(
        &self,
        world: &World,
        taken: &Taken,
        judged: &mut Option<Judgement>,
        seconds: f64,
    ) -> Decision {
        let rhythm = world.sampler.rhythm();
        // Tiles that have less were ended.
        let now = taken.ends().max().unwrap_or(0);
        let mut tiles: Vec<usize> =
            (0..taken.tiles()).filter(|&tile| taken.end(tile) == now).collect();
        let next = next_check(now, rhythm);
        if let Some(error) = self.error
            && is_check(now, rhythm)
        {
            *judged = judge::judge(&world.film.window, world.light_unit, taken);
            let settled = |noise: &Noise| settled(noise, error);
            if let Some(judged) = judged {
                if settled(&judged.whole()) {
                    return Decision::Stop(Stopped::Error);
                }
                if self.adaptive {
                    let done: Vec<bool> = (0..taken.tiles())
                        .map(|tile| taken.end(tile) < now || settled(&judged.tile(tile)))
                        .collect();
                    let columns = world.film.window.tile_columns();
                    tiles.retain(|&tile| !around(tile, columns, done.len()).all(|i| done[i]));
                    if tiles.is_empty() {
                        return Decision::Stop(Stopped::Error);
                    }
                }
            }
        }
        if self.samples.is_some_and(|samples| now >= samples) {
            return Decision::Stop(Stopped::Samples);
        }
        let begun = now > taken.first();
        if begun && self.time.is_some_and(|time| seconds >= time) {
            return Decision::Stop(Stopped::Time);
        }

        let mut until = self.samples.unwrap_or(u64::MAX);
        let mut expected = until;
        if let Some(error) = self.error {
            until = until.min(next);
            let factor = judged.as_ref().map_or(0.0, |it| it.whole().high / (error * error));
            let enough = (now as f64 * factor).min(1e15) as u64;
            expected = expected.min(next_check(enough.saturating_sub(1), rhythm).max(next));
        }
        if let Some(time) = self.time {
            let ratio = if seconds > 0.0 { time / seconds } else { 1.0 };
            expected = expected.min((now as f64 * ratio).min(1e15) as u64).max(now);
        }
        let left = self.time.filter(|_| begun).map(|time| time - seconds);
        Decision::Take(Left { tiles, until, expected, seconds: left })
    }
}

/// Whether the error is small enough, and to be believed.
fn settled(noise: &Noise, error: f64) -> bool {
    noise.high.sqrt() <= error && (noise.high == 0.0 || noise.doubtful_part <= MOST_DOUBTFUL)
}

/// How many samples each pixel has when the error is looked at first.
pub fn first_check(rhythm: Rhythm) -> u64 {
    LEAST_FOR_ERROR.next_multiple_of(rhythm.block)
}

/// The first check after so many samples.
fn next_check(samples: u64, rhythm: Rhythm) -> u64 {
    let mut check = first_check(rhythm);
    while check <= samples {
        check = check.saturating_mul(2);
    }
    check
}

fn is_check(samples: u64, rhythm: Rhythm) -> bool {
    samples > 0 && next_check(samples - 1, rhythm) == samples
}

/// A tile and those that touch it, in rows of so many.
fn around(tile: usize, columns: usize, tiles: usize) -> impl Iterator<Item = usize> {
    let (row, column) = (tile / columns, tile % columns);
    let rows = tiles.div_ceil(columns);
    let near = |place: usize, end: usize| place.saturating_sub(1)..(place + 2).min(end);
    near(row, rows).flat_map(move |row| near(column, columns).map(move |c| row * columns + c))
}
