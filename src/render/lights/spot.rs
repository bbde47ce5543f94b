//! Light of a point within a cone.

use glam::{DVec3, Vec3};

use super::{Arrival, Emitter, Point, PointLight};

/// A point that shines within a cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotLight {
    /// The same without the cone.
    pub bulb: PointLight,
    /// Where the light goes; unit length.
    pub axis: Vec3,
    /// 1 − cos of the angle from the axis at which the light begins to fade, and at which it ends.
    pub fades: [f64; 2],
}

impl SpotLight {
    /// With the angles from the axis at which the light begins to fade and at which it ends, in
    /// radians.
    pub fn new(bulb: PointLight, axis: Vec3, angles: [f64; 2]) -> Self {
        // 1 − cos θ, for small θ too.
        let fades = angles.map(|angle| 2.0 * (0.5 * angle).sin().powi(2));
        Self { bulb, axis, fades }
    }

    /// What bounds it.
    pub(super) fn emitter(&self) -> Emitter {
        let angle = 2.0 * (0.5 * self.fades[1]).sqrt().min(1.0).asin();
        let intensity = f64::from(self.bulb.intensity.luminance());
        Emitter::cone(self.bulb.position.as_dvec3(), self.axis.as_dvec3(), angle, intensity)
    }

    pub(super) fn arrive(&self, at: &Point) -> Option<Arrival> {
        let arrival = self.bulb.arrive(at)?;
        let part = self.part(at.position.as_dvec3() - self.bulb.position.as_dvec3());
        let irradiance = arrival.irradiance * part as f32;
        (part > 0.0).then_some(Arrival { irradiance, ..arrival })
    }

    /// The part of its intensity that goes in a direction, of any length.
    fn part(&self, way: DVec3) -> f64 {
        let axis = self.axis.as_dvec3().normalize_or_zero();
        // 1 − cos θ again: half the squared chord.
        let off = 0.5 * (way.normalize_or_zero() - axis).length_squared();
        let [begin, end] = self.fades;
        if off <= begin {
            return 1.0;
        }
        let t = ((end - off) / (end - begin)).max(0.0);
        t * t * (3.0 - 2.0 * t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    fn spot(angles: [f64; 2]) -> SpotLight {
        let bulb = PointLight { position: Vec3::ZERO, intensity: Rgb::ONE };
        SpotLight::new(bulb, Vec3::Z, angles)
    }

    #[test]
    fn a_cone_is_whole_within_fades_smoothly_and_ends() {
        for scale in [1.0, 1e-3, 1e-7] {
            let spot = spot([0.4 * scale, 0.8 * scale]);
            let part = |angle: f64| spot.part(DVec3::new(angle.sin(), 0.0, angle.cos()));
            assert_eq!(part(0.0), 1.0);
            assert!((part(0.399 * scale) - 1.0).abs() < 1e-12);
            assert_eq!(part(0.801 * scale), 0.0);
            // Half way by the cosine.
            let middle = 0.5 * (spot.fades[0] + spot.fades[1]);
            let angle = 2.0 * (0.5 * middle).sqrt().asin();
            assert!((part(angle) - 0.5).abs() < 1e-6, "{scale}: {}", part(angle));
        }
    }

    #[test]
    fn a_sharp_cone_has_an_edge_and_a_full_one_has_none() {
        let sharp = spot([0.5, 0.5]);
        assert_eq!(sharp.part(DVec3::new(0.499_f64.sin(), 0.0, 0.499_f64.cos())), 1.0);
        assert_eq!(sharp.part(DVec3::new(0.501_f64.sin(), 0.0, 0.501_f64.cos())), 0.0);
        let full = spot([std::f64::consts::PI; 2]);
        assert_eq!(full.part(DVec3::NEG_Z), 1.0);
    }
}
