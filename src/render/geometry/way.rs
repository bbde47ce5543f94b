//! A ray among many that are on their way through the tree at once ([`super::fleet`]), and which
//! children of the nodes above wait for it.

use std::mem::MaybeUninit;

use super::Geometry;
use super::best::Best;
use super::lanes::{LANES, Lanes, NONE_LEFT, Portable, sixteen};
use super::leaf::Asked;
use super::node::{Child, Node};
use super::ray::Probe;
use super::tree::Tree;
use super::walk::{DEEPEST, Slabs, WIDEN, fetch};

/// Which children of a node wait.
pub(super) trait Waits<L: Lanes>: Copy {
    /// All children, none later than any limit.
    fn all(lanes: L) -> Self;
    /// Those that a ray meets.
    fn met(lanes: L, slabs: &Slabs<L>, node: &Node, limit: f32) -> Self;
    fn any(self, lanes: L) -> bool;
    /// Takes out the lane of the one that comes next; and whether there is one, before the limit.
    fn next(&mut self, lanes: L, limit: f32) -> (usize, bool);
}

/// The nearest comes next.
#[derive(Clone, Copy)]
pub(super) struct Nearest<L: Lanes>(L::Queue);

impl<L: Lanes> Waits<L> for Nearest<L> {
    #[inline(always)]
    fn all(lanes: L) -> Self {
        let zero = lanes.splat(0.0);
        Self(lanes.queue(zero, zero))
    }

    #[inline(always)]
    fn met(lanes: L, slabs: &Slabs<L>, node: &Node, limit: f32) -> Self {
        Self(slabs.queue(lanes, node, limit))
    }

    #[inline(always)]
    fn any(self, lanes: L) -> bool {
        lanes.first(self.0).0 != NONE_LEFT
    }

    #[inline(always)]
    fn next(&mut self, lanes: L, limit: f32) -> (usize, bool) {
        let (near, lane) = lanes.first(self.0);
        self.0 = lanes.without(self.0, lane);
        (lane, near <= sixteen(limit))
    }
}

/// The largest comes next: it is the last lane.
#[derive(Clone, Copy)]
pub(super) struct Largest(u32);

impl<L: Lanes> Waits<L> for Largest {
    #[inline(always)]
    fn all(_: L) -> Self {
        Self((1 << LANES) - 1)
    }

    #[inline(always)]
    fn met(lanes: L, slabs: &Slabs<L>, node: &Node, limit: f32) -> Self {
        Self(slabs.met(lanes, node, limit))
    }

    #[inline(always)]
    fn any(self, _: L) -> bool {
        self.0 != 0
    }

    #[inline(always)]
    fn next(&mut self, _: L, _: f32) -> (usize, bool) {
        let some = self.0 != 0;
        let lane = (self.0 | 1).ilog2() as usize % LANES;
        self.0 &= !(1 << lane);
        (lane, some)
    }
}

/// Room for the nodes above a ray.
const ROOM: usize = 32;
const _: () = assert!(DEEPEST < ROOM);
/// Odd numbers of cache lines: the same parts of many ways don't push each other out.
const _: () = assert!(size_of::<Way<Nearest<Portable>>>() / 64 % 2 == 1);
const _: () = assert!(size_of::<Way<Largest>>() / 64 % 2 == 1);

/// A ray on its way.
#[repr(align(64))]
pub(super) struct Way<W> {
    pub probe: Probe,
    pub best: Best,
    /// Which of its stream it is.
    pub number: usize,
    /// Whether it met something, where anything will do.
    pub met: bool,
    /// Where it comes to next, and the span of that box.
    pub next: Child,
    pub span: f32,
    /// How many nodes above have children that wait.
    waiting: usize,
    /// Their numbers, and which children; all up to `waiting` are there. Below them is one whose
    /// children always wait: who comes to that is at the end.
    above: [MaybeUninit<u32>; ROOM],
    waits: [MaybeUninit<W>; ROOM],
}

impl<W: Copy> Way<W> {
    /// At the root, written into its place: room that is not yet needed is not copied.
    #[inline(always)]
    pub fn begin<L: Lanes>(
        lanes: L,
        place: &mut MaybeUninit<Self>,
        number: usize,
        (probe, best): (Probe, Best),
    ) where
        W: Waits<L>,
    {
        let way = place.as_mut_ptr();
        // SAFETY: each is a place inside of `place`, and what is left may be without a value.
        unsafe {
            (&raw mut (*way).probe).write(probe);
            (&raw mut (*way).best).write(best);
            (&raw mut (*way).number).write(number);
            (&raw mut (*way).met).write(false);
            (&raw mut (*way).next).write(Child::ROOT);
            (&raw mut (*way).span).write(0.0);
            (&raw mut (*way).waiting).write(0);
            (*way).above[0].write(0);
            (*way).waits[0].write(W::all(lanes));
        }
    }

    /// The ray, as the ends of the tree want it.
    #[inline(always)]
    pub fn asked<'a, const ANY: bool>(&'a mut self, geometry: &'a Geometry) -> Asked<'a, ANY> {
        let Geometry { tree, shapes, .. } = geometry;
        Asked { tree, shapes, probe: &self.probe, best: &mut self.best }
    }

    /// Finds the children of the node that it is at.
    #[inline(always)]
    pub fn open<L: Lanes>(&mut self, lanes: L, tree: &Tree)
    where
        W: Waits<L>,
    {
        let number = self.next.number();
        let slabs = Slabs::new(lanes, &self.probe);
        let waits = W::met(lanes, &slabs, &tree.nodes[number], self.best.t * WIDEN);
        let place = (self.waiting + 1) % ROOM;
        self.above[place].write(number as u32);
        self.waits[place].write(waits);
        self.waiting += usize::from(waits.any(lanes));
    }

    /// Which children of the last node wait.
    #[inline(always)]
    fn last(&self) -> W {
        // SAFETY: all up to `waiting` are there.
        unsafe { self.waits[self.waiting % ROOM].assume_init() }
    }

    /// Leaves nodes out whose children come too late, after the limit has changed.
    #[inline(always)]
    pub fn forget<L: Lanes>(&mut self, lanes: L)
    where
        W: Waits<L>,
    {
        let limit = self.best.t * WIDEN;
        while !self.last().next(lanes, limit).1 {
            self.waiting -= 1;
        }
    }

    /// It met something, and anything will do.
    #[inline(always)]
    pub fn end(&mut self) {
        self.waiting = 0;
        self.met = true;
    }

    /// Goes on to the next child that waits, [`Child::NONE`] if none does, and asks memory for it.
    #[inline(always)]
    pub fn go_on<L: Lanes>(&mut self, lanes: L, tree: &Tree) -> Child
    where
        W: Waits<L>,
    {
        let limit = self.best.t * WIDEN;
        let (lane, waits) = loop {
            let mut waits = self.last();
            let (lane, really) = waits.next(lanes, limit);
            if really {
                break (lane, waits);
            }
            self.waiting -= 1;
        };
        let place = self.waiting % ROOM;
        self.waits[place].write(waits);
        // SAFETY: as above.
        let node = &tree.nodes[unsafe { self.above[place].assume_init() } as usize];
        self.next = if self.waiting == 0 { Child::NONE } else { node.children[lane] };
        self.span = node.spans[lane];
        self.waiting -= usize::from(!waits.any(lanes));
        fetch(lanes, &tree.nodes, &tree.blocks, self.next);
        self.next
    }
}
