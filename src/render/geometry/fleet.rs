//! Many rays on their way through the tree at once, each taking a step in turn.
//!
//! A ray alone waits for the memory of each node that it comes to, and the processor guesses its way
//! wrongly again and again. Here a ray asks for the memory of what comes next, and others take their
//! steps until its turn comes. All do the same one after the other: those at nodes, those at leaves,
//! those that may have met something there; and then each looks where to go on. Who is in which list
//! is told without a jump, so there is next to nothing to guess. Steps of several rays overlap in the
//! processor, since none waits for another.

use std::mem::MaybeUninit;

use super::Geometry;
use super::best::{Best, Meeting};
use super::lanes::{Lanes, Task};
use super::leaf::Found;
use super::node::{Below, Child};
use super::ray::{Probe, Ray};
use super::way::{Largest, Nearest, Waits, Way};

/// Rays that are on their way at once, at most.
pub(super) const MOST: usize = 64;

/// Fewer rays are faster one by one: none takes its steps while another's are not yet done.
pub(super) const LEAST: usize = 32;

/// Rays of a fleet by number: those at nodes from the front, those at leaves from the back.
struct List {
    all: [u8; MOST],
    nodes: usize,
    leaves: usize,
}

impl List {
    const EMPTY: Self = Self { all: [0; MOST], nodes: 0, leaves: 0 };

    /// One that comes to a node or to a leaf; one at the end is left out.
    #[inline(always)]
    fn push(&mut self, number: usize, next: Child) {
        self.all[self.nodes % MOST] = number as u8;
        self.nodes += usize::from(next.is_node());
        self.all[(2 * MOST - 1 - self.leaves) % MOST] = number as u8;
        self.leaves += usize::from(next.is_leaf());
    }

    /// The nth of those at nodes.
    #[inline(always)]
    fn at_node(&self, nth: usize) -> usize {
        usize::from(self.all[nth % MOST]) % MOST
    }

    /// The nth of those at leaves.
    #[inline(always)]
    fn at_leaf(&self, nth: usize) -> usize {
        self.at_node(nth + MOST - self.leaves)
    }

    /// The nth of all.
    #[inline(always)]
    fn any(&self, nth: usize) -> usize {
        let back = if nth < self.nodes { 0 } else { MOST - self.leaves - self.nodes };
        self.at_node(nth + back)
    }
}

/// Rays on their way.
struct Fleet<L: Lanes, W> {
    ways: [MaybeUninit<Way<W>>; MOST],
    list: List,
    /// Who may have met something, and what.
    close: [u8; MOST],
    found: [MaybeUninit<Found<L>>; MOST],
    /// A bit for each ray that takes part: others are to be asked alone.
    part: u64,
    /// A bit for each that met something, where anything will do.
    met: u64,
}

impl<L: Lanes, W: Waits<L>> Fleet<L, W> {
    /// Up to [`MOST`] rays go all their ways; with `ANY` until they meet anything.
    #[inline(always)]
    fn go<const ANY: bool>(&mut self, lanes: L, geometry: &Geometry, rays: &[Ray]) {
        self.set_out::<ANY>(lanes, geometry, rays);
        while self.list.nodes + self.list.leaves != 0 {
            for nth in 0..self.list.nodes {
                let number = self.list.at_node(nth);
                self.way(number).open(lanes, &geometry.tree);
            }
            self.meet::<ANY>(lanes, geometry);
            let before = std::mem::replace(&mut self.list, List::EMPTY);
            for nth in 0..before.nodes + before.leaves {
                let number = before.any(nth);
                let way = self.way(number);
                way.go_on(lanes, &geometry.tree);
                let next = way.next;
                self.list.push(number, next);
            }
        }
    }

