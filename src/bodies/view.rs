//! Where the camera stands.

use glam::DVec3;

use super::placed::Placed;
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
