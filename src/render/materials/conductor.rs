//! Smooth metal: Fresnel's formulas for a complex index of refraction.

use glam::Vec3;

use super::{Facing, Reflector};
use crate::math::Rgb;
use crate::optics::fresnel;

/// A metal that mirrors.
#[derive(Clone, Debug, PartialEq)]
pub enum Conductor {
    /// Of an index n + ik for each channel.
    Channels {
        /// The real parts.
        n: [f64; 3],
        /// The imaginary parts.
        k: [f64; 3],
    },
    /// Of a table: at the i-th of m entries, 2 or more, the cosine is (i / (m - 1))².
    Table(Vec<Rgb>),
}

impl Conductor {
    pub(super) fn at(&self, facing: &Facing) -> Reflector {
        let (wi, ns) = facing.mirrored();
        Reflector { wi, reflectance: self.reflectance(Self::cosine(facing, ns)) }
    }

    /// The viewer's cosine to a normal.
    #[inline(always)]
    pub(super) fn cosine(facing: &Facing, ns: Vec3) -> f32 {
        facing.wo.dot(ns).clamp(0.0, 1.0)
    }

    /// What it gives back of light that falls straight on it.
    pub(super) fn colour(&self) -> Rgb {
        self.reflectance(1.0)
    }

    /// What it gives back at this cosine to the normal.
    pub(super) fn reflectance(&self, cos: f32) -> Rgb {
        match self {
            Self::Channels { n, k } => {
                let part = |i: usize| fresnel::conductor(n[i], k[i], cos.into()) as f32;
                Rgb::new(part(0), part(1), part(2))
            }
            Self::Table(table) => {
                let place = cos.sqrt() * (table.len() - 1) as f32;
                let before = (place as usize).min(table.len() - 2);
                let t = place - before as f32;
                table[before] * (1.0 - t) + table[before + 1] * t
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_straight_between_their_angles() {
        let table = Conductor::Table(vec![Rgb::ONE, Rgb::grey(0.5), Rgb::new(0.0, 0.25, 0.5)]);
        assert_eq!(table.reflectance(0.0), Rgb::ONE);
        assert_eq!(table.reflectance(0.25), Rgb::grey(0.5));
        assert_eq!(table.reflectance(1.0), Rgb::new(0.0, 0.25, 0.5));
        assert_eq!(table.reflectance(0.0625), Rgb::grey(0.75));
        assert_eq!(table.colour(), Rgb::new(0.0, 0.25, 0.5));
    }

    #[test]
    fn channels_are_reckoned_each_by_itself() {
        let gold = Conductor::Channels { n: [0.14, 0.43, 1.38], k: [3.697, 2.455, 1.914] };
        let cases = [
            (0.0_f32, [0.962585, 0.786916, 0.408220]),
            (60.0, [0.958123, 0.788132, 0.439799]),
            (85.0, [0.975978, 0.919646, 0.765842]),
        ];
        for (degrees, truth) in cases {
            let found = gold.reflectance(degrees.to_radians().cos()).to_array();
            for (found, truth) in found.into_iter().zip(truth) {
                assert!((found - truth).abs() < 1e-5, "{degrees}: {found}, not {truth}");
            }
        }
    }
}
