//! Family `matter`: media that cannot be rendered.

use crate::diag::{Code, Diagnostic, Span};
use crate::scene::At;

/// A medium in which something happens to light that no integrator follows; `index`: it is said by
/// an index with an imaginary part.
pub fn not_followed(medium: &At<String>, at: Span, does: &str, index: bool) -> Diagnostic {
    let headline = format!("the medium `{}` {does} light, which is not rendered yet", **medium);
    Diagnostic::error(Code::MATTER_NOT_FOLLOWED, headline)
        .label(at, "light would not go through it straight and whole")
        .why("So far every integrator follows light from surface to surface, through clear matter alone.")
        .help(match index {
            true => "write an index without its imaginary part to see the medium clear; for metal write `material NAME: conductor { ior: … }` with this index",
            false => "to see the medium clear leave this field out, or write `0 / m`; in place of a medium of the shelf write one of its index alone, such as `homogeneous { ior: 1.333 }`",
        })
}

/// A body of clear matter that is so few steps of single precision across: less than `least`.
pub fn too_small(name: &At<String>, steps: f64, least: f64) -> Diagnostic {
    let headline =
        format!("`{}` is too small beside the rest of the scene to be rendered as clear", **name);
    Diagnostic::error(Code::MATTER_TOO_SMALL, headline)
        .label(name.span, format!("{steps:.0} steps of single precision across; {least} is least"))
        .why("Single precision tells positions apart to one part in 16 million of the distance from the middle of the scene. Rays would miss the far side of so small a body, and their light be lost.")
        .help("check its unit; or leave out what makes the scene so large")
}

/// A body of clear matter that loses triangles to rounding, and is not closed any more.
pub fn lost_triangles(name: &At<String>, lost: u64, of: usize) -> Diagnostic {
    let headline =
        format!("`{}` loses {lost} of {of} triangles to rounding, and is not closed", **name);
    Diagnostic::error(Code::MATTER_TOO_SMALL, headline)
        .label(name.span, "too small or too thin there to be rendered as clear")
        .why("Beside the size of the whole scene their corners coincide, or lie on a line, in single precision. Light that goes in there would never come out.")
        .help("check its unit, and the factors of `scale`; or leave out what makes the scene so large")
}

/// A medium whose absorption is said in two ways.
pub fn absorbs_twice(medium: &At<String>, index: Span, absorption: Span) -> Diagnostic {
    let headline = format!("the absorption of the medium `{}` is said twice", **medium);
    Diagnostic::error(Code::MATTER_ABSORBS_TWICE, headline)
        .label(index, "by an index with an imaginary part …")
        .label(absorption, "… and by itself")
        .why("Of an index n + ik the absorption at the wavelength L is 4 pi k / L.")
        .help("leave one of them out: `absorption`, or the imaginary part")
}
