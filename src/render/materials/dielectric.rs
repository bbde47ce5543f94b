//! A smooth surface between two kinds of clear matter: Fresnel's formulas and Snell's law.

use super::{Event, Facing, Scattered};
use crate::math::Rgb;

/// A surface between two media.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dielectric {
    /// Index of refraction behind the face.
    pub inside: f64,
    /// Index of refraction before it.
    pub outside: f64,
}

impl Dielectric {
    pub(super) fn at(&self, facing: Facing) -> Interface {
        let (here, beyond) =
            if facing.front { (self.outside, self.inside) } else { (self.inside, self.outside) };
        let eta = beyond / here;
        // Of indices that are nearly the same the difference is exact, the quotient is not.
        let excess = (beyond - here) / here;
        let cos = f64::from(facing.wo.dot(facing.ns)).clamp(0.0, 1.0);
        let rest = excess * (eta + 1.0);
        let g_2 = rest + cos * cos;
        if g_2 <= 0.0 {
            return Interface { facing, eta, bend: 0.0, reflectance: 1.0 };
        }
        // g is the cosine beyond, times eta; bend is g − cos without cancellation.
        let g = g_2.sqrt();
        let (bend, sum) = (rest / (g + cos), g + cos);
        let parallel = (cos * sum - 1.0) / (cos * bend + 1.0);
        let reflectance = 0.5 * (bend / sum).powi(2) * (1.0 + parallel * parallel);
        Interface { facing, eta, bend, reflectance: reflectance.clamp(0.0, 1.0) }
    }
}

/// Such a surface at a hit.
#[derive(Clone, Copy, Debug)]
pub struct Interface {
    facing: Facing,
    /// Index beyond over the index on the viewer's side.
    eta: f64,
    bend: f64,
    /// The part of the light that is reflected; 1 where all is.
    reflectance: f64,
}

impl Interface {
    pub(super) fn reflected(&self) -> Option<Scattered> {
        let weight = Rgb::grey(self.reflectance as f32);
        (self.reflectance > 0.0).then_some(Scattered {
            wi: self.facing.mirrored()?,
            weight,
            squeeze: 1.0,
            pdf_w: 0.0,
            event: Event::SpecularReflection,
        })
    }

    pub(super) fn refracted(&self) -> Option<Scattered> {
        if self.reflectance >= 1.0 {
            return None;
        }
        let Facing { wo, ns, ng, .. } = self.facing;
        let way = -(wo.as_dvec3() + self.bend * ns.as_dvec3());
        let wi = way.normalize().as_vec3();
        (wi.dot(ng) < 0.0).then_some(Scattered {
            wi,
            weight: Rgb::grey((1.0 - self.reflectance) as f32),
            squeeze: (1.0 / (self.eta * self.eta)) as f32,
            pdf_w: 0.0,
            event: Event::SpecularTransmission,
        })
    }

    /// One of the two, each as often as light goes there.
    pub(super) fn sample(&self, u: f64) -> Option<Scattered> {
        let way = if u < self.reflectance { self.reflected() } else { self.refracted() };
        way.map(|way| Scattered { weight: Rgb::ONE, ..way })
    }
}
