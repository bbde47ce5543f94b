//! What a camera that stands somewhere has in view.

use glam::DVec3;

use super::Shot;
use crate::diag::Span;
use crate::scene::Camera;

/// A perspective camera in metres; directions have unit length. The camera `overview` sees its
/// scene by its nature.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    pub eye: DVec3,
    pub forward: DVec3,
    right: DVec3,
    up: DVec3,
    /// Half the picture's width and height, at distance 1.
    half: [f64; 2],
    /// Where its direction is said.
    pub at: Span,
}

impl View {
    /// None: it is an `overview`, or faces nowhere.
    pub fn of(shot: &Shot) -> Option<Self> {
        let scene = &shot.stage.scene;
        let Camera::Perspective(camera) = &scene.camera.value else { return None };
        let forward = (camera.look_at.0 - camera.eye.0).try_normalize()?;
        let right = forward.cross(camera.up.0).try_normalize()?;
        let [width, height] = scene.film.size.0.map(|n| n as f64);
        let tangent = (0.5 * camera.fov_y.0).tan();
        Some(Self {
            eye: camera.eye.0,
            forward,
            right,
            up: right.cross(forward),
            half: [tangent * width / height, tangent],
            at: camera.look_at.span,
        })
    }

    /// Normals of the planes through the eye that bound what is seen, inward; not unit length.
    pub fn sides(&self) -> [DVec3; 5] {
        let [x, y] = self.half;
        [
            self.forward,
            self.forward * x + self.right,
            self.forward * x - self.right,
            self.forward * y + self.up,
            self.forward * y - self.up,
        ]
    }
}
