//! What many surfaces do with light: those of a turn, sorted by kind.

use glam::Vec3;

use super::interfaces::Interfaces;
use super::reflectors::Reflectors;
use super::{Facing, Lambert, Lamberts, Material, Matter, Mixed, OnlyDiffuse, Part, Surface, Ways};
use crate::render::geometry::Hit;
use crate::render::samplers::Fours;

/// Surfaces, one lane for each. They come by [`Matter::rank`].
pub trait Many: Default {
    /// Forgets them.
    fn clear(&mut self);

    /// One more: a material at a hit, seen from `wo`.
    fn push(&mut self, material: &Material, hit: &Hit, wo: Vec3) -> Seen;

    /// With which chance what the last of them scatters to all sides is sampled.
    fn chance(&self, part: Part) -> f32;

    /// A way on from each, of all that it does, by numbers in [0, 1)⁴: see [`super::Bsdf::sample`].
    /// What they scatter to all sides are `lamberts`.
    fn ways(&mut self, materials: &[Material], lamberts: &Lamberts, fours: &Fours, ways: &mut Ways);
}

/// What is to be known of a surface at once.
pub struct Seen {
    /// What it scatters to all sides, if it does.
    pub lambert: Option<Lambert>,
    /// Whether some light goes in one direction alone.
    pub is_specular: bool,
}

/// Diffuse surfaces.
#[derive(Default)]
pub struct Scattering {
    count: usize,
}

impl Many for Scattering {
    #[inline(always)]
    fn clear(&mut self) {
        self.count = 0;
    }

    #[inline(always)]
    fn push(&mut self, material: &Material, hit: &Hit, wo: Vec3) -> Seen {
        self.count += 1;
        Seen { lambert: Some(OnlyDiffuse::at(material, hit, wo)), is_specular: false }
    }

    #[inline(always)]
    fn chance(&self, _: Part) -> f32 {
        1.0
    }

    fn ways(&mut self, _: &[Material], lamberts: &Lamberts, fours: &Fours, ways: &mut Ways) {
        ways.by_cosine(self.count, lamberts, fours);
    }
}

/// Surfaces of any kind.
#[derive(Default)]
pub struct Mingled {
    /// Those that may scatter to all sides, mixtures among them.
    scattering: usize,
    mixtures: Vec<(usize, Mixed)>,
    reflectors: Reflectors,
    interfaces: Interfaces,
}

impl Many for Mingled {
    fn clear(&mut self) {
        self.scattering = 0;
        self.mixtures.clear();
        self.reflectors.clear();
        self.interfaces.clear();
    }

    #[inline]
    fn push(&mut self, material: &Material, hit: &Hit, wo: Vec3) -> Seen {
        let facing = &Facing::new(hit, wo);
        let specular = Seen { lambert: None, is_specular: true };
        match &material.surface {
            Surface::Conductor(_) => {
                self.reflectors.metal(facing, hit.material);
                specular
            }
            Surface::Dielectric(dielectric) => {
                self.interfaces.push(facing, dielectric.indices(facing));
                specular
            }
            Surface::Diffuse(diffuse) => {
                self.scattering += 1;
                Seen { lambert: Some(diffuse.at(hit.uv, facing)), is_specular: false }
            }
            Surface::Mirror(mirror) => {
                self.reflectors.mirror(facing, mirror.reflectance.at(hit.uv));
                specular
            }
            Surface::Mixture(mixture) => {
                let mixed = mixture.at(hit.uv, facing);
                self.mixtures.push((self.scattering, mixed));
                self.scattering += 1;
                let lambert = mixed.scatters().then_some(*mixed.lambert());
                Seen { lambert, is_specular: mixed.is_specular() }
            }
        }
    }

    #[inline]
    fn chance(&self, part: Part) -> f32 {
        match self.mixtures.last() {
            Some((lane, mixed)) if lane + 1 == self.scattering => mixed.chance(part),
            _ => 1.0,
        }
    }

    fn ways(
        &mut self,
        materials: &[Material],
        lamberts: &Lamberts,
        fours: &Fours,
        ways: &mut Ways,
    ) {
        ways.scatter(self.scattering);
        ways.by_cosine(self.scattering, lamberts, fours);
        for (lane, mixed) in &self.mixtures {
            ways.put(*lane, mixed.sample(Part::All, fours.at(*lane)));
        }
        let [.., chances, _] = fours.rows();
        let first = self.scattering;
        let first = first + self.reflectors.ways(materials, first, ways);
        self.interfaces.ways(first, chances, ways);
    }
}
