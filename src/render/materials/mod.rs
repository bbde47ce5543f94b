//! Materials: what a surface does with light, and what it becomes at a hit.
//!
//! A material is asked once a hit ([`Material::at`]) for its BSDF there, seen from `wo`. All
//! directions point away from the surface. Weights are of radiance that goes from `wi` to `wo`.

mod conductor;
mod dielectric;
mod diffuse;
mod facing;
mod interfaces;
mod lamberts;
mod many;
mod matter;
mod mirror;
mod mixture;
mod reflectors;
mod ways;

#[cfg(test)]
mod tests;

pub use conductor::Conductor;
pub use dielectric::{Dielectric, Interface};
pub use diffuse::{Diffuse, Lambert};
pub use lamberts::Lamberts;
pub use many::{Many, Mingled, Scattering, Seen};
pub use matter::{Any, MOST_RANKS, Makeup, Matter, OnlyDiffuse, Scatter};
pub use mirror::{Mirror, Reflector};
pub use mixture::{Mixed, Mixture};
pub use ways::Ways;

use facing::Facing;
use glam::{DVec2, Vec3};

use super::geometry::Hit;
use crate::math::Rgb;
use crate::math::paths::Event;

/// What a surface does with light, and what it shines of itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// What it does with light.
    pub surface: Surface,
    /// What it shines.
    pub emission: Emission,
    /// Number of the medium before it.
    pub before: u32,
    /// Number of the medium behind it; None: no light goes through.
    pub behind: Option<u32>,
}

/// What a surface shines of itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Emission {
    /// Radiance in light units, the same in all directions.
    pub radiance: Rgb,
    /// Whether its back shines as well as its front.
    pub both: bool,
}

/// What a surface does with light.
#[derive(Clone, Debug, PartialEq)]
pub enum Surface {
    /// Smooth metal.
    Conductor(Conductor),
    /// A smooth surface of clear matter.
    Dielectric(Dielectric),
    /// Lambert's.
    Diffuse(Diffuse),
    /// A perfect mirror.
    Mirror(Mirror),
    /// Several of them.
    Mixture(Mixture),
}

impl Material {
    /// The radiance that a hit shines of itself towards `wo`, in light units.
    #[inline]
    pub fn emission(&self, hit: &Hit, wo: Vec3) -> Rgb {
        let Emission { radiance, both } = self.emission;
        if both || hit.ng.dot(wo) > 0.0 { radiance } else { Rgb::BLACK }
    }

    /// The colour of the surface at a hit, for a picture that shows what is where.
    pub fn colour(&self, hit: &Hit) -> Rgb {
        self.surface.colour(hit.uv)
    }

    /// What the material is at a hit, seen from `wo`, which points away from the surface.
    #[inline]
    pub fn at(&self, hit: &Hit, wo: Vec3) -> Bsdf {
        self.surface.at(hit.uv, &Facing::new(hit, wo))
    }
}

impl Surface {
    fn colour(&self, uv: DVec2) -> Rgb {
        match self {
            Self::Conductor(conductor) => conductor.colour(),
            Self::Dielectric(_) => Rgb::grey(0.8),
            Self::Diffuse(diffuse) => diffuse.albedo.at(uv),
            Self::Mirror(mirror) => mirror.reflectance.at(uv),
            Self::Mixture(mixture) => mixture.colour(uv),
        }
    }

    fn at(&self, uv: DVec2, facing: &Facing) -> Bsdf {
        match self {
            Self::Conductor(conductor) => Bsdf::Reflector(conductor.at(facing)),
            Self::Dielectric(dielectric) => Bsdf::Interface(dielectric.at(facing)),
            Self::Diffuse(diffuse) => Bsdf::Lambert(diffuse.at(uv, facing)),
            Self::Mirror(mirror) => Bsdf::Reflector(mirror.at(uv, facing)),
            Self::Mixture(mixture) => Bsdf::Mixed(mixture.at(uv, facing)),
        }
    }
}

/// How the surface at a hit scatters light.
#[derive(Clone, Copy, Debug)]
pub enum Bsdf {
    /// Clear matter.
    Interface(Interface),
    /// Lambert's.
    Lambert(Lambert),
    /// Several of them.
    Mixed(Mixed),
    /// A mirror or a smooth metal.
    Reflector(Reflector),
}

