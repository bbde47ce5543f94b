//! Planes without end. They have no box and stand beside the tree.

use glam::{DVec3, Vec2};

use super::ray::{Point, Probe, Sheet, Surface};
use super::rounding;
use super::shapes::Plane;

/// A plane's far end: squares of distances beyond 2⁶⁰ would soon be more than f32 holds.
const REACH: f64 = (1_u64 << 60) as f64;

/// The parameter t > 0 at which the ray meets the plane through `point` square to `normal`.
pub(super) fn root(probe: &Probe, point: DVec3, normal: DVec3) -> Option<f64> {
    let t = normal.dot(point - probe.origin()) / normal.dot(probe.direction());
    (t > 0.0 && t < REACH).then_some(t)
}

/// The point of that plane next to `p`.
pub(super) fn project(p: DVec3, point: DVec3, normal: DVec3) -> DVec3 {
    p - normal * (normal.dot(p - point) / normal.length_squared())
}

/// The parameter t > 0 at which the ray meets the plane.
pub(super) fn meet(probe: &Probe, plane: &Plane) -> Option<f32> {
    root(probe, plane.point.as_dvec3(), plane.normal.as_dvec3()).map(|t| t as f32)
}

/// The place where the ray meets it.
pub(super) fn surface(probe: &Probe, plane: &Plane) -> Surface {
    let (point, normal) = (plane.point.as_dvec3(), plane.normal.as_dvec3());
    let t = root(probe, point, normal).unwrap_or(0.0);
    let far = probe.origin() + t * probe.direction();
    let exact = project(far, point, normal);
    let magnitude = point.abs() + far.abs() + exact.abs();
    let (position, error) = rounding::position(exact, magnitude);
    let ng = normal.normalize_or(DVec3::Z).as_vec3();
    Surface { point: Point { position, error, ng, sheet: Sheet::NONE }, ns: ng, uv: Vec2::ZERO }
}
