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
use super::block::Candidates;
use super::lanes::{LANES, Lanes, NONE_LEFT, Task, sixteen};
use super::node::{Below, Child, Node};
use super::ray::Probe;
use super::shapes::{Kind, Primitive, Shapes};
use super::tree::Tree;
use super::{disk, sphere};

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
    let mut world = World::<ANY> { tree, shapes, probe, slabs: Slabs::new(probe), best };
    descend::<L, ANY, _>(lanes, &tree.nodes, &mut world)
}

/// What is met at the ends of a tree's branches.
pub(super) trait Ends<L: Lanes> {
    /// The ray. It is asked for after each end: where that has been met by a function of its own,
    /// what was in vectors is better made anew than kept.
    fn slabs(&self) -> &Slabs;

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
    slabs: Slabs,
    best: &'a mut Best,
}

impl<L: Lanes, const ANY: bool> Ends<L> for World<'_, ANY> {
    #[inline(always)]
    fn slabs(&self) -> &Slabs {
        &self.slabs
    }

    #[inline(always)]
    fn limit(&self) -> f32 {
        self.best.t
    }

    #[inline(always)]
    fn block(&mut self, lanes: L, number: usize) -> bool {
        lanes.apart(Leaf { world: self, number })
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

/// A block of the world's, met in a function of its own: what the way down keeps in registers then
/// stays out of its way.
struct Leaf<'a, 'w, const ANY: bool> {
    world: &'a mut World<'w, ANY>,
    number: usize,
}

impl<L: Lanes, const ANY: bool> Task<L> for Leaf<'_, '_, ANY> {
    type Answer = bool;

    #[inline(always)]
    fn run(self, lanes: L) -> bool {
        meet_block(lanes, self.world, self.number)
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

/// Nearest boxes first.
#[inline(always)]
fn first<L: Lanes, E: Ends<L>>(lanes: L, nodes: &[Node], ends: &mut E) -> bool {
    // A node on the way, and which of its children wait.
    let mut stack = [MaybeUninit::<(L::Queue, u32)>::uninit(); DEEPEST];
    let mut waiting = 0;
    let mut current = Child::ROOT;
    let mut limit = ends.limit() * WIDEN;
    loop {
        // Down to something to meet.
        let slabs = ends.slabs().spread(lanes);
        while let Below::Node(number) = current.below() {
            let node = &nodes[number];
            let (near, far) = slabs.meet(lanes, node, limit);
            let queue = lanes.queue(near, far);
            let (near, lane) = lanes.first(queue);
            if near != NONE_LEFT {
                let queue = lanes.without(queue, lane);
                stack[waiting] = MaybeUninit::new((queue, number as u32));
                waiting += usize::from(lanes.first(queue).0 != NONE_LEFT);
                current = node.children[lane];
            } else {
                // SAFETY: all below `waiting` has been written.
                match unsafe { next(lanes, nodes, &mut stack, &mut waiting, limit) } {
                    Some(child) => current = child,
                    None => return false,
                }
            }
        }
        let done = match current.below() {
            Below::Round(primitive) => ends.round(lanes, primitive),
            Below::Block(number) | Below::Node(number) => ends.block(lanes, number),
        };
        if done {
            return true;
        }
        limit = ends.limit() * WIDEN;
        // SAFETY: as above.
        match unsafe { next(lanes, nodes, &mut stack, &mut waiting, limit) } {
            Some(child) => current = child,
            None => return false,
        }
    }
}

/// The nearest child of the last node on the way that has some waiting before a limit.
///
/// # Safety
///
/// All of the stack below `waiting` must have been written.
#[inline(always)]
unsafe fn next<L: Lanes>(
    lanes: L,
    nodes: &[Node],
    stack: &mut [MaybeUninit<(L::Queue, u32)>; DEEPEST],
    waiting: &mut usize,
    limit: f32,
) -> Option<Child> {
    while *waiting > 0 {
        // SAFETY: the caller's.
        let (queue, number) = unsafe { stack[*waiting - 1].assume_init() };
        let (near, lane) = lanes.first(queue);
        if near <= sixteen(limit) {
            stack[*waiting - 1] = MaybeUninit::new((lanes.without(queue, lane), number));
            return Some(nodes[number as usize].children[lane]);
        }
        *waiting -= 1;
    }
    None
}

/// The largest boxes first: they are the last lanes.
#[inline(always)]
fn any<L: Lanes, E: Ends<L>>(lanes: L, nodes: &[Node], ends: &mut E) -> bool {
    // A node on the way, and a bit for each of its children that wait.
    let mut stack = [MaybeUninit::<(u32, u32)>::uninit(); DEEPEST];
    let mut waiting = 0;
    let mut current = Child::ROOT;
    let limit = ends.limit() * WIDEN;
    loop {
        let slabs = ends.slabs().spread(lanes);
        while let Below::Node(number) = current.below() {
            let node = &nodes[number];
            let (near, far) = slabs.meet(lanes, node, limit);
            let met = lanes.at_most(near, far);
            if met != 0 {
                let lane = met.ilog2();
                let others = met ^ (1 << lane);
                stack[waiting] = MaybeUninit::new((others, number as u32));
                waiting += usize::from(others != 0);
                current = node.children[lane as usize % LANES];
            } else {
                // SAFETY: all below `waiting` has been written; none that is there is zero.
                match unsafe { next_of_any(nodes, &mut stack, &mut waiting) } {
                    Some(child) => current = child,
                    None => return false,
                }
            }
        }
        let done = match current.below() {
            Below::Round(primitive) => ends.round(lanes, primitive),
            Below::Block(number) | Below::Node(number) => ends.block(lanes, number),
        };
        if done {
            return true;
        }
        // SAFETY: as above.
        match unsafe { next_of_any(nodes, &mut stack, &mut waiting) } {
            Some(child) => current = child,
            None => return false,
        }
    }
}

/// The largest child that waits of the last node on the way that has some.
///
/// # Safety
///
/// All of the stack below `waiting` must have been written, and have children.
#[inline(always)]
unsafe fn next_of_any(
    nodes: &[Node],
    stack: &mut [MaybeUninit<(u32, u32)>; DEEPEST],
    waiting: &mut usize,
) -> Option<Child> {
    if *waiting == 0 {
        return None;
    }
    // SAFETY: the caller's.
    let (met, number) = unsafe { stack[*waiting - 1].assume_init() };
    let lane = met.ilog2();
    let others = met ^ (1 << lane);
    stack[*waiting - 1] = MaybeUninit::new((others, number));
    *waiting -= usize::from(others == 0);
    Some(nodes[number as usize].children[lane as usize % LANES])
}

/// Offers the triangles that the ray meets; with `ANY`, whether it meets one of them.
#[inline(always)]
fn meet_block<L: Lanes, const ANY: bool>(lanes: L, world: &mut World<ANY>, number: usize) -> bool {
    let blocks = &world.tree.blocks;
    let Candidates { possible, inside, between: [least, most] } =
        blocks[number].candidates(lanes, world.probe);
    if possible == 0 {
        return false;
    }
    let left_out = blocks[number].left_out(lanes, world.probe);
    let (possible, inside) = (possible & !left_out, inside & !left_out);
    if possible == 0 {
        return false;
    }
    let tiny = lanes.splat(f32::MIN_POSITIVE);
    let ahead = inside & lanes.at_most(tiny, least);
    let behind = inside & lanes.at_most(most, lanes.sub(lanes.splat(0.0), tiny));
    let first = ahead & lanes.at_most(least, lanes.splat(world.best.t));
    // Neither certainly behind the origin, nor certainly met.
    let left = possible & !(ahead | behind);
    if ANY {
        let met = first & lanes.at_most(most, lanes.splat(world.best.t.next_down()));
        let left = left | first;
        return met != 0
            || left != 0 && lanes.apart(Rest::<ANY> { world, number, lanes: left, inside });
    }
    if first != 0 {
        let (least, most) = (lanes.store(least), lanes.store(most));
        let mut first = first;
        while first != 0 {
            let lane = first.trailing_zeros() as usize % LANES;
            first &= first - 1;
            let place = best::place(number, lane);
            world.best.offer_within([least[lane], most[lane]], (blocks, place), world.probe);
        }
    }
    left != 0 && lanes.apart(Rest::<ANY> { world, number, lanes: left, inside })
}

/// Triangles of a block that f32 is not sure about.
struct Rest<'a, 'w, const ANY: bool> {
    world: &'a mut World<'w, ANY>,
    number: usize,
    /// A bit for each.
    lanes: u32,
    /// A bit for each whose edges the ray is known to pass inside of.
    inside: u32,
}

impl<L: Lanes, const ANY: bool> Task<L> for Rest<'_, '_, ANY> {
    type Answer = bool;

    #[inline(always)]
    fn run(self, lanes: L) -> bool {
        let World { tree, probe, best, .. } = self.world;
        let block = &tree.blocks[self.number];
        let mut left = self.lanes;
        while left != 0 {
            let lane = left.trailing_zeros() as usize % LANES;
            left &= left - 1;
            let inside = self.inside & (1 << lane) != 0;
            if let Some(t) = block.face(lane).meet(lanes, probe, inside) {
                best.settle(lanes, &tree.blocks, probe);
                best.offer_at(t, block.primitive(lane), best::place(self.number, lane));
                if ANY && best.primitive.is_some() {
                    return true;
                }
            }
        }
        false
    }
}

#[inline(never)]
fn meet_round(shapes: &Shapes, probe: &Probe, primitive: Primitive) -> Option<f32> {
    match primitive.kind() {
        Kind::Sphere => sphere::meet(probe, &shapes.spheres[primitive.index()]),
        _ => disk::meet(probe, &shapes.disks[primitive.index()]),
    }
}

/// A ray as boxes want it.
pub(super) struct Slabs {
    /// For near planes, and for far ones by [`WIDEN`] more.
    inverse: [Vec3A; 2],
    /// For near planes, and for far ones.
    origin: [Vec3A; 2],
    /// 1 where the ray goes towards lesser coordinates, and so meets upper planes first.
    backwards: [bool; 3],
}

impl Slabs {
    #[inline(always)]
    pub fn new(probe: &Probe) -> Self {
        Self::from(probe, [probe.near_origin; 2])
    }

    /// The same for boxes, or a ray, that are off by so much along each axis.
    #[inline(always)]
    pub fn within(probe: &Probe, off: Vec3A) -> Self {
        let origin = probe.near_origin;
        let off = off + (origin.abs() + off) * (2.0 * f32::EPSILON);
        let forwards = off.copysign(probe.inverse);
        Self::from(probe, [origin + forwards, origin - forwards])
    }

    #[inline(always)]
    fn from(probe: &Probe, origin: [Vec3A; 2]) -> Self {
        let inverse = probe.inverse;
        let backwards = [inverse.x < 0.0, inverse.y < 0.0, inverse.z < 0.0];
        Self { inverse: [inverse, inverse * WIDEN], origin, backwards }
    }

    /// Spread over vectors.
    #[inline(always)]
    fn spread<L: Lanes>(&self, lanes: L) -> Spread<L> {
        let [near, far] = self.inverse;
        let [from, to] = self.origin;
        let [x, y, z] = self.backwards;
        // Not by `map`: a call that is not inlined loses what the processor is known to have.
        Spread {
            inverse: [
                [lanes.splat(near.x), lanes.splat(far.x)],
                [lanes.splat(near.y), lanes.splat(far.y)],
                [lanes.splat(near.z), lanes.splat(far.z)],
            ],
            origin: [
                [lanes.splat(from.x), lanes.splat(to.x)],
                [lanes.splat(from.y), lanes.splat(to.y)],
                [lanes.splat(from.z), lanes.splat(to.z)],
            ],
            backwards: [usize::from(x), usize::from(y), usize::from(z)],
        }
    }
}

/// Axis, then near and far.
struct Spread<L: Lanes> {
    inverse: [[L::Eight; 2]; 3],
    origin: [[L::Eight; 2]; 3],
    backwards: [usize; 3],
}

impl<L: Lanes> Spread<L> {
    /// Where the ray enters each of the boxes, and where it leaves them or ends, by [`WIDEN`] more: it
    /// meets those where the former is not more than the latter.
    #[inline(always)]
    fn meet(&self, lanes: L, node: &Node, limit: f32) -> (L::Eight, L::Eight) {
        let [x, y, z] = [0, 1, 2];
        let near = lanes.max(self.plane(lanes, node, x, 0), self.plane(lanes, node, y, 0));
        let near = lanes.max(near, lanes.max(self.plane(lanes, node, z, 0), lanes.splat(0.0)));
        let far = lanes.min(self.plane(lanes, node, x, 1), self.plane(lanes, node, y, 1));
        let far = lanes.min(far, lanes.min(self.plane(lanes, node, z, 1), lanes.splat(limit)));
        (near, far)
    }

    /// Where the ray meets the near (0) or far (1) planes across an axis.
    #[inline(always)]
    fn plane(&self, lanes: L, node: &Node, axis: usize, far: usize) -> L::Eight {
        let side = (self.backwards[axis] ^ far) & 1;
        let planes = lanes.load(&node.planes[axis][side]);
        lanes.mul(lanes.sub(planes, self.origin[axis][far]), self.inverse[axis][far])
    }
}
