//! A round disc infinitely far away, bright all over: the sun.
//!
//! Angles are measured by chords between unit vectors: the cosine of half a degree has lost most
//! digits of the angle in f32.

use std::f64::consts::PI;

use glam::{Vec2, Vec3};

use super::choice::Gives;
use crate::math::{Rgb, random, warp};

/// A disc in the sky.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Towards its centre; unit length.
    towards: Vec3,
    /// Half the angle it fills.
    half_angle: f32,
    /// The square of the chord from its centre to its rim.
    chord_squared: f32,
    /// One over its solid angle.
    pdf_w: f32,
    /// In light units.
    radiance: Rgb,
}

impl Disc {
    /// The disc of a half angle in radians, 1e-4 or more and below π/2, that gives a surface square
    /// to its centre this irradiance, in light units.
    pub fn new(towards: Vec3, half_angle: f64, irradiance: Rgb) -> Self {
        let half_chord = (0.5 * half_angle).sin();
        // ∫ cos θ dω is π sin² θ of the rim.
        let radiance = irradiance / (PI * half_angle.sin().powi(2)) as f32;
        Self {
            towards,
            half_angle: half_angle as f32,
            chord_squared: (4.0 * half_chord * half_chord) as f32,
            pdf_w: (1.0 / (4.0 * PI * half_chord * half_chord)) as f32,
            radiance,
        }
    }

    /// About the irradiance it gives.
    pub(super) fn gives(&self) -> Gives {
        Gives::from(self.towards, self.irradiance(), f64::from(self.half_angle.sin()))
    }

    /// About the irradiance, of luminance, on a surface square to its centre.
    pub(super) fn irradiance(&self) -> f64 {
        f64::from(self.radiance.luminance() / self.pdf_w)
    }

    /// Radiance from a direction.
    pub fn radiance(&self, direction: Vec3) -> Rgb {
        if self.holds(direction) { self.radiance } else { Rgb::BLACK }
    }

    /// A direction of it, uniform in solid angle, with the radiance from there and that density.
    pub(super) fn sample(&self, u: [f64; 2]) -> (Vec3, Rgb, f32) {
        let u = Vec2::from_array(u.map(random::unit_f32));
        let wi = warp::about(self.towards, warp::square_to_cone(u, self.half_angle));
        (wi.normalize(), self.radiance, self.pdf_w)
    }

    /// The density in solid angle with which `sample` gives a direction.
    pub(super) fn pdf_w(&self, direction: Vec3) -> f32 {
        if self.holds(direction) { self.pdf_w } else { 0.0 }
    }

    fn holds(&self, direction: Vec3) -> bool {
        (direction - self.towards).length_squared() <= self.chord_squared
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::chi_squared;

    const SAMPLES: u64 = 50_000;

    fn suns() -> impl Iterator<Item = Disc> {
        let towards = [Vec3::Z, Vec3::NEG_Z, Vec3::new(1.0, -2.0, 0.3).normalize()];
        [1e-4, 0.00465, 0.5].into_iter().flat_map(move |half_angle| {
            towards.map(|towards| Disc::new(towards, half_angle, Rgb::new(1.0, 2.0, 3.0)))
        })
    }

    /// Four rings of one solid angle by twelve sectors.
    #[test]
    fn samples_fill_the_disc_evenly_and_nothing_else() {
        for sun in suns() {
            let (x, y) = sun.towards.any_orthonormal_pair();
            let mut counts = vec![0; 48];
            let mut outside = 0;
            for i in 0..SAMPLES {
                let (wi, radiance, _) = sun.sample(random::unit_pair(random::at(5, i)));
                assert!((wi.length() - 1.0).abs() < 1e-6);
                assert_eq!(radiance, sun.radiance);
                outside += u64::from(!sun.holds(wi));
                let chord = wi - sun.towards;
                let ring = (chord.length_squared() / sun.chord_squared * 4.0) as usize;
                let turn = chord.dot(y).atan2(chord.dot(x)) / std::f32::consts::TAU + 0.5;
                counts[ring.min(3) * 12 + ((turn * 12.0) as usize).min(11)] += 1;
            }
            // Rounding of unit vectors, where the disc is as small as a thousand of their steps.
            assert!(outside <= SAMPLES / 500, "{outside} of {SAMPLES}");
            chi_squared::assert_fits(&counts, &[1.0 / 48.0; 48]);
        }
    }

    /// Monte Carlo by its own samples, on surfaces square to it and tilted.
    #[test]
    fn irradiance_is_what_was_asked_for_whatever_the_size() {
        for sun in suns() {
            for tilt in [0.0_f32, 0.9] {
                let (x, _) = sun.towards.any_orthonormal_pair();
                let normal = sun.towards * tilt.cos() + x * tilt.sin();
                let mean = (0..SAMPLES).map(|i| {
                    let (wi, radiance, density) = sun.sample(random::unit_pair(random::at(6, i)));
                    f64::from(radiance.g * normal.dot(wi) / density)
                });
                let found = mean.sum::<f64>() / SAMPLES as f64;
                let expected = 2.0 * f64::from(tilt.cos());
                assert!((found / expected - 1.0).abs() < 4e-3, "{sun:?}: {found}, not {expected}");
            }
        }
    }

    #[test]
    fn the_disc_is_seen_within_its_rim_alone() {
        for sun in suns() {
            let (x, _) = sun.towards.any_orthonormal_pair();
            let at = |angle: f32| (sun.towards + x * angle.tan()).normalize();
            assert_eq!(sun.radiance(at(0.95 * sun.half_angle)), sun.radiance);
            assert_eq!(sun.radiance(at(1.05 * sun.half_angle)), Rgb::BLACK);
            assert_eq!(sun.radiance(-sun.towards), Rgb::BLACK);
        }
    }
}
