//! How much light surfaces give back at most, whatever their textures.

use crate::load::Stage;
use crate::optics::colour;
use crate::scene::{Reflectance, Texture, Textured};

/// The largest of each channel, as rendered.
pub fn largest(stage: &Stage, reflectance: &Textured<Reflectance>) -> [f64; 3] {
    match reflectance {
        Textured::Plain(plain) => colour::reflected(&plain.0),
        Textured::Texture(name) => match &stage.texture(name).texture.value.value {
            Texture::Checker(checker) => {
                let (a, b) = (colour::reflected(&checker.a.0), colour::reflected(&checker.b.0));
                std::array::from_fn(|i| a[i].max(b[i]))
            }
        },
    }
}