/// A part of what a surface does with light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// All of it.
    All,
    /// What goes to all sides.
    Scattering,
    /// What goes in one direction alone, or two.
    Specular,
}

/// A direction from which light comes that a surface sends to the viewer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scattered {
    /// Unit length, away from the surface.
    pub wi: Vec3,
    /// The BSDF times the cosine over the density of the direction; of a direction that is the
    /// only one, the part of the light that goes there over the probability of the choice.
    pub weight: Rgb,
    /// A factor that the weight lacks, and roulette is not to count: of radiance that comes from matter
    /// of another index, which has it squeezed into less solid angle; of a way that more paths are
    /// sent than the surface would.
    pub squeeze: f32,
    /// Density in solid angle; 0 of a direction that is the only one.
    pub pdf_w: f32,
    /// What happened.
    pub event: Event,
}

impl Bsdf {
    /// What scatters light to all sides, if something does.
    fn lambert(&self) -> Option<&Lambert> {
        match self {
            Self::Lambert(lambert) => Some(lambert),
            Self::Mixed(mixed) if mixed.scatters() => Some(mixed.lambert()),
            Self::Interface(_) | Self::Mixed(_) | Self::Reflector(_) => None,
        }
    }

    /// The BSDF towards the viewer of light from `wi`, times the cosine at the shading normal,
    /// in 1/sr; without specular parts.
    pub fn scattered(&self, wi: Vec3) -> Rgb {
        self.lambert().map_or(Rgb::BLACK, |lambert| lambert.scattered(wi))
    }

    /// Whether light from `wi` reaches the viewer's side of the geometric surface. Where normals
    /// are interpolated it may not, though it is above the shading normal: it would leak through
    /// from behind.
    pub fn faces(&self, wi: Vec3) -> bool {
        self.lambert().is_some_and(|lambert| lambert.faces(wi))
    }

    /// What happens to light that it scatters to all sides, if it does.
    pub fn scatters(&self) -> Option<Event> {
        self.lambert().map(|_| Event::DiffuseReflection)
    }

    /// Whether some light goes in one direction alone.
    pub fn is_specular(&self) -> bool {
        match self {
            Self::Lambert(_) => false,
            Self::Mixed(mixed) => mixed.is_specular(),
            Self::Interface(_) | Self::Reflector(_) => true,
        }
    }

    /// Shading normal on the side from which light counts that is scattered; zero if it counts
    /// from both.
    pub fn side(&self) -> Vec3 {
        self.lambert().map_or(Vec3::ZERO, |lambert| lambert.side())
    }

    /// A direction for light to come from, by `u` in [0, 1)⁴: the first two choose it, the third
    /// the part of the BSDF, the fourth is not used. None: it brings nothing.
    pub fn sample(&self, part: Part, u: [f64; 4]) -> Option<Scattered> {
        match (self, part) {
            (Self::Mixed(mixed), _) => mixed.sample(part, u),
            (Self::Lambert(_), Part::Specular) => None,
            (Self::Lambert(lambert), _) => lambert.sample([u[0], u[1]]),
            (_, Part::Scattering) => None,
            (Self::Interface(interface), _) => Some(interface.sample(u[2])),
            (Self::Reflector(reflector), _) => Some(reflector.reflected()),
        }
    }

    /// Density in solid angle with which `sample` gives a direction; without specular ones.
    pub fn pdf_w(&self, part: Part, wi: Vec3) -> f32 {
        match (self, part) {
            (Self::Mixed(mixed), _) => mixed.chance(part) * mixed.lambert().pdf_w(wi),
            (Self::Lambert(lambert), Part::All | Part::Scattering) => lambert.pdf_w(wi),
            _ => 0.0,
        }
    }

    /// All directions that are the only ones: each with the part of the light that goes there.
    pub fn specular(&self) -> [Option<Scattered>; 2] {
        match self {
            Self::Lambert(_) => [None, None],
            Self::Interface(interface) => [interface.reflected(), interface.refracted()],
            Self::Mixed(mixed) => mixed.specular(),
            Self::Reflector(reflector) => [Some(reflector.reflected()), None],
        }
    }
}
