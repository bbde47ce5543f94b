//! A perfect mirror.

use glam::DVec2;

use super::{Event, Facing, Scattered};
use crate::math::Rgb;
use crate::render::textures::Colour;

/// A surface that gives light back in one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Mirror {
    /// The part of the light that is given back, on either side.
    pub reflectance: Colour,
}

impl Mirror {
    pub(super) fn at(&self, uv: DVec2, facing: Facing) -> Reflector {
        Reflector { reflectance: self.reflectance.at(uv), facing }
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
