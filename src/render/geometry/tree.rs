//! The tree over all bounded shapes, four children a node, and the walk of a ray through it.
//!
//! Boxes are tested by slabs in f32. A plane's parameter (b − o)·(1/d) is off by γ(3) at most, so a
//! ray certainly misses only if near > far·(1 + γ(3))/(1 − γ(3)) [Ize13]; [`WIDEN`] is above that,
//! and above the rounding of the best t. What a box holds is decided in f64 and doesn't move;
//! boxes are a little larger than their shapes ([`super::build`]) for rays along their faces.

use glam::{Vec3, Vec4};

use super::block::Block;
use super::ray::Probe;
use super::shapes::{Kind, Primitive, Shapes};
use super::{Bounds, disk, sphere, triangle};

/// Children a node, triangles a block: the lanes of a vector.
pub(super) const LANES: usize = 4;

/// 16u, u = 2⁻²⁴: more than the 8u that near, far and the best t can be apart by rounding.
const WIDEN: f32 = 1.0 + 8.0 * f32::EPSILON;

/// Most nodes on the way from the root to a leaf; build keeps to it.
pub(super) const DEEPEST: usize = 40;

/// Each node on the way leaves at most three children waiting; the last is left with four.
const STACK: usize = DEEPEST * (LANES - 1) + 1;

/// What a node's lane leads to: two bits of kind, thirty of number. Spheres and disks stand for
/// themselves, numbered as primitives are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Child(pub u32);

const SHIFT: u32 = 30;
const NUMBER: u32 = (1 << SHIFT) - 1;
const NODE: u32 = 0;
const BLOCK: u32 = 3;

impl Child {
    pub fn node(index: usize) -> Self {
        Self(NODE << SHIFT | index as u32)
    }

    pub fn block(index: usize) -> Self {
        Self(BLOCK << SHIFT | index as u32)
    }

    /// A sphere or a disk.
    pub fn round(primitive: Primitive) -> Self {
        debug_assert!(matches!(primitive.kind(), Kind::Sphere | Kind::Disk));
        Self(primitive.bits())
    }
}

/// Four boxes and what they hold.
#[repr(align(64))]
pub(super) struct Node {
    /// Axis, then lower and upper planes; a lane a child. A lane without a child is never met.
    planes: [[Vec4; 2]; 3],
    children: [Child; LANES],
}

impl Node {
    /// A node without children.
    pub const EMPTY: Self =
        Self { planes: [[Vec4::INFINITY, Vec4::NEG_INFINITY]; 3], children: [Child(0); LANES] };

    /// Puts a child into a lane.
    pub fn set(&mut self, lane: usize, bounds: Bounds, child: Child) {
        for axis in 0..3 {
            self.planes[axis][0][lane] = bounds.min[axis];
            self.planes[axis][1][lane] = bounds.max[axis];
        }
        self.children[lane] = child;
    }
}

/// The tree.
pub(super) struct Tree {
    pub nodes: Vec<Node>,
    pub blocks: Vec<Block>,
}

/// The best meeting so far. Its order makes answers the same whatever the order of the tree.
pub(super) struct Best {
    /// Meetings must come before this.
    pub t: f32,
    pub primitive: Option<Primitive>,
}

impl Best {
    pub fn offer(&mut self, t: f32, primitive: Primitive) {
        if t < self.t || (t == self.t && self.primitive.is_some_and(|best| primitive < best)) {
            *self = Self { t, primitive: Some(primitive) };
        }
    }
}

impl Tree {
    /// Offers every meeting that can be the best. With `ANY`, returns at the first found.
    pub fn walk<const ANY: bool>(&self, shapes: &Shapes, probe: &Probe, best: &mut Best) {
        match probe.axis {
            0 => self.walk_along::<0, ANY>(shapes, probe, best),
            1 => self.walk_along::<1, ANY>(shapes, probe, best),
            _ => self.walk_along::<2, ANY>(shapes, probe, best),
        }
    }

