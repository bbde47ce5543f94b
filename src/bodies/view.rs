//! Where the camera stands, and how far the scene reaches.

use glam::DVec3;

use super::placed::{Body, Placed};
use crate::diag::Span;
use crate::math::Bounds;
use crate::scene::{Camera, Scene};

/// Where a camera stands, in metres, and where that is said; None where nothing says it.
pub fn eye(scene: &Scene, placed: &[Placed]) -> Option<(DVec3, Span)> {
    match &scene.camera.value {
        Camera::Perspective(camera) => Some((camera.eye.0, camera.eye.span)),
        Camera::Overview(camera) => {
            let all = placed.iter().map(Placed::bounds).fold(Bounds::EMPTY, Bounds::union);
            let away = camera.distance.0 * 0.5 * all.size();
            let eye = (!all.is_empty()).then(|| all.centre() - camera.look.0 * away)?;
            Some((eye, scene.camera.span))
        }
    }
}

/// The box that single precision is spent on, in metres: around all bounded objects; where none is
/// bounded, around points of the others and the camera. Empty if there is neither.
pub fn extent(camera: &Camera, placed: &[Placed]) -> Bounds {
    let bounded = placed.iter().map(Placed::bounds).fold(Bounds::EMPTY, Bounds::union);
    if !bounded.is_empty() {
        return bounded;
    }
    let planes = placed.iter().filter_map(|object| match object.body {
        Body::Plane { point, .. } => Some(point),
        _ => None,
    });
    let eye = match camera {
        Camera::Perspective(camera) => Some(camera.eye.0),
        Camera::Overview(_) => None,
    };
    Bounds::around(planes.chain(eye))
}
