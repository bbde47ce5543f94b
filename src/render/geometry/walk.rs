//! The way of a ray through the tree.
//!
//! Boxes are tested by slabs in f32. A plane's parameter (b − o)·(1/d) is off by less than 4u of
//! itself, u = 2⁻²⁴; what near, far and the best t can be apart by that is in [`WIDEN`] [Ize13].
//! Boxes are a little larger than their shapes ([`super::build`]) for rays along their faces.
//!
//! Children that wait are kept by node, with the higher halves of their distances side by side: the
//! nearest is found, and left out, by one instruction each where the processor has it. Rounded
//! down so, a distance is a little less than it is: a child may be opened in vain, never left out.

use std::mem::MaybeUninit;

use glam::Vec3A;

use super::best::Best;
use super::block::Block;
use super::lanes::{LANES, Lanes, NONE_LEFT, sixteen};
use super::leaf::Asked;
use super::node::{Below, Child, Node, Side};
use super::ray::{Axis, Probe};
use super::shapes::{Primitive, Shapes};
use super::tree::Tree;

/// 16u, u = 2⁻²⁴: more than near, far and the best t can be apart by rounding, for their size.
pub(super) const WIDEN: f32 = 1.0 + 8.0 * f32::EPSILON;

/// Most nodes on the way from the root to a leaf; build keeps to it.
pub(super) const DEEPEST: usize = 26;

/// Offers every meeting that can be the best. With `ANY`, returns at the first found.
#[inline(always)]
pub(super) fn walk<L: Lanes, const ANY: bool>(
    lanes: L,
    tree: &Tree,
    shapes: &Shapes,
    probe: &Probe,
    best: &mut Best,
) -> bool {
    let slabs = Slabs::new(lanes, probe);
    let mut world = World::<L, ANY> { asked: Asked { tree, shapes, probe, best }, slabs };
    descend::<L, ANY, _>(lanes, &tree.nodes, &mut world)
}

/// What is met at the ends of a tree's branches.
pub(super) trait Ends<L: Lanes> {
    /// The ray.
    fn slabs(&self) -> &Slabs<L>;

    /// All blocks of the tree.
    fn blocks(&self) -> &[Block];

    /// Boxes that are entered after this need not be looked into.
    fn limit(&self) -> f32;

    /// Meets a block of triangles in a box of a `span`; whether that is the end.
    fn block(&mut self, lanes: L, number: usize, span: f32) -> bool;

    /// Meets what stands for itself; whether that is the end.
    fn round(&mut self, lanes: L, primitive: Primitive) -> bool;
}

/// A ray on its way down the tree over the shapes of the world.
struct World<'a, L: Lanes, const ANY: bool> {
    asked: Asked<'a, ANY>,
    slabs: Slabs<L>,
}

impl<L: Lanes, const ANY: bool> Ends<L> for World<'_, L, ANY> {
    #[inline(always)]
    fn slabs(&self) -> &Slabs<L> {
        &self.slabs
    }

    #[inline(always)]
    fn blocks(&self) -> &[Block] {
        &self.asked.tree.blocks
    }

    #[inline(always)]
    fn limit(&self) -> f32 {
        self.asked.best.t
    }

    #[inline(always)]
    fn block(&mut self, lanes: L, number: usize, span: f32) -> bool {
        self.asked.block(lanes, number, span)
    }

    #[inline(always)]
    fn round(&mut self, lanes: L, primitive: Primitive) -> bool {
        self.asked.round(lanes, primitive)
    }
}

/// The way through a tree, nearest boxes first; with `ANY`, in no order. Whether its end was met.
#[inline(always)]
pub(super) fn descend<L: Lanes, const ANY: bool, E: Ends<L>>(
    lanes: L,
    nodes: &[Node],
    ends: &mut E,
) -> bool {
    if nodes.is_empty() {
        return false;
    }
    if ANY { any(lanes, nodes, ends) } else { first(lanes, nodes, ends) }
}

/// Asks memory for a child that is to be looked into later.
#[inline(always)]
pub(super) fn fetch<L: Lanes>(lanes: L, nodes: &[Node], blocks: &[Block], child: Child) {
    // By a choice, not by a jump.
    let node = nodes.as_ptr().wrapping_add(child.number()).cast::<u8>();
    let block = blocks.as_ptr().wrapping_add(child.number()).cast::<u8>();
    lanes.fetch(if child.is_node() { node } else { block });
}

/// Nearest boxes first.
#[inline(always)]
fn first<L: Lanes, E: Ends<L>>(lanes: L, nodes: &[Node], ends: &mut E) -> bool {
    // Nodes above the one that the ray is in, and which of their children wait.
    let mut stack = [MaybeUninit::<(L::Queue, &Node)>::uninit(); DEEPEST];
    let mut waiting = 0;
    let mut limit = ends.limit() * WIDEN;
    let mut node = &nodes[0];
    let mut queue = ends.slabs().queue(lanes, node, limit);
    loop {
        let (near, lane) = lanes.first(queue);
        if near > sixteen(limit) {
            if waiting == 0 {
                return false;
            }
            waiting -= 1;
            // SAFETY: all below `waiting` has been written.
            (queue, node) = unsafe { stack[waiting].assume_init() };
            continue;
        }
        queue = lanes.without(queue, lane);
        let done = match node.children[lane].below() {
            Below::Node(number) => {
                stack[waiting] = MaybeUninit::new((queue, node));
                let (after, second) = lanes.first(queue);
                waiting += usize::from(after != NONE_LEFT);
                fetch(lanes, nodes, ends.blocks(), node.children[second]);
                node = &nodes[number];
                queue = ends.slabs().queue(lanes, node, limit);
                continue;
            }
            Below::Block(number) => ends.block(lanes, number, node.spans[lane]),
            Below::Round(primitive) => ends.round(lanes, primitive),
        };
        if done {
            return true;
        }
        limit = ends.limit() * WIDEN;
    }
}

