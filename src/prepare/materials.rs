//! Materials of the scene → materials of the world, with emission in light units.

use std::collections::{BTreeMap, HashMap};

use super::objects::Placed;
use crate::diag::Span;
use crate::math::{Rgb, Spectrum};
use crate::optics::colour;
use crate::render::materials::{Diffuse, Material};
use crate::scene;

/// The materials in use.
pub(super) struct Table {
    /// By number.
    pub all: Vec<Material>,
    /// Numbers of each object's slots.
    slots: BTreeMap<u32, Vec<u32>>,
}

/// Makes the table of all materials of these objects; a declaration is in it once.
pub(super) fn table(bodies: &[Placed], light_unit: f64) -> Table {
    let mut table = Table { all: Vec::new(), slots: BTreeMap::new() };
    // A material is known by the place of its declaration: its name alone may be used again by
    // another file of materials.
    let mut known: HashMap<(&str, Span), u32> = HashMap::new();
    for body in bodies {
        let mut slots = Vec::with_capacity(body.materials.len());
        for named in &body.materials {
            let number = *known
                .entry((named.name.value.as_str(), named.value.span))
                .or_insert(table.all.len() as u32);
            if number as usize == table.all.len() {
                table.all.push(material(&named.value, light_unit));
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

    /// Whether surfaces of this material are lamps.
    pub fn shines(&self, number: u32) -> bool {
        !self.all[number as usize].emission().is_black()
    }
}

fn material(material: &scene::Material, light_unit: f64) -> Material {
    match material {
        scene::Material::Diffuse(diffuse) => Material::Diffuse(Diffuse {
            albedo: as_f32(colour::reflected(&diffuse.albedo.0)),
            emission: in_units(&diffuse.emission.0, light_unit),
        }),
    }
}

/// What light a spectrum is, in light units.
pub(super) fn in_units(spectrum: &Spectrum, light_unit: f64) -> Rgb {
    as_f32(colour::emitted(spectrum).map(|channel| channel / light_unit))
}

fn as_f32(channels: [f64; 3]) -> Rgb {
    let [r, g, b] = channels.map(|channel| channel as f32);
    Rgb::new(r, g, b)
}
