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
const MOST: usize = 64;

/// Fewer rays are faster one by one: none takes its steps while another's are not yet done.
pub(super) const LEAST: usize = 32;

/// Places of rays in a fleet.
struct List {
    all: [u8; MOST],
    count: usize,
}

impl List {
    const EMPTY: Self = Self { all: [0; MOST], count: 0 };

    /// One more, if it really is one; without a jump.
    #[inline(always)]
    fn push(&mut self, place: usize, really: bool) {
        self.all[self.count % MOST] = place as u8;
        self.count += usize::from(really);
    }

    #[inline(always)]
    fn get(&self, nth: usize) -> usize {
        usize::from(self.all[nth % MOST]) % MOST
    }

    /// The last comes in place of one that is left out.
    #[inline(always)]
    fn leave_out(&mut self, nth: usize) {
        self.count -= 1;
        self.all[nth % MOST] = self.all[self.count % MOST];
    }
}

/// What a stream of rays asks.
trait Questions {
    fn rays(&self) -> &[Ray];

    /// Answers a ray that is at its end.
    fn answer<L: Lanes, W>(&mut self, lanes: L, way: &mut Way<W>);

    /// Answers one that does not take part.
    fn answer_alone(&mut self, number: usize);
}

/// Rays on their way. Where one has come to its end, the next of the stream begins.
struct Fleet<'a, L: Lanes, W, Q> {
    lanes: L,
    geometry: &'a Geometry,
    questions: Q,
    /// How many of the stream have set out.
    begun: usize,
    ways: [MaybeUninit<Way<W>>; MOST],
    found: [MaybeUninit<Found<L>>; MOST],
}

impl<'a, L: Lanes, W: Waits<L>, Q: Questions> Fleet<'a, L, W, Q> {
    /// All rays go all their ways; with `ANY` until they meet something.
    #[inline(always)]
    fn go<const ANY: bool>(&mut self) {
        let [mut active, mut nodes, mut leaves] = [List::EMPTY, List::EMPTY, List::EMPTY];
        for place in 0..MOST {
            let begun = self.begin::<ANY>(place);
            active.push(place, begun);
            nodes.push(place, begun);
        }
        let Self { lanes, geometry: Geometry { tree, .. }, .. } = *self;
        while active.count != 0 {
            for nth in 0..nodes.count {
                self.way(nodes.get(nth)).open(lanes, tree);
            }
            self.meet::<ANY>(&leaves);
            (nodes.count, leaves.count) = (0, 0);
            let mut ended = List::EMPTY;
            for nth in 0..active.count {
                let place = active.get(nth);
                let next = self.way(place).go_on(lanes, tree);
                nodes.push(place, next.is_node());
                leaves.push(place, next.is_leaf());
                ended.push(nth, next == Child::NONE);
            }
            // The last first, so that whatever takes the place of one goes on.
            for nth in (0..ended.count).rev() {
                let nth = ended.get(nth);
                let place = active.get(nth);
                self.answer(place);
                if self.begin::<ANY>(place) {
                    nodes.push(place, true);
                } else {
                    active.leave_out(nth);
                }
            }
        }
    }

    /// Takes the next ray of the stream that takes part into a place, if there is one. Rays so great
    /// that squares may be no numbers don't, nor what is no ray, nor what meets a plane where that will
    /// do.
    #[inline(always)]
    fn begin<const ANY: bool>(&mut self, place: usize) -> bool {
        while let Some(ray) = self.questions.rays().get(self.begun) {
            let number = self.begun;
            self.begun += 1;
            if let Some(probe) = Probe::new(self.lanes, ray, self.geometry.tree.moderate) {
                let mut best = Best::before(ray.t_max);
                self.geometry.meet_planes(&probe, &mut best);
                if !(probe.extreme || ANY && best.primitive.is_some()) {
                    let place = &mut self.ways[place % MOST];
                    Way::begin(self.lanes, place, number, (probe, best));
                    return true;
                }
            }
            self.questions.answer_alone(number);
        }
        false
    }

