//! The tile loop: a pass over the picture, spread over threads.
//!
//! A pass is a function of the world and a range of samples. Tiles are computed apart, each by
//! one thread from its first sample to its last, so nothing depends on which thread does which.

use std::ops::Range;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::World;
use super::film::{Begun, Groups, Taken, Tile};
use super::integrators::{GiveUp, Wave};
use crate::math::Rgb;

/// What a pass is asked to do.
pub struct Job<'a> {
    /// Chooses all random numbers.
    pub seed: u64,
    /// Samples of every pixel, counted from the first of the whole render; all of one block.
    pub samples: Range<u64>,
    /// Which tiles of the film are to have them.
    pub tiles: &'a [usize],
    /// What was taken before, up to these samples.
    pub taken: &'a Taken,
    /// Whether to leave the rest undone. Asked before each tile; and now and then in a sample, or
    /// in those that are taken together, with the rays followed, since one alone may take for ever.
    pub cancelled: &'a GiveUp<'a>,
    /// Told after each tile how many samples were taken in it.
    pub advance: &'a (dyn Fn(u64) + Sync),
}

/// What is counted while samples are taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    /// Rays from the camera.
    pub rays: u64,
    /// Rays to lamps.
    pub shadow_rays: u64,
    /// Samples that were not finite.
    pub invalid: Option<Invalid>,
}

/// Samples that were not finite. They count as black.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Invalid {
    /// How many.
    pub count: u64,
    /// Where: the lowest pixel, and its lowest sample.
    pub first: Place,
}

/// A sample's place. Ordered by pixel in reading order of the whole film, then by sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Place {
    /// Row of the whole film, from the top.
    pub y: u64,
    /// Column of the whole film, from the left.
    pub x: u64,
    /// Number of the sample, from 0.
    pub sample: u64,
    /// Number of the object that the camera's ray met.
    pub object: Option<u32>,
}

impl Counts {
    /// Adds what was counted elsewhere.
    pub fn add(&mut self, other: &Self) {
        // What was read from a file may be any number.
        self.rays = self.rays.saturating_add(other.rays);
        self.shadow_rays = self.shadow_rays.saturating_add(other.shadow_rays);
        self.invalid = match (self.invalid, other.invalid) {
            (Some(a), Some(b)) => {
                let count = a.count.saturating_add(b.count);
                Some(Invalid { count, first: a.first.min(b.first) })
            }
            (a, b) => a.or(b),
        };
    }
}

/// Takes the job's samples of every pixel of its tiles: the sums of each tile's block, with what
/// was taken before. A tile is None if the job was cancelled before its end. `follower` makes for each
/// tile what follows the samples of a wave, where groups of so many pixels are to be together.
pub fn pass<F>(
    world: &World,
    job: &Job,
    group: usize,
    follower: impl Fn() -> F + Sync,
) -> Vec<Option<Begun>>
where
    F: FnMut(&mut Wave),
{
    let tiles = world.film.tiles();
    job.tiles
        .par_iter()
        .with_max_len(1)
        .map(|&index| {
            if (job.cancelled)(0) {
                return None;
            }
            let tile = &tiles[index];
            let sums = one(world, job, (tile, group), job.taken.begun(index), follower())?;
            (job.advance)(tile.pixels() * (job.samples.end - job.samples.start));
            Some(sums)
        })
        .collect()
}

