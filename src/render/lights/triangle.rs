//! Lamps that are triangles: uniform points in the solid angle of one [Arvo95], without arc
//! cosines, which know few digits of small and of thin ones.

use glam::{DVec2, DVec3, Vec2};

use super::flat::{Flat, LEAST, Sampled, is_wide};
use super::{Geometry, Site};
use crate::math::{random, warp};
use crate::render::geometry::{Facet, Form, Primitive};

/// A triangle as a site sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct SolidTriangle {
    /// Towards its corners; unit length.
    corners: [DVec3; 3],
    /// The determinant of the three, without its sign.
    determinant: f64,
    /// In sr.
    pub solid_angle: f64,
}

impl SolidTriangle {
    /// From directions to its corners, of unit length, and the determinant of the three.
    pub fn new(corners: [DVec3; 3], determinant: f64) -> Self {
        let [a, b, c] = corners;
        let determinant = determinant.abs();
        // [VanOosterom83]
        let below = 1.0 + a.dot(b) + b.dot(c) + c.dot(a);
        Self { corners, determinant, solid_angle: 2.0 * determinant.atan2(below) }
    }

    /// A direction of it, uniform in solid angle.
    pub fn sample(&self, [u, v]: [f64; 2]) -> DVec3 {
        let [a, b, c] = self.corners;
        // In the plane of the first and the third corner, square to the first.
        let chord = c - a;
        let across = chord - chord.dot(a) * a;
        let sine = across.length();
        let (across, height) = (across / sine, self.determinant / sine);
        // The point d of the edge from a to c for which a, b, d have the part u of the solid angle.
        // Of the angle φ from a to d: tan(φ/2) = (1 + a·b) T / (height - (b·across) T), where T is
        // the tangent of half that solid angle.
        let (sin, cos) = (0.5 * u * self.solid_angle).sin_cos();
        let along = height * cos - b.dot(across) * sin;
        let half = along * a + (1.0 + a.dot(b)) * sin * across;
        let half = half.normalize_or(a);
        let d = 2.0 * a.dot(half) * half - a;
        // On the arc from b to d, uniform in the cosine from b; by what it lacks of 1.
        let chord = d - b;
        let lack = 0.5 * v * chord.length_squared();
        let aside = (chord - chord.dot(b) * b).normalize_or_zero();
        (1.0 - lack) * b + (lack * (2.0 - lack)).max(0.0).sqrt() * aside
    }
}

/// A triangle that shines. There may be many of them: what follows from its corners is not kept.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle {
    pub primitive: Primitive,
    corners: [DVec3; 3],
}

impl Triangle {
    /// None of one without area, or of what is no triangle.
    pub fn of(primitive: Primitive, geometry: &Geometry) -> Option<Self> {
        let Form::Triangle(corners) = geometry.form(primitive) else { return None };
        let found = Self { primitive, corners };
        found.cross().try_normalize().map(|_| found)
    }

    /// Twice its area along its normal.
    fn cross(&self) -> DVec3 {
        let [a, b, c] = self.corners;
        (b - a).cross(c - a)
    }

    fn flat(&self, cross: DVec3) -> Flat {
        let length = cross.length();
        Flat { at: self.corners[0], normal: cross / length, area: 0.5 * length }
    }

    /// None in the middle: it is to be sampled by area. None at all: it is not seen.
    fn solid(&self, cross: DVec3, site: &Site, both: bool) -> Option<Option<SolidTriangle>> {
        self.flat(cross).height(site, both)?;
        let from = site.point.position.as_dvec3();
        let [a, b, c] = self.corners;
        let edges = [b - a, c - b, a - c].map(DVec3::length_squared);
        let longest = edges.into_iter().fold(0.0, f64::max);
        if !is_wide(longest, ((a + b + c) / 3.0 - from).length_squared()) {
            return Some(None);
        }
        let ways = self.corners.map(|corner| corner - from);
        let lengths = ways.map(DVec3::length);
        let towards = [0, 1, 2].map(|i| ways[i] / lengths[i]);
        // Its differences are of corners, and exact: no digits are lost.
        let determinant = ways[0].dot(cross) / (lengths[0] * lengths[1] * lengths[2]);
        let solid = SolidTriangle::new(towards, determinant);
        Some((solid.solid_angle > LEAST).then_some(solid))
    }

    /// A point of it that the site sees. Its front alone is seen, if not `both`.
    #[inline(never)]
    pub fn sample(&self, (site, both): (&Site, bool), u: [f64; 2]) -> Option<Sampled> {
        let from = site.point.position.as_dvec3();
        let (cross, facet, [a, b, c]) =
            (self.cross(), Facet::of(self.primitive, self.corners), self.corners);
        let on = |weights: DVec2| facet.point(a + weights.x * (b - a) + weights.y * (c - a));
        let Some(solid) = self.solid(cross, site, both)? else {
            let weights = warp::square_to_triangle(Vec2::from_array(u.map(random::unit_f32)));
            return self.flat(cross).sampled(site, on(weights.as_dvec2()));
        };
        let wi = solid.sample(u);
        let p = cross.dot(a - from) / cross.dot(wi) * wi - (a - from);
        // Weights of the second and third corner at that point of its plane.
        let weights = DVec2::new(p.cross(c - a).dot(cross), (b - a).cross(p).dot(cross));
        let point = on(within(weights / cross.length_squared()));
        let pdf_w = 1.0 / solid.solid_angle;
        point.position.is_finite().then_some(Sampled { point, wi, pdf_w })
    }

    /// Density with which `sample` gives the direction of a point of it.
    pub fn pdf_w(&self, (site, both): (&Site, bool), way: DVec3) -> f64 {
        let cross = self.cross();
        match self.solid(cross, site, both) {
            None => 0.0,
            Some(None) => self.flat(cross).density(way),
            Some(Some(solid)) => 1.0 / solid.solid_angle,
        }
    }
}

/// The nearest weights of a point that rounding has put beyond an edge.
fn within(weights: DVec2) -> DVec2 {
    let weights = weights.max(DVec2::ZERO);
    weights / weights.element_sum().max(1.0)
}
