//! A perfect mirror.

use super::{Event, Facing, Scattered};
use crate::math::Rgb;

/// A surface that gives light back in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// The part of the light that is given back, on either side.
    pub reflectance: Rgb,
}

impl Mirror {
    pub(super) fn at(&self, facing: Facing) -> Reflector {
        Reflector { reflectance: self.reflectance, facing }
    }
}

/// A mirror at a hit.
#[derive(Clone, Copy, Debug)]
pub struct Reflector {
    reflectance: Rgb,
    facing: Facing,
}

impl Reflector {
    pub(super) fn reflected(&self) -> Option<Scattered> {
        Some(Scattered {
            wi: self.facing.mirrored()?,
            weight: self.reflectance,
            squeeze: 1.0,
            pdf_w: 0.0,
            event: Event::SpecularReflection,
        })
    }
}
