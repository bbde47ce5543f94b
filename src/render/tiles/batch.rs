//! Samples of a part of the film, wave by wave.

use super::{Counts, Invalid, Job, Place};
use crate::math::Rgb;
use crate::render::World;
use crate::render::film::{Begun, Groups, Tile};
use crate::render::integrators::Wave;

/// Takes the job's samples of tiles, each with what was taken before, in groups of so many pixels;
/// those of one cell if there are any. None if one of them was given up.
pub(super) fn take(
    world: &World,
    job: &Job,
    tiles: &[(Tile, Option<&Begun>)],
    group: usize,
    follow: impl FnMut(&mut Wave),
) -> Option<Vec<Begun>> {
    let rhythm = world.sampler.rhythm();
    let block = job.samples.start / rhythm.block;
    let begun = |(tile, from): &(Tile, Option<&Begun>)| {
        let fresh = || Begun::new([tile.pixels() as usize, world.film.layers], block, rhythm);
        (*tile, from.cloned().unwrap_or_else(fresh))
    };
    let mut batch = Batch {
        world,
        seed: job.seed,
        tiles: tiles.iter().map(begun).collect(),
        samples: Vec::with_capacity(Wave::MOST),
        ends: Vec::new(),
        wave: Wave::new(world, Some(job.cancelled)),
        follow,
    };
    if group > 1 {
        let mut groups = Groups::new(&world.film, &tiles.first()?.0, group, job.seed);
        for number in job.samples.clone() {
            groups.of(number).try_for_each(|pixels| batch.add(number, pixels))?;
        }
    } else {
        // The samples of a pixel, then those of the next.
        for (tile, _) in tiles {
            for (x, y) in tile.places() {
                job.samples.clone().try_for_each(|number| batch.add(number, &[[x, y]]))?;
            }
        }
    }
    batch.take()?;
    Some(batch.tiles.into_iter().map(|(_, begun)| begun).collect())
}

/// Samples that are to be taken together.
struct Batch<'w, F> {
    world: &'w World,
    seed: u64,
    /// What is wanted.
    tiles: Vec<(Tile, Begun)>,
    samples: Vec<Sample>,
    /// Where each group of them ends.
    ends: Vec<usize>,
    wave: Wave<'w>,
    /// Follows them.
    follow: F,
}

/// A sample of a pixel.
struct Sample {
    /// The tile, and the number of the pixel in it. None: only other pixels want its light.
    index: Option<(usize, usize)>,
    /// Its place on the whole film.
    pixel: [u64; 2],
    /// Number of the sample, from 0.
    number: u64,
}

impl<F: FnMut(&mut Wave)> Batch<'_, F> {
    /// Adds a sample of each pixel of a group, if any of them is wanted. None if one was given up.
    fn add(&mut self, number: u64, pixels: &[[u64; 2]]) -> Option<()> {
        if self.samples.len() + pixels.len() > Wave::MOST {
            self.take()?;
        }
        let first = self.samples.len();
        for &pixel in pixels {
            let tiles = self.tiles.iter().enumerate();
            let index = tiles
                .map(|(nth, (tile, _))| tile.index(pixel).map(|index| (nth, index)))
                .find_map(|index| index);
            self.samples.push(Sample { index, pixel, number });
        }
        if self.samples[first..].iter().all(|sample| sample.index.is_none()) {
            self.samples.truncate(first);
        } else {
            self.ends.push(self.samples.len());
        }
        Some(())
    }

    /// Takes them, and adds them to their pixels in their order. None if one of them was given up.
    fn take(&mut self) -> Option<()> {
        let Self { world, tiles, samples, wave, .. } = self;
        let all = samples.iter().map(|sample| (sample.pixel, sample.number));
        wave.begin(self.seed, all, &self.ends);
        (self.follow)(wave);
        if wave.given_up {
            return None;
        }
        let rhythm = world.sampler.rhythm();
        let layers = world.film.layers;
        let mut brought = wave.brought();
        for of_pixel in samples.chunk_by(|a, b| a.index == b.index) {
            let brought = brought.by_ref().take(of_pixel.len());
            let Some((tile, index)) = of_pixel[0].index else {
                brought.for_each(drop);
                continue;
            };
            let begun = &mut tiles[tile].1;
            let (mut counts, mut pixel) = (*begun.counts(), begun.pixel(index));
            for (sample, (carrier, weight)) in of_pixel.iter().zip(brought) {
                counts.rays += 1;
                counts.shadow_rays += carrier.shadow_rays;
                let weighed = |radiance: Rgb| {
                    let [r, g, b] = radiance.to_array();
                    [weight * f64::from(r), weight * f64::from(g), weight * f64::from(b)]
                };
                let value = if carrier.radiance.is_finite() {
                    let sums = begun.layers(index, layers);
                    for (sum, layer) in sums.iter_mut().zip(&carrier.layers) {
                        let value = weighed(*layer);
                        (0..3).for_each(|channel| sum[channel] += value[channel]);
                    }
                    weighed(carrier.radiance)
                } else {
                    let ([x, y], object) = (sample.pixel, carrier.object);
                    let first = Place { y, x, sample: sample.number, object };
                    let invalid = Some(Invalid { count: 1, first });
                    counts.add(&Counts { invalid, ..Counts::default() });
                    [0.0; 3]
                };
                pixel.add(value, sample.number % rhythm.block, rhythm);
            }
            begun.put(index, &pixel);
            *begun.counts() = counts;
        }
        drop(brought);
        samples.clear();
        self.ends.clear();
        Some(())
    }
}
