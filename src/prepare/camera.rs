//! Cameras of the scene → cameras of the world. All of them see through a pinhole.

use glam::DVec3;

use super::errors::scene as errors;
use super::space::Space;
use super::{Settings, film};
use crate::bodies::{Body, Placed};
use crate::diag::Diagnostic;
use crate::render::cameras::{Camera, Floor, Perspective};
use crate::scene::{self, Scene};

/// A camera may stand so many radii of the scene away: its rays still meet the scene within 1e-7
/// radii of where they should.
const FARTHEST: f64 = 1e9;

/// Least sine between the direction of view and up: below it rounding would turn the picture.
const LEAST_SINE: f64 = 1e-9;

/// The camera, if it can see.
pub(super) fn prepare(
    scene: &Scene,
    bodies: &[Placed],
    space: &Space,
    settings: &Settings,
    found: &mut Vec<Diagnostic>,
) -> Option<Camera> {
    let View { forward, up, fov_y } = check(scene, found)?;
    let (eye, at) = match &scene.camera.value {
        scene::Camera::Overview(_) if space.radius() == 0.0 => {
            found.push(errors::nothing_to_see(scene.camera.span));
            return None;
        }
        scene::Camera::Overview(camera) => {
            (-forward * (camera.distance.0 * space.radius()), camera.distance.span)
        }
        scene::Camera::Perspective(camera) => (space.point(camera.eye.0), camera.eye.span),
    };
    // Not greater: what is not a number is too far as well.
    if !eye.is_finite() || eye.abs().max_element() > FARTHEST * space.radius().max(1.0) {
        found.push(errors::too_far_away(at, FARTHEST));
        return None;
    }
    let (size, _) = film::window(&scene.film, settings).ok()?;
    let floors = bodies.iter().filter_map(|placed| match placed.body {
        Body::Plane { point, normal, .. } => Some(Floor::new(space.point(point), normal)),
        _ => None,
    });
    // A little more than what there is, for the rounding of shapes.
    let reach = if space.radius() > 0.0 { space.radius() * (1.0 + 1e-6) } else { f64::INFINITY };
    let camera = Perspective::new(eye, forward, up, fov_y, size).starting(reach, floors.collect());
    Some(Camera::Perspective(camera))
}

/// How a camera is turned; directions have unit length.
pub(super) struct View {
    forward: DVec3,
    up: DVec3,
    fov_y: f64,
}

/// How the camera is turned, if it can be told. Nothing is asked of the objects.
pub(super) fn check(scene: &Scene, found: &mut Vec<Diagnostic>) -> Option<View> {
    let (forward, at, up, fov_y) = match &scene.camera.value {
        scene::Camera::Overview(camera) => {
            (camera.look.0, camera.look.span, &camera.up, camera.fov_y.0)
        }
        scene::Camera::Perspective(camera) => {
            // Halved, and by the largest coordinate first: far ones overflow.
            let way = 0.5 * camera.look_at.0 - 0.5 * camera.eye.0;
            let way = (way / way.abs().max_element()).normalize_or_zero();
            if way == DVec3::ZERO || !way.is_finite() {
                found.push(errors::looks_nowhere(camera.eye.span, camera.look_at.span));
                return None;
            }
            (way, camera.look_at.span, &camera.up, camera.fov_y.0)
        }
    };
    if forward.cross(up.0).length() < LEAST_SINE {
        found.push(errors::looks_along_up(up.span, at));
        return None;
    }
    Some(View { forward, up: up.0, fov_y })
}
