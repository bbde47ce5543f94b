//! Points on shapes, uniform by area, for lamps.

use glam::{BVec3, DVec3, Vec2, Vec3};

use super::shapes::Kind;
use super::{Geometry, Point, Primitive, Sheet};
use super::{disk, rounding, sphere, triangle};
use crate::math::warp;

/// What a primitive is, in f64, world units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// Its corners, counter-clockwise seen from its front.
    Triangle([DVec3; 3]),
    /// Its front is outside.
    Sphere {
        /// Its centre.
        centre: DVec3,
        /// Its radius.
        radius: f64,
    },
    /// Its front is where its normal points.
    Disk {
        /// Its centre.
        centre: DVec3,
        /// Unit length.
        normal: DVec3,
        /// Its radius.
        radius: f64,
    },
    /// Without end.
    Plane,
}

/// A triangle: what its points have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Sum of the magnitudes that make its points, per coordinate.
    magnitude: DVec3,
    ng: Vec3,
    sheet: Sheet,
}

impl Facet {
    /// A triangle with these corners.
    pub fn of(primitive: Primitive, corners: [DVec3; 3]) -> Self {
        let [a, b, c] = corners;
        let ng = triangle::normal(corners).normalize_or(DVec3::Z).as_vec3();
        let sheet = Sheet::of(primitive);
        Self { magnitude: a.abs() + b.abs() + c.abs(), ng, sheet }
    }

    /// This one, or the other: by a choice of numbers, not of ways.
    #[inline(always)]
    pub fn or(&self, other: &Self, is_other: bool) -> Self {
        Self {
            magnitude: DVec3::select(BVec3::splat(is_other), other.magnitude, self.magnitude),
            ng: Vec3::select(BVec3::splat(is_other), other.ng, self.ng),
            sheet: if is_other { other.sheet } else { self.sheet },
        }
    }

    /// A point of it that was computed in f64 from its form.
    #[inline(always)]
    pub fn point(&self, exact: DVec3) -> Point {
        let (position, error) = rounding::position(exact, self.magnitude);
        Point { position, error, ng: self.ng, sheet: self.sheet }
    }
}

impl Geometry {
    /// What a primitive is.
    pub fn form(&self, primitive: Primitive) -> Form {
        let index = primitive.index();
        match primitive.kind() {
            Kind::Triangle => Form::Triangle(self.shapes.exact_corners(index)),
            Kind::Sphere => {
                let sphere = &self.shapes.spheres[index];
                let radius = f64::from(sphere.radius);
                Form::Sphere { centre: sphere.centre.as_dvec3(), radius }
            }
            Kind::Disk => {
                let disk = &self.shapes.disks[index];
                let normal = disk.normal.as_dvec3().normalize_or(DVec3::Z);
                let (centre, radius) = (disk.centre.as_dvec3(), f64::from(disk.radius));
                Form::Disk { centre, normal, radius }
            }
            Kind::Plane => Form::Plane,
        }
    }

    /// A point of a primitive that was computed in f64 from its form: as surfaces have points.
    pub fn point(&self, primitive: Primitive, exact: DVec3) -> Point {
        let index = primitive.index();
        match primitive.kind() {
            Kind::Triangle => Facet::of(primitive, self.shapes.exact_corners(index)).point(exact),
            Kind::Sphere => {
                let sphere = &self.shapes.spheres[index];
                let normal = (exact - sphere.centre.as_dvec3()).normalize_or(DVec3::Z);
                sphere::point(sphere, normal)
            }
            Kind::Disk => disk::point(&self.shapes.disks[index], exact),
            Kind::Plane => Point::free(exact.as_vec3()),
        }
    }

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
                let [a, b, c] = self.shapes.exact_corners(index);
                let weights = warp::square_to_triangle(u).as_dvec2();
                Some(self.point(primitive, a + weights.x * (b - a) + weights.y * (c - a)))
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
