//! The tile loop: a pass over the picture, spread over threads.
//!
//! A pass is a function of the world and a range of samples. Tiles are computed apart, each by
//! one thread from its first sample to its last, so nothing depends on which thread does which.

mod batch;

use std::collections::HashMap;
use std::ops::Range;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::World;
use super::film::{Begun, Taken, Tile};
use super::integrators::{GiveUp, Wave};

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
/// part of the film what follows the samples of a wave, where groups of so many pixels are together.
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
    // Each tile by itself; of those of a cell, where groups are, the first for all.
    let mut first = HashMap::new();
    let mut parts: Vec<Vec<usize>> = Vec::new();
    for (nth, &index) in job.tiles.iter().enumerate() {
        let part = if group > 1 { tiles[index].cell() } else { [nth as u64, 0] };
        let part = *first.entry(part).or_insert(parts.len());
        if part == parts.len() {
            parts.push(Vec::new());
        }
        parts[part].push(nth);
    }
    let taken: Vec<(usize, Option<Begun>)> = parts
        .into_par_iter()
        .with_max_len(1)
        .flat_map_iter(|part| {
            let of = |nth: &usize| {
                let index = job.tiles[*nth];
                (tiles[index], job.taken.begun(index))
            };
            let of: Vec<(Tile, Option<&Begun>)> = part.iter().map(of).collect();
            let sums = match (job.cancelled)(0) {
                true => None,
                false => batch::take(world, job, &of, group, follower()),
            };
            if sums.is_some() {
                let pixels: u64 = of.iter().map(|(tile, _)| tile.pixels()).sum();
                (job.advance)(pixels * (job.samples.end - job.samples.start));
            }
            let sums =
                sums.map_or(vec![None; part.len()], |sums| sums.into_iter().map(Some).collect());
            part.into_iter().zip(sums)
        })
        .collect();
    let mut all = vec![None; job.tiles.len()];
    for (nth, begun) in taken {
        all[nth] = begun;
    }
    all
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

    /// How many there are where this is asked.
    pub fn here() -> usize {
        rayon::current_num_threads()
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
