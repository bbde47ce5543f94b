//! Materials: what a surface does with light, and what it becomes at a hit.

mod diffuse;

pub use diffuse::{Diffuse, Lambert};

use glam::Vec3;

use super::geometry::Hit;
use crate::math::Rgb;

/// A surface's material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Material {
    /// Lambert's.
    Diffuse(Diffuse),
}

impl Material {
    /// The radiance the front side shines of itself.
    pub fn emission(&self) -> Rgb {
        match self {
            Self::Diffuse(diffuse) => diffuse.emission,
        }
    }

    /// The colour of the surface, for a picture that shows what is where.
    pub fn colour(&self) -> Rgb {
        match self {
            Self::Diffuse(diffuse) => diffuse.albedo,
        }
    }

    /// What the material is at a hit, seen from `wo`, which points away from the surface.
    pub fn at(&self, hit: &Hit, wo: Vec3) -> Bsdf {
        match self {
            Self::Diffuse(diffuse) => Bsdf::Lambert(diffuse.at(hit, wo)),
        }
    }
}

/// How the surface at a hit scatters light.
#[derive(Clone, Copy, Debug)]
pub enum Bsdf {
    /// Lambert's.
    Lambert(Lambert),
}

impl Bsdf {
    /// The BSDF towards the viewer of light from `wi`, times the cosine at the shading normal,
    /// in 1/sr.
    pub fn scattered(&self, wi: Vec3) -> Rgb {
        match self {
            Self::Lambert(lambert) => lambert.scattered(wi),
        }
    }

    /// Whether light from `wi` reaches the viewer's side of the geometric surface. Where normals
    /// are interpolated it may not, though it is above the shading normal: it would leak through
    /// from behind.
    pub fn faces(&self, wi: Vec3) -> bool {
        match self {
            Self::Lambert(lambert) => lambert.faces(wi),
        }
    }
}
