//! Spheres, from outside and inside, near and far.

use std::f64::consts::PI;

use glam::{DVec3, Vec2};

use super::Bounds;
use super::ray::{Point, Probe, Sheet, Surface};
use super::rounding;
use super::shapes::Sphere;

/// The least root t > 0 of |o + t·d − centre| = radius, without cancellation [Haines19].
fn root(probe: &Probe, sphere: &Sphere) -> Option<f64> {
    let d = probe.direction();
    let radius = f64::from(sphere.radius);
    let f = probe.origin() - sphere.centre.as_dvec3();
    let a = d.length_squared();
    let b = -f.dot(d);
    let c = f.length_squared() - radius * radius;
    // Outside, and not going nearer.
    if c > 0.0 && b <= 0.0 {
        return None;
    }
    // By the distance of the line from the centre, not by b² − a·c, which cancels for far spheres.
    let distance = f + (b / a) * d;
    let discriminant = radius * radius - distance.length_squared();
    if discriminant < 0.0 {
        return None;
    }
    let q = b + (a * discriminant).sqrt().copysign(b);
    let (first, second) = (c / q, q / a);
    let (near, far) = (first.min(second), first.max(second));
    [near, far].into_iter().find(|t| *t > 0.0 && t.is_finite())
}

/// The parameter t > 0 at which the ray meets the sphere.
pub(super) fn meet(probe: &Probe, sphere: &Sphere) -> Option<f32> {
    root(probe, sphere).map(|t| t as f32)
}

/// The point of the sphere in a direction from its centre (unit).
pub(super) fn point(sphere: &Sphere, normal: DVec3) -> Point {
    let centre = sphere.centre.as_dvec3();
    let radius = f64::from(sphere.radius);
    let exact = centre + radius * normal;
    let (position, error) = rounding::position(exact, centre.abs() + radius);
    Point { position, error, ng: normal.as_vec3(), sheet: Sheet::NONE }
}

/// The place where the ray meets it.
pub(super) fn surface(probe: &Probe, sphere: &Sphere) -> Surface {
    let t = root(probe, sphere).unwrap_or(0.0);
    let local = probe.origin() + t * probe.direction() - sphere.centre.as_dvec3();
    let normal = local.normalize_or(DVec3::Z);
    let point = point(sphere, normal);
    Surface { point, ns: point.ng, uv: Vec2::ZERO }
}

/// The box around it.
pub(super) fn bounds(sphere: &Sphere) -> Bounds {
    let (centre, radius) = (sphere.centre.as_dvec3(), f64::from(sphere.radius));
    Bounds { min: rounding::down(centre - radius), max: rounding::up(centre + radius) }
}

/// In square world units.
pub(super) fn area(sphere: &Sphere) -> f64 {
    4.0 * PI * f64::from(sphere.radius).powi(2)
}
