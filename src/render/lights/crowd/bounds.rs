//! What bounds emitters: a box, a cone about their normals, and their intensity.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec3;

/// One or several things that shine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::render::lights) struct Emitter {
    /// Corners of the box around them, world units.
    pub min: DVec3,
    pub max: DVec3,
    /// Their normals, or where they look: about this axis, of unit length.
    pub axis: DVec3,
    /// Angle from the axis to the farthest of these, 0 to π.
    pub spread: f64,
    /// Angle from one of these to the farthest direction in which it shines, 0 to π/2.
    pub reach: f64,
    /// Whether they shine to the other side as well.
    pub both: bool,
    /// Greatest intensity of all together: light units times square world units.
    pub intensity: f64,
}

impl Emitter {
    /// Alike in every direction, from within a box.
    pub fn everywhere([min, max]: [DVec3; 2], intensity: f64) -> Self {
        Self { min, max, axis: DVec3::Z, spread: PI, reach: FRAC_PI_2, both: false, intensity }
    }

    /// A flat surface within a box.
    pub fn flat([min, max]: [DVec3; 2], normal: DVec3, both: bool, intensity: f64) -> Self {
        let axis = normal.normalize_or(DVec3::Z);
        Self { min, max, axis, spread: 0.0, reach: FRAC_PI_2, both, intensity }
    }

    /// A point that shines up to an angle from an axis.
    pub fn cone(point: DVec3, axis: DVec3, angle: f64, intensity: f64) -> Self {
        let axis = axis.normalize_or(DVec3::Z);
        Self { min: point, max: point, axis, spread: angle, reach: 0.0, both: false, intensity }
    }

    /// The same with so many times the intensity.
    pub fn times(self, factor: f64) -> Self {
        Self { intensity: factor * self.intensity, ..self }
    }

    /// Both together.
    pub fn and(&self, other: &Self) -> Self {
        let (axis, spread) = cone((self.axis, self.spread), (other.axis, other.spread));
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
            axis,
            spread,
            reach: self.reach.max(other.reach),
            both: self.both || other.both,
            intensity: self.intensity + other.intensity,
        }
    }

    pub fn centre(&self) -> DVec3 {
        0.5 * self.min + 0.5 * self.max
    }

    /// Half the diagonal of the box.
    pub fn radius(&self) -> f64 {
        0.5 * (self.max - self.min).length()
    }

    /// How much is lost by bounding them together: their intensity, times the square of the size of
    /// the ball around them, times the solid angle into which they may shine, about as in
    /// [ContyEstevez18, eq. 1].
    pub fn cost(&self) -> f64 {
        let (o, sides) = (self.spread, if self.both { 2.0 } else { 1.0 });
        let w = (o + self.reach).min(PI);
        let beyond = 2.0 * w * o.sin() - (o - 2.0 * w).cos() - 2.0 * o * o.sin() + o.cos();
        let solid_angle = TAU * (1.0 - o.cos()) + FRAC_PI_2 * beyond;
        self.intensity * self.radius().powi(2) * (sides * solid_angle)
    }
}

/// The smallest cone around two, each an axis and an angle.
fn cone(a: (DVec3, f64), b: (DVec3, f64)) -> (DVec3, f64) {
    let (a, b) = if a.1 >= b.1 { (a, b) } else { (b, a) };
    // By the chord: arc cosines of nearly 1 know few digits.
    let between = 2.0 * (0.5 * (a.0 - b.0).length()).min(1.0).asin();
    if between + b.1 <= a.1 {
        return a;
    }
    let spread = 0.5 * (a.1 + between + b.1);
    let across = (b.0 - a.0.dot(b.0) * a.0).normalize_or_zero();
    if spread >= PI || across == DVec3::ZERO {
        return (a.0, PI);
    }
    let turn = spread - a.1;
    (turn.cos() * a.0 + turn.sin() * across, spread)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cone_holds_both_that_it_was_made_of() {
        let axes = [DVec3::Z, DVec3::X, DVec3::NEG_Z, DVec3::new(0.6, 0.0, 0.8)];
        for a in axes {
            for b in axes {
                for angles in [[0.0, 0.0], [0.3, 0.1], [0.0, 2.0], [PI, 0.2]] {
                    let (axis, spread) = cone((a, angles[0]), (b, angles[1]));
                    assert!((axis.length() - 1.0).abs() < 1e-12 && spread <= PI);
                    for (of, angle) in [(a, angles[0]), (b, angles[1])] {
                        let farthest = axis.dot(of).clamp(-1.0, 1.0).acos() + angle;
                        assert!(spread >= farthest.min(PI) - 1e-7, "{a} {b} {angles:?}");
                    }
                }
            }
        }
    }
}
