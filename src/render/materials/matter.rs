//! What the surfaces of a scene may be. Loops over paths are compiled for each answer, so that a
//! scene of diffuse surfaces pays for no others.

use glam::Vec3;

use super::{Bsdf, Event, Facing, Lambert, Lamberts, Material, Part, Scattered, Surface, Ways};
use crate::math::Rgb;
use crate::render::geometry::Hit;
use crate::render::samplers::Fours;

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

    /// For so many surfaces, ways on of all that they do, by numbers of theirs in [0, 1)⁴: those of
    /// `bsdfs`, of which the diffuse parts are `lamberts`.
    fn ways<'a>(
        bsdfs: impl ExactSizeIterator<Item = &'a Self::Bsdf>,
        lamberts: &Lamberts,
        fours: &Fours,
        ways: &mut Ways,
    ) where
        Self::Bsdf: 'a;
}

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
    /// See [`Bsdf::lambert_of`].
    fn lambert_of(&self, part: Part) -> Option<(&Lambert, f32)>;
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

    fn ways<'a>(
        bsdfs: impl ExactSizeIterator<Item = &'a Bsdf>,
        _: &Lamberts,
        fours: &Fours,
        ways: &mut Ways,
    ) {
        for (lane, bsdf) in bsdfs.enumerate() {
            ways.put(lane, bsdf.sample(Part::All, fours.at(lane)));
        }
    }
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

    fn ways<'a>(
        bsdfs: impl ExactSizeIterator<Item = &'a Lambert>,
        lamberts: &Lamberts,
        fours: &Fours,
        ways: &mut Ways,
    ) {
        ways.by_cosine(bsdfs.len(), lamberts, fours);
    }
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

    #[inline(always)]
    fn lambert_of(&self, part: Part) -> Option<(&Lambert, f32)> {
        (part != Part::Specular).then_some((self, 1.0))
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

    fn lambert_of(&self, part: Part) -> Option<(&Lambert, f32)> {
        self.lambert_of(part)
    }

    fn specular(&self) -> [Option<Scattered>; 2] {
        self.specular()
    }
}
