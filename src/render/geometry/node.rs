//! What the tree is made of: nodes of eight boxes, and what the boxes hold.

use super::Bounds;
use super::lanes::LANES;
use super::ray::Axis;
use super::shapes::{Kind, Primitive};

/// What a node's lane leads to: two bits of kind, thirty of number. Spheres and disks stand for
/// themselves, numbered as primitives are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Child(u32);

const SHIFT: u32 = 30;
const NUMBER: u32 = (1 << SHIFT) - 1;
const NODE: u32 = 0;
const BLOCK: u32 = 3;

/// A [`Child`] taken apart.
pub(super) enum Below {
    /// The number of a node.
    Node(usize),
    /// The number of a block of triangles.
    Block(usize),
    /// A sphere or a disk.
    Round(Primitive),
}

impl Child {
    pub const ROOT: Self = Self(NODE << SHIFT);

    /// Neither a node nor what holds shapes: no tree has so many nodes.
    pub const NONE: Self = Self(NODE << SHIFT | NUMBER);

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

    /// Whether it is a node.
    #[inline(always)]
    pub fn is_node(self) -> bool {
        self.0 < Self::NONE.0
    }

    /// Whether it holds shapes.
    #[inline(always)]
    pub fn is_leaf(self) -> bool {
        self.0 > Self::NONE.0
    }

    /// Of a node or a block.
    #[inline(always)]
    pub fn number(self) -> usize {
        (self.0 & NUMBER) as usize
    }

    #[inline(always)]
    pub fn below(self) -> Below {
        let number = (self.0 & NUMBER) as usize;
        match self.0 >> SHIFT {
            NODE => Below::Node(number),
            BLOCK => Below::Block(number),
            _ => Below::Round(Primitive::from_bits(self.0)),
        }
    }
}

/// Eight boxes and what they hold: four cache lines.
#[repr(C, align(64))]
pub(super) struct Node {
    /// Axis, then lower and upper planes; a lane a child. A lane without a child is never met.
    pub planes: [[[f32; LANES]; 2]; 3],
    pub children: [Child; LANES],
    /// Of children that are blocks, a little more than the greatest extent of their boxes.
    pub spans: [f32; LANES],
}

/// Which planes of a node: bytes from its beginning.
#[derive(Clone, Copy)]
pub(super) struct Side(usize);

impl Side {
    /// The lower or the upper planes across an axis.
    pub fn of(axis: Axis, upper: bool) -> Self {
        let vector = size_of::<[f32; LANES]>();
        Self((axis as usize * 2 + usize::from(upper)) * vector)
    }

    /// Upper in place of lower, or the other way round.
    #[inline(always)]
    pub fn other(self) -> Self {
        Self(self.0 ^ size_of::<[f32; LANES]>())
    }
}

impl Node {
    /// A node without children.
    pub const EMPTY: Self = Self {
        planes: [[[f32::INFINITY; LANES], [f32::NEG_INFINITY; LANES]]; 3],
        children: [Child::ROOT; LANES],
        spans: [0.0; LANES],
    };

    #[inline(always)]
    pub fn side(&self, side: Side) -> &[f32; LANES] {
        // SAFETY: the planes are what a node begins with, and a `Side` is one of the six.
        unsafe { &*(&raw const self.planes).byte_add(side.0).cast() }
    }

    /// Puts a block of triangles with its box into a lane.
    pub fn set_block(&mut self, lane: usize, bounds: Bounds, number: usize) {
        const UP: f32 = 1.0 + 8.0 * f32::EPSILON;
        self.set(lane, bounds);
        self.children[lane] = Child::block(number);
        self.spans[lane] = (bounds.max - bounds.min).max_element() * UP;
    }

    /// Puts a box into a lane.
    pub fn set(&mut self, lane: usize, bounds: Bounds) {
        for axis in 0..3 {
            self.planes[axis][0][lane] = bounds.min[axis];
            self.planes[axis][1][lane] = bounds.max[axis];
        }
    }

    /// The box around all children.
    pub fn bounds(&self) -> Bounds {
        let edge = |side: usize, f: fn(f32, f32) -> f32| {
            [0, 1, 2].map(|axis| {
                let planes = &self.planes[axis][side];
                planes.iter().copied().fold(planes[0], f)
            })
        };
        Bounds { min: edge(0, f32::min).into(), max: edge(1, f32::max).into() }
    }
}
