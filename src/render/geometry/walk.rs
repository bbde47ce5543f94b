//! The way of a ray through the tree.
//!
//! Boxes are tested by slabs in f32. A plane's parameter (b − o)·(1/d) is computed as b/d − o/d, in
//! which the roundings of o/d and b/d can be far above those of the difference. They are below 4u of
//! |o/d| beside 4u of the parameter itself: the former is taken from near planes and added to far
//! ones ([`Slabs`]), the latter, with the rounding of the best t, is in [`WIDEN`] [Ize13].
//! Boxes are a little larger than their shapes ([`super::build`]) for rays along their faces.

use std::mem::MaybeUninit;

use glam::Vec3A;

use super::best::Best;
use super::block::Block;
use super::lanes::{LANES, Lanes};
use super::node::{Below, Child, Node};
use super::ray::Probe;
use super::shapes::{Kind, Primitive, Shapes};
use super::tree::Tree;
use super::{disk, sphere};

/// 16u, u = 2⁻²⁴: more than near, far and the best t can be apart by rounding, for their size.
const WIDEN: f32 = 1.0 + 8.0 * f32::EPSILON;

/// Most nodes on the way from the root to a leaf; build keeps to it.
pub(super) const DEEPEST: usize = 26;

/// Each node on the way leaves at most seven children waiting; the last is left with eight.
const STACK: usize = DEEPEST * (LANES - 1) + 1;

/// Offers every meeting that can be the best. With `ANY`, returns at the first found.
#[inline(always)]
pub(super) fn walk<L: Lanes, const ANY: bool>(
    lanes: L,
    tree: &Tree,
    shapes: &Shapes,
    probe: &Probe,
    best: &mut Best,
) {
    let slabs = Slabs::new(lanes, probe);
    descend::<L, ANY, _>(
        lanes,
        &tree.nodes,
        &slabs,
        &mut World::<ANY> { tree, shapes, probe, best },
    );
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
        meet_block::<L, ANY>(lanes, self.tree, &self.tree.blocks[number], self.probe, self.best)
    }

    #[inline(always)]
    fn round(&mut self, lanes: L, primitive: Primitive) -> bool {
        if let Some(t) = meet_round(self.shapes, self.probe, primitive) {
            self.best.settle(lanes, &self.tree.faces, self.probe);
            self.best.offer(t, primitive);
            return ANY && self.best.primitive.is_some();
        }
        false
    }
}

/// The way through a tree, nearest boxes first; with `ANY`, in no order.
#[inline(always)]
pub(super) fn descend<L: Lanes, const ANY: bool, E: Ends<L>>(
    lanes: L,
    nodes: &[Node],
    slabs: &Slabs<L>,
    ends: &mut E,
) {
    if nodes.is_empty() {
        return;
    }
    let mut stack = [MaybeUninit::uninit(); STACK];
    let mut waiting = 0;
    let mut current = Child::ROOT;
    loop {
        match current.below() {
            Below::Node(number) => {
                let node = &nodes[number];
                let (near, mut met) = slabs.meet(lanes, node, ends.limit());
                if met != 0 {
                    // Where any meeting will do, the largest come first: they are the last lanes.
                    let near = if ANY { [0.0; LANES] } else { lanes.store(near) };
                    let mut next = || {
                        let lane = (met.trailing_zeros() as usize) % LANES;
                        met &= met - 1;
                        (entry(near[lane], node.children[lane]), met != 0)
                    };
                    // The nearest is held back, the others wait, the farthest longest.
                    let (mut nearest, mut more) = next();
                    let before = waiting;
                    while more {
                        let mut farther;
                        (farther, more) = next();
                        if ANY || farther < nearest {
                            (nearest, farther) = (farther, nearest);
                        }
                        let mut at = waiting;
                        while !ANY && at > before {
                            // SAFETY: as below.
                            let other = unsafe { stack[at - 1].assume_init() };
                            if other >= farther {
                                break;
                            }
                            stack[at] = MaybeUninit::new(other);
                            at -= 1;
                        }
                        stack[at] = MaybeUninit::new(farther);
                        waiting += 1;
                    }
                    current = split(nearest).1;
                    continue;
                }
            }
            Below::Block(number) => {
                if ends.block(lanes, number) {
                    return;
                }
            }
            Below::Round(primitive) => {
                if ends.round(lanes, primitive) {
                    return;
                }
            }
        }
        let limit = ends.limit() * WIDEN;
        loop {
            if waiting == 0 {
                return;
            }
            waiting -= 1;
            // SAFETY: all below `waiting` has been written.
            let (near, child) = split(unsafe { stack[waiting].assume_init() });
            if ANY || near <= limit {
                current = child;
                break;
            }
        }
    }
}

/// A child waiting on the stack. Ordered by distance, as floats that are not negative are by bits.
#[inline(always)]
fn entry(near: f32, child: Child) -> u64 {
    u64::from(near.to_bits()) << 32 | u64::from(child.bits())
}

#[inline(always)]
fn split(entry: u64) -> (f32, Child) {
    (f32::from_bits((entry >> 32) as u32), Child::from_bits(entry as u32))
}

