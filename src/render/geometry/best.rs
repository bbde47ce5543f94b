//! The best meeting so far of a ray on its way through the tree.

use super::ray::Probe;
use super::shapes::{Primitive, Shapes};
use super::triangle;

/// The best meeting so far. Its order makes answers the same whatever the order of the tree.
pub(super) struct Best {
    /// Meetings must come before this: the parameter of the best, or an upper bound of it.
    pub t: f32,
    /// A lower bound of the parameter; `t` itself if that is exact.
    least: f32,
    pub primitive: Option<Primitive>,
}

impl Best {
    /// Nothing so far, and nothing from `t_max` on.
    pub fn before(t_max: f32) -> Self {
        Self { t: t_max, least: t_max, primitive: None }
    }

    /// A meeting at exactly `t`.
    pub fn offer(&mut self, t: f32, primitive: Primitive) {
        if t < self.t || (t == self.t && self.primitive.is_some_and(|best| primitive < best)) {
            *self = Self { t, least: t, primitive: Some(primitive) };
        }
    }

    /// A triangle met at a t > 0 within bounds. Only if they overlap with those of the best, f64
    /// tells which comes first.
    #[inline(always)]
    pub fn offer_within(
        &mut self,
        [least, most]: [f32; 2],
        primitive: Primitive,
        probe: &Probe,
        shapes: &Shapes,
    ) {
        let behind = least > self.t;
        if most < self.least {
            *self = Self { t: most, least, primitive: Some(primitive) };
        } else if !behind {
            self.settle(probe, shapes);
            if let Some(t) = triangle::meet(probe, shapes.exact_corners(primitive.index()), true) {
                self.offer(t, primitive);
            }
        }
    }

    /// Makes the parameter exact.
    #[inline(always)]
    pub fn settle(&mut self, probe: &Probe, shapes: &Shapes) {
        if self.least < self.t
            && let Some(primitive) = self.primitive
        {
            let t = triangle::meet(probe, shapes.exact_corners(primitive.index()), true);
            self.t = t.unwrap_or(self.t);
            self.least = self.t;
        }
    }
}
