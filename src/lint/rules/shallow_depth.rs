//! A depth that leaves out much of the light.

use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::plan::{self, Kind};
use crate::scene::Integrator;

/// So much may be left out, of all that surfaces scatter, before it is doubted.
const MUCH: f64 = 0.05;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let Integrator::Path(path) = &shot.stage.scene.integrator.value else { return };
    // Light that was scattered once is a picture of its own.
    if path.depth.most().is_none_or(|most| most <= 1) {
        return;
    }
    let biases = plan::biases(shot.stage);
    let cut = biases.into_iter().filter(|bias| bias.kind == Kind::Depth);
    found.extend(cut.filter(|bias| bias.bound.is_none_or(|bound| bound > MUCH)).map(|bias| {
        let headline = format!("{}: {}", bias.setting, bias.brief);
        Diagnostic::warning(Code::LINT_SHALLOW_DEPTH, headline)
            .label(bias.at, bias.effect)
            .help("write `depth: unlimited`: paths that bring little are ended by `roulette`, which leaves nothing out on average")
    }));
}
