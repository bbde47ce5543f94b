//! A wave: samples that are taken together, each by itself.
//!
//! Whatever is done is done for all of them in turn. A sample alone keeps a processor waiting, as
//! each of its steps needs the one before; the same step of many samples does not. No sample learns
//! of another: each has its numbers, its ray, and what it brings home.

use super::carrier::{Carrier, GiveUp, PATIENCE};
use super::{Ray, Stream, Tracing, World};
use crate::render::lanes::LANES;
use crate::render::samplers::Fours;

/// Samples that are taken together.
pub struct Wave<'w> {
    pub(super) world: &'w World,
    give_up: Option<&'w GiveUp<'w>>,
    /// Their numbers, of which the film's filter has had its own.
    pub(super) streams: Vec<Stream>,
    /// For the next four of each.
    pub(super) fours: Fours,
    /// The camera's rays.
    pub(super) rays: Vec<Ray>,
    /// What the film's filter makes of each, as a factor.
    weights: Vec<f64>,
    /// What each brings home; those beyond the last sample are kept for their memory.
    pub(super) carriers: Vec<Carrier<'w>>,
    /// Where each group of samples ends that share light.
    pub(super) groups: Vec<usize>,
    /// Rays that were followed for all of them.
    followed: u64,
    /// One of them was given up: what they found are no samples.
    pub given_up: bool,
}

impl<'w> Wave<'w> {
    /// The most samples of a wave: several times as many as are on their way together, so that it has
    /// mostly as many.
    pub const MOST: usize = 4 * LANES;

    /// Of no samples yet; now and then they ask `give_up` whether to go on.
    pub fn new(world: &'w World, give_up: Option<&'w GiveUp<'w>>) -> Self {
        Self {
            world,
            give_up,
            streams: Vec::new(),
            fours: Fours::default(),
            rays: Vec::new(),
            weights: Vec::new(),
            carriers: Vec::new(),
            groups: Vec::new(),
            followed: 0,
            given_up: false,
        }
    }

    /// Begins these samples, each of a pixel, in place of those before; [`Self::MOST`] at most. Those
    /// that may share light are together, in groups that end there.
    pub fn begin(
        &mut self,
        seed: u64,
        mut samples: impl Iterator<Item = ([u64; 2], u64)> + Clone,
        groups: &[usize],
    ) {
        let world = self.world;
        self.followed = 0;
        self.groups.clear();
        self.groups.extend_from_slice(groups);
        self.streams.clear();
        self.rays.clear();
        self.weights.clear();
        loop {
            let first = self.streams.len();
            self.fours.clear();
            for ([x, y], sample) in samples.clone().take(LANES) {
                let mut stream = world.sampler.stream(seed, world.film.index(x, y), sample);
                self.fours.push(&mut stream);
                self.streams.push(stream);
            }
            if self.streams.len() == first {
                break;
            }
            self.fours.draw();
            for (lane, ([x, y], _)) in samples.by_ref().take(LANES).enumerate() {
                let [u, v, ..] = self.fours.at(lane);
                let (dx, dy, weight) = world.film.filter.sample([u, v]);
                self.rays.push(world.camera.ray(x as f64 + 0.5 + dx, y as f64 + 0.5 + dy));
                self.weights.push(weight);
            }
        }
        while self.carriers.len() < self.rays.len() {
            self.carriers.push(Carrier::new(world, self.give_up));
        }
    }

    /// What each of them brings home, and what the film's filter makes of it, as a factor.
    pub fn brought(&self) -> impl Iterator<Item = (&Carrier<'w>, f64)> {
        self.carriers.iter().zip(self.weights.iter().copied())
    }

    /// So many rays more are followed. Now and then that is a question whether to go on.
    pub(super) fn follow(&mut self, rays: usize) {
        let asked = self.followed / PATIENCE;
        self.followed += rays as u64;
        if self.followed / PATIENCE > asked {
            self.given_up |= self.give_up.is_some_and(|give_up| give_up(self.followed));
        }
    }

    /// Paths are to be kept, surface by surface.
    pub(super) fn trace(&mut self) {
        self.carriers.iter_mut().for_each(|carrier| carrier.traced = Some(Tracing::default()));
    }

    /// Follows them one after the other.
    pub fn each(&mut self, mut radiance: impl FnMut(&Ray, &mut Stream, &mut Carrier)) {
        for ((ray, stream), carrier) in
            self.rays.iter().zip(&mut self.streams).zip(&mut self.carriers)
        {
            radiance(ray, stream, carrier);
            if carrier.given_up {
                self.given_up = true;
                return;
            }
        }
    }
}
