//! Materials of the scene → materials of the world, with emission in light units.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::errors::scene as errors;
use super::textures::Textures;
use crate::bodies::Placed;
use crate::diag::{Diagnostic, Span};
use crate::load::Stage;
use crate::math::{Rgb, Spectrum};
use crate::optics::{self, colour};
use crate::render::materials::{
    Conductor, Dielectric, Diffuse, Emission, Material, Mirror, Mixture, Surface,
};
use crate::scene::{self, Medium, Named, Ref, Sides};

/// The materials in use.
pub(super) struct Table {
    /// By number.
    pub all: Vec<Material>,
    /// Numbers of each object's slots.
    slots: BTreeMap<u32, Vec<u32>>,
}

/// Makes the table of all materials of these objects; a declaration is in it once, one that shines
/// once for each object.
pub(super) fn table(
    stage: &Stage,
    bodies: &[Placed],
    light_unit: f64,
    found: &mut Vec<Diagnostic>,
) -> Table {
    let mut textures = Textures::of(stage);
    let mut table = Table { all: Vec::new(), slots: BTreeMap::new() };
    // A material is known by the place of its declaration: its name alone may be used again by
    // another file of materials. One that shines makes a lamp of each object.
    let mut known: HashMap<(&str, Span, Option<u32>), u32> = HashMap::new();
    let mut told: HashSet<(&str, Span)> = HashSet::new();
    check_media(stage, bodies, found);
    for body in bodies {
        let mut slots = Vec::with_capacity(body.materials.len());
        for (named, parts) in body.materials.iter().zip(&body.parts) {
            let place = (named.name.value.as_str(), named.value.span);
            if told.insert(place) {
                check(named, parts, found);
            }
            let shines = parts.iter().any(|(_, part)| part.value.shines());
            let number = *known
                .entry((place.0, place.1, shines.then_some(body.number)))
                .or_insert(table.all.len() as u32);
            if number as usize == table.all.len() {
                table.all.push(material(&mut textures, named, parts, light_unit));
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
        let Emission { radiance, both } = self.all[number as usize].emission;
        (!radiance.is_black()).then_some((radiance, both))
    }
}

/// What of media in use cannot be rendered.
fn check_media(stage: &Stage, bodies: &[Placed], found: &mut Vec<Diagnostic>) {
    let mut told: HashSet<&str> = HashSet::new();
    for (_, part) in bodies.iter().flat_map(|body| body.parts.iter().flatten()) {
        let scene::Material::Dielectric(dielectric) = &part.value.value else { continue };
        for name in [Some(&dielectric.inside.value), dielectric.outside.as_ref()] {
            let Some(medium) = name.map(|name| stage.medium(name)) else { continue };
            let Medium::Homogeneous(homogeneous) = &medium.value.value;
            if homogeneous.ior.absorbs() && told.insert(&medium.name.value) {
                found.push(errors::absorbing_medium(medium, homogeneous.ior.span));
            }
        }
    }
}

/// What of a mixture cannot be: its parts are materials, and the part of each.
fn check(mixture: &Named<scene::Material>, parts: &[Share], found: &mut Vec<Diagnostic>) {
    let mut shining = parts.iter().filter(|(_, part)| part.value.shines());
    if let Some((_, first)) = shining.next() {
        let sides = |part: &Named<scene::Material>| part.value.glow().map(|(_, emits)| emits.value);
        if let Some((_, other)) = shining.find(|(_, part)| sides(part) != sides(first)) {
            found.push(errors::mixed_sides(mixture, first, other));
        }
    }
    let dielectric = |(_, part): &Share| match &part.value.value {
        scene::Material::Dielectric(dielectric) => {
            Some((dielectric.inside.value.clone(), dielectric.outside.value.clone()))
        }
        _ => None,
    };
    let mut clear = parts.iter().filter(|part| dielectric(part).is_some());
    if let Some(first) = clear.next()
        && let Some(other) = clear.find(|other| dielectric(other) != dielectric(first))
    {
        found.push(errors::mixed_insides(mixture, first.1, other.1));
    }
}

/// A material, and which part of a mixture it is.
type Share<'a> = (f64, &'a Named<scene::Material>);

fn material(
    textures: &mut Textures,
    named: &Named<scene::Material>,
    parts: &[Share],
    light_unit: f64,
) -> Material {
    let mut emission = Emission { radiance: Rgb::BLACK, both: false };
    for (share, part) in parts {
        if let Some((radiance, emits)) = part.value.glow() {
            emission.radiance += in_units(&radiance.0.scaled(*share), light_unit);
            emission.both |= part.value.shines() && emits.value == Sides::Both;
        }
    }
    Material { surface: surface(textures, named), emission }
}

fn surface(textures: &mut Textures, material: &Named<scene::Material>) -> Surface {
    let stage = textures.stage;
    match &material.value.value {
        scene::Material::Conductor(conductor) => Surface::Conductor(metal(&conductor.ior)),
        scene::Material::Dielectric(dielectric) => Surface::Dielectric(Dielectric {
            inside: index(stage, &dielectric.inside),
            outside: dielectric.outside.as_ref().map_or(1.0, |medium| index(stage, medium)),
        }),
        scene::Material::Diffuse(diffuse) => {
            Surface::Diffuse(Diffuse { albedo: textures.colour(&diffuse.albedo) })
        }
        scene::Material::Mirror(mirror) => {
            Surface::Mirror(Mirror { reflectance: textures.colour(&mirror.reflectance) })
        }
        scene::Material::Mix(_) => {
            let parts = stage.scene.parts(material).into_iter();
            let part = |(share, part): Share| (share as f32, surface(textures, part));
            Surface::Mixture(Mixture { parts: parts.map(part).collect() })
        }
    }
}

fn metal(ior: &scene::Index) -> Conductor {
    match optics::metal::by_angle(&ior.n, &ior.k) {
        Some(table) => Conductor::Table(table.into_iter().map(as_f32).collect()),
        None => Conductor::Channels { n: colour::reflected(&ior.n), k: colour::reflected(&ior.k) },
    }
}

/// The index of refraction of a medium at the middle of the visible range.
fn index(stage: &Stage, medium: &Ref<Medium>) -> f64 {
    let Medium::Homogeneous(medium) = &stage.medium(medium).value.value;
    optics::at(&medium.ior.n, optics::MIDDLE)
}

/// What light a spectrum is, in light units.
pub(super) fn in_units(spectrum: &Spectrum, light_unit: f64) -> Rgb {
    as_f32(colour::emitted(spectrum).map(|channel| channel / light_unit))
}

/// Channels as render has them.
pub(super) fn as_f32(channels: [f64; 3]) -> Rgb {
    let [r, g, b] = channels.map(|channel| channel as f32);
    Rgb::new(r, g, b)
}
