//! A short render of a few tiles: what a whole one will take, and how wrong it will be.

use super::Settings;
use crate::math::random;
use crate::measure::noise::{self, Noise, Share};
use crate::render::World;
use crate::render::film::Taken;
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

/// Samples of a pilot run, of all pixels together; about.
const SAMPLES: u64 = 1 << 18;

/// Samples of each pixel, where two rounds are more than these.
const FEW: u64 = 16;

/// Renders a few tiles, the same ones with the same samples in every run. `now` tells seconds since
/// any fixed moment.
pub fn pilot(world: &World, integrator: &Integrator, seed: u64, now: &dyn Fn() -> f64) -> Pilot {
    let rhythm = world.sampler.rhythm();
    let samples = samples(rhythm);
    let all = world.film.tiles();
    let tiles = chosen(all.len(), (SAMPLES / samples / all[0].pixels()).max(1) as usize);
    let settings = Settings::samples(seed, samples);
    let mut taken = Taken::new(&world.film, rhythm, 0);
    // The first warms caches up.
    let mut begun = 0.0;
    for range in [0..1, 1..samples] {
        begun = now();
        let job = Job {
            seed: settings.seed,
            samples: range.clone(),
            tiles: &tiles,
            taken: &taken,
            cancelled: &|| false,
            advance: &|_| (),
        };
        let sums = integrator.pass(world, &job);
        for (tile, sums) in tiles.iter().zip(sums) {
            if let Some(sums) = sums {
                taken.put(*tile, sums, range.end);
            }
        }
    }
    let seconds = now() - begun;
    let counts = taken.counts();
    let (noise, bound) = noise_of(world, &taken, &tiles);
    let pixels = tiles.iter().map(|tile| all[*tile].pixels()).sum();
    Pilot {
        samples,
        pixels,
        timed: (samples - 1) * pixels,
        seconds,
        shadow_rays: counts.shadow_rays as f64 / counts.rays.max(1) as f64,
        noise,
        bound,
    }
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

fn noise_of(world: &World, taken: &Taken, tiles: &[usize]) -> (Option<Noise>, bool) {
    let means: Vec<_> = taken
        .means(&world.film.window, world.light_unit)
        .enumerate()
        .filter(|(index, _)| tiles.binary_search(index).is_ok())
        .map(|(_, means)| means)
        .collect();
    if means.iter().any(|tile| tile.freedom == 0) {
        return (None, false);
    }
    let pixels = means.iter().flat_map(|tile| &tile.pixels);
    let luminance = |[r, g, b]: [f64; 3]| 0.2126 * r + 0.7152 * g + 0.0722 * b;
    let epsilon = noise::epsilon(pixels.map(|pixel| luminance(pixel.mean)));
    let share = |tile: &crate::render::film::TileMeans| {
        Share::of(&tile.pixels, tile.freedom, tile.bound, epsilon)
    };
    let all = means.iter().map(share).fold(Share::default(), |all, share| all.and(&share));
    (Some(all.noise(epsilon)), means.iter().any(|tile| tile.bound))
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
