//! Family `scene`: settings that make a picture systematically wrong, where none may.

use crate::diag::{Code, Diagnostic};
use crate::plan::Bias;

/// A setting that `--unbiased` refuses.
pub fn biased(bias: &Bias) -> Diagnostic {
    let make = if bias.setting.contains(" and ") { "make" } else { "makes" };
    let headline = format!("{} {make} the picture systematically wrong", bias.setting);
    Diagnostic::error(Code::SCENE_BIASED, headline)
        .label(bias.at, bias.effect.clone())
        .why("`--unbiased` asks for pictures whose only error is noise.")
        .help(bias.instead_write)
}
