//! Smooth metal: Fresnel's formulas for a complex index of refraction.

use super::{Event, Facing, Scattered};
use crate::math::Rgb;

/// A metal that mirrors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conductor {
    /// The real part of the index, for each channel.
    pub n: [f32; 3],
    /// The imaginary part.
    pub k: [f32; 3],
}

impl Conductor {
    pub(super) fn at(&self, facing: Facing) -> Metal {
        Metal { conductor: *self, facing }
    }

    /// What it gives back of light that falls straight on it.
    pub(super) fn colour(&self) -> Rgb {
        self.reflectance(1.0)
    }

    /// What it gives back at this cosine to the normal.
    fn reflectance(&self, cos: f32) -> Rgb {
        let [r, g, b] =
            std::array::from_fn(|i| fresnel(self.n[i].into(), self.k[i].into(), cos.into()) as f32);
        Rgb::new(r, g, b)
    }
}

/// The part of unpolarised light that a surface of index n + ik reflects.
fn fresnel(n: f64, k: f64, cos: f64) -> f64 {
    let (cos_2, sin_2) = (cos * cos, 1.0 - cos * cos);
    let (n_2, k_2) = (n * n, k * k);
    let t = n_2 - k_2 - sin_2;
    let a_2_plus_b_2 = (t * t + 4.0 * n_2 * k_2).sqrt();
    let a = (0.5 * (a_2_plus_b_2 + t)).max(0.0).sqrt();
    let across = (a_2_plus_b_2 - 2.0 * a * cos + cos_2) / (a_2_plus_b_2 + 2.0 * a * cos + cos_2);
    let (s, q) = (cos_2 * a_2_plus_b_2 + sin_2 * sin_2, 2.0 * a * cos * sin_2);
    0.5 * across * (1.0 + (s - q) / (s + q))
}

/// A metal at a hit.
#[derive(Clone, Copy, Debug)]
pub struct Metal {
    conductor: Conductor,
    facing: Facing,
}

impl Metal {
    pub(super) fn reflected(&self) -> Option<Scattered> {
        let Facing { wo, ns, .. } = self.facing;
        Some(Scattered {
            wi: self.facing.mirrored()?,
            weight: self.conductor.reflectance(wo.dot(ns).clamp(0.0, 1.0)),
            squeeze: 1.0,
            pdf_w: 0.0,
            event: Event::SpecularReflection,
        })
    }
}
