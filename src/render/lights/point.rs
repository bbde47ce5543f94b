//! Light of a point.

use glam::Vec3;

use super::{Arrival, Emitter, Point, between};
use crate::math::Rgb;

/// A point that shines alike in every direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// World units.
    pub position: Vec3,
    /// Light units times square world units: at a distance of d world units the irradiance is
    /// intensity / d².
    pub intensity: Rgb,
}

impl PointLight {
    /// What bounds it.
    pub(super) fn emitter(&self) -> Emitter {
        let position = self.position.as_dvec3();
        Emitter::everywhere([position; 2], f64::from(self.intensity.luminance()))
    }

    pub(super) fn arrive(&self, at: &Point) -> Option<Arrival> {
        let way = self.position.as_dvec3() - at.position.as_dvec3();
        let wi = way.try_normalize()?;
        // In f64: squares of small distances have no place in f32.
        let irradiance = self.intensity * (1.0 / way.length_squared()) as f32;
        let shadow = between(at, &Point::free(self.position));
        Some(Arrival { wi: wi.as_vec3(), irradiance, pdf_w: 0.0, shadow })
    }
}