    /// Rays as great as squares may be no numbers don't take part, nor what is no ray.
    #[inline(always)]
    fn set_out<const ANY: bool>(&mut self, lanes: L, geometry: &Geometry, rays: &[Ray]) {
        for (number, (ray, place)) in rays.iter().zip(&mut self.ways).enumerate() {
            let Some(probe) = Probe::new(lanes, ray, geometry.tree.moderate) else { continue };
            if probe.extreme {
                continue;
            }
            let mut best = Best::before(ray.t_max);
            geometry.meet_planes(&probe, &mut best);
            let met = ANY && best.primitive.is_some();
            self.part |= 1 << number;
            self.met |= u64::from(met) << number;
            let way = Way::begin(lanes, place, (probe, best));
            if !(met || geometry.tree.nodes.is_empty()) {
                self.list.push(number, way.next);
            }
        }
    }

    /// Meets what is in the leaves.
    #[inline(always)]
    fn meet<const ANY: bool>(&mut self, lanes: L, geometry: &Geometry) {
        let mut close = 0;
        for nth in 0..self.list.leaves {
            let number = self.list.at_leaf(nth);
            let way = self.way(number);
            let span = way.span;
            match way.next.below() {
                Below::Block(block) => {
                    let found = way.asked::<ANY>(geometry).look(lanes, block, span);
                    self.close[close % MOST] = number as u8;
                    close += usize::from(found.any());
                    self.found[number].write(found);
                }
                Below::Round(primitive) => {
                    let met = way.asked::<ANY>(geometry).round(lanes, primitive);
                    self.tell(number, met);
                }
                Below::Node(_) => {}
            }
        }
        for nth in 0..close {
            let number = usize::from(self.close[nth % MOST]) % MOST;
            // SAFETY: it has just been written for all that are close.
            let found = unsafe { self.found[number].assume_init_read() };
            let way = self.way(number);
            let block = way.next.number();
            let met = way.asked::<ANY>(geometry).offer(lanes, block, &found);
            way.forget(lanes);
            self.tell(number, met);
        }
    }

    /// Whether anything will do and was met.
    #[inline(always)]
    fn tell(&mut self, number: usize, met: bool) {
        self.met |= u64::from(met) << number;
        if met {
            self.way(number).end();
        }
    }

    /// A ray that takes part.
    #[inline(always)]
    fn way(&mut self, number: usize) -> &mut Way<W> {
        // SAFETY: those that take part are asked for alone, and have been written.
        unsafe { self.ways[number % MOST].assume_init_mut() }
    }
}

impl<L: Lanes, W> Fleet<L, W> {
    /// Without rays.
    const EMPTY: Self = Self {
        ways: [const { MaybeUninit::uninit() }; MOST],
        list: List::EMPTY,
        close: [0; MOST],
        found: [const { MaybeUninit::uninit() }; MOST],
        part: 0,
        met: 0,
    };
}

/// [`Geometry::meet`] of up to [`MOST`] rays, but for instances. A bit for each that was asked.
pub(super) struct MeetFleet<'a> {
    pub geometry: &'a Geometry,
    pub rays: &'a [Ray],
    pub met: &'a mut [Option<Meeting>],
}

impl Task for MeetFleet<'_> {
    type Answer = u64;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> u64 {
        let Self { geometry, rays, met } = self;
        let mut fleet = Fleet::<L, Nearest<L>>::EMPTY;
        fleet.go::<false>(lanes, geometry, rays);
        for (number, met) in met.iter_mut().enumerate() {
            *met = None;
            if fleet.part & 1 << number != 0 {
                let way = fleet.way(number);
                way.best.settle(lanes, &geometry.tree.blocks, &way.probe);
                *met = way.best.meeting();
            }
        }
        fleet.part
    }
}

/// [`Geometry::occluded`] of up to [`MOST`] rays, but for instances. A bit for each that was asked,
/// and for each that is.
pub(super) struct OccludedFleet<'a> {
    pub geometry: &'a Geometry,
    pub rays: &'a [Ray],
}

impl Task for OccludedFleet<'_> {
    type Answer = [u64; 2];

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> [u64; 2] {
        let mut fleet = Fleet::<L, Largest>::EMPTY;
        fleet.go::<true>(lanes, self.geometry, self.rays);
        [fleet.part, fleet.met]
    }
}
