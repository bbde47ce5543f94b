//! Materials: what a surface does with light.

use super::vocabulary::vocabulary;
use super::{At, Index, Medium, Radiance, Ref, Reflectance, Texture, Textured};

vocabulary! {
    /// What a surface does with light.
    pub enum Material: "material" {
        /// Smooth metal: reflects by Fresnel's formulas for a complex index of refraction.
        "conductor" => Conductor {
            /// Its index of refraction, `metal.gold` or `complex(n, k)`.
            ior: Index;
        }
        /// A smooth surface of clear matter, such as glass: reflects and refracts by Fresnel's
        /// formulas.
        "dielectric" => Dielectric {
            /// What is behind the face.
            inside: Ref<Medium>;
            /// What is before it. Left out: what is around the body, a vacuum in the open.
            outside: Option<Ref<Medium>>;
        }
        /// Lambert's: the same radiance in every direction.
        "diffuse" => Diffuse {
            /// The part of the light that is scattered back.
            albedo: Textured<Reflectance>;
            /// What it shines of itself. A surface with an emission is a lamp.
            emission: Radiance = "0 W/m^2/sr";
            /// Which of its sides shine.
            emits: Sides = "front";
        }
        /// A perfect mirror.
        "mirror" => Mirror {
            /// The part of the light that is given back.
            reflectance: Textured<Reflectance> = "1";
        }
    }
}

vocabulary! {
    /// Sides of a surface.
    pub words Sides: "choice of sides" {
        /// Its front alone.
        "front" => Front
        /// Its front and its back.
        "both" => Both
    }
}

impl Material {
    /// The part of light it gives back, if that is a field of it.
    pub fn reflectance(&self) -> Option<&At<Textured<Reflectance>>> {
        match self {
            Self::Diffuse(diffuse) => Some(&diffuse.albedo),
            Self::Mirror(mirror) => Some(&mirror.reflectance),
            Self::Conductor(_) | Self::Dielectric(_) => None,
        }
    }

    /// The texture it reads, if it reads one.
    pub fn texture(&self) -> Option<&Ref<Texture>> {
        self.reflectance().and_then(|reflectance| reflectance.texture())
    }

    /// What it shines of itself, if it can.
    pub fn emission(&self) -> Option<&At<Radiance>> {
        match self {
            Self::Diffuse(diffuse) => Some(&diffuse.emission),
            Self::Conductor(_) | Self::Dielectric(_) | Self::Mirror(_) => None,
        }
    }

    /// Whether it shines.
    pub fn shines(&self) -> bool {
        self.emission().is_some_and(|emission| !emission.0.is_zero())
    }

    /// Whether light goes through it.
    pub fn transmits(&self) -> bool {
        matches!(self, Self::Dielectric(_))
    }

    /// Whether light leaves it in all directions, and not in one alone.
    pub fn scatters(&self) -> bool {
        matches!(self, Self::Diffuse(_))
    }
}
