//! Uniform points in the solid angle of a triangle [Arvo95], without arc cosines, which know few
//! digits of small and of thin ones.

use glam::DVec3;

/// A triangle as a site sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct SolidTriangle {
    /// Towards its corners; unit length.
    corners: [DVec3; 3],
    /// In the plane of the first and the third corner, square to the first; unit length.
    across: DVec3,
    /// The determinant of the first two corners and `across`.
    height: f64,
    /// In sr.
    pub solid_angle: f64,
}

impl SolidTriangle {
    /// From directions to its corners, of unit length, and the determinant of the three.
    pub fn new(corners: [DVec3; 3], determinant: f64) -> Self {
        let [a, b, c] = corners;
        // [VanOosterom83]
        let below = 1.0 + a.dot(b) + b.dot(c) + c.dot(a);
        let solid_angle = 2.0 * determinant.abs().atan2(below);
        let chord = c - a;
        let across = chord - chord.dot(a) * a;
        let sine = across.length();
        let height = determinant.abs() / sine;
        Self { corners, across: across / sine, height, solid_angle }
    }

    /// A direction of it, uniform in solid angle.
    pub fn sample(&self, [u, v]: [f64; 2]) -> DVec3 {
        let [a, b, _] = self.corners;
        // The point d of the edge from a to c for which a, b, d have the part u of the solid angle.
        // Of the angle φ from a to d: tan(φ/2) = (1 + a·b) T / (height - (b·across) T), where T is
        // the tangent of half that solid angle.
        let (sin, cos) = (0.5 * u * self.solid_angle).sin_cos();
        let along = self.height * cos - b.dot(self.across) * sin;
        let half = along * a + (1.0 + a.dot(b)) * sin * self.across;
        let half = half.normalize_or(a);
        let d = 2.0 * a.dot(half) * half - a;
        // On the arc from b to d, uniform in the cosine from b; by what it lacks of 1.
        let chord = d - b;
        let lack = 0.5 * v * chord.length_squared();
        let aside = (chord - chord.dot(b) * b).normalize_or_zero();
        (1.0 - lack) * b + (lack * (2.0 - lack)).max(0.0).sqrt() * aside
    }
}
