//! The best meeting so far of a ray on its way through the tree.

use super::block::Block;
use super::lanes::{LANES, Lanes, Portable};
use super::ray::Probe;
use super::shapes::Primitive;

/// Where a ray first meets a surface: what is needed to choose among surfaces, and to find out all
/// the rest ([`super::Geometry::hit`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// Distance along the ray, the same as [`super::Hit::t`].
    pub t: f32,
    /// What is met; of an instance, the triangle by its number in the mesh.
    pub primitive: Primitive,
    pub(super) place: Place,
}

/// Where what is met is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// A triangle of the tree, by [`place`].
    Tree(u32),
    /// A triangle of an instance, by the number of that.
    Instance(u32),
    /// Among the shapes alone.
    Shapes,
}

/// Stands for the place of other shapes.
const NO_PLACE: usize = usize::MAX;

/// The best meeting so far. Its order makes answers the same whatever the order of the tree.
pub(super) struct Best {
    /// Meetings must come before this: the parameter of the best, or an upper bound of it.
    pub t: f32,
    /// A lower bound of the parameter; `t` itself if that is exact.
    least: f32,
    /// Of a triangle, its place in the tree.
    place: usize,
    pub primitive: Option<Primitive>,
}

/// The place of a triangle: its block and lane. Build keeps it below 2³².
#[inline(always)]
pub(super) fn place(block: usize, lane: usize) -> usize {
    block * LANES + lane
}

impl Best {
    /// Nothing so far, and nothing from `t_max` on.
    pub fn before(t_max: f32) -> Self {
        Self { t: t_max, least: t_max, place: NO_PLACE, primitive: None }
    }

    /// A meeting at exactly `t`, with a shape that is no triangle.
    pub fn offer(&mut self, t: f32, primitive: Primitive) {
        self.offer_at(t, primitive, NO_PLACE);
    }

    /// A meeting at exactly `t`.
    #[inline(always)]
    pub fn offer_at(&mut self, t: f32, primitive: Primitive, place: usize) {
        if t < self.t || (t == self.t && self.primitive.is_some_and(|best| primitive < best)) {
            *self = Self { t, least: t, place, primitive: Some(primitive) };
        }
    }

    /// What is met, if anything is. Its parameter is exact only after [`Self::settle`].
    #[inline(always)]
    pub fn meeting(&self) -> Option<Meeting> {
        let place = match self.place {
            NO_PLACE => Place::Shapes,
            place => Place::Tree(place as u32),
        };
        Some(Meeting { t: self.t, primitive: self.primitive?, place })
    }

    /// A triangle met at a t > 0 within bounds. Only if they overlap with those of the best, f64
    /// tells which comes first.
    #[inline(always)]
    pub fn offer_within(
        &mut self,
        [least, most]: [f32; 2],
        (blocks, place): (&[Block], usize),
        probe: &Probe,
    ) {
        if most < self.least {
            let primitive = Some(blocks[place / LANES].primitive(place % LANES));
            *self = Self { t: most, least, place, primitive };
        } else if least <= self.t {
            self.offer_exactly((blocks, place), probe, true);
        }
    }

    /// A triangle, if it is met; `inside` if the ray is known to pass inside of its edges.
    #[cold]
    #[inline(never)]
    pub fn offer_exactly(
        &mut self,
        (blocks, place): (&[Block], usize),
        probe: &Probe,
        inside: bool,
    ) {
        let (block, lane) = (&blocks[place / LANES], place % LANES);
        if let Some(t) = block.face(lane).meet(Portable, probe, inside) {
            self.settle(Portable, blocks, probe);
            self.offer_at(t, block.primitive(lane), place);
        }
    }

    /// Makes the parameter exact.
    #[inline(always)]
    pub fn settle<L: Lanes>(&mut self, lanes: L, blocks: &[Block], probe: &Probe) {
        if self.least < self.t {
            let face = blocks[self.place / LANES].face(self.place % LANES);
            self.t = face.parameter(lanes, probe);
            self.least = self.t;
        }
    }
}
