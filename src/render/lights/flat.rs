//! What flat surfaces of lamps have in common: a plane, and points by area.

use glam::DVec3;

use super::{Point, Site};

/// A flat surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flat {
    /// A point of its plane.
    pub at: DVec3,
    /// On its front, unit length.
    pub normal: DVec3,
    /// In square world units.
    pub area: f64,
}

/// A point of a surface that a site sees.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sampled {
    pub point: Point,
    /// Towards it, unit length.
    pub wi: DVec3,
    /// Density of that direction.
    pub pdf_w: f64,
}

/// A surface of which the size is less than about a third of its distance is sampled by area: the
/// squares of the two, one over the other. Its distance and its cosine vary so little that this
/// adds no noise to be seen, and takes a fifth of the time.
const NARROW: f64 = 0.1;

/// Of less than this solid angle, in sr, what is sampled knows too few digits.
pub(super) const LEAST: f64 = 1e-8;

impl Flat {
    /// The height of a site over the plane. None: it is in it, to within rounding, or behind it and
    /// that is dark.
    #[inline(always)]
    pub fn height(&self, site: &Site, both: bool) -> Option<f64> {
        let (height, is_over) = self.over(&site.point, both);
        is_over.then_some(height)
    }

    /// The height of a point over the plane, and whether that is [one](Self::height).
    #[inline(always)]
    pub fn over(&self, from: &Point, both: bool) -> (f64, bool) {
        let height = (from.position.as_dvec3() - self.at).dot(self.normal);
        let error = self.normal.abs().dot(from.error.as_dvec3());
        let seen = if both { height.abs() } else { height };
        (height, seen > error)
    }

    /// Density in solid angle of what is uniform by area, a way off.
    #[inline(always)]
    pub fn density(&self, way: DVec3) -> f64 {
        let distance_2 = way.length_squared();
        let along = way.dot(self.normal).abs();
        let density = distance_2 * distance_2.sqrt() / (self.area * along);
        if along > 0.0 { density } else { 0.0 }
    }

    /// One of its points, that was chosen by area.
    #[inline(never)]
    pub fn sampled(&self, site: &Site, point: Point) -> Option<Sampled> {
        let way = point.position.as_dvec3() - site.point.position.as_dvec3();
        let (wi, pdf_w) = (way.try_normalize()?, self.density(way));
        (pdf_w > 0.0).then_some(Sampled { point, wi, pdf_w })
    }
}

/// Whether a surface of this size, squared, is so near that its directions differ.
#[inline]
pub(super) fn is_wide(size_2: f64, distance_2: f64) -> bool {
    size_2 > NARROW * distance_2
}
