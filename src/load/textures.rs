//! Textures: what they say, and the pictures that they name.

use std::sync::Arc;

use super::errors::texture as errors;
use super::files::{Asked, Shelf};
use super::loader::Used;
use super::{StagedFile, StagedTexture};
use crate::diag::Diagnostic;
use crate::math::{Texels, Values};
use crate::scene::{Encoding, Named, Texture};

/// What staging a texture works with.
pub(super) struct Desk<'a, 'p> {
    pub shelf: &'a mut Shelf<'p>,
    pub found: &'a mut Vec<Diagnostic>,
    pub used: &'a mut Vec<Used>,
}

impl Desk<'_, '_> {
    /// Reads what a texture names. None: there is an error, which was told.
    pub fn stage(&mut self, texture: &Named<Texture>) -> Option<StagedTexture> {
        let texels = match &texture.value.value {
            Texture::Checker(_) => None,
            Texture::Image(image) => {
                let span = image.file.span;
                let asked = Asked { name: &image.file.text, path: &image.file.path, span };
                let texels = self.texels(asked)?;
                if image.encoding.value == Some(Encoding::Srgb) && is_linear(&texels) {
                    let at = (image.encoding.span, span);
                    self.found.push(errors::encoded_floats(asked.name, at));
                    return None;
                }
                Some(texels)
            }
        };
        Some(StagedTexture { texture: texture.clone(), texels })
    }

    /// The texels of a file.
    fn texels(&mut self, asked: Asked) -> Option<Arc<Texels>> {
        let picture = self.shelf.picture(asked, self.found)?;
        let file = StagedFile {
            name: asked.name.to_string(),
            path: asked.path.to_path_buf(),
            span: asked.span,
            bytes: picture.bytes,
            triangles: None,
        };
        Used::note(self.used, file, picture.digest);
        Some(picture.texels.clone())
    }
}

/// Whether a file's values are light itself, with nothing to decode.
fn is_linear(texels: &Texels) -> bool {
    matches!(texels.values, Values::Float(_))
}
