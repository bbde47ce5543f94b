//! A short render: what a whole one will take, and how wrong it will be.

use std::collections::HashMap;
use std::ops::Range;

use super::judge::epsilon;
use crate::math::{MeanPixel, random};
use crate::measure::noise::{Noise, Share};
use crate::render::World;
use crate::render::film::{Taken, TileMeans};
use crate::render::integrators::Integrator;
use crate::render::samplers::Rhythm;
use crate::render::tiles::Job;

/// What a pilot run found.
#[derive(Clone, Copy, Debug)]
pub struct Pilot {
    /// Samples of each pixel.
    pub samples: u64,
    /// Pixels that had them.
    pub pixels: u64,
    /// Samples of all pixels that were timed: all but the first of each.
    pub timed: u64,
    /// Seconds they took.
    pub seconds: f64,
    /// Rays to lamps for each ray from the camera.
    pub shadow_rays: f64,
    /// The noise of those pixels; None if nothing is known of it.
    pub noise: Option<Noise>,
    /// Whether the noise is only a bound from above.
    pub bound: bool,
}

impl Pilot {
    /// Samples a second, of all pixels together.
    pub fn rate(&self) -> f64 {
        // Clocks are others'.
        self.timed as f64 / self.seconds.max(1e-9)
    }
}

/// Samples of a pilot run's second part, of all pixels together; about.
const SAMPLES: u64 = 1 << 18;

/// Samples of each pixel, where two rounds are more than these.
const FEW: u64 = 16;

/// Tiles that are looked at at most.
const MOST_TILES: usize = 4096;

/// Two samples of every tile tell how long it takes and where the noise is: at a few edges, often.
/// Then more samples of the noisiest tiles, and of some of the others, which stand for all others.
/// The same tiles and samples in every run. `now` tells seconds since any fixed moment.
pub fn pilot(world: &World, integrator: &Integrator, seed: u64, now: &dyn Fn() -> f64) -> Pilot {
    let rhythm = world.sampler.rhythm();
    let samples = samples(rhythm);
    let all = world.film.tiles();
    let mut taken = Taken::new(&world.film, rhythm, 0);
    let take = |taken: &mut Taken, tiles: &[usize], range: Range<u64>| {
        let job = Job {
            seed,
            samples: range.clone(),
            tiles,
            taken,
            cancelled: &|_| false,
            advance: &|_| (),
        };
        for (tile, sums) in tiles.iter().zip(integrator.pass(world, &job)) {
            if let Some(sums) = sums {
                taken.put(*tile, sums, range.end);
            }
        }
    };
    let looked = chosen(all.len(), MOST_TILES);
    // The first warms caches up.
    take(&mut taken, &looked, 0..1);
    let begun = now();
    take(&mut taken, &looked, 1..2);
    let seconds = now() - begun;
    let counts = taken.counts();
    let timed = looked.iter().map(|tile| all[*tile].pixels()).sum();

    let (noisy, others) =
        parts(world, &taken, looked, (SAMPLES / samples / all[0].pixels()) as usize);
    let some = chosen(others.len(), noisy.len().max(1));
    let some: Vec<usize> = some.into_iter().map(|nth| others[nth]).collect();
    let mut tiles = [&noisy[..], &some[..]].concat();
    tiles.sort_unstable();
    take(&mut taken, &tiles, 2..samples);
    let stands_for = others.len() as f64 / some.len().max(1) as f64;
    let weight = |tile: usize| if noisy.contains(&tile) { 1.0 } else { stands_for };
    let (noise, bound) = noise_of(world, &taken, &tiles, weight);
    Pilot {
        samples,
        pixels: tiles.iter().map(|tile| all[*tile].pixels()).sum(),
        timed,
        seconds,
        shadow_rays: counts.shadow_rays as f64 / counts.rays.max(1) as f64,
        noise,
        bound,
    }
}

