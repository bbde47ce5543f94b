//! Light that paths find by chance alone, and hardly ever: of a small lamp or the sun, by a mirror
//! or glass.

use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::plan::{self, Kind};

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let biases = plan::biases(shot.stage);
    let rare = biases.into_iter().filter(|bias| bias.kind == Kind::RareCaustics);
    found.extend(rare.map(|bias| {
        let headline = format!("{} is hardly ever found", bias.setting);
        Diagnostic::warning(Code::LINT_RARE_CAUSTICS, headline)
            .label(bias.at, bias.effect)
            .why("Smooth mirrors and glass cannot be asked for light: a path finds it by going the right way by chance. Its caustics are single bright pixels until thousands of samples are taken, and missing in most pictures of few.")
            .help(bias.instead_write)
    }));
}
