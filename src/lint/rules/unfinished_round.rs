//! Samples that are no whole number of rounds through the cells of a stratified pixel.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::scene::Sampler;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let scene = &shot.stage.scene;
    let Sampler::Stratified(sampler) = &scene.sampler.value else { return };
    if !shot.own_limits {
        return;
    }
    let stop = &scene.stop;
    // Other limits end where they end.
    let (Some(samples), None, None) = (&stop.samples.value, &stop.time.value, &stop.error.value)
    else {
        return;
    };
    let grid = &sampler.grid;
    let cells = grid.0.saturating_mul(grid.0);
    // A quick look at the default grid is no statement about it.
    let stated = grid.span != scene.sampler.span;
    if samples.0 % cells != 0 && (stated || samples.0 > cells) {
        found.push(unfinished(samples.0, grid.value.0, (stop.samples.span, grid.span)));
    }
}

fn unfinished(samples: u64, grid: u64, (at, cells_at): (Span, Span)) -> Diagnostic {
    let cells = grid * grid;
    let rest = samples % cells;
    let headline = format!("{samples} samples do not fill a grid of {grid} × {grid} cells evenly");
    let below = samples - rest;
    let whole = if below == 0 {
        format!("write `samples: {cells}`")
    } else {
        format!("write `samples: {below}` or `samples: {}`", below + cells)
    };
    let root = samples.isqrt();
    let help = if root * root == samples {
        format!("{whole}, or `grid: {root}`, which {samples} samples fill once")
    } else {
        whole
    };
    Diagnostic::warning(Code::LINT_UNFINISHED_ROUND, headline)
        .label(at, format!("leaves {} of {cells} cells empty in the last round", cells - rest))
        .label(cells_at, format!("{cells} cells"))
        .why("Each sample falls into a cell of its own; only whole rounds spread them evenly over the pixel.")
        .help(help)
}
