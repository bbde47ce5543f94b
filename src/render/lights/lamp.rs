//! Lamps with an area: the surfaces of one object that share one emitting material.

use glam::{DVec3, Vec2, Vec3};

use super::{Arrival, Geometry, Hit, Point, Site, between};
use crate::math::{Rgb, random};
use crate::render::geometry::Primitive;

/// Surfaces that shine with the same radiance everywhere.
#[derive(Clone, Debug)]
pub struct Lamp {
    radiance: Rgb,
    /// Whether the backs shine as well.
    both: bool,
    surfaces: Vec<Primitive>,
    /// Area up to and including each surface, in square world units. Ascending.
    areas: Vec<f64>,
    centre: Centre,
}

/// A lamp as one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Centre {
    /// Centroid of its surfaces by area, and the mean of their normals by area, of unit length:
    /// the direction it faces. Zero for a lamp that faces every way, which shines nothing then.
    pub point: Point,
}

impl Lamp {
    /// A lamp over `surfaces` of positive, finite area. Its radiance in light units, and whether
    /// both sides have it.
    pub fn new(
        (radiance, both): (Rgb, bool),
        surfaces: Vec<Primitive>,
        geometry: &Geometry,
        centre: Centre,
    ) -> Self {
        let mut total = 0.0;
        let grow = |surface: &Primitive| {
            total += geometry.area(*surface);
            total
        };
        let areas = surfaces.iter().map(grow).collect();
        Self { radiance, both, surfaces, areas, centre }
    }

    /// Area of all surfaces, in square world units.
    pub fn area(&self) -> f64 {
        self.areas.last().copied().unwrap_or(0.0)
    }

    /// Light from a point of the lamp, uniform by area.
    pub(super) fn sample(&self, geometry: &Geometry, at: &Point, u: [f64; 2]) -> Option<Arrival> {
        let (surface, within) = self.choose(u[0])?;
        let u = Vec2::new(random::unit_f32(within), random::unit_f32(u[1]));
        let to = geometry.sample(surface, u)?;
        self.arrive(at, &to)
    }

    /// Larsen's simplification: all flux from the centre, L = Lₑ A cos θ / r², θ at the lamp.
    pub(super) fn at_centre(&self, at: &Point) -> Option<Arrival> {
        self.arrive(at, &self.centre.point)
    }

    /// The surface in which the part `u` of the area lies, and where in it, again in [0, 1): one
    /// number serves twice, so that stratified numbers stay stratified over the whole lamp.
    fn choose(&self, u: f64) -> Option<(Primitive, f64)> {
        let area = u * self.area();
        let last = self.areas.len().checked_sub(1)?;
        let index = self.areas.partition_point(|up_to| *up_to <= area).min(last);
        let before = if index == 0 { 0.0 } else { self.areas[index - 1] };
        let within = (area - before) / (self.areas[index] - before);
        Some((self.surfaces[index], within.clamp(0.0, 1.0 - f64::EPSILON)))
    }

    /// The lamp's radiance times the solid angle its area would fill around `to`: Lₑ A cos θ / r².
    fn arrive(&self, at: &Point, to: &Point) -> Option<Arrival> {
        let way = to.position.as_dvec3() - at.position.as_dvec3();
        let distance_2 = way.length_squared();
        let wi = way.try_normalize()?;
        let cos = -wi.dot(to.ng.as_dvec3());
        let cos = if self.both { cos.abs() } else { cos };
        if cos <= 0.0 {
            return None;
        }
        let solid_angle = self.area() * cos / distance_2;
        let irradiance = self.radiance * solid_angle as f32;
        let pdf_w = (1.0 / solid_angle) as f32;
        Some(Arrival { wi: wi.as_vec3(), irradiance, pdf_w, shadow: between(at, to) })
    }

    /// Density with which `sample` gives the direction in which a ray from `site` met the lamp.
    pub(super) fn pdf_w(&self, _geometry: &Geometry, site: &Site, hit: &Hit) -> f32 {
        let way = hit.position.as_dvec3() - site.point.position.as_dvec3();
        let distance_2 = way.length_squared();
        let cos = (way.dot(hit.ng.as_dvec3())).abs() / distance_2.sqrt();
        (distance_2 / (self.area() * cos)) as f32
    }
}

impl Centre {
    /// The centre of a lamp: `centroid` by area; `facing`, the sum of its normals times their
    /// areas; `reach`, the greatest magnitude of its coordinates, which bounds how far rounding
    /// moved its surfaces. All in world units.
    pub fn new(centroid: DVec3, facing: DVec3, reach: DVec3) -> Self {
        let error = (reach.as_vec3() * f32::EPSILON).map(f32::next_up);
        let ng = facing.normalize_or_zero().as_vec3();
        Self { point: Point { position: centroid.as_vec3(), error, ng } }
    }

    /// The direction the lamp faces.
    pub fn facing(&self) -> Vec3 {
        self.point.ng
    }
}
