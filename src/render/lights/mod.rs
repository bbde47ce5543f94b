//! Lights: what shines on a point, and from where.

mod directional;
mod lamp;

pub use directional::Directional;
pub use lamp::{Centre, Lamp};

use glam::Vec3;

use super::geometry::{Geometry, Point, Ray};
use crate::math::Rgb;

/// Everything that shines.
#[derive(Clone, Debug, Default)]
pub struct Lights {
    /// Radiance from everywhere around the scene, in light units: seen where a ray meets nothing.
    pub background: Rgb,
    /// What is sampled, in a fixed order.
    pub all: Vec<Light>,
}

/// A light that can be sampled.
#[derive(Clone, Debug)]
pub enum Light {
    /// Parallel light from infinitely far away.
    Directional(Directional),
    /// A surface that shines.
    Lamp(Lamp),
}

/// Light that arrives at a point if nothing is in its way.
#[derive(Clone, Copy, Debug)]
pub struct Arrival {
    /// Where it comes from: unit length, away from the point.
    pub wi: Vec3,
    /// Irradiance on a surface square to `wi`, in light units; of a sampled light, the estimate:
    /// radiance over the sample's density in solid angle.
    pub irradiance: Rgb,
    /// Meets what is in the way.
    pub shadow: Ray,
}

impl Light {
    /// Light from one point of it, chosen by `u` in [0, 1)².
    pub fn sample(&self, geometry: &Geometry, at: &Point, u: [f64; 2]) -> Option<Arrival> {
        match self {
            Self::Directional(directional) => Some(directional.arrive(at)),
            Self::Lamp(lamp) => lamp.sample(geometry, at, u),
        }
    }

    /// All its light as if it came from its centre.
    pub fn at_centre(&self, at: &Point) -> Option<Arrival> {
        match self {
            Self::Directional(directional) => Some(directional.arrive(at)),
            Self::Lamp(lamp) => lamp.at_centre(at),
        }
    }
}
