//! The best meeting so far of a ray on its way through the tree.

use super::lanes::Lanes;
use super::ray::Probe;
use super::shapes::Primitive;
use super::triangle::Face;

/// Stands for the face of other shapes.
const NO_FACE: u32 = u32::MAX;

/// The best meeting so far. Its order makes answers the same whatever the order of the tree.
pub(super) struct Best {
    /// Meetings must come before this: the parameter of the best, or an upper bound of it.
    pub t: f32,
    /// A lower bound of the parameter; `t` itself if that is exact.
    least: f32,
    /// The number of the face that is met, if one is.
    face: u32,
    pub primitive: Option<Primitive>,
}

impl Best {
    /// Nothing so far, and nothing from `t_max` on.
    pub fn before(t_max: f32) -> Self {
        Self { t: t_max, least: t_max, face: NO_FACE, primitive: None }
    }

    /// A meeting at exactly `t`, with a shape that is no face.
    pub fn offer(&mut self, t: f32, primitive: Primitive) {
        self.offer_face(t, primitive, NO_FACE);
    }

    /// A meeting at exactly `t`, with a face.
    #[inline(always)]
    pub fn offer_face(&mut self, t: f32, primitive: Primitive, face: u32) {
        if t < self.t || (t == self.t && self.primitive.is_some_and(|best| primitive < best)) {
            *self = Self { t, least: t, face, primitive: Some(primitive) };
        }
    }

    /// The number of the face that is met, if one is.
    #[inline(always)]
    pub fn face(&self) -> Option<usize> {
        (self.face != NO_FACE).then_some(self.face as usize)
    }

    /// A face met at a t > 0 within bounds. Only if they overlap with those of the best, f64 tells
    /// which comes first.
    #[inline(always)]
    pub fn offer_within<L: Lanes>(
        &mut self,
        lanes: L,
        [least, most]: [f32; 2],
        (faces, number): (&[Face], usize),
        probe: &Probe,
    ) {
        let behind = least > self.t;
        if most < self.least {
            let primitive = Some(faces[number].primitive);
            *self = Self { t: most, least, face: number as u32, primitive };
        } else if !behind {
            self.settle(lanes, faces, probe);
            if let Some(t) = faces[number].meet(lanes, probe, true) {
                self.offer_face(t, faces[number].primitive, number as u32);
            }
        }
    }

    /// Makes the parameter exact.
    #[inline(always)]
    pub fn settle<L: Lanes>(&mut self, lanes: L, faces: &[Face], probe: &Probe) {
        if self.least < self.t {
            self.t = faces[self.face as usize].meet(lanes, probe, true).unwrap_or(self.t);
            self.least = self.t;
        }
    }
}