/// Offers the triangles that the ray meets; whether that is the end.
#[inline(always)]
fn meet_block<L: Lanes, const ANY: bool>(
    lanes: L,
    tree: &Tree,
    block: &Block,
    probe: &Probe,
    best: &mut Best,
) -> bool {
    let candidates = block.candidates(lanes, probe);
    let mut possible = candidates.possible;
    if possible == 0 {
        return false;
    }
    let (least, most) = (lanes.store(candidates.between[0]), lanes.store(candidates.between[1]));
    while possible != 0 {
        let lane = (possible.trailing_zeros() as usize) % LANES;
        possible &= possible - 1;
        let number = block.first as usize + lane;
        let inside = candidates.inside & (1 << lane) != 0;
        let between = [least[lane], most[lane]];
        if inside && between[1] < 0.0 {
            continue;
        }
        if inside && between[0] > 0.0 {
            if !ANY {
                best.offer_within(lanes, between, (&tree.faces, number), probe);
                continue;
            }
            if between[1] < best.t {
                best.primitive = Some(tree.faces[number].primitive);
                return true;
            }
            if between[0] > best.t {
                continue;
            }
        }
        if let Some(t) = tree.faces[number].meet(lanes, probe, inside) {
            best.settle(lanes, &tree.faces, probe);
            best.offer_face(t, tree.faces[number].primitive, number as u32);
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
    /// o/d, for near planes and for far ones.
    origin: [[L::Eight; 2]; 3],
    /// 1 where the ray goes towards lesser coordinates, and so meets upper planes first.
    backwards: [usize; 3],
}

impl<L: Lanes> Slabs<L> {
    #[inline(always)]
    pub fn new(lanes: L, probe: &Probe) -> Self {
        let inverse = inverse(probe.near_direction, probe.near_origin);
        let origin = probe.near_origin * inverse;
        Self::widened(lanes, inverse, origin, origin.abs() * (2.0 * f32::EPSILON))
    }

    /// The same for boxes, or a ray, that are off by so much along each axis.
    #[inline(always)]
    pub fn within(lanes: L, probe: &Probe, off: Vec3A) -> Self {
        let inverse = inverse(probe.near_direction, probe.near_origin);
        let origin = probe.near_origin * inverse;
        let error = (origin.abs() + off * inverse.abs()) * (2.0 * f32::EPSILON);
        Self::widened(lanes, inverse, origin, error + off * inverse.abs())
    }

    /// With an error of o/d.
    #[inline(always)]
    fn widened(lanes: L, inverse: Vec3A, origin: Vec3A, error: Vec3A) -> Self {
        let (near, far) = (origin + error, origin - error);
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

    /// Where the ray enters each of the boxes, and a bit for each that it enters before `limit`.
    #[inline(always)]
    fn meet(&self, lanes: L, node: &Node, limit: f32) -> (L::Eight, u32) {
        let [x, y, z] = [0, 1, 2];
        let near = lanes.max(self.plane(lanes, node, x, 0), self.plane(lanes, node, y, 0));
        let near = lanes.max(near, lanes.max(self.plane(lanes, node, z, 0), lanes.splat(0.0)));
        let far = lanes.min(self.plane(lanes, node, x, 1), self.plane(lanes, node, y, 1));
        let far = lanes.min(far, lanes.min(self.plane(lanes, node, z, 1), lanes.splat(limit)));
        (near, lanes.at_most(near, lanes.mul(far, lanes.splat(WIDEN))))
    }

    /// Where the ray meets the near (0) or far (1) planes across an axis.
    #[inline(always)]
    fn plane(&self, lanes: L, node: &Node, axis: usize, far: usize) -> L::Eight {
        let side = (self.backwards[axis] ^ far) & 1;
        let planes = lanes.load(&node.planes[axis][side]);
        lanes.mul_sub(planes, self.inverse[axis], self.origin[axis][far])
    }
}

/// 1/d, kept so small that o/d is finite: a coordinate within ±2⁻¹⁰⁰, or ±2⁻¹²⁶ of the origin's,
/// stands for one of that size, which moves the ray by less than what o/d is widened by, or boxes
/// are padded. −0 goes the same way as +0.
#[inline(always)]
fn inverse(direction: Vec3A, origin: Vec3A) -> Vec3A {
    const LEAST: f32 = 1.0 / (1_u128 << 100) as f32;
    const FAR: f32 = 1.0 / (1_u128 << 26) as f32;
    // In this order, since numbers below the normal ones are slow.
    let least = (origin.abs() * FAR).max(Vec3A::ONE) * LEAST;
    let size = direction.abs().max(least);
    let size = Vec3A::select(direction.cmplt(Vec3A::ZERO), -size, size);
    size.recip()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverses_are_finite_and_zeros_alike() {
        let inverse = |d: f32, o: f32| inverse(Vec3A::splat(d), Vec3A::splat(o)).x;
        assert_eq!(inverse(-0.5, 1.0), -2.0);
        assert_eq!(inverse(0.0, 1.0), inverse(-0.0, 1.0));
        for d in [0.0, 1e-45, -1e-45, 1e-38, -1e-30, 1.0] {
            for o in [0.0, 1e-45, 1.0, -1e12, f32::MAX] {
                let i = inverse(d, o);
                assert!(i.is_finite() && (i * o).is_finite() && i * d >= 0.0, "{d}, {o}");
            }
        }
    }
}
