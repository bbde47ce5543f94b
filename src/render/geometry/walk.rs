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

use super::best::{self, Best};
use super::block::{Block, Candidates};
use super::lanes::{LANES, Lanes, NONE_LEFT, sixteen};
use super::node::{Below, Child, Node};
use super::ray::Probe;
use super::shapes::{Kind, Primitive, Shapes};
use super::tree::Tree;
use super::{disk, sphere};

/// 16u, u = 2⁻²⁴: more than near, far and the best t can be apart by rounding, for their size.
const WIDEN: f32 = 1.0 + 8.0 * f32::EPSILON;

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
    let mut world = World::<ANY> { tree, shapes, probe, best };
    descend::<L, ANY, _>(lanes, &tree.nodes, &slabs, &mut world)
}

/// What is met at the ends of a tree's branches.
pub(super) trait Ends<L: Lanes> {
    /// Boxes that are entered after this need not be looked into.
    fn limit(&self) -> f32;

    /// Meets a block of triangles; whether that is the end.
    fn block(&mut self, lanes: L, number: usize) -> bool;

    /// Meets what stands for itself; whether that is the end.
    fn round(&mut self, lanes: L, primitive: Primitive) -> bool;
}

/// The shapes of the world, and the tree over them.
struct World<'a, const ANY: bool> {
    tree: &'a Tree,
    shapes: &'a Shapes,
    probe: &'a Probe,
    best: &'a mut Best,
}

impl<L: Lanes, const ANY: bool> Ends<L> for World<'_, ANY> {
    #[inline(always)]
    fn limit(&self) -> f32 {
        self.best.t
    }

    #[inline(always)]
    fn block(&mut self, lanes: L, number: usize) -> bool {
        meet_block::<L, ANY>(lanes, &self.tree.blocks, number, self.probe, self.best)
    }

    #[inline(always)]
    fn round(&mut self, lanes: L, primitive: Primitive) -> bool {
        if let Some(t) = meet_round(self.shapes, self.probe, primitive) {
            self.best.settle(lanes, &self.tree.blocks, self.probe);
            self.best.offer(t, primitive);
            return ANY && self.best.primitive.is_some();
        }
        false
    }
}

/// The way through a tree, nearest boxes first; with `ANY`, in no order. Whether its end was met.
#[inline(always)]
pub(super) fn descend<L: Lanes, const ANY: bool, E: Ends<L>>(
    lanes: L,
    nodes: &[Node],
    slabs: &Slabs<L>,
    ends: &mut E,
) -> bool {
    if nodes.is_empty() {
        return false;
    }
    if ANY { any(lanes, nodes, slabs, ends) } else { first(lanes, nodes, slabs, ends) }
}

/// Nearest boxes first.
#[inline(always)]
fn first<L: Lanes, E: Ends<L>>(lanes: L, nodes: &[Node], slabs: &Slabs<L>, ends: &mut E) -> bool {
    // A node on the way, and which of its children wait.
    let mut stack = [MaybeUninit::<(L::Queue, u32)>::uninit(); DEEPEST];
    let mut waiting = 0;
    let mut current = Child::ROOT;
    loop {
        match current.below() {
            Below::Node(number) => {
                let node = &nodes[number];
                let (near, far) = slabs.meet(lanes, node, ends.limit());
                let queue = lanes.queue(near, far);
                let (near, lane) = lanes.first(queue);
                if near != NONE_LEFT {
                    let queue = lanes.without(queue, lane);
                    stack[waiting] = MaybeUninit::new((queue, number as u32));
                    waiting += usize::from(lanes.first(queue).0 != NONE_LEFT);
                    current = node.children[lane];
                    continue;
                }
            }
            Below::Block(number) => {
                if ends.block(lanes, number) {
                    return true;
                }
            }
            Below::Round(primitive) => {
                if ends.round(lanes, primitive) {
                    return true;
                }
            }
        }
        let limit = sixteen(ends.limit() * WIDEN);
        loop {
            if waiting == 0 {
                return false;
            }
            // SAFETY: all below `waiting` has been written.
            let (queue, number) = unsafe { stack[waiting - 1].assume_init() };
            let (near, lane) = lanes.first(queue);
            if near <= limit {
                stack[waiting - 1] = MaybeUninit::new((lanes.without(queue, lane), number));
                current = nodes[number as usize].children[lane];
                break;
            }
            waiting -= 1;
        }
    }
}

/// The largest boxes first: they are the last lanes.
#[inline(always)]
fn any<L: Lanes, E: Ends<L>>(lanes: L, nodes: &[Node], slabs: &Slabs<L>, ends: &mut E) -> bool {
    // A node on the way, and a bit for each of its children that wait.
    let mut stack = [MaybeUninit::<(u32, u32)>::uninit(); DEEPEST];
    let mut waiting = 0;
    let mut current = Child::ROOT;
    loop {
        match current.below() {
            Below::Node(number) => {
                let node = &nodes[number];
                let (near, far) = slabs.meet(lanes, node, ends.limit());
                let met = lanes.at_most(near, far);
                if met != 0 {
                    let lane = met.ilog2();
                    let others = met ^ (1 << lane);
                    stack[waiting] = MaybeUninit::new((others, number as u32));
                    waiting += usize::from(others != 0);
                    current = node.children[lane as usize % LANES];
                    continue;
                }
            }
            Below::Block(number) => {
                if ends.block(lanes, number) {
                    return true;
                }
            }
            Below::Round(primitive) => {
                if ends.round(lanes, primitive) {
                    return true;
                }
            }
        }
        if waiting == 0 {
            return false;
        }
        // SAFETY: all below `waiting` has been written; none that is there is zero.
        let (met, number) = unsafe { stack[waiting - 1].assume_init() };
        let lane = met.ilog2();
        let others = met ^ (1 << lane);
        stack[waiting - 1] = MaybeUninit::new((others, number));
        waiting -= usize::from(others == 0);
        current = nodes[number as usize].children[lane as usize % LANES];
    }
}

