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

/// A surface whose directions differ by less than this chord, squared, is sampled by area: its
/// distance and its cosine vary by a hundredth.
const NARROW: f64 = 1e-4;

/// Of less than this solid angle, in sr, what is sampled knows too few digits.
pub(super) const LEAST: f64 = 1e-8;

impl Flat {
    /// The height of a site over the plane. None: it is in it, to within rounding, or behind it and
    /// that is dark.
    pub fn height(&self, site: &Site, both: bool) -> Option<f64> {
        let height = (site.point.position.as_dvec3() - self.at).dot(self.normal);
        let error = self.normal.abs().dot(site.point.error.as_dvec3());
        let seen = if both { height.abs() } else { height };
        (seen > error).then_some(height)
    }

    /// Density in solid angle of what is uniform by area, a way off.
    pub fn density(&self, way: DVec3) -> f64 {
        let distance_2 = way.length_squared();
        let along = way.dot(self.normal).abs();
        if along > 0.0 { distance_2 * distance_2.sqrt() / (self.area * along) } else { 0.0 }
    }

    /// One of its points, that was chosen by area.
    pub fn sampled(&self, site: &Site, point: Point) -> Option<Sampled> {
        let way = point.position.as_dvec3() - site.point.position.as_dvec3();
        let (wi, pdf_w) = (way.try_normalize()?, self.density(way));
        (pdf_w > 0.0).then_some(Sampled { point, wi, pdf_w })
    }
}

/// Whether a surface of this size, squared, is so near that its directions differ.
pub(super) fn is_wide(size_2: f64, distance_2: f64) -> bool {
    size_2 > NARROW * distance_2
}
