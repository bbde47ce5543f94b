//! Materials: what a surface does with light.

use std::collections::HashMap;

use super::schema::Range;
use super::vocabulary::vocabulary;
use super::{
    At, Index, Medium, Named, Number, Radiance, Ref, Reflectance, Scene, Texture, Textured,
};
use crate::math::paths::Event;

vocabulary! {
    /// What a surface does with light.
    pub enum Material: "material" {
        /// Smooth metal: reflects by Fresnel's formulas for a complex index of refraction.
        "conductor" => Conductor {
            /// Its index of refraction, `metal.gold` or `complex(n, k)`.
            ior: Index;
            /// What it shines of itself. A surface with an emission is a lamp.
            emission: Radiance = "0 W/m^2/sr";
            /// Which of its sides shine.
            emits: Sides = "front";
        }
        /// A smooth surface of clear matter, such as glass: reflects and refracts by Fresnel's
        /// formulas.
        "dielectric" => Dielectric {
            /// What is behind the face.
            inside: Ref<Medium>;
            /// What is before it. Left out: what is inside of the innermost body around the surface,
            /// and `surroundings` where there is none.
            outside: Option<Ref<Medium>>;
        }
        /// Lambert's: the same radiance in every direction.
        "diffuse" => Diffuse {
            /// The part of the light that is scattered back.
            albedo: Textured<Reflectance>;
            /// What it shines of itself, the same all over. A surface with an emission is a lamp.
            emission: Radiance = "0 W/m^2/sr";
            /// Which of its sides shine.
            emits: Sides = "front";
        }
        /// A perfect mirror.
        "mirror" => Mirror {
            /// The part of the light that is given back.
            reflectance: Textured<Reflectance> = "1";
            /// What it shines of itself. A surface with an emission is a lamp.
            emission: Radiance = "0 W/m^2/sr";
            /// Which of its sides shine.
            emits: Sides = "front";
        }
        /// Two materials in one surface, too fine to be told apart: of every part of it, however
        /// small, `amount` is the second, and the rest the first. It shines what they shine.
        "mix" => Mix {
            /// One of the two; it may be a mixture itself.
            first: Ref<Material>;
            /// The other.
            second: Ref<Material>;
            /// The part of the surface that is the second.
            amount: Number, Range::between(0.0, 1.0);
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
            Self::Conductor(_) | Self::Dielectric(_) | Self::Mix(_) => None,
        }
    }

    /// The texture it reads, if it reads one.
    pub fn texture(&self) -> Option<&Ref<Texture>> {
        self.reflectance().and_then(|reflectance| reflectance.texture())
    }

    /// What it shines of itself, and on which sides, if that is a field of it.
    pub fn glow(&self) -> Option<(&At<Radiance>, &At<Sides>)> {
        match self {
            Self::Conductor(conductor) => Some((&conductor.emission, &conductor.emits)),
            Self::Diffuse(diffuse) => Some((&diffuse.emission, &diffuse.emits)),
            Self::Mirror(mirror) => Some((&mirror.emission, &mirror.emits)),
            Self::Dielectric(_) | Self::Mix(_) => None,
        }
    }

    /// What it shines of itself, if that is a field of it.
    pub fn emission(&self) -> Option<&At<Radiance>> {
        self.glow().map(|(emission, _)| emission)
    }

    /// Whether it shines; what a mixture is made of is not looked at.
    pub fn shines(&self) -> bool {
        self.emission().is_some_and(|emission| !emission.0.is_zero())
    }

    /// The medium behind it, and the one before it where that is said, if light goes through it.
    pub fn sides(&self) -> Option<(&Ref<Medium>, Option<&Ref<Medium>>)> {
        match self {
            Self::Dielectric(it) => Some((&it.inside.value, it.outside.as_ref())),
            _ => None,
        }
    }

    /// Whether light goes through it.
    pub fn transmits(&self) -> bool {
        matches!(self, Self::Dielectric(_))
    }

    /// What it does with light; of a mixture its parts say it.
    pub fn events(&self) -> &'static [Event] {
        match self {
            Self::Conductor(_) | Self::Mirror(_) => &[Event::SpecularReflection],
            Self::Dielectric(_) => &[Event::SpecularReflection, Event::SpecularTransmission],
            Self::Diffuse(_) => &[Event::DiffuseReflection],
            Self::Mix(_) => &[],
        }
    }

    /// Whether light leaves it in all directions, and not in one alone.
    pub fn scatters(&self) -> bool {
        matches!(self, Self::Diffuse(_))
    }
}

/// Materials and the part of each.
type Parts<'a> = Vec<(f64, &'a Named<Material>)>;

impl Scene {
    /// What a material is made of, and the part of each: of a mixture what is no mixture itself,
    /// each once, in the order of their first mention, without those of which there is nothing; of
    /// another material that alone.
    pub fn parts<'a>(&'a self, material: &'a Named<Material>) -> Parts<'a> {
        self.looked_up(material, &mut HashMap::new())
    }

    /// The same, with what is known of mixtures within it.
    fn looked_up<'a>(
        &'a self,
        material: &'a Named<Material>,
        known: &mut HashMap<&'a str, Parts<'a>>,
    ) -> Parts<'a> {
        let Material::Mix(mix) = &material.value.value else { return vec![(1.0, material)] };
        let mut all: Parts = Vec::new();
        for (share, name) in [(1.0 - mix.amount.0, &mix.first), (mix.amount.0, &mix.second)] {
            if share == 0.0 {
                continue;
            }
            let parts = match known.get(name.name.as_str()) {
                Some(parts) => parts.clone(),
                None => {
                    let parts = self.looked_up(self.material(name), known);
                    known.insert(&name.name, parts.clone());
                    parts
                }
            };
            for (part, material) in parts {
                match all.iter_mut().find(|(_, other)| std::ptr::eq(*other, material)) {
                    Some((sum, _)) => *sum += share * part,
                    None => all.push((share * part, material)),
                }
            }
        }
        all
    }
}
