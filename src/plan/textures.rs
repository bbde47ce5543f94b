//! How much light surfaces give back at most, whatever their textures.

use crate::load::{Stage, StagedTexture};
use crate::math::srgb;
use crate::optics::colour;
use crate::scene::{Reflectance, Texture, Textured};

/// The largest of each channel, as rendered.
pub fn largest(stage: &Stage, reflectance: &Textured<Reflectance>) -> [f64; 3] {
    match reflectance {
        Textured::Plain(plain) => colour::reflected(&plain.0),
        Textured::Texture(name) => largest_of(stage.texture(name)),
    }
}

/// The same of a texture.
pub fn largest_of(staged: &StagedTexture) -> [f64; 3] {
    match &staged.texture.value.value {
        Texture::Checker(checker) => {
            let (a, b) = (colour::reflected(&checker.a.0), colour::reflected(&checker.b.0));
            std::array::from_fn(|i| a[i].max(b[i]))
        }
        Texture::Image(image) => {
            let tint = colour::reflected(&image.tint.0);
            let most = staged.texels.as_ref().map_or([0.0; 3], |texels| texels.largest());
            let encoded = staged.is_encoded();
            std::array::from_fn(|i| tint[i] * if encoded { srgb::decode(most[i]) } else { most[i] })
        }
    }
}
