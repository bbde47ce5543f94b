//! The paths of a wave's samples in flight: which there are, and where each stands.

use glam::Vec3;

use super::carrier::{Branch, Carrier, Trail};
use super::lit::Lit;
use super::path::Split;
use super::reuse::Reuse;
use super::turns::Turns;
use super::{Ray, Source, Wave, World};
use crate::math::Rgb;
use crate::render::geometry::{Hit, Meeting};
use crate::render::lanes::{LANES, Parted};
use crate::render::lights::{Arrivals, Site, Sites};
use crate::render::materials::{MOST_RANKS, Many, Matter};

/// The paths in flight, and what they meet in a turn. Kept from wave to wave, for its memory.
pub struct Flight<M: Matter> {
    /// Of each sample that has begun the branch that is followed, by number of the sample; what is
    /// beyond is of waves before.
    pub(super) branches: Vec<Branch>,
    /// So many have.
    begun: usize,
    /// The samples that are on their way, at most one for each lane.
    pub(super) lanes: Vec<usize>,
    /// Those that will have one in the next turn.
    pub(super) next: Next,
    /// Their rays, and what those meet.
    pub(super) rays: Vec<Ray>,
    pub(super) meetings: Vec<Option<Meeting>>,
    pub(super) hits: Vec<Option<Hit>>,
    /// Of what was met, where light goes on, the numbers of the hits: by rank but the first.
    pub(super) later: [Vec<u32>; MOST_RANKS - 1],
    /// The surfaces, by rank.
    pub(super) surfaces: Vec<Surface>,
    /// What they do with light.
    pub(super) many: M::Many,
    /// Where those are.
    pub(super) sites: Sites,
    /// The paths that have come to them by scattering; None: it does not, or nothing is shown of it.
    pub(super) trails: Vec<Option<Trail>>,
    /// The light that lamps have for them.
    pub(super) arrivals: Arrivals,
    /// What they bring to each.
    pub(super) lit: Lit,
    /// How the paths go on that have come to them.
    pub(super) turns: Turns,
    /// Which of them, and in the end which do.
    pub(super) parted: Parted,
    /// What has been asked of lamps.
    pub(super) questions: Questions,
    /// What samples share, if they do.
    pub(super) reuse: Reuse,
}

/// Samples that go on.
#[derive(Default)]
pub(super) struct Next {
    pub lanes: Vec<usize>,
}

/// A surface that a path has met.
pub(super) struct Surface {
    /// The sample.
    pub lane: usize,
    /// The number of its hit.
    pub place: usize,
    pub site: Site,
    /// Whether light goes to all sides from it.
    pub scatters: bool,
    pub split: Split,
}

impl<M: Matter> Flight<M> {
    /// Of no wave yet.
    pub fn new() -> Self {
        Self {
            branches: Vec::new(),
            begun: 0,
            lanes: Vec::new(),
            next: Next::default(),
            rays: Vec::new(),
            meetings: Vec::new(),
            hits: Vec::new(),
            later: [const { Vec::new() }; MOST_RANKS - 1],
            surfaces: Vec::new(),
            many: M::Many::default(),
            sites: Sites::default(),
            trails: Vec::new(),
            arrivals: Arrivals::default(),
            lit: Lit::default(),
            turns: Turns::default(),
            parted: Parted::default(),
            questions: Questions::default(),
            reuse: Reuse::default(),
        }
    }

    /// Begins a wave.
    pub(super) fn begin(&mut self) {
        self.begun = 0;
        self.lanes.clear();
    }

    /// Begins as many of the samples of a wave as there is room for. Whether any are on their way.
    pub(super) fn enter(&mut self, wave: &mut Wave) -> bool {
        let first = self.begun;
        let end = wave.rays.len().min(first + LANES - self.lanes.len());
        if self.branches.len() < end {
            self.branches.resize(end, Branch::BLANK);
        }
        self.begun = end;
        for sample in first..end {
            let trail = wave.carriers[sample].start();
            self.branches[sample].begin(wave.world, &wave.rays[sample], trail);
            self.lanes.push(sample);
        }
        !self.lanes.is_empty()
    }

    /// Forgets what was met.
    pub(super) fn forget(&mut self) {
        self.later.iter_mut().for_each(Vec::clear);
        self.surfaces.clear();
        self.many.clear();
        self.sites.clear();
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
        if carrier.waiting.is_empty() {
            return;
        }
        if let Some(next) = carrier.waiting.pop() {
            *branch = next;
            self.lanes.push(lane);
        }
    }
}

/// Light that lamps will bring if nothing is in its way.
pub(super) struct Questions {
    count: usize,
    /// As many as are answered together at most.
    rays: Vec<Ray>,
    hidden: Vec<bool>,
    /// The sample, and what it will have.
    light: Vec<(usize, Trail, Rgb)>,
    parted: Parted,
}

impl Default for Questions {
    fn default() -> Self {
        let ray = Ray::new(Vec3::ZERO, Vec3::Z);
        Self {
            count: 0,
            rays: vec![ray; LANES],
            hidden: vec![false; LANES],
            light: vec![(0, Trail::START, Rgb::BLACK); LANES],
            parted: Parted::default(),
        }
    }
}

impl Questions {
    /// Brings light to a sample, if nothing is in its way where there are shadows.
    #[inline(always)]
    pub fn ask(
        &mut self,
        (world, shadows, carriers): (&World, bool, &mut [Carrier]),
        lane: usize,
        ray: impl Fn() -> Ray,
        (trail, light): (Trail, Rgb),
    ) {
        if !shadows {
            carriers[lane].add(trail, light, || Source::of(&ray()));
            return;
        }
        // In place: what is pushed is put together elsewhere, and copied.
        self.rays[self.count] = ray();
        self.light[self.count] = (lane, trail, light);
        self.count += 1;
        if self.count == LANES {
            self.answer(world, carriers);
        }
    }

    /// Brings home the light of those that nothing is in the way of, in the order in which they were
    /// asked.
    pub fn answer(&mut self, world: &World, carriers: &mut [Carrier]) {
        let (rays, hidden) = (&self.rays[..self.count], &mut self.hidden[..self.count]);
        world.geometry.occluded_all(rays, hidden);
        for &(lane, ..) in &self.light[..self.count] {
            carriers[lane].shadow_rays += 1;
        }
        let [seen, _] = self.parted.by(self.count, |nth| !hidden[nth]);
        for &nth in seen {
            let (lane, trail, light) = self.light[nth as usize];
            carriers[lane].add(trail, light, || Source::of(&rays[nth as usize]));
        }
        self.count = 0;
    }
}
