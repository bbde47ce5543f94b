//! Spheres, from outside and inside, near and far.

use std::f64::consts::PI;

use glam::{DVec3, Vec2, Vec3};

use super::Bounds;
use super::ray::{Point, Probe, Sheet, Surface};
use super::rounding;
use super::shapes::Sphere;

/// Centre and radius.
type Round = (Vec3, f32);

#[inline(always)]
pub(super) fn round(sphere: &Sphere) -> Round {
    (sphere.centre, sphere.radius)
}

/// The least root t > 0 of |o + t·d − centre| = radius, without cancellation [Haines19]; -1 if there is
/// none. Without jumps, so that a loop over it becomes vectors.
#[inline(always)]
pub(super) fn root(origin: DVec3, d: DVec3, (centre, radius): Round) -> f64 {
    let radius = f64::from(radius);
    let f = origin - centre.as_dvec3();
    let a = d.length_squared();
    let b = -f.dot(d);
    let c = f.length_squared() - radius * radius;
    // Outside, and not going nearer.
    let away = (c > 0.0) & (b <= 0.0);
    // By the distance of the line from the centre, not by b² − a·c, which cancels for far spheres.
    let distance = f + (b / a) * d;
    let discriminant = radius * radius - distance.length_squared();
    // No number where that is negative, and so is what follows.
    let q = b + (a * discriminant).sqrt().copysign(b);
    let (first, second) = (c / q, q / a);
    let near = if first < second { first } else { second };
    let far = if first > second { first } else { second };
    let is_near = (near > 0.0) & (near < f64::INFINITY);
    let t = if is_near { near } else { far };
    if (t > 0.0) & (t < f64::INFINITY) & !away { t } else { -1.0 }
}

/// The parameter t > 0 at which the ray meets the sphere.
pub(super) fn meet(probe: &Probe, sphere: &Sphere) -> Option<f32> {
    let t = root(probe.origin(), probe.direction(), round(sphere));
    (t > 0.0).then_some(t as f32)
}

/// The normal where a ray meets it.
#[inline(always)]
pub(super) fn normal(origin: DVec3, direction: DVec3, (centre, radius): Round) -> DVec3 {
    let t = root(origin, direction, (centre, radius));
    let t = if t > 0.0 { t } else { 0.0 };
    let local = origin + t * direction - centre.as_dvec3();
    let scale = 1.0 / local.length();
    let some = (scale > 0.0) & (scale < f64::INFINITY);
    DVec3::new(
        if some { local.x * scale } else { 0.0 },
        if some { local.y * scale } else { 0.0 },
        if some { local.z * scale } else { 1.0 },
    )
}

/// The point of it in a direction from its centre (unit), and the bound of its error.
#[inline(always)]
pub(super) fn place((centre, radius): Round, normal: DVec3) -> (Vec3, Vec3) {
    let (centre, radius) = (centre.as_dvec3(), f64::from(radius));
    rounding::position(centre + radius * normal, centre.abs() + radius)
}

/// The point of the sphere in a direction from its centre (unit).
pub(super) fn point(sphere: &Sphere, normal: DVec3) -> Point {
    let (position, error) = place(round(sphere), normal);
    Point { position, error, ng: normal.as_vec3(), sheet: Sheet::NONE }
}

/// The place where the ray meets it.
pub(super) fn surface(probe: &Probe, sphere: &Sphere) -> Surface {
    let normal = normal(probe.origin(), probe.direction(), round(sphere));
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