/// Offers the triangles that the ray meets; with `ANY`, whether it meets one of them.
#[inline(always)]
fn meet_block<L: Lanes, const ANY: bool>(
    lanes: L,
    blocks: &[Block],
    number: usize,
    probe: &Probe,
    best: &mut Best,
) -> bool {
    let block = &blocks[number];
    let Candidates { possible, inside, between: [least, most] } = block.candidates(lanes, probe);
    if possible == 0 {
        return false;
    }
    let tiny = lanes.splat(f32::MIN_POSITIVE);
    let ahead = inside & lanes.at_most(tiny, least);
    let behind = inside & lanes.at_most(most, lanes.sub(lanes.splat(0.0), tiny));
    let first = ahead & lanes.at_most(least, lanes.splat(best.t));
    // Neither certainly behind the origin, nor certainly met.
    let mut left = possible & !(ahead | behind);
    if ANY {
        let met = first & lanes.at_most(most, lanes.splat(best.t.next_down()));
        if met != 0 {
            return true;
        }
        left |= first;
    } else if first != 0 {
        let (least, most) = (lanes.store(least), lanes.store(most));
        let mut first = first;
        while first != 0 {
            let lane = first.trailing_zeros() as usize % LANES;
            first &= first - 1;
            let place = best::place(number, lane);
            best.offer_within(lanes, [least[lane], most[lane]], (blocks, place), probe);
        }
    }
    while left != 0 {
        let lane = left.trailing_zeros() as usize % LANES;
        left &= left - 1;
        if let Some(t) = block.face(lane).meet(lanes, probe, inside & (1 << lane) != 0) {
            best.settle(lanes, blocks, probe);
            best.offer_at(t, block.primitive(lane), best::place(number, lane));
            if ANY && best.primitive.is_some() {
                return true;
            }
        }
    }
    false
}

#[inline]
fn meet_round(shapes: &Shapes, probe: &Probe, primitive: Primitive) -> Option<f32> {
    match primitive.kind() {
        Kind::Sphere => sphere::meet(probe, &shapes.spheres[primitive.index()]),
        _ => disk::meet(probe, &shapes.disks[primitive.index()]),
    }
}

/// A ray as boxes want it.
pub(super) struct Slabs<L: Lanes> {
    inverse: [L::Eight; 3],
    /// For near planes and for far ones.
    origin: [[L::Eight; 2]; 3],
    /// 1 where the ray goes towards lesser coordinates, and so meets upper planes first.
    backwards: [usize; 3],
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

    /// With an origin for near planes and one for far ones.
    #[inline(always)]
    fn from(lanes: L, probe: &Probe, [near, far]: [Vec3A; 2]) -> Self {
        let inverse = probe.inverse;
        // Not by `map`: a call that is not inlined loses what the processor is known to have.
        Self {
            inverse: [lanes.splat(inverse.x), lanes.splat(inverse.y), lanes.splat(inverse.z)],
            origin: [
                [lanes.splat(near.x), lanes.splat(far.x)],
                [lanes.splat(near.y), lanes.splat(far.y)],
                [lanes.splat(near.z), lanes.splat(far.z)],
            ],
            backwards: [
                usize::from(inverse.x < 0.0),
                usize::from(inverse.y < 0.0),
                usize::from(inverse.z < 0.0),
            ],
        }
    }

    /// Where the ray enters each of the boxes, and where it leaves them or ends: it meets those where
    /// the former is not more than the latter.
    #[inline(always)]
    fn meet(&self, lanes: L, node: &Node, limit: f32) -> (L::Eight, L::Eight) {
        let [x, y, z] = [0, 1, 2];
        let near = lanes.max(self.plane(lanes, node, x, 0), self.plane(lanes, node, y, 0));
        let near = lanes.max(near, lanes.max(self.plane(lanes, node, z, 0), lanes.splat(0.0)));
        let far = lanes.min(self.plane(lanes, node, x, 1), self.plane(lanes, node, y, 1));
        let far = lanes.min(far, lanes.min(self.plane(lanes, node, z, 1), lanes.splat(limit)));
        (near, lanes.mul(far, lanes.splat(WIDEN)))
    }

    /// Where the ray meets the near (0) or far (1) planes across an axis.
    #[inline(always)]
    fn plane(&self, lanes: L, node: &Node, axis: usize, far: usize) -> L::Eight {
        let side = (self.backwards[axis] ^ far) & 1;
        let planes = lanes.load(&node.planes[axis][side]);
        lanes.mul(lanes.sub(planes, self.origin[axis][far]), self.inverse[axis])
    }
}
