//! What geometry promises, tried on shapes made in code. Every run draws the same numbers.

mod agreement;
mod extremes;
mod fleets;
mod instances;
mod leaving;
pub(super) mod meshes;
mod packets;
mod processors;
mod sampling;
mod streams;
mod watertight;

use glam::{DVec3, Vec3};

use super::{Geometry, Primitive, Ray, Sheet};

/// What is no number, by either sign and by its first and its last bits.
const NO_NUMBERS: [f32; 4] =
    [f32::NAN, -f32::NAN, f32::from_bits(0x7FFF_FFFF), f32::from_bits(0xFFFF_FFFF)];

/// The first meeting by asking every shape, without a tree.
fn by_hand(geometry: &Geometry, ray: &Ray) -> Option<(f32, Primitive)> {
    let probe = super::Probe::new(super::lanes::Portable, ray, true).unwrap();
    let shapes = geometry.shapes();
    let meet = |p: Primitive| match p.kind() {
        super::Kind::Triangle => {
            super::triangle::meet(&probe, shapes.exact_corners(p.index()), false)
        }
        super::Kind::Sphere => super::sphere::meet(&probe, &shapes.spheres[p.index()]),
        super::Kind::Disk => super::disk::meet(&probe, &shapes.disks[p.index()]),
        super::Kind::Plane => super::plane::meet(&probe, &shapes.planes[p.index()]),
    };
    let all = shapes.primitives().filter_map(|p| Some((meet(p)?, p)));
    all.filter(|(t, _)| *t < ray.t_max).min_by(|a, b| a.partial_cmp(b).unwrap())
}

/// The same, that knows nothing of surfaces at its ends.
fn unnamed(ray: Ray) -> Ray {
    Ray { leaves: Sheet::NONE, reaches: Sheet::NONE, ..ray }
}

/// A ray from one place towards another, and the distance between them.
fn towards(origin: Vec3, target: DVec3) -> (Ray, f64) {
    let way = target - origin.as_dvec3();
    (Ray::new(origin, way.normalize().as_vec3()), way.length())
}
