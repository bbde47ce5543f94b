//! A perfect mirror, and whatever else gives back light in one direction.

use glam::{DVec2, Vec3};

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
    pub(super) fn at(&self, uv: DVec2, facing: &Facing) -> Reflector {
        Reflector { wi: facing.mirrored().0, reflectance: self.reflectance.at(uv) }
    }
}

/// A mirror or a metal at a hit.
#[derive(Clone, Copy, Debug)]
pub struct Reflector {
    /// Where the light comes from.
    pub(super) wi: Vec3,
    /// The part of it that is given back.
    pub(super) reflectance: Rgb,
}

impl Reflector {
    pub(super) fn reflected(&self) -> Scattered {
        Scattered {
            wi: self.wi,
            weight: self.reflectance,
            squeeze: 1.0,
            pdf_w: 0.0,
            event: Event::SpecularReflection,
        }
    }
}