/// The largest boxes first: they are the last lanes.
#[inline(always)]
fn any<L: Lanes, E: Ends<L>>(lanes: L, nodes: &[Node], ends: &mut E) -> bool {
    // Nodes above the one that the ray is in, and a bit for each of their children that wait.
    let mut stack = [MaybeUninit::<(u32, &Node)>::uninit(); DEEPEST];
    let mut waiting = 0;
    let limit = ends.limit() * WIDEN;
    let mut node = &nodes[0];
    let mut met = ends.slabs().met(lanes, node, limit);
    loop {
        if met == 0 {
            if waiting == 0 {
                return false;
            }
            waiting -= 1;
            // SAFETY: all below `waiting` has been written.
            (met, node) = unsafe { stack[waiting].assume_init() };
        }
        let lane = met.ilog2() as usize % LANES;
        met ^= 1 << lane;
        let done = match node.children[lane].below() {
            Below::Node(number) => {
                stack[waiting] = MaybeUninit::new((met, node));
                waiting += usize::from(met != 0);
                let second = (met | 1).ilog2() as usize % LANES;
                fetch(lanes, nodes, ends.blocks(), node.children[second]);
                node = &nodes[number];
                met = ends.slabs().met(lanes, node, limit);
                continue;
            }
            Below::Block(number) => ends.block(lanes, number, node.spans[lane]),
            Below::Round(primitive) => ends.round(lanes, primitive),
        };
        if done {
            return true;
        }
    }
}

/// A ray as boxes want it.
#[derive(Clone, Copy)]
pub(super) struct Slabs<L: Lanes> {
    inverse: [L::Eight; 3],
    /// For near planes, and for far ones.
    origin: [[L::Eight; 3]; 2],
    /// The planes that the ray meets first: the upper ones where it goes towards lesser coordinates.
    near: [Side; 3],
}

impl<L: Lanes> Slabs<L> {
    #[inline(always)]
    pub fn new(lanes: L, probe: &Probe) -> Self {
        Self::from(lanes, probe, [probe.near_origin; 2])
    }

    /// The same for boxes, or a ray, that are off by so much along each axis.
    #[inline(always)]
    pub fn within(lanes: L, probe: &Probe, off: Vec3A) -> Self {
        let origin = probe.near_origin;
        let off = off + (origin.abs() + off) * (2.0 * f32::EPSILON);
        let forwards = off.copysign(probe.inverse);
        Self::from(lanes, probe, [origin + forwards, origin - forwards])
    }

    #[inline(always)]
    fn from(lanes: L, probe: &Probe, [from, to]: [Vec3A; 2]) -> Self {
        let inverse = probe.inverse;
        // Not by `map`: a call that is not inlined loses what the processor is known to have.
        Self {
            inverse: [lanes.splat(inverse.x), lanes.splat(inverse.y), lanes.splat(inverse.z)],
            origin: [
                [lanes.splat(from.x), lanes.splat(from.y), lanes.splat(from.z)],
                [lanes.splat(to.x), lanes.splat(to.y), lanes.splat(to.z)],
            ],
            near: [
                Side::of(Axis::X, inverse.x.to_bits() >> 31 != 0),
                Side::of(Axis::Y, inverse.y.to_bits() >> 31 != 0),
                Side::of(Axis::Z, inverse.z.to_bits() >> 31 != 0),
            ],
        }
    }

    /// The boxes that the ray meets, by where it enters them.
    #[inline(always)]
    pub fn queue(&self, lanes: L, node: &Node, limit: f32) -> L::Queue {
        let (near, far) = self.meet(lanes, node, limit);
        lanes.queue(near, far)
    }

    /// A bit for each box that the ray meets.
    #[inline(always)]
    pub fn met(&self, lanes: L, node: &Node, limit: f32) -> u32 {
        let (near, far) = self.meet(lanes, node, limit);
        lanes.at_most(near, far)
    }

    /// Where the ray enters each of the boxes, and where it leaves them or ends, by [`WIDEN`] more: it
    /// meets those where the former is not more than the latter.
    #[inline(always)]
    fn meet(&self, lanes: L, node: &Node, limit: f32) -> (L::Eight, L::Eight) {
        let [x, y, z] = self.near;
        let near =
            lanes.max(self.plane(lanes, node, (0, x), 0), self.plane(lanes, node, (1, y), 0));
        let near = lanes.max(near, self.plane(lanes, node, (2, z), 0));
        let near = lanes.max(near, lanes.splat(0.0));
        let [x, y, z] = [x.other(), y.other(), z.other()];
        let far = lanes.min(self.plane(lanes, node, (0, x), 1), self.plane(lanes, node, (1, y), 1));
        let far = lanes.min(far, self.plane(lanes, node, (2, z), 1));
        let far = lanes.min(lanes.mul(far, lanes.splat(WIDEN)), lanes.splat(limit));
        (near, far)
    }

    /// Where the ray meets planes across an axis, near (0) or far (1) ones.
    #[inline(always)]
    fn plane(&self, lanes: L, node: &Node, (axis, side): (usize, Side), far: usize) -> L::Eight {
        let planes = lanes.load(node.side(side));
        lanes.mul(lanes.sub(planes, self.origin[far][axis]), self.inverse[axis])
    }
}
