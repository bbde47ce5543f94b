//! World space: the scene, moved to the middle of its bounding box and scaled by a power of two
//! to fit about [-1, 1].
//!
//! So single precision is spent where the scene is, wherever and however large its author made
//! it; a scene scaled by a power of two becomes the same world, bit by bit.

use glam::{DAffine3, DVec3};

use crate::bodies::{self, Placed};
use crate::math::Bounds;
use crate::scene;

/// The map from metres to world units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Space {
    centre: DVec3,
    /// A power of two.
    scale: f64,
    /// From the middle of the box of all bounded objects to its corners, in world units.
    half: DVec3,
}

impl Space {
    /// The space of a scene's objects. Where none is bounded, points of the others and the camera
    /// stand in for them.
    pub fn around(bodies: &[Placed], camera: &scene::Camera) -> Self {
        let extent = bodies::extent(camera, bodies);
        if bodies.iter().any(|body| !body.bounds().is_empty()) {
            return Self::of(extent);
        }
        let space = if extent.is_empty() {
            Self { centre: DVec3::ZERO, scale: 1.0, half: DVec3::ZERO }
        } else {
            Self::of(extent)
        };
        Self { half: DVec3::ZERO, ..space }
    }

    fn of(bounds: Bounds) -> Self {
        let half = bounds.half();
        let scale = power_of_two_over(half.max_element());
        Self { centre: bounds.centre(), scale, half: half * scale }
    }

    /// The point, in metres, that is the origin of the world.
    pub fn centre(&self) -> DVec3 {
        self.centre
    }

    /// A point.
    pub fn point(&self, metres: DVec3) -> DVec3 {
        (metres - self.centre) * self.scale
    }

    /// The map from world units to metres.
    pub fn to_metres(self) -> DAffine3 {
        let scale = DVec3::splat(1.0 / self.scale);
        DAffine3::from_translation(self.centre) * DAffine3::from_scale(scale)
    }

    /// A length.
    pub fn length(&self, metres: f64) -> f64 {
        metres * self.scale
    }

    /// Half the diagonal of the box around all bounded objects, in world units; 0 for none.
    pub fn radius(&self) -> f64 {
        self.half.length()
    }
}

/// 2ⁿ such that x · 2ⁿ is in [1/2, 1); 1 for what has no such n.
fn power_of_two_over(x: f64) -> f64 {
    const BIAS: i64 = 1023;
    let exponent = (x.to_bits() >> 52 & 0x7ff) as i64 - BIAS;
    // Sizes near the ends of f64 are refused elsewhere; here they must only do no harm.
    if x > 0.0 && x.is_finite() {
        2.0_f64.powi(-(exponent.clamp(-1000, 1000) as i32) - 1)
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_are_brought_to_one_by_powers_of_two() {
        for x in [1e-300, 1e-9, 0.3, 0.5, 1.0, 7.0, 1e7, 1e200] {
            let scaled = x * power_of_two_over(x);
            assert!((0.5..1.0).contains(&scaled), "{x} became {scaled}");
            assert_eq!(power_of_two_over(x).to_bits() & ((1 << 52) - 1), 0);
        }
        assert_eq!(power_of_two_over(0.0), 1.0);
        let bounds = Bounds { min: DVec3::new(99.0, -1.0, 0.0), max: DVec3::new(101.0, 3.0, 0.0) };
        let space = Space::of(bounds);
        assert_eq!(space.point(DVec3::new(101.0, 3.0, 0.0)), DVec3::new(0.25, 0.5, 0.0));
        assert_eq!(space.length(4.0), 1.0);
    }
}
