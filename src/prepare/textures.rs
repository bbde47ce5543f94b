//! Textures of the scene → textures of the world, each once.

use std::collections::HashMap;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::materials::as_f32;
use crate::load::Stage;
use crate::optics::colour;
use crate::render::textures::{Checker, Colour, Layout, Texture};
use crate::scene::{self, Angle, Pair, Reflectance, Step, Textured};

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
            Textured::Plain(plain) => return Colour::Plain(as_f32(colour::reflected(&plain.0))),
            Textured::Texture(name) => name,
        };
        let texture = &self.stage.texture(name).texture;
        let known = self.known.entry(&texture.name.value);
        Colour::Texture(known.or_insert_with(|| Arc::new(made(&texture.value))).clone())
    }
}

fn made(texture: &scene::Texture) -> Texture {
    let reflected = |said: &Reflectance| as_f32(colour::reflected(&said.0));
    match texture {
        scene::Texture::Checker(checker) => Texture::Checker(Checker {
            layout: layout(&checker.squares, &checker.turn, &checker.offset),
            a: reflected(&checker.a),
            b: reflected(&checker.b),
        }),
    }
}

fn layout(times: &Pair, turn: &Angle, offset: &Pair) -> Layout {
    // As a step of a place: exact for quarter turns.
    let turned = Step::Rotate(DVec3::Z, turn.0).transform().vector(DVec3::X);
    let pair = |pair: &Pair| DVec2::from_array(pair.0);
    Layout::new(pair(times), (turned.x, turned.y), pair(offset))
}
