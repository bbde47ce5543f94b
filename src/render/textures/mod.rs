//! Textures: colours that differ from place to place of a surface, read once a hit.
//!
//! Prefiltering is left out: of what is smaller than a pixel, the samples of the pixel make the
//! mean.

mod checker;
mod image;
mod layout;

use std::sync::Arc;

use glam::DVec2;

pub use self::image::{Filter, Image, Wrap};
pub use checker::Checker;
pub use layout::Layout;

use crate::math::Rgb;

/// A colour of a surface.
#[derive(Clone, Debug, PartialEq)]
pub enum Colour {
    /// The same all over it.
    Plain(Rgb),
    /// By a texture.
    Texture(Arc<Texture>),
}

impl Colour {
    /// At these coordinates of a surface.
    #[inline]
    pub fn at(&self, uv: DVec2) -> Rgb {
        match self {
            Self::Plain(colour) => *colour,
            Self::Texture(texture) => texture.at(uv),
        }
    }
}

/// A texture, laid on by the coordinates of surfaces.
#[derive(Clone, Debug, PartialEq)]
pub enum Texture {
    /// Squares in turn.
    Checker(Checker),
    /// A picture.
    Image(Image),
}

impl Texture {
    fn at(&self, uv: DVec2) -> Rgb {
        match self {
            Self::Checker(checker) => checker.at(uv),
            Self::Image(image) => image.at(uv),
        }
    }
}
