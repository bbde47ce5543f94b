//! Family `texture`: what is wrong between textures and the surfaces they lie on.

use crate::diag::{Code, Diagnostic, Span};
use crate::scene::At;

/// A texture on a mesh that says nothing of where it lies. `at` is where the texture is named;
/// `without` of `all` triangles of the mesh have the texture and no
/// coordinates.
pub fn no_coordinates(
    object: &At<String>,
    texture: &str,
    at: Span,
    (without, all): (usize, usize),
) -> Diagnostic {
    let some = without < all;
    let have = if without == 1 { "has" } else { "have" };
    let part = if some { "parts of the mesh" } else { "the mesh" };
    let headline = format!(
        "{part} `{}` {} no coordinates for the texture `{texture}`",
        **object,
        if some { "have" } else { "has" }
    );
    let told = Diagnostic::error(Code::TEXTURE_NO_COORDINATES, headline)
        .label(at, "this texture lies on the mesh")
        .label(object.span, "whose file does not say where");
    let told = match some {
        true => told.why(format!(
            "{without} of its {all} triangles {have} this texture and no `vt` at some corner."
        )),
        false => told.why("The faces of its .obj file name no `vt`."),
    };
    told.help(
        "export the mesh with its texture coordinates, or give it a material without a texture",
    )
}
