//! Materials of the scene → materials of the world, with emission in light units.

use std::collections::{BTreeMap, HashMap};

use super::objects::Placed;
use super::textures::Textures;
use crate::diag::Span;
use crate::load::Stage;
use crate::math::{Rgb, Spectrum};
use crate::optics::{self, colour};
use crate::render::materials::{Conductor, Dielectric, Diffuse, Material, Mirror};
use crate::scene::{self, Medium, Ref, Scene, Sides};

/// The materials in use.
pub(super) struct Table {
    /// By number.
    pub all: Vec<Material>,
    /// Numbers of each object's slots.
    slots: BTreeMap<u32, Vec<u32>>,
}

/// Makes the table of all materials of these objects; a declaration is in it once, one that shines
/// once for each object.
pub(super) fn table(stage: &Stage, bodies: &[Placed], light_unit: f64) -> Table {
    let mut textures = Textures::of(stage);
    let mut table = Table { all: Vec::new(), slots: BTreeMap::new() };
    // A material is known by the place of its declaration: its name alone may be used again by
    // another file of materials. One that shines makes a lamp of each object.
    let mut known: HashMap<(&str, Span, Option<u32>), u32> = HashMap::new();
    for body in bodies {
        let mut slots = Vec::with_capacity(body.materials.len());
        for named in &body.materials {
            let number = *known
                .entry((
                    named.name.value.as_str(),
                    named.value.span,
                    named.value.shines().then_some(body.number),
                ))
                .or_insert(table.all.len() as u32);
            if number as usize == table.all.len() {
                table.all.push(material(&mut textures, &named.value, light_unit));
            }
            slots.push(number);
        }
        table.slots.insert(body.number, slots);
    }
    table
}

impl Table {
    /// The number of the material of an object's slot.
    pub fn number(&self, object: u32, slot: usize) -> u32 {
        self.slots[&object][slot]
    }

    /// The radiance of surfaces of this material, in light units, and whether both sides have it;
    /// None if they are no lamps.
    pub fn emission(&self, number: u32) -> Option<(Rgb, bool)> {
        match &self.all[number as usize] {
            Material::Diffuse(diffuse) if !diffuse.emission.is_black() => {
                Some((diffuse.emission, diffuse.both))
            }
            _ => None,
        }
    }
}

fn material(textures: &mut Textures, material: &scene::Material, light_unit: f64) -> Material {
    let scene = &*textures.stage.scene;
    match material {
        scene::Material::Conductor(conductor) => Material::Conductor(Conductor {
            n: channels(&conductor.ior.n),
            k: channels(&conductor.ior.k),
        }),
        scene::Material::Dielectric(dielectric) => Material::Dielectric(Dielectric {
            inside: index(scene, &dielectric.inside),
            outside: dielectric.outside.as_ref().map_or(1.0, |medium| index(scene, medium)),
        }),
        scene::Material::Mirror(mirror) => {
            Material::Mirror(Mirror { reflectance: textures.colour(&mirror.reflectance) })
        }
        scene::Material::Diffuse(diffuse) => Material::Diffuse(Diffuse {
            albedo: textures.colour(&diffuse.albedo),
            emission: in_units(&diffuse.emission.0, light_unit),
            both: diffuse.emits.value == Sides::Both,
        }),
    }
}

/// A part of an index of refraction for each channel.
fn channels(of: &Spectrum) -> [f32; 3] {
    match of {
        Spectrum::Rgb(channels) => channels.map(|channel| channel as f32),
        other => PRIMARIES.map(|nm| optics::at(other, nm) as f32),
    }
}

/// Wavelengths in nm that look like the primaries of sRGB.
const PRIMARIES: [f64; 3] = [611.4, 549.1, 464.3];

/// The index of refraction of a medium at the middle of the visible range.
fn index(scene: &Scene, medium: &Ref<Medium>) -> f64 {
    let Medium::Homogeneous(medium) = &scene.medium(medium).value.value;
    optics::at(&medium.ior.n, MIDDLE)
}

/// Wavelength of the yellow line of helium, at which indices are told in catalogues, in nm.
const MIDDLE: f64 = 587.6;

/// What light a spectrum is, in light units.
pub(super) fn in_units(spectrum: &Spectrum, light_unit: f64) -> Rgb {
    as_f32(colour::emitted(spectrum).map(|channel| channel / light_unit))
}

/// Channels as render has them.
pub(super) fn as_f32(channels: [f64; 3]) -> Rgb {
    let [r, g, b] = channels.map(|channel| channel as f32);
    Rgb::new(r, g, b)
}
