//! Textures of the stage → textures of the world, each once.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::errors::texture as errors;
use super::materials::as_f32;
use crate::bodies::{Body, Placed};
use crate::diag::Diagnostic;
use crate::load::{Stage, StagedTexture};
use crate::math::{Rgb, Texels, Values, srgb};
use crate::optics::colour;
use crate::render::textures::{Checker, Colour, Filter, Image, Layout, Texture, Wrap};
use crate::scene::{self, Angle, Pair, Reflectance, Step, TextureFilter, Textured};

/// Textures as they are asked for.
pub(super) struct Textures<'a> {
    pub stage: &'a Stage,
    known: HashMap<&'a str, Arc<Texture>>,
}

impl<'a> Textures<'a> {
    pub fn of(stage: &'a Stage) -> Self {
        Self { stage, known: HashMap::new() }
    }

    /// What a surface's colour becomes.
    pub fn colour(&mut self, said: &Textured<Reflectance>) -> Colour {
        let name = match said {
            Textured::Plain(plain) => return Colour::Plain(reflected(plain)),
            Textured::Texture(name) => name,
        };
        let staged = self.stage.texture(name);
        let known = self.known.entry(&staged.texture.name.value);
        Colour::Texture(known.or_insert_with(|| Arc::new(texture(staged))).clone())
    }
}

/// Finds meshes with a texture that they have no coordinates for; of each the first.
pub(super) fn check(bodies: &[Placed], found: &mut Vec<Diagnostic>) {
    for placed in bodies {
        let Body::Mesh { mesh, .. } = placed.body else { continue };
        let slots = placed.parts.iter().enumerate();
        let mut slots = slots.flat_map(|(slot, parts)| parts.iter().map(move |part| (slot, part)));
        found.extend(slots.find_map(|(slot, (_, material))| {
            let said = material.value.value.reflectance()?;
            let texture = said.texture()?;
            let without = mesh.without_coordinates(slot as u32);
            let counts = (without, mesh.triangles.len());
            let name = placed.name();
            (counts.0 > 0).then(|| errors::no_coordinates(name, &texture.name, said.span, counts))
        }));
    }
}

/// Memory of all pictures, in bytes; one that several textures share counts once.
pub(super) fn bytes(stage: &Stage) -> u64 {
    let mut seen = HashSet::new();
    let texels = stage.textures.iter().filter_map(|staged| staged.texels.as_ref());
    texels.filter(|texels| seen.insert(Arc::as_ptr(texels))).map(|it| it.bytes() as u64).sum()
}

fn texture(staged: &StagedTexture) -> Texture {
    match (&staged.texture.value.value, &staged.texels) {
        (scene::Texture::Checker(checker), _) => Texture::Checker(Checker {
            layout: layout(&checker.squares, &checker.turn, &checker.offset),
            a: reflected(&checker.a),
            b: reflected(&checker.b),
        }),
        (scene::Texture::Image(image), Some(texels)) => Texture::Image(Image {
            layout: layout(&image.repeats, &image.turn, &image.offset),
            texels: texels.clone(),
            decoded: decoded(texels, staged.is_encoded()),
            tint: reflected(&image.tint),
            wrap: match image.wrap.value {
                scene::Wrap::Repeat => Wrap::Repeat,
                scene::Wrap::Clamp => Wrap::Clamp,
                scene::Wrap::Mirror => Wrap::Mirror,
            },
            filter: match image.filter.value {
                TextureFilter::Nearest => Filter::Nearest,
                TextureFilter::Linear => Filter::Linear,
            },
        }),
        (scene::Texture::Image(_), None) => unreachable!("load reads the picture of each image"),
    }
}

fn reflected(said: &Reflectance) -> Rgb {
    as_f32(colour::reflected(&said.0))
}

/// What each value of a picture is worth, as light.
fn decoded(texels: &Texels, encoded: bool) -> Arc<[f32]> {
    let most: u16 = match &texels.values {
        Values::Grey8(_) | Values::Rgb8(_) => 255,
        Values::Grey16(_) | Values::Rgb16(_) => u16::MAX,
        Values::Float(_) => return Arc::new([]),
    };
    let worth = |value: u16| {
        let part = f64::from(value) / f64::from(most);
        if encoded { srgb::decode(part) as f32 } else { part as f32 }
    };
    (0..=most).map(worth).collect()
}

fn layout(times: &Pair, turn: &Angle, offset: &Pair) -> Layout {
    // As a step of a place: exact for quarter turns.
    let turned = Step::Rotate(DVec3::Z, turn.0).transform().vector(DVec3::X);
    let pair = |pair: &Pair| DVec2::from_array(pair.0);
    Layout::new(pair(times), (turned.x, turned.y), pair(offset))
}
