//! Parallel light from infinitely far away.

use glam::Vec3;

use super::choice::Gives;
use super::{Arrival, Point};
use crate::math::Rgb;

/// Light of one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Directional {
    /// Towards the light; unit length.
    pub to_light: Vec3,
    /// On a surface square to it, in light units.
    pub irradiance: Rgb,
}

impl Directional {
    pub(super) fn arrive(&self, at: &Point) -> Arrival {
        let shadow = at.ray(self.to_light);
        Arrival { wi: self.to_light, irradiance: self.irradiance, pdf_w: 0.0, shadow }
    }

    /// About the irradiance it gives.
    pub(super) fn gives(&self) -> Gives {
        Gives::from(self.to_light, f64::from(self.irradiance.luminance()), 0.0)
    }
}
