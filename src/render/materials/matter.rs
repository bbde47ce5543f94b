//! What the surfaces of a scene may be. Loops over paths are compiled for each answer, so that a
//! scene of diffuse surfaces pays for no others.

use glam::Vec3;

use super::{
    Bsdf, Event, Facing, Lambert, Many, Material, Mingled, Part, Scattered, Scattering, Surface,
};
use crate::math::Rgb;
use crate::render::geometry::Hit;

/// Which materials there are in a world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Makeup {
    /// Any.
    Any,
    /// Diffuse ones alone.
    Diffuse,
}

/// What surfaces may be.
pub trait Matter {
    /// What one of them is at a hit.
    type Bsdf: Scatter;

    /// What a material is at a hit, seen from `wo`.
    fn at(material: &Material, hit: &Hit, wo: Vec3) -> Self::Bsdf;

    /// What many of them are.
    type Many: Many;

    /// Where surfaces of a material come among many: those that may scatter light to all sides first,
    /// since they alone ask lamps. Less than `RANKS`.
    fn rank(material: &Material) -> usize;

    /// How many ranks there are, [`MOST_RANKS`] at most.
    const RANKS: usize;
}

/// Scattering surfaces, mirrors and metals, and clear ones.
pub const MOST_RANKS: usize = 3;

/// How the surface at a hit scatters light: see the methods of [`Bsdf`].
pub trait Scatter {
    /// See [`Bsdf::scattered`].
    fn scattered(&self, wi: Vec3) -> Rgb;
    /// See [`Bsdf::faces`].
    fn faces(&self, wi: Vec3) -> bool;
    /// See [`Bsdf::scatters`].
    fn scatters(&self) -> Option<Event>;
    /// See [`Bsdf::is_specular`].
    fn is_specular(&self) -> bool;
    /// See [`Bsdf::side`].
    fn side(&self) -> Vec3;
    /// See [`Bsdf::sample`].
    fn sample(&self, part: Part, u: [f64; 4]) -> Option<Scattered>;
    /// See [`Bsdf::specular`].
    fn specular(&self) -> [Option<Scattered>; 2];
}

/// Any surface.
#[derive(Clone, Copy, Debug)]
pub struct Any;

impl Matter for Any {
    type Bsdf = Bsdf;

    #[inline]
    fn at(material: &Material, hit: &Hit, wo: Vec3) -> Bsdf {
        material.at(hit, wo)
    }

    type Many = Mingled;

    #[inline(always)]
    fn rank(material: &Material) -> usize {
        match material.surface {
            Surface::Diffuse(_) | Surface::Mixture(_) => 0,
            Surface::Conductor(_) | Surface::Mirror(_) => 1,
            Surface::Dielectric(_) => 2,
        }
    }

    const RANKS: usize = MOST_RANKS;
}

/// Diffuse surfaces alone.
#[derive(Clone, Copy, Debug)]
pub struct OnlyDiffuse;

impl Matter for OnlyDiffuse {
    type Bsdf = Lambert;

    #[inline]
    fn at(material: &Material, hit: &Hit, wo: Vec3) -> Lambert {
        let facing = Facing::new(hit, wo);
        match &material.surface {
            Surface::Diffuse(diffuse) => diffuse.at(hit.uv, &facing),
            other => {
                debug_assert!(false, "{other:?} in a world of diffuse surfaces");
                Lambert::black(&facing)
            }
        }
    }

    type Many = Scattering;

    #[inline(always)]
    fn rank(_: &Material) -> usize {
        0
    }

    const RANKS: usize = 1;
}

impl Scatter for Lambert {
    #[inline(always)]
    fn scattered(&self, wi: Vec3) -> Rgb {
        self.scattered(wi)
    }

    #[inline(always)]
    fn faces(&self, wi: Vec3) -> bool {
        self.faces(wi)
    }

    #[inline]
    fn scatters(&self) -> Option<Event> {
        Some(Event::DiffuseReflection)
    }

    #[inline]
    fn is_specular(&self) -> bool {
        false
    }

    #[inline]
    fn side(&self) -> Vec3 {
        self.side()
    }

    #[inline(always)]
    fn sample(&self, part: Part, u: [f64; 4]) -> Option<Scattered> {
        if part == Part::Specular { None } else { self.sample([u[0], u[1]]) }
    }

    #[inline]
    fn specular(&self) -> [Option<Scattered>; 2] {
        [None, None]
    }
}

impl Scatter for Bsdf {
    fn scattered(&self, wi: Vec3) -> Rgb {
        self.scattered(wi)
    }

    fn faces(&self, wi: Vec3) -> bool {
        self.faces(wi)
    }

    fn scatters(&self) -> Option<Event> {
        self.scatters()
    }

    fn is_specular(&self) -> bool {
        self.is_specular()
    }

    fn side(&self) -> Vec3 {
        self.side()
    }

    fn sample(&self, part: Part, u: [f64; 4]) -> Option<Scattered> {
        self.sample(part, u)
    }

    fn specular(&self) -> [Option<Scattered>; 2] {
        self.specular()
    }
}
