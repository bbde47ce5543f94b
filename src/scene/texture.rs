//! Textures: colours that differ from place to place of a surface.

use serde::Serialize;

use super::schema::{Checked, Range, Type, Vocabulary};
use super::vocabulary::vocabulary;
use super::{Angle, At, FileName, Pair, Ref, Reflectance};

vocabulary! {
    /// A colour that differs from place to place of a surface. It is laid on by the coordinates u
    /// and v of the surface: of a quad from 0 to 1 along each edge, of a sphere from 0 to 1 around
    /// it and from its lower pole to the upper, of a plane in `tile`s, of a disk from 0 to 1 over
    /// the square around it, of a mesh as its file has them.
    pub enum Texture: "texture" {
        /// Squares of two colours in turn.
        "checker" => Checker {
            /// The colour of the square above and right of the origin of the coordinates.
            a: Reflectance;
            /// The colour of its neighbours.
            b: Reflectance;
            /// How many squares there are in 1 of u, and of v.
            squares: Pair = "(1, 1)", Range::above(0.0);
            /// How far it is moved along u and v, after it was turned.
            offset: Pair = "(0, 0)";
            /// How far it is turned about the origin of the coordinates, from u to v.
            turn: Angle = "0 deg";
        }
        /// A picture from a file: PNG, JPEG, PNM, Radiance HDR or OpenEXR. It fills 1 of u and of
        /// v, its lower left corner at the origin of the coordinates. What the file says of
        /// gamma, profiles and orientation is not looked at; transparency is ignored, and told.
        "image" => Image {
            /// The file of the picture.
            file: FileName;
            /// How its values are encoded. Left out: `linear` for files of floating-point numbers,
            /// `srgb` for all others.
            encoding: Option<Encoding>;
            /// What lies beyond its edges.
            wrap: Wrap = "repeat";
            /// How it is read between the centres of its texels.
            filter: TextureFilter = "linear";
            /// What its colours are multiplied by.
            tint: Reflectance = "1";
            /// How often it is repeated in 1 of u, and of v.
            repeats: Pair = "(1, 1)", Range::above(0.0);
            /// How far it is moved along u and v, after it was turned.
            offset: Pair = "(0, 0)";
            /// How far it is turned about the origin of the coordinates, from u to v.
            turn: Angle = "0 deg";
        }
    }
}

vocabulary! {
    /// How values of a picture are encoded.
    pub words Encoding: "encoding" {
        /// For displays, by the curve of sRGB.
        "srgb" => Srgb
        /// Not at all: they are light, or parts of light.
        "linear" => Linear
    }
}

vocabulary! {
    /// What lies beyond the edges of a picture.
    pub words Wrap: "wrapping" {
        /// The picture again.
        "repeat" => Repeat
        /// The texels of its edge.
        "clamp" => Clamp
        /// The picture mirrored, and so on.
        "mirror" => Mirror
    }
}

vocabulary! {
    /// How a picture is read between the centres of its texels. What is smaller than a pixel is
    /// averaged by the samples of the pixel.
    pub words TextureFilter: "texture filter" {
        /// The texel that the place lies in.
        "nearest" => Nearest
        /// Between the four texels around it, in linear light.
        "linear" => Linear
    }
}

/// A quantity that is the same all over a surface, or differs by a texture.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Textured<T> {
    /// The same everywhere.
    Plain(T),
    /// As the texture says.
    Texture(Ref<Texture>),
}

impl<T> Textured<T> {
    /// The value, if it is the same everywhere.
    pub fn plain(&self) -> Option<&T> {
        match self {
            Self::Plain(value) => Some(value),
            Self::Texture(_) => None,
        }
    }

    /// The texture, if there is one.
    pub fn texture(&self) -> Option<&Ref<Texture>> {
        match self {
            Self::Plain(_) => None,
            Self::Texture(texture) => Some(texture),
        }
    }
}

impl<T: Vocabulary> Vocabulary for Textured<T> {
    const TYPE: Type = match (T::TYPE, <Ref<Texture> as Vocabulary>::TYPE) {
        (Type::Spectrum(of), Type::Reference { kind, target: Some(target) }) => {
            Type::Textured { of, kind, target }
        }
        _ => panic!("textures are of spectra"),
    };

    fn lower(checked: &Checked) -> Self {
        match checked {
            Checked::Reference(_) => Self::Texture(Ref::lower(checked)),
            plain => Self::Plain(T::lower(plain)),
        }
    }
}

impl Texture {
    /// The colours that it says: of a picture, what it is multiplied by.
    pub fn colours(&self) -> Vec<&At<Reflectance>> {
        match self {
            Self::Checker(checker) => vec![&checker.a, &checker.b],
            Self::Image(image) => vec![&image.tint],
        }
    }
}
