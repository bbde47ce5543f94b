//! Cameras: from a place on the film to a ray.

mod perspective;

pub use perspective::{Floor, Perspective};

use super::geometry::Ray;

/// Where the picture is taken from.
#[derive(Clone, Debug)]
pub enum Camera {
    /// A pinhole.
    Perspective(Perspective),
}

impl Camera {
    /// The ray of a place on the film, in pixels: x to the right, y down, from the top left
    /// corner. Places outside the film are seen too, since filters reach there.
    pub fn ray(&self, x: f64, y: f64) -> Ray {
        match self {
            Self::Perspective(camera) => camera.ray(x, y),
        }
    }

    /// The same camera, with a film of `size` pixels spread over a part of its own: the `extent`
    /// pixels from `corner` on.
    pub fn over(&self, corner: [u64; 2], extent: [u64; 2], size: [u64; 2]) -> Self {
        match self {
            Self::Perspective(camera) => Self::Perspective(camera.over(corner, extent, size)),
        }
    }
}
