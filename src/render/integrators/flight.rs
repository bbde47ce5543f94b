//! The paths of a wave's samples in flight: which there are, and where each stands.

use super::carrier::{Branch, Carrier, Trail};
use super::lit::Lit;
use super::path::Split;
use super::{Ray, Source, Wave, World};
use crate::math::Rgb;
use crate::render::geometry::{Hit, Meeting};
use crate::render::lights::{Arrivals, Site, Sites};
use crate::render::materials::{Cosines, Matter};

/// The paths in flight, and what they meet in a turn. Kept from wave to wave, for its memory.
pub struct Flight<M: Matter> {
    /// Of each sample the branch that is followed, by number of the sample.
    pub(super) branches: Vec<Branch>,
    /// The samples that have one.
    pub(super) lanes: Vec<usize>,
    /// Those that will have one in the next turn.
    pub(super) next: Next,
    /// Their rays, and what those meet.
    pub(super) rays: Vec<Ray>,
    pub(super) meetings: Vec<Option<Meeting>>,
    pub(super) hits: Vec<Option<Hit>>,
    /// What was met, where light goes on.
    pub(super) surfaces: Vec<Surface<M>>,
    /// Where those are.
    pub(super) sites: Sites,
    /// The paths that have come to them by scattering; None: it does not, or nothing is shown of it.
    pub(super) trails: Vec<Option<Trail>>,
    /// The light that lamps have for them.
    pub(super) arrivals: Arrivals,
    /// What they bring to each.
    pub(super) lit: Lit,
    /// The directions that light comes from.
    pub(super) cosines: Cosines,
    /// What has been asked of lamps.
    pub(super) questions: Questions,
}

/// Samples that go on.
#[derive(Default)]
pub(super) struct Next {
    pub lanes: Vec<usize>,
}

/// A surface that a path has met.
pub(super) struct Surface<M: Matter> {
    /// The sample.
    pub lane: usize,
    /// The number of its hit.
    pub place: usize,
    pub site: Site,
    pub bsdf: M::Bsdf,
    pub split: Split,
}

impl<M: Matter> Flight<M> {
    /// Of no wave yet.
    pub fn new() -> Self {
        Self {
            branches: Vec::new(),
            lanes: Vec::new(),
            next: Next::default(),
            rays: Vec::new(),
            meetings: Vec::new(),
            hits: Vec::new(),
            surfaces: Vec::new(),
            sites: Sites::default(),
            trails: Vec::new(),
            arrivals: Arrivals::default(),
            lit: Lit::default(),
            cosines: Cosines::default(),
            questions: Questions::default(),
        }
    }

    /// Begins the samples of a wave.
    pub(super) fn begin(&mut self, wave: &mut Wave) {
        self.branches.clear();
        for (ray, carrier) in wave.rays.iter().zip(&mut wave.carriers) {
            self.branches.push(Branch::first(wave.world, ray, carrier.start()));
        }
        self.lanes.clear();
        self.lanes.extend(0..self.branches.len());
    }

    /// Finds what the rays meet.
    pub(super) fn meet(&mut self, world: &World) {
        let count = self.lanes.len();
        self.rays.clear();
        self.rays.extend(self.lanes.iter().map(|&lane| self.branches[lane].ray));
        self.meetings.resize(count, None);
        world.geometry.meet_all(&self.rays, &mut self.meetings);
        self.hits.resize(count, None);
        world.geometry.hit_all(&self.rays, &self.meetings, &mut self.hits);
    }

    /// Begins the next turn.
    pub(super) fn turn(&mut self) {
        std::mem::swap(&mut self.lanes, &mut self.next.lanes);
        self.next.lanes.clear();
    }
}

impl Next {
    /// A branch has come to its end. The sample goes on by one that waits, if there is any.
    pub fn end(&mut self, lane: usize, branch: &mut Branch, carrier: &mut Carrier) {
        if let Some(next) = carrier.waiting.pop() {
            *branch = next;
            self.lanes.push(lane);
        }
    }
}

/// Light that lamps will bring if nothing is in its way.
#[derive(Default)]
pub(super) struct Questions {
    rays: Vec<Ray>,
    hidden: Vec<bool>,
    /// The sample, and what it will have.
    light: Vec<(usize, Trail, Rgb)>,
}

impl Questions {
    /// So many are answered together at most.
    const MOST: usize = 256;

    /// Brings light to a sample, if nothing is in its way where there are shadows.
    #[inline(always)]
    pub fn ask(
        &mut self,
        (world, shadows, carriers): (&World, bool, &mut [Carrier]),
        lane: usize,
        ray: Ray,
        (trail, light): (Trail, Rgb),
    ) {
        if !shadows {
            carriers[lane].add(trail, light, || Source::of(&ray));
            return;
        }
        self.rays.push(ray);
        self.light.push((lane, trail, light));
        if self.rays.len() >= Self::MOST {
            self.answer(world, carriers);
        }
    }

    /// Brings home the light of those that nothing is in the way of, in the order in which they were
    /// asked.
    pub fn answer(&mut self, world: &World, carriers: &mut [Carrier]) {
        self.hidden.resize(self.rays.len(), false);
        world.geometry.occluded_all(&self.rays, &mut self.hidden);
        for (nth, &(lane, trail, light)) in self.light.iter().enumerate() {
            let carrier = &mut carriers[lane];
            carrier.shadow_rays += 1;
            if !self.hidden[nth] {
                carrier.add(trail, light, || Source::of(&self.rays[nth]));
            }
        }
        self.rays.clear();
        self.light.clear();
    }
}