/// The noisiest of some tiles, half of so many, and all others in their order.
fn parts(
    world: &World,
    taken: &Taken,
    mut looked: Vec<usize>,
    wanted: usize,
) -> (Vec<usize>, Vec<usize>) {
    if looked.len() <= wanted {
        return (looked, Vec::new());
    }
    let means: Vec<TileMeans> = taken.means(&world.film.window, world.light_unit).collect();
    let epsilon = epsilon(pixels(means.iter()));
    let noise = |tile: &usize| {
        let means = &means[*tile];
        Share::of(&means.pixels, means.freedom.max(1), means.bound, epsilon).noise(epsilon).relmse
    };
    let noise: HashMap<usize, f64> = looked.iter().map(|tile| (*tile, noise(tile))).collect();
    looked.sort_by(|a, b| noise[b].total_cmp(&noise[a]).then(a.cmp(b)));
    let mut others = looked.split_off((wanted / 2).max(1));
    others.sort_unstable();
    (looked, others)
}

/// Samples of each pixel: two whole rounds, if they are not too many, since only rounds tell how
/// good a sampler is.
fn samples(rhythm: Rhythm) -> u64 {
    let rounds = FEW.div_ceil(rhythm.round).max(2) * rhythm.round;
    if rounds <= 2 * FEW { rounds } else { FEW }
}

/// Some of so many tiles, spread over all: one at a random place in each of equal parts, so that
/// they do not stand in columns.
fn chosen(all: usize, wanted: usize) -> Vec<usize> {
    let wanted = wanted.min(all);
    let place = |part: usize| {
        let [jitter, _] = random::unit_pair(random::mix(part as u64));
        let place = (part as f64 + jitter) * all as f64 / wanted as f64;
        (place as usize).min(all - 1)
    };
    let mut tiles: Vec<usize> =
        if wanted == all { (0..all).collect() } else { (0..wanted).map(place).collect() };
    tiles.dedup();
    tiles
}

/// The noise of a picture for which these tiles stand, each for so many.
fn noise_of(
    world: &World,
    taken: &Taken,
    tiles: &[usize],
    weight: impl Fn(usize) -> f64,
) -> (Option<Noise>, bool) {
    let means: Vec<(usize, TileMeans)> = taken
        .means(&world.film.window, world.light_unit)
        .enumerate()
        .filter(|(index, _)| tiles.binary_search(index).is_ok())
        .collect();
    if means.iter().any(|(_, tile)| tile.freedom == 0) {
        return (None, false);
    }
    let epsilon = epsilon(pixels(means.iter().map(|(_, tile)| tile)));
    let share = |(index, tile): &(usize, TileMeans)| {
        Share::of(&tile.pixels, tile.freedom, tile.bound, epsilon).times(weight(*index))
    };
    let all = means.iter().map(share).fold(Share::default(), |all, share| all.and(&share));
    (Some(all.noise(epsilon)), means.iter().any(|(_, tile)| tile.bound))
}

fn pixels<'a>(means: impl Iterator<Item = &'a TileMeans>) -> impl Iterator<Item = MeanPixel> {
    means.flat_map(|tile| tile.pixels.iter().copied())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_are_chosen_once_in_order_all_over() {
        for (all, wanted) in [(1, 1), (1, 9), (9, 9), (10, 9), (1024, 32)] {
            let tiles = chosen(all, wanted);
            assert!(tiles.is_sorted_by(|a, b| a < b) && *tiles.last().unwrap() < all, "{tiles:?}");
            assert!(tiles.len() >= wanted.min(all) / 2, "{tiles:?}");
        }
        assert_eq!(chosen(9, 9).len(), 9);
        let columns: std::collections::BTreeSet<_> =
            chosen(1024, 32).iter().map(|i| i % 32).collect();
        assert!(columns.len() > 12, "{columns:?}");
    }

    #[test]
    fn two_rounds_are_taken_where_they_are_few() {
        for (round, expected) in [(1, 16), (4, 16), (9, 18), (16, 32), (25, 16), (1 << 20, 16)] {
            assert_eq!(samples(Rhythm { round, block: 2 * round }), expected, "{round}");
        }
    }
}