/// The samples of one tile, in groups of so many pixels; None if one of them was given up.
fn one(
    world: &World,
    job: &Job,
    (tile, group): (&Tile, usize),
    from: Option<&Begun>,
    mut follow: impl FnMut(&mut Wave),
) -> Option<Begun> {
    let rhythm = world.sampler.rhythm();
    let block = job.samples.start / rhythm.block;
    let fresh = || Begun::new([tile.pixels() as usize, world.film.layers], block, rhythm);
    let mut begun = from.cloned().unwrap_or_else(fresh);
    let mut wave = Wave::new(world, Some(job.cancelled));
    let mut batch = Batch::default();
    if group == 1 {
        // The samples of a pixel, then those of the next.
        for (x, y) in tile.places() {
            for number in job.samples.clone() {
                batch.push(tile, number, &[[x, y]]);
                if batch.is_full(group) {
                    batch.take(world, job.seed, (&mut wave, &mut follow), &mut begun)?;
                }
            }
        }
    } else {
        let mut groups = Groups::new(&world.film, tile, group, job.seed);
        for number in job.samples.clone() {
            for pixels in groups.of(number) {
                batch.push(tile, number, pixels);
                if batch.is_full(group) {
                    batch.take(world, job.seed, (&mut wave, &mut follow), &mut begun)?;
                }
            }
        }
    }
    batch.take(world, job.seed, (&mut wave, &mut follow), &mut begun)?;
    Some(begun)
}

/// Samples that are to be taken together.
#[derive(Default)]
struct Batch {
    samples: Vec<Sample>,
    /// Where each group of them ends.
    ends: Vec<usize>,
}

/// A sample of a pixel.
struct Sample {
    /// Number of the pixel in its tile; None: it is beside it, and only others want its light.
    index: Option<usize>,
    /// Its place on the whole film.
    pixel: [u64; 2],
    /// Number of the sample, from 0.
    number: u64,
}

impl Batch {
    /// Adds a sample of each pixel of a group, if any of them is in the tile.
    fn push(&mut self, tile: &Tile, number: u64, pixels: &[[u64; 2]]) {
        let first = self.samples.len();
        let samples = pixels.iter();
        self.samples.extend(samples.map(|&pixel| Sample { index: tile.index(pixel), pixel, number }));
        if self.samples[first..].iter().all(|sample| sample.index.is_none()) {
            return self.samples.truncate(first);
        }
        self.ends.push(self.samples.len());
    }

    /// Whether there is no place for one more group of that size.
    fn is_full(&self, group: usize) -> bool {
        self.samples.len() + group > Wave::MOST
    }

    /// Takes them, and adds them to their pixels in their order. None if one of them was given up.
    fn take(
        &mut self,
        world: &World,
        seed: u64,
        (wave, follow): (&mut Wave, &mut impl FnMut(&mut Wave)),
        begun: &mut Begun,
    ) -> Option<()> {
        let samples = self.samples.iter().map(|sample| (sample.pixel, sample.number));
        wave.begin(seed, samples, &self.ends);
        follow(wave);
        if wave.given_up {
            return None;
        }
        let rhythm = world.sampler.rhythm();
        let layers = world.film.layers;
        let mut counts = *begun.counts();
        let mut brought = wave.brought();
        for of_pixel in self.samples.chunk_by(|a, b| a.index == b.index) {
            let brought = brought.by_ref().take(of_pixel.len());
            let Some(index) = of_pixel[0].index else {
                brought.for_each(drop);
                continue;
            };
            let mut pixel = begun.pixel(index);
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
        }
        *begun.counts() = counts;
        self.samples.clear();
        self.ends.clear();
        Some(())
    }
}

/// The most threads for each processor: more of them only take each other's time.
const MOST_A_PROCESSOR: usize = 8;

/// A pool of so many threads, in place of one for each processor.
pub struct Threads(rayon::ThreadPool);

impl Threads {
    /// Of so many threads, or of fewer if that is many times the processors: the work comes out the
    /// same. None if the system will not give so many.
    pub fn new(count: usize) -> Option<Self> {
        let processors = std::thread::available_parallelism().map_or(1, usize::from);
        let count = count.min(processors.saturating_mul(MOST_A_PROCESSOR));
        rayon::ThreadPoolBuilder::new().num_threads(count).build().ok().map(Self)
    }

