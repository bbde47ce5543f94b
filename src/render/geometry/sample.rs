//! Points on shapes, uniform by area, for lamps.

use glam::{DVec3, Vec2};

use super::shapes::Kind;
use super::{Geometry, Point, Primitive};
use super::{disk, rounding, sphere, triangle};
use crate::math::warp;

impl Geometry {
    /// Area of a primitive in square world units; +∞ for a plane.
    pub fn area(&self, primitive: Primitive) -> f64 {
        let index = primitive.index();
        match primitive.kind() {
            Kind::Triangle => triangle::area(self.shapes.exact_corners(index)),
            Kind::Sphere => sphere::area(&self.shapes.spheres[index]),
            Kind::Disk => disk::area(&self.shapes.disks[index]),
            Kind::Plane => f64::INFINITY,
        }
    }

    /// A point of a primitive from `u` in [0, 1)², uniform by area: its density is 1 over
    /// [`Geometry::area`]. None for a plane, which has no uniform density.
    pub fn sample(&self, primitive: Primitive, u: Vec2) -> Option<Point> {
        let index = primitive.index();
        match primitive.kind() {
            Kind::Triangle => {
                let corners = self.shapes.exact_corners(index);
                let [a, b, c] = corners;
                let weights = warp::square_to_triangle(u).as_dvec2();
                let exact = a + weights.x * (b - a) + weights.y * (c - a);
                let magnitude = a.abs() + b.abs() + c.abs();
                let (position, error) = rounding::position(exact, magnitude);
                let ng = triangle::normal(corners).normalize_or(DVec3::Z).as_vec3();
                Some(Point { position, error, ng })
            }
            Kind::Sphere => {
                let normal = warp::square_to_sphere(u).as_dvec3().normalize_or(DVec3::Z);
                Some(sphere::point(&self.shapes.spheres[index], normal))
            }
            Kind::Disk => {
                let disk = &self.shapes.disks[index];
                let (x, y) = disk.normal.as_dvec3().normalize_or(DVec3::Z).any_orthonormal_pair();
                let on = f64::from(disk.radius) * warp::square_to_disk(u).as_dvec2();
                Some(disk::point(disk, disk.centre.as_dvec3() + on.x * x + on.y * y))
            }
            Kind::Plane => None,
        }
    }
}
