//! One surface of a lamp, as a site sees it: points of it, and the density of their directions.
//!
//! Near surfaces are sampled by solid angle: their light has no more noise than the cosine at the
//! site gives it. Far ones are sampled by area: they fill so little that this is the same, costs
//! less, and needs no differences of nearly equal directions. What decides is the surface and the
//! site alone, so that the density of a direction that was found otherwise is known.

use std::f64::consts::PI;

use glam::DVec3;

use super::flat::Sampled;
use super::rectangle::Rectangle;
use super::round::{Disk, Sphere};
use super::triangle::Triangle;
use super::{Emitter, Geometry, Site};
use crate::render::geometry::{Form, Primitive};

/// A surface, with all that does not depend on the site.
#[derive(Clone, Debug)]
pub(super) enum Patch {
    Disk(Disk),
    Rectangle(Box<Rectangle>),
    Sphere(Sphere),
    Triangle(Triangle),
    /// Without area, or without end: never sampled.
    None(Primitive),
}

impl Patch {
    /// Surfaces of a lamp, with triangles joined to rectangles where two in a row are one.
    pub fn of(surfaces: &[Primitive], geometry: &Geometry) -> Vec<Self> {
        let mut all = Vec::new();
        let mut rest = surfaces;
        while let Some((first, after)) = rest.split_first() {
            let pair = after.first().map(|second| [*first, *second]);
            match pair.and_then(|pair| Rectangle::of(pair, geometry)) {
                Some(rectangle) => {
                    all.push(Self::Rectangle(Box::new(rectangle)));
                    rest = &after[1..];
                }
                None => {
                    all.push(Self::one(*first, geometry));
                    rest = after;
                }
            }
        }
        all
    }

    fn one(primitive: Primitive, geometry: &Geometry) -> Self {
        let found = match geometry.form(primitive) {
            Form::Disk { .. } => Disk::of(primitive, geometry).map(Self::Disk),
            Form::Sphere { .. } => Sphere::of(primitive, geometry).map(Self::Sphere),
            Form::Triangle(_) => Triangle::of(primitive, geometry).map(Self::Triangle),
            Form::Plane => None,
        };
        found.unwrap_or(Self::None(primitive))
    }

    /// The primitives it is made of.
    pub fn primitives(&self) -> impl Iterator<Item = Primitive> {
        let (first, second) = match self {
            Self::Disk(disk) => (disk.primitive, None),
            Self::Rectangle(rectangle) => {
                let [a, b] = rectangle.triangles();
                (a, Some(b))
            }
            Self::Sphere(sphere) => (sphere.primitive, None),
            Self::Triangle(triangle) => (triangle.primitive, None),
            Self::None(one) => (*one, None),
        };
        std::iter::once(first).chain(second)
    }

    /// What bounds it, of a radiance of 1.
    pub fn emitter(&self, geometry: &Geometry, both: bool) -> Emitter {
        let of = |primitive| match geometry.form(primitive) {
            Form::Triangle([a, b, c]) => {
                let normal = (b - a).cross(c - a);
                let corners = [a.min(b).min(c), a.max(b).max(c)];
                Emitter::flat(corners, normal, both, 0.5 * normal.length())
            }
            Form::Disk { centre, normal, radius } => {
                let reach = radius * (DVec3::ONE - normal * normal).max(DVec3::ZERO).map(f64::sqrt);
                let corners = [centre - reach, centre + reach];
                Emitter::flat(corners, normal, both, PI * radius * radius)
            }
            Form::Sphere { centre, radius } => {
                let corners = [centre - radius, centre + radius];
                Emitter::everywhere(corners, PI * radius * radius)
            }
            Form::Plane => Emitter::everywhere([DVec3::ZERO; 2], 0.0),
        };
        let all = self.primitives().map(of);
        all.reduce(|a, b| a.and(&b)).unwrap_or(Emitter::everywhere([DVec3::ZERO; 2], 0.0))
    }

    /// A point of it that the site sees. Its front alone is seen, if not `both`.
    #[inline(always)]
    pub fn sample(
        &self,
        geometry: &Geometry,
        (site, both): (&Site, bool),
        u: [f64; 2],
    ) -> Option<Sampled> {
        match self {
            Self::Disk(disk) => disk.sample(geometry, (site, both), u),
            Self::Rectangle(rectangle) => rectangle.sample((site, both), u),
            Self::Sphere(sphere) => sphere.sample(geometry, (site, both), u),
            Self::Triangle(triangle) => triangle.sample((site, both), u),
            Self::None(_) => None,
        }
    }

    /// Density with which `sample` gives the direction of a point of it.
    pub fn pdf_w(&self, (site, both): (&Site, bool), point: DVec3) -> f64 {
        let way = point - site.point.position.as_dvec3();
        match self {
            Self::Disk(disk) => disk.pdf_w((site, both), way),
            Self::Rectangle(rectangle) => rectangle.pdf_w((site, both), way),
            Self::Sphere(sphere) => sphere.pdf_w((site, both), way),
            Self::Triangle(triangle) => triangle.pdf_w((site, both), way),
            Self::None(_) => 0.0,
        }
    }
}