    /// Does `work` with these threads, and everything that it spreads over threads.
    pub fn run<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        self.0.install(work)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;
    use crate::render::cameras::{Camera, Perspective};
    use crate::render::film::{Film, Filter, Window};
    use crate::render::geometry::{Geometry, Ray, Shapes};
    use crate::render::integrators::Carrier;
    use crate::render::lights::Lights;
    use crate::render::materials::Makeup;
    use crate::render::samplers::{Sampler, Stream};
    use glam::DVec3;

    fn world() -> World {
        let size = [40, 20];
        let eye = Perspective::new(DVec3::ZERO, DVec3::Z, DVec3::Y, 1.0, size);
        World {
            geometry: Geometry::build(Shapes::new()),
            materials: Vec::new(),
            media: Vec::new(),
            overlaps: None,
            camera_medium: 0,
            makeup: Makeup::Any,
            lights: Lights::default(),
            guide: None,
            camera: Camera::Perspective(eye),
            film: Film {
                size,
                window: Window { x0: 2, y0: 1, x1: 40, y1: 20 },
                filter: Filter::Box { radius: 0.5 },
                layers: 0,
            },
            paths: None,
            sampler: Sampler::Independent,
            light_unit: 1.0,
        }
    }

    /// What was taken, and these samples of all tiles in one pass.
    fn more<F>(world: &World, mut taken: Taken, samples: Range<u64>, radiance: F) -> Taken
    where
        F: Fn(&Ray, &mut Stream, &mut Carrier) + Sync,
    {
        let follower = || |wave: &mut Wave| wave.each(&radiance);
        let tiles: Vec<usize> = (0..taken.tiles()).collect();
        let end = samples.end;
        let job = Job {
            seed: 1,
            samples,
            tiles: &tiles,
            taken: &taken,
            cancelled: &|_| false,
            advance: &|_| (),
        };
        for (tile, begun) in pass(world, &job, 1, follower).into_iter().enumerate() {
            taken.put(tile, begun.unwrap(), end);
        }
        taken
    }

    fn nothing(world: &World) -> Taken {
        Taken::new(&world.film, world.sampler.rhythm(), 0)
    }

    /// Not finite where the ray goes to the left and down; else one.
    fn broken(ray: &Ray, _: &mut Stream, carrier: &mut Carrier) {
        let bad = ray.direction.x > 0.0 && ray.direction.y < 0.0;
        let value =
            if bad { [f32::NAN, f32::INFINITY][usize::from(ray.direction.x > 0.1)] } else { 1.0 };
        carrier.radiance = Rgb::new(1.0, value, 1.0);
        carrier.object = Some(7);
    }

    #[test]
    fn samples_that_are_not_finite_are_counted_located_and_black() {
        let world = world();
        let taken = more(&world, nothing(&world), 0..3, broken);
        let counts = taken.counts();
        assert_eq!(counts.rays, 38 * 19 * 3);
        let invalid = counts.invalid.unwrap();
        // Looking along +z with +y up, +x is to the left: columns 2 to 19, rows 10 to 19.
        assert_eq!(invalid.count, 18 * 10 * 3);
        assert_eq!(invalid.first, Place { y: 10, x: 2, sample: 0, object: Some(7) });
        for means in taken.means(&world.film.window, 1.0) {
            for ((x, y), pixel) in means.tile.places().zip(&means.pixels) {
                let expected = if x < 20 && y >= 10 { 0.0 } else { 1.0 };
                assert_eq!(pixel.mean, [expected; 3], "{x} {y}");
            }
        }
    }

    #[test]
    fn passes_go_on_where_others_ended() {
        let world = world();
        let value = |ray: &Ray, stream: &mut Stream, carrier: &mut Carrier| {
            let [u, _] = stream.pair();
            carrier.radiance = Rgb::grey(ray.direction.x * u as f32 / 3.0);
        };
        let whole = more(&world, nothing(&world), 0..10, value);
        let first = more(&world, nothing(&world), 0..3, value);
        assert_eq!(more(&world, first, 3..10, value), whole);
    }
}
