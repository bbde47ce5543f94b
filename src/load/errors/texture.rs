//! Pictures that are textures.

use crate::diag::{Code, Diagnostic, Span};
use crate::files::Failure;

/// A file that is no picture, or a broken one.
pub fn unreadable(file: &str, span: Span, failure: &Failure) -> Diagnostic {
    Diagnostic::error(Code::TEXTURE_UNREADABLE, format!("the picture `{file}` {failure}"))
        .label(span, "names it")
        .help("name a PNG, JPEG, PNM, Radiance HDR or OpenEXR file; open it elsewhere to see whether it is whole")
}

/// A picture with an opacity.
pub fn transparent(file: &str, span: Span) -> Diagnostic {
    Diagnostic::warning(
        Code::TEXTURE_TRANSPARENCY,
        format!("the transparency of the picture `{file}` is ignored"),
    )
    .label(span, "has texels that are not opaque")
    .why("A texture is the colour of a surface, which is there all over.")
    .help("nothing to do if its colours are right there too; else save the picture without transparency")
}

/// `encoding: srgb` for a file of light.
pub fn encoded_floats(file: &str, (encoding, span): (Span, Span)) -> Diagnostic {
    Diagnostic::error(
        Code::TEXTURE_FLOAT_ENCODING,
        format!("the picture `{file}` holds linear light and is not encoded as sRGB"),
    )
    .label(encoding, "says that it is")
    .label(span, "a file of floating-point numbers")
    .help("write `encoding: linear`, or leave it out")
    .mend("write `linear`", encoding, "linear")
}
