//! Flat round disks.

use std::f64::consts::PI;

use glam::{DVec3, Vec2};

use super::Bounds;
use super::plane;
use super::ray::{Point, Probe, Sheet, Surface};
use super::rounding;
use super::shapes::Disk;

/// The parameter t > 0 at which the ray meets the disk, rim included.
pub(super) fn meet(probe: &Probe, disk: &Disk) -> Option<f32> {
    let (centre, normal) = (disk.centre.as_dvec3(), disk.normal.as_dvec3());
    let t = plane::root(probe, centre, normal)?;
    let p = plane::project(probe.origin() + t * probe.direction(), centre, normal);
    let radius = f64::from(disk.radius);
    ((p - centre).length_squared() <= radius * radius).then_some(t as f32)
}

/// A point of the disk's plane.
pub(super) fn point(disk: &Disk, exact: DVec3) -> Point {
    let centre = disk.centre.as_dvec3();
    let magnitude = centre.abs() + f64::from(disk.radius);
    let (position, error) = rounding::position(exact, magnitude);
    let ng = disk.normal.as_dvec3().normalize_or(DVec3::Z).as_vec3();
    Point { position, error, ng, sheet: Sheet::NONE }
}

/// The place where the ray meets it.
pub(super) fn surface(probe: &Probe, disk: &Disk) -> Surface {
    let (centre, normal) = (disk.centre.as_dvec3(), disk.normal.as_dvec3());
    let t = plane::root(probe, centre, normal).unwrap_or(0.0);
    let point = point(disk, plane::project(probe.origin() + t * probe.direction(), centre, normal));
    Surface { point, ns: point.ng, uv: Vec2::ZERO }
}

/// The box around it: along each axis it reaches as far as the axis lies in its plane.
pub(super) fn bounds(disk: &Disk) -> Bounds {
    let (centre, n) = (disk.centre.as_dvec3(), disk.normal.as_dvec3().normalize_or(DVec3::Z));
    let s = n * n;
    let reach = DVec3::new(s.y + s.z, s.z + s.x, s.x + s.y).map(f64::sqrt);
    let reach = f64::from(disk.radius) * reach;
    Bounds { min: rounding::down(centre - reach), max: rounding::up(centre + reach) }
}

/// In square world units.
pub(super) fn area(disk: &Disk) -> f64 {
    PI * f64::from(disk.radius).powi(2)
}
