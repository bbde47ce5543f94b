//! Light that no path of the integrator can find: from a light without extent by a mirror or glass.

use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::plan::{self, Kind};

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let biases = plan::biases(shot.stage);
    let caustics = biases.into_iter().filter(|bias| bias.kind == Kind::Caustics);
    found.extend(caustics.map(|bias| {
        Diagnostic::warning(Code::LINT_IMPOSSIBLE_PATH, format!("{} in the picture", bias.brief))
            .label(bias.at, bias.effect)
            .why("A path from the camera meets a light without extent by asking for it alone, and smooth mirrors and glass cannot be asked: they send light on in one direction.")
            .help(bias.instead_write)
    }));
}
