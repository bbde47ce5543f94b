//! Materials of .mtl files by their model of illumination, `illum`.
//!
//! 0, 1 and 2 are diffuse; 3 and 8 a mirror of reflectance Ks; 4 to 7 and 9 glass of index Ni; 11 the metal
//! that the material is called after; 12 to 14 the medium of the scene that it is called after.

use super::errors::mtl as errors;
use super::materials::Place;
use crate::data::{Figures, shelf};
use crate::diag::{Diagnostic, Span};
use crate::files::mtl;
use crate::math::{Spectrum, Table};
use crate::scene::{
    At, Conductor, Dielectric, Diffuse, Homogeneous, Index, Material, Medium, Mirror, Named,
    Radiance, Ref, Reflectance, Scene, Sides, Texture, Textured,
};

/// What a model of illumination is taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Model {
    /// Kd is the albedo.
    Diffuse,
    /// Ks is the reflectance.
    Mirror,
    /// Clear matter of index Ni.
    Glass,
    /// A metal of the shelf.
    Metal,
    /// A medium of the scene.
    Medium,
}

impl Model {
    pub fn of(said: &mtl::Material) -> Self {
        match said.illum.as_ref().map(|illum| illum.value) {
            Some(3 | 8) => Self::Mirror,
            Some(4..=7 | 9) => Self::Glass,
            Some(11) => Self::Metal,
            Some(12..=14) => Self::Medium,
            _ => Self::Diffuse,
        }
    }

    /// Whether light goes through it.
    pub fn is_clear(self) -> bool {
        matches!(self, Self::Glass | Self::Medium)
    }
}

/// What surrounds a material: whose it is, and what it may name.
pub(super) struct Context<'a> {
    pub scene: &'a Scene,
    /// Name of the .mtl file.
    pub file: &'a str,
    /// Where a mesh names the file it comes from.
    pub field: Span,
    pub at: Place,
    /// Media that no scene declares.
    pub media: &'a mut Vec<Named<Medium>>,
}

impl Context<'_> {
    /// As the scene would have said it: `emission` is what it shines if it is opaque, `texture`
    /// its albedo if it is diffuse and has one.
    pub fn material(
        &mut self,
        said: &mtl::Material,
        emission: At<Radiance>,
        texture: Option<At<Ref<Texture>>>,
    ) -> Result<Material, Box<Diagnostic>> {
        let whole = self.at.span(&said.name);
        let emits = At::new(Sides::Front, whole);
        Ok(match Model::of(said) {
            Model::Diffuse => {
                let plain = || self.colour(&said.diffuse);
                let albedo = texture.map(|texture| texture.map(Textured::Texture)).or_else(plain);
                let albedo = albedo.unwrap_or_else(|| At::new(black(), whole));
                Material::Diffuse(Diffuse { albedo, emission, emits })
            }
            Model::Mirror => {
                let reflectance = self.colour(&said.specular);
                let reflectance = reflectance.ok_or_else(|| {
                    Box::new(errors::no_mirror_colour(&said.name.value, whole, self.field))
                })?;
                Material::Mirror(Mirror { reflectance, emission, emits })
            }
            Model::Glass => {
                let inside = self.glass(said)?;
                Material::Dielectric(Dielectric { inside, outside: At::new(None, whole) })
            }
            Model::Metal => {
                Material::Conductor(Conductor { ior: self.metal(said)?, emission, emits })
            }
            Model::Medium => {
                let (outside, inside) = match said.name.value.split_once("_to_") {
                    Some((outside, inside)) => (Some(outside), inside),
                    None => (None, said.name.value.as_str()),
                };
                let inside = At::new(self.medium(inside, whole)?, whole);
                let outside = outside.map(|name| self.medium(name, whole)).transpose()?;
                Material::Dielectric(Dielectric { inside, outside: At::new(outside, whole) })
            }
        })
    }

    fn colour(&self, said: &Option<mtl::Said<[f64; 3]>>) -> Option<At<Textured<Reflectance>>> {
        let plain = |rgb| Textured::Plain(Reflectance(Spectrum::Rgb(rgb)));
        said.as_ref().map(|said| At::new(plain(said.value), self.at.span(said)))
    }

    /// A medium of its own for clear matter of index Ni.
    fn glass(&mut self, said: &mtl::Material) -> Result<At<Ref<Medium>>, Box<Diagnostic>> {
        let (name, whole) = (&said.name.value, self.at.span(&said.name));
        let Some(index) = said.index.as_ref().filter(|index| index.value > 0.0) else {
            return Err(Box::new(errors::no_index(name, whole, self.field)));
        };
        let at = self.at.span(index);
        let ior = Index { n: Spectrum::Constant(index.value), k: Spectrum::Constant(0.0) };
        let medium = Medium::Homogeneous(Homogeneous::clear(At::new(ior, at)));
        let mut called = format!("{}: {name}", self.file);
        loop {
            let taken = |other: &&Named<Medium>| other.name.value == called;
            match self.scene.media.iter().chain(&*self.media).find(taken) {
                Some(other) if other.value.value == medium => break,
                Some(_) => called.push('\''),
                None => {
                    let name = At::new(called.clone(), whole);
                    self.media.push(Named { name, value: At::new(medium, at) });
                    break;
                }
            }
        }
        Ok(At::new(Ref::new(called), at))
    }

    fn metal(&self, said: &mtl::Material) -> Result<At<Index>, Box<Diagnostic>> {
        let (name, whole) = (said.name.value.as_str(), self.at.span(&said.name));
        let metals = shelf("metal").expect("a shelf");
        let rows = metals.find(name).map(|datum| datum.figures);
        let Some(Figures::Metal(rows)) = rows else {
            let known: Vec<_> = metals.data().map(|datum| datum.word).collect();
            return Err(Box::new(errors::no_such_metal(name, &known, whole, self.field)));
        };
        let column = |i: usize| {
            let nodes = rows().iter().map(|row| (row[0], row[i])).collect();
            Spectrum::Table(Table::new(nodes).expect("wavelengths rise"))
        };
        Ok(At::new(Index { n: column(1), k: column(2) }, whole))
    }

    fn medium(&self, name: &str, at: Span) -> Result<Ref<Medium>, Box<Diagnostic>> {
        let all = &self.scene.media;
        match all.iter().any(|medium| medium.name.value == name) {
            true => Ok(Ref::new(name)),
            false => {
                let known: Vec<_> = all.iter().map(|medium| medium.name.value.as_str()).collect();
                Err(Box::new(errors::no_such_medium(name, &known, at, self.field)))
            }
        }
    }
}

fn black() -> Textured<Reflectance> {
    Textured::Plain(Reflectance(Spectrum::Rgb([0.0; 3])))
}
