//! Cameras: from a place on the film to a ray.

mod perspective;

pub use perspective::{Floor, Perspective};

use glam::DVec3;

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

    /// Where the part of the line from `from` to `to` that is before the camera lies on the film;
    /// None if all of it is behind.
    pub fn projected(&self, from: DVec3, to: DVec3) -> Option<[[f64; 2]; 2]> {
        match self {
            Self::Perspective(camera) => camera.projected(from, to),
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
