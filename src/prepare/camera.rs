//! Cameras of the scene → cameras of the world. All of them see through a pinhole.

use glam::DVec3;

use super::errors::scene as errors;
use super::objects::{Body, Placed};
use super::space::Space;
use super::{Settings, film};
use crate::diag::{Diagnostic, Span};
use crate::render::cameras::{Camera, Floor, Perspective};
use crate::scene::{self, At, Direction, Scene};

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
    let (eye, forward, up, fov_y) = match &scene.camera.value {
        scene::Camera::Overview(camera) => {
            let radius = space.radius();
            if radius == 0.0 {
                found.push(errors::nothing_to_see(scene.camera.span));
                return None;
            }
            let distance = camera.distance.0 * radius;
            let (look, at) = (camera.look.0, camera.look.span);
            let up = upright(look, at, &camera.up, found)?;
            (
                within_reach(-look * distance, camera.distance.span, space, found)?,
                look,
                up,
                camera.fov_y.0,
            )
        }
        scene::Camera::Perspective(camera) => {
            let (eye, look_at) = (camera.eye.0, camera.look_at.0);
            // By the largest coordinate first: squares of far ones overflow.
            let way = look_at - eye;
            let way = (way / way.abs().max_element()).normalize_or_zero();
            if way == DVec3::ZERO || !way.is_finite() {
                found.push(errors::looks_nowhere(camera.eye.span, camera.look_at.span));
                return None;
            }
            let up = upright(way, camera.look_at.span, &camera.up, found)?;
            (
                within_reach(space.point(eye), camera.eye.span, space, found)?,
                way,
                up,
                camera.fov_y.0,
            )
        }
    };
    let (size, _) = film::window(&scene.film, settings).ok()?;
    let floors = bodies.iter().filter_map(|placed| match placed.body {
        Body::Plane { point, normal } => Some(Floor::new(space.point(point), normal)),
        _ => None,
    });
    // A little more than what there is, for the rounding of shapes.
    let reach = if space.radius() > 0.0 { space.radius() * (1.0 + 1e-6) } else { f64::INFINITY };
    let camera = Perspective::new(eye, forward, up, fov_y, size).starting(reach, floors.collect());
    Some(Camera::Perspective(camera))
}

/// The part of `up` square to the direction of view, which must not be parallel to it.
fn upright(
    forward: DVec3,
    at: Span,
    up: &At<Direction>,
    found: &mut Vec<Diagnostic>,
) -> Option<DVec3> {
    if forward.cross(up.0).length() < LEAST_SINE {
        found.push(errors::looks_along_up(up.span, at));
        return None;
    }
    Some(up.0)
}

fn within_reach(eye: DVec3, at: Span, space: &Space, found: &mut Vec<Diagnostic>) -> Option<DVec3> {
    // Written so that what is not a number is too far as well.
    if eye.abs().max_element() <= FARTHEST * space.radius().max(1.0) {
        return Some(eye);
    }
    found.push(errors::too_far_away(at, FARTHEST));
    None
}
