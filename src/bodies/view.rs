//! Where the camera stands, and how far the scene reaches.

use glam::DVec3;

use super::crossing::nearest;
use super::placed::{Body, Placed};
use crate::diag::Span;
use crate::math::Bounds;
use crate::scene::{Camera, Scene};

/// Part of half the size of a scene that rounding takes: five steps of single precision below 1.
const TOGETHER: f64 = 5.0 / (1 << 24) as f64;

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

/// Surfaces nearer to each other, in metres, lie on each other: rays are of single precision, in
/// which the objects fill about [-1, 1], and end in rounding before they tell them apart.
pub fn together(camera: &Camera, placed: &[Placed]) -> f64 {
    let all = extent(camera, placed);
    if all.is_empty() { 0.0 } else { TOGETHER * all.half().max_element() }
}

/// Whether a point lies on the surface of an object, to within so many metres.
pub fn is_on(object: &Placed, p: DVec3, within: f64) -> bool {
    let on = |corners: [DVec3; 3]| nearest(p, corners).distance(p) <= within;
    match &object.body {
        Body::Mesh { mesh, to_metres } => {
            let Bounds { min, max } = object.bounds();
            let corners = |of: &[u32; 3]| of.map(|i| to_metres.point(mesh.positions[i as usize]));
            let around = Bounds { min: min - within, max: max + within };
            around.holds(p) && mesh.triangles.iter().any(|of| on(corners(of)))
        }
        Body::Face { corners, .. } => {
            (1..corners.len() - 1).any(|i| on([corners[0], corners[i], corners[i + 1]]))
        }
        Body::Sphere { centre, radius, .. } => (p.distance(*centre) - radius).abs() <= within,
        Body::Disk { centre, normal, radius, .. } => {
            normal.dot(p - centre).abs() <= within && p.distance(*centre) <= *radius
        }
        Body::Plane { point, normal, .. } => normal.dot(p - point).abs() <= within,
    }
}
