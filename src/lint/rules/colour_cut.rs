//! An albedo by wavelengths whose colour sRGB lacks: it is cut, and the picture shows another.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::optics::colour;

/// A channel may be cut by so much, of 1: less is hard to see beside what was meant.
const UNSEEN: f64 = 0.02;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    for (name, albedo) in shot.reflectances() {
        let moved = colour::cut(&albedo.0);
        if moved > UNSEEN {
            found.push(cut(name, moved, colour::reflected(&albedo.0), albedo.span));
        }
    }
}

fn cut(name: &str, moved: f64, shown: [f64; 3], at: Span) -> Diagnostic {
    let headline = format!("the colour of `{name}` is more saturated than a picture can show");
    let [r, g, b] = shown.map(|channel| (1e3 * channel).round() / 1e3);
    Diagnostic::warning(Code::LINT_COLOUR_CUT, headline)
        .label(at, format!("a channel is cut by {moved:.2}"))
        .why("A picture has three channels, those of sRGB, and none below 0 or above 1 for a surface.")
        .help(format!(
            "take a paler spectrum; or write `rgb({r}, {g}, {b})`, which is what it becomes"
        ))
}
