//! Family `scene`: objects that cannot be placed.

use crate::diag::{Code, Diagnostic, Span};
use crate::scene::At;

/// A sphere or disk that would become an ellipsoid or ellipse.
pub fn uneven_scale(name: &At<String>, place: Span, what: &str) -> Diagnostic {
    let headline = format!("the {what} `{}` is scaled unevenly", **name);
    Diagnostic::error(Code::SCENE_UNEVEN_SCALE, headline)
        .label(place, format!("after these steps it is no {what} any more"))
        .why(format!("A {what} is met exactly, as what it is, and so has one radius; only meshes, quads and triangles can be stretched."))
        .help("scale by the same factor along all axes, or use a mesh of that form")
}

/// A face without area.
pub fn no_area(name: &At<String>, spans: &[Span], because: &str) -> Diagnostic {
    let headline = format!("`{}` has no area", **name);
    let all = spans.iter().skip(1).fold(
        Diagnostic::error(Code::SCENE_NO_AREA, headline).label(spans[0], because.to_string()),
        |diagnostic, span| diagnostic.label(*span, "and this"),
    );
    all.why("Nothing can be seen of it, and no light can meet it.")
        .help("move one of its points, or leave the object out")
}

/// Coordinates that no arithmetic can hold.
pub fn beyond_numbers(name: &At<String>, object: Span) -> Diagnostic {
    let headline = format!("`{}` is too large, too small or too far away for numbers", **name);
    Diagnostic::error(Code::SCENE_BEYOND_NUMBERS, headline)
        .label(object, "placed, its coordinates or its size lie outside 1e-40 m to 1e40 m")
        .why("Areas and volumes are products of coordinates; beyond these bounds they overflow or vanish, even in double precision.")
        .help("check units, exponents and the factors of `scale`")
}