    fn walk_along<const AXIS: usize, const ANY: bool>(
        &self,
        shapes: &Shapes,
        probe: &Probe,
        best: &mut Best,
    ) {
        if self.nodes.is_empty() {
            return;
        }
        let slabs = Slabs::new(probe.near_origin, probe.inverse);
        let mut stack = [0_u64; STACK];
        let mut waiting = 0;
        let mut current = Child::node(0);
        loop {
            let number = (current.0 & NUMBER) as usize;
            match current.0 >> SHIFT {
                NODE => {
                    let node = &self.nodes[number];
                    let (near, mut met) = slabs.meet(node, best.t);
                    if met != 0 {
                        let near = near.to_array();
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
                            if farther < nearest {
                                (nearest, farther) = (farther, nearest);
                            }
                            let mut at = waiting;
                            while !ANY && at > before && stack[at - 1] < farther {
                                stack[at] = stack[at - 1];
                                at -= 1;
                            }
                            stack[at] = farther;
                            waiting += 1;
                        }
                        current = split(nearest).1;
                        continue;
                    }
                }
                BLOCK => {
                    self.blocks[number].meet::<AXIS>(probe, best);
                }
                _ => {
                    let primitive = Primitive::from_bits(current.0);
                    if let Some(t) = meet_round(shapes, probe, primitive) {
                        best.offer(t, primitive);
                    }
                }
            }
            if ANY && best.primitive.is_some() {
                return;
            }
            let limit = best.t * WIDEN;
            loop {
                if waiting == 0 {
                    return;
                }
                waiting -= 1;
                let (near, child) = split(stack[waiting]);
                if near <= limit {
                    current = child;
                    break;
                }
            }
        }
    }

    /// Memory held, in bytes.
    pub fn bytes(&self) -> usize {
        self.nodes.capacity() * size_of::<Node>() + self.blocks.capacity() * size_of::<Block>()
    }
}

/// A child waiting on the stack. Ordered by distance, as floats that are not negative are by bits.
fn entry(near: f32, child: Child) -> u64 {
    u64::from(near.to_bits()) << 32 | u64::from(child.0)
}

fn split(entry: u64) -> (f32, Child) {
    (f32::from_bits((entry >> 32) as u32), Child(entry as u32))
}

fn meet_round(shapes: &Shapes, probe: &Probe, primitive: Primitive) -> Option<f32> {
    match primitive.kind() {
        Kind::Sphere => sphere::meet(probe, &shapes.spheres[primitive.index()]),
        _ => disk::meet(probe, &shapes.disks[primitive.index()]),
    }
}

impl Block {
    /// Offers the triangles that the ray meets.
    #[inline(always)]
    fn meet<const AXIS: usize>(&self, probe: &Probe, best: &mut Best) {
        let candidates = self.candidates::<AXIS>(probe, best.t * WIDEN);
        let mut possible = candidates.possible;
        while possible != 0 {
            let lane = (possible.trailing_zeros() as usize) % LANES;
            possible &= possible - 1;
            let inside = candidates.inside & (1 << lane) != 0;
            if let Some(t) = triangle::meet(probe, self.triangle(lane), inside) {
                best.offer(t, self.primitive(lane));
            }
        }
    }
}

/// A ray as boxes want it.
struct Slabs {
    origin: [Vec4; 3],
    inverse: [Vec4; 3],
    /// 1 where the ray goes towards lesser coordinates, and so meets upper planes first.
    backwards: [usize; 3],
}

impl Slabs {
    fn new(origin: Vec3, inverse: Vec3) -> Self {
        Self {
            origin: origin.to_array().map(Vec4::splat),
            inverse: inverse.to_array().map(Vec4::splat),
            backwards: inverse.to_array().map(|i| usize::from(i < 0.0)),
        }
    }

    /// Where the ray enters each of the four boxes, and a bit for each that it enters before
    /// `limit`.
    #[inline(always)]
    fn meet(&self, node: &Node, limit: f32) -> (Vec4, u32) {
        let plane = |axis: usize, side: usize| {
            (node.planes[axis][side & 1] - self.origin[axis]) * self.inverse[axis]
        };
        let [bx, by, bz] = self.backwards;
        let near = plane(0, bx).max(plane(1, by)).max(plane(2, bz).max(Vec4::ZERO));
        let far = plane(0, 1 - bx).min(plane(1, 1 - by));
        let far = far.min(plane(2, 1 - bz).min(Vec4::splat(limit)));
        (near, near.cmple(far * WIDEN).bitmask())
    }
}