    /// Answers the ray of a place.
    #[inline(always)]
    fn answer(&mut self, place: usize) {
        // SAFETY: as in `way`.
        let way = unsafe { self.ways[place % MOST].assume_init_mut() };
        self.questions.answer(self.lanes, way);
    }

    /// Meets what is in the leaves.
    #[inline(always)]
    fn meet<const ANY: bool>(&mut self, leaves: &List) {
        let Self { lanes, geometry, .. } = *self;
        let mut close = List::EMPTY;
        for nth in 0..leaves.count {
            let place = leaves.get(nth);
            let way = self.way(place);
            let span = way.span;
            match way.next.below() {
                Below::Block(block) => {
                    let found = way.asked::<ANY>(geometry).look(lanes, block, span);
                    close.push(place, found.any());
                    self.found[place].write(found);
                }
                Below::Round(primitive) => {
                    if way.asked::<ANY>(geometry).round(lanes, primitive) {
                        way.end();
                    }
                }
                Below::Node(_) => {}
            }
        }
        for nth in 0..close.count {
            let place = close.get(nth);
            // SAFETY: it has just been written for all that are close.
            let found = unsafe { self.found[place].assume_init_read() };
            let way = self.way(place);
            let block = way.next.number();
            if way.asked::<ANY>(geometry).offer(lanes, block, &found) {
                way.end();
            } else {
                way.forget(lanes);
            }
        }
    }

    /// A ray on its way.
    #[inline(always)]
    fn way(&mut self, place: usize) -> &mut Way<W> {
        // SAFETY: only places are asked for where a ray has begun.
        unsafe { self.ways[place % MOST].assume_init_mut() }
    }
}

impl<'a, L: Lanes, W, Q> Fleet<'a, L, W, Q> {
    #[inline(always)]
    fn new(lanes: L, geometry: &'a Geometry, questions: Q) -> Self {
        let ways = [const { MaybeUninit::uninit() }; MOST];
        let found = [const { MaybeUninit::uninit() }; MOST];
        Self { lanes, geometry, questions, begun: 0, ways, found }
    }
}

/// [`Geometry::meet`] of many rays, but for instances.
pub(super) struct MeetFleet<'a> {
    pub geometry: &'a Geometry,
    pub rays: &'a [Ray],
    pub met: &'a mut [Option<Meeting>],
}

impl Task for MeetFleet<'_> {
    type Answer = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        Fleet::<L, Nearest<L>, _>::new(lanes, self.geometry, self).go::<false>();
    }
}

impl Questions for MeetFleet<'_> {
    #[inline(always)]
    fn rays(&self) -> &[Ray] {
        self.rays
    }

    #[inline(always)]
    fn answer<L: Lanes, W>(&mut self, lanes: L, way: &mut Way<W>) {
        way.best.settle(lanes, &self.geometry.tree.blocks, &way.probe);
        self.met[way.number] = way.best.meeting();
    }

    fn answer_alone(&mut self, number: usize) {
        let Geometry { tree, .. } = self.geometry;
        self.met[number] = tree.walker.meet(self.geometry, &self.rays[number]);
    }
}

/// [`Geometry::occluded`] of many rays, but for instances.
pub(super) struct OccludedFleet<'a> {
    pub geometry: &'a Geometry,
    pub rays: &'a [Ray],
    pub occluded: &'a mut [bool],
}

impl Task for OccludedFleet<'_> {
    type Answer = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        Fleet::<L, Largest, _>::new(lanes, self.geometry, self).go::<true>();
    }
}

impl Questions for OccludedFleet<'_> {
    #[inline(always)]
    fn rays(&self) -> &[Ray] {
        self.rays
    }

    #[inline(always)]
    fn answer<L: Lanes, W>(&mut self, _: L, way: &mut Way<W>) {
        self.occluded[way.number] = way.met;
    }

    fn answer_alone(&mut self, number: usize) {
        let Geometry { tree, .. } = self.geometry;
        self.occluded[number] = tree.walker.occluded(self.geometry, &self.rays[number]);
    }
}
