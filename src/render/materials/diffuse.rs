//! Lambert's law: the same radiance in every direction, on both sides of the surface.

use std::f32::consts::FRAC_1_PI;

use glam::Vec3;

use crate::math::Rgb;
use crate::render::geometry::Hit;

/// A diffuse surface; its front side may be a lamp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Diffuse {
    /// The part of the light that is scattered back, on either side.
    pub albedo: Rgb,
    /// Radiance of the front side, in light units.
    pub emission: Rgb,
}

impl Diffuse {
    /// The surface at a hit, seen from `wo`.
    pub(super) fn at(&self, hit: &Hit, wo: Vec3) -> Lambert {
        // Seen from behind, the surface is shaded as if it were turned round.
        let side = if hit.ng.dot(wo) >= 0.0 { 1.0 } else { -1.0 };
        Lambert { albedo: self.albedo, ng: side * hit.ng, ns: side * hit.ns }
    }
}

/// A diffuse surface at a hit.
#[derive(Clone, Copy, Debug)]
pub struct Lambert {
    albedo: Rgb,
    /// Geometric normal on the viewer's side.
    ng: Vec3,
    /// Shading normal on the same side.
    ns: Vec3,
}

impl Lambert {
    /// albedo/π times the cosine at the shading normal. Interpolated normals may be lit where the
    /// surface itself is not: there it stays black, or light would leak through from behind.
    pub(super) fn scattered(&self, wi: Vec3) -> Rgb {
        if self.ng.dot(wi) <= 0.0 {
            return Rgb::BLACK;
        }
        self.albedo * (FRAC_1_PI * self.ns.dot(wi).max(0.0))
    }
}
