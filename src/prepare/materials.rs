//! Materials of the scene → materials of the world, with emission in light units.

use std::collections::{HashMap, HashSet};

use super::errors::scene as errors;
use super::textures::Textures;
use crate::bodies::{Matter, Placed};
use crate::diag::{Diagnostic, Span};
use crate::load::Stage;
use crate::math::{Rgb, Spectrum};
use crate::optics::{self, colour};
use crate::render::materials::{
    Conductor, Dielectric, Diffuse, Emission, Material, Mirror, Mixture, Surface,
};
use crate::render::overlaps::{Overlap, Overlaps};
use crate::scene::{self, Medium, Named};

/// The materials in use.
pub(super) struct Table {
    /// By number.
    pub all: Vec<Material>,
    /// What is known of each where bodies overlap, if any do.
    pub overlaps: Option<Overlaps>,
    /// For each placed object's slots, the media before it with the number of the material there.
    slots: Vec<Vec<Vec<(u32, u32)>>>,
}

/// Makes the table of all materials of these objects; a declaration is in it once, one that shines
/// once for each object.
pub(super) fn table(
    stage: &Stage,
    (bodies, matter): (&[Placed], &Matter),
    light_unit: f64,
    found: &mut Vec<Diagnostic>,
) -> Table {
    let mut textures = Textures::of(stage);
    let overlaps = (!matter.overlaps.is_empty())
        .then(|| Overlaps { camera: matter.overlaps.camera, materials: Vec::new() });
    let mut table = Table { all: Vec::new(), overlaps, slots: Vec::new() };
    // A material is known by the place of its declaration: its name alone may be used again by
    // another file of materials. One that shines makes a lamp of each object.
    // What is before it is part of what it is.
    let mut known: HashMap<(&str, Span, Option<u32>, u32), u32> = HashMap::new();
    let mut told: HashSet<(&str, Span)> = HashSet::new();
    for (rank, body) in bodies.iter().enumerate() {
        let mut slots = Vec::with_capacity(body.materials.len());
        for (slot, (named, parts)) in body.materials.iter().zip(&body.parts).enumerate() {
            let place = (named.name.value.as_str(), named.value.span);
            if told.insert(place) {
                check(named, parts, found);
            }
            let shines = parts.iter().any(|(_, part)| part.value.shines());
            let mut numbers = Vec::new();
            for before in matter.all_before(rank, slot) {
                let said = parts.iter().find_map(|(_, part)| part.value.value.sides());
                let inside = said.and_then(|(inside, _)| matter.number(&inside.name));
                let outside = said.is_some_and(|(_, outside)| outside.is_some());
                let overlap = inside.map_or(Overlap::default(), |inside| Overlap {
                    behind: matter.overlaps.bit(rank, inside),
                    before: if outside { matter.overlaps.bit(rank, before) } else { 0 },
                    hidden: matter.overlaps.hidden(rank, inside),
                    within: Vec::new(),
                });
                // Its own number for what shines, and where it overlaps.
                let own = shines || overlap != Overlap::default();
                let number = *known
                    .entry((place.0, place.1, own.then_some(body.number), before))
                    .or_insert(table.all.len() as u32);
                if number as usize == table.all.len() {
                    let ends = inside.map_or(Vec::new(), |it| matter.overlaps.ending_at(rank, it));
                    let mut add = |before: u32| {
                        let sides = Sides::of(matter, parts, before);
                        let made = material(&mut textures, named, parts, (light_unit, &sides));
                        table.all.push(made);
                        if let Some(overlaps) = &mut table.overlaps {
                            overlaps.materials.push(overlap.clone());
                        }
                        table.all.len() as u32 - 1
                    };
                    add(before);
                    let within = ends.into_iter().map(|(bit, medium)| (bit, add(medium))).collect();
                    if let Some(overlaps) = &mut table.overlaps {
                        overlaps.materials[number as usize].within = within;
                    }
                }
                numbers.push((before, number));
            }
            slots.push(numbers);
        }
        table.slots.push(slots);
    }
    table
}

impl Table {
    /// The number of the material of a placed object's slot, where there is this medium before it.
    pub fn number(&self, rank: usize, slot: usize, before: u32) -> u32 {
        let all = &self.slots[rank][slot];
        let found = all.iter().find(|(medium, _)| *medium == before);
        found.expect("one for each medium before it").1
    }

    /// The radiance of surfaces of this material, in light units, and whether both sides have it;
    /// None if they are no lamps.
    pub fn emission(&self, number: u32) -> Option<(Rgb, bool)> {
        let Emission { radiance, both } = self.all[number as usize].emission;
        (!radiance.is_black()).then_some((radiance, both))
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
    (light_unit, sides): (f64, &Sides),
) -> Material {
    let mut emission = Emission { radiance: Rgb::BLACK, both: false };
    for (share, part) in parts {
        if let Some((radiance, emits)) = part.value.glow() {
            emission.radiance += in_units(&radiance.0.scaled(*share), light_unit);
            emission.both |= part.value.shines() && emits.value == scene::Sides::Both;
        }
    }
    let surface = surface(textures, named, sides);
    Material { surface, emission, before: sides.before, behind: sides.behind }
}

/// What is on the sides of a surface.
struct Sides {
    before: u32,
    behind: Option<u32>,
    /// Their indices of refraction; behind an opaque surface there is none.
    indices: [f64; 2],
}

impl Sides {
    fn of(matter: &Matter, parts: &[Share], before: u32) -> Self {
        let inside = parts.iter().find_map(|(_, part)| part.value.value.sides());
        let behind = inside.and_then(|(inside, _)| matter.number(&inside.name));
        let indices = [index(matter, before), behind.map_or(1.0, |behind| index(matter, behind))];
        Self { before, behind, indices }
    }
}

fn surface(textures: &mut Textures, material: &Named<scene::Material>, sides: &Sides) -> Surface {
    let stage = textures.stage;
    match &material.value.value {
        scene::Material::Conductor(conductor) => Surface::Conductor(metal(&conductor.ior, sides)),
        scene::Material::Dielectric(_) => {
            let [outside, inside] = sides.indices;
            Surface::Dielectric(Dielectric { inside, outside })
        }
        scene::Material::Diffuse(diffuse) => {
            Surface::Diffuse(Diffuse { albedo: textures.colour(&diffuse.albedo) })
        }
        scene::Material::Mirror(mirror) => {
            Surface::Mirror(Mirror { reflectance: textures.colour(&mirror.reflectance) })
        }
        scene::Material::Mix(_) => {
            let parts = stage.scene.parts(material).into_iter();
            let part = |(share, part): Share| (share as f32, surface(textures, part, sides));
            Surface::Mixture(Mixture { parts: parts.map(part).collect() })
        }
    }
}

fn metal(ior: &scene::Index, sides: &Sides) -> Conductor {
    // Light comes from what is before it: its own index there is the quotient of both.
    let against = 1.0 / sides.indices[0];
    let (n, k) = (ior.n.scaled(against), ior.k.scaled(against));
    match optics::metal::by_angle(&n, &k) {
        Some(table) => Conductor::Table(table.into_iter().map(as_f32).collect()),
        None => Conductor::Channels { n: colour::reflected(&n), k: colour::reflected(&k) },
    }
}

/// The index of refraction of a medium at the middle of the visible range.
fn index(matter: &Matter, medium: u32) -> f64 {
    match matter.media[medium as usize].map(|medium| &medium.value.value) {
        Some(Medium::Homogeneous(medium)) => optics::at(&medium.ior.n, optics::MIDDLE),
        None => 1.0,
    }
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
