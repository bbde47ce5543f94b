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
            false => "leave this field out, or set it to 0, to see the medium clear",
        })
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
