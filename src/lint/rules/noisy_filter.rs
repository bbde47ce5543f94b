//! Few samples under a filter with negative lobes.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::scene::Filter;

/// Fewer samples than these leave more noise than any sharpness is worth.
const LEAST: u64 = 16;

/// The standard deviation, in parts of the brightness, that one sample leaves even to areas of
/// one brightness.
const OF_ONE: f64 = 0.56;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let scene = &shot.stage.scene;
    let filter = &scene.film.filter;
    if let (Filter::Mitchell(_), Some(samples)) = (&filter.value, scene.stop.most_samples())
        && samples < LEAST
    {
        found.push(noisy(samples, filter.span, scene.stop.samples.span));
    }
}

fn noisy(samples: u64, at: Span, samples_at: Span) -> Diagnostic {
    let noise = 100.0 * OF_ONE / (samples as f64).sqrt();
    Diagnostic::warning(Code::LINT_NOISY_FILTER, "`mitchell` wants more samples than these")
        .label(at, "weighs some samples negatively")
        .label(samples_at, format!("adds noise of up to {noise:.0} % of the brightness"))
        .help("write at least `samples: 64`, or another filter, such as `tent` or `gaussian`")
}
