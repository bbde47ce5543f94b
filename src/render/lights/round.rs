//! Lamps that are round: disks and spheres.

use std::f64::consts::{PI, TAU};

use glam::{DVec3, Vec2, Vec3};

use super::flat::{Flat, LEAST, Sampled};
use super::rectangle::SolidRectangle;
use super::{Geometry, Site};
use crate::math::{random, warp};
use crate::render::geometry::{Form, Primitive};

/// A disk that shines.
#[derive(Clone, Copy, Debug)]
pub(super) struct Disk {
    /// Its point is the centre.
    flat: Flat,
    pub primitive: Primitive,
    pub radius: f64,
    /// In its plane, unit length, square to each other.
    axes: [DVec3; 2],
}

impl Disk {
    /// None of what is no disk.
    pub fn of(primitive: Primitive, geometry: &Geometry) -> Option<Self> {
        let Form::Disk { centre, normal, radius } = geometry.form(primitive) else { return None };
        let flat = Flat { at: centre, normal, area: PI * radius * radius };
        Some(Self { flat, primitive, radius, axes: normal.any_orthonormal_pair().into() })
    }

    /// The rectangle around it; points beyond the rim bring nothing. None in the middle: it is to
    /// be sampled by area. None at all: it is not seen.
    fn solid(&self, site: &Site, both: bool) -> Option<Option<SolidRectangle>> {
        let height = self.flat.height(site, both)?;
        let way = self.flat.at - site.point.position.as_dvec3();
        // Further away than its radius, light by area has less noise than misses of the square make.
        let beyond_rim = (way + height * self.flat.normal).length() - self.radius;
        if height.hypot(beyond_rim.max(0.0)) >= self.radius {
            return Some(None);
        }
        let [x, y] = self.axes.map(|axis| way.dot(axis));
        let r = self.radius;
        let solid = SolidRectangle::new([x - r, x + r], [y - r, y + r], height);
        Some((solid.solid_angle > LEAST).then_some(solid))
    }

    /// A point of it that the site sees. Its front alone is seen, if not `both`.
    #[inline(never)]
    pub fn sample(
        &self,
        geometry: &Geometry,
        (site, both): (&Site, bool),
        u: [f64; 2],
    ) -> Option<Sampled> {
        let Some(solid) = self.solid(site, both)? else {
            let u = Vec2::from_array(u.map(random::unit_f32));
            return self.flat.sampled(site, geometry.sample(self.primitive, u)?);
        };
        let way = solid.way(solid.sample(u), self.axes, self.flat.normal);
        let exact = site.point.position.as_dvec3() + way;
        if (exact - self.flat.at).length_squared() > self.radius * self.radius {
            return None;
        }
        let point = geometry.point(self.primitive, exact);
        Some(Sampled { point, wi: way.try_normalize()?, pdf_w: 1.0 / solid.solid_angle })
    }

    /// Density with which `sample` gives the direction of a point of it.
    pub fn pdf_w(&self, (site, both): (&Site, bool), way: DVec3) -> f64 {
        match self.solid(site, both) {
            None => 0.0,
            Some(None) => self.flat.density(way),
            Some(Some(solid)) => 1.0 / solid.solid_angle,
        }
    }
}

/// A sphere that shines.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sphere {
    pub primitive: Primitive,
    centre: DVec3,
    radius: f64,
}

/// How points of a sphere are found for a site.
enum Way {
    /// From outside: the direction of its centre, the squared sine of the angle it fills, and one
    /// minus its cosine.
    Cone { towards: DVec3, sin_2: f64, lack: f64 },
    /// From inside: as of what surrounds the scene.
    Inside,
}

impl Sphere {
    /// None of what is no sphere.
    pub fn of(primitive: Primitive, geometry: &Geometry) -> Option<Self> {
        let Form::Sphere { centre, radius } = geometry.form(primitive) else { return None };
        Some(Self { primitive, centre, radius })
    }

    /// None: no point of it can be seen.
    fn way(&self, site: &Site, both: bool) -> Option<Way> {
        let (centre, radius) = (self.centre, self.radius);
        let way = centre - site.point.position.as_dvec3();
        let distance = way.length();
        // On the sphere itself, the side that asks tells.
        let on = (distance - radius).abs() <= site.point.error.as_dvec3().length();
        let inside = match site.normal {
            normal if on && normal != Vec3::ZERO => way.dot(normal.as_dvec3()) > 0.0,
            _ => distance < radius,
        };
        if inside {
            return both.then_some(Way::Inside);
        }
        if on {
            return None;
        }
        let sin_2 = (radius / distance).powi(2);
        let cos_2 = (distance - radius) * (distance + radius) / (distance * distance);
        // 1 - cos, for small angles too.
        let lack = sin_2 / (1.0 + cos_2.sqrt());
        Some(Way::Cone { towards: way / distance, sin_2, lack })
    }

    /// A point of it that the site sees. From inside nothing is seen, if not `both`.
    #[inline(never)]
    pub fn sample(
        &self,
        geometry: &Geometry,
        (site, both): (&Site, bool),
        u: [f64; 2],
    ) -> Option<Sampled> {
        let (centre, radius) = (self.centre, self.radius);
        match self.way(site, both)? {
            Way::Cone { towards, sin_2, lack } => {
                let off = u[0] * lack;
                let sine_2 = off * (2.0 - off);
                let part = (sine_2 / sin_2).min(1.0);
                let (x, y) = towards.any_orthonormal_pair();
                let (sin, cos) = (TAU * u[1]).sin_cos();
                let aside = cos * x + sin * y;
                let wi = (1.0 - off) * towards + sine_2.sqrt() * aside;
                // At the centre, the angle between the site and the point.
                let cosine = sine_2 / sin_2.sqrt() + (1.0 - off) * (1.0 - part).sqrt();
                let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
                let exact = centre + radius * (sine * aside - cosine * towards);
                let point = geometry.point(self.primitive, exact);
                Some(Sampled { point, wi, pdf_w: 1.0 / (TAU * lack) })
            }
            Way::Inside => {
                let u = Vec2::from_array(u.map(random::unit_f32));
                let wi = match site.normal {
                    Vec3::ZERO => warp::square_to_sphere(u),
                    normal => warp::about(normal, warp::square_to_cosine(u)),
                };
                let wi = wi.as_dvec3().normalize_or(DVec3::Z);
                let pdf_w = around(site, wi);
                let from = site.point.position.as_dvec3();
                let to_centre = centre - from;
                let along = to_centre.dot(wi);
                let depth = radius * radius - (to_centre - along * wi).length_squared();
                let exact = from + (along + depth.max(0.0).sqrt()) * wi;
                let point = geometry.point(self.primitive, exact);
                (pdf_w > 0.0).then_some(Sampled { point, wi, pdf_w })
            }
        }
    }

    /// Density with which `sample` gives the direction of a point of it.
    pub fn pdf_w(&self, (site, both): (&Site, bool), way: DVec3) -> f64 {
        match self.way(site, both) {
            None => 0.0,
            Some(Way::Cone { lack, .. }) => 1.0 / (TAU * lack),
            Some(Way::Inside) => around(site, way.normalize_or_zero()),
        }
    }
}

/// The density of a direction of what surrounds a site: for a surface by the cosine, else uniform.
fn around(site: &Site, wi: DVec3) -> f64 {
    match site.normal {
        Vec3::ZERO => 0.25 / PI,
        normal => normal.as_dvec3().dot(wi).max(0.0) / PI,
    }
}
