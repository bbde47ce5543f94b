//! A medium in which light is faster than in a vacuum: probably an index against another medium.

use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::math::Spectrum;
use crate::optics;
use crate::scene::Medium;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    for medium in &shot.stage.scene.media {
        let Medium::Homogeneous(homogeneous) = &medium.value.value;
        let least = match &homogeneous.ior.n {
            Spectrum::Rgb(channels) => channels.iter().copied().fold(f64::INFINITY, f64::min),
            other => optics::tabulated(other).map_or(f64::INFINITY, |table| table.bounds().0),
        };
        if least < 1.0 {
            let headline = format!("light is faster in `{}` than in a vacuum", *medium.name);
            found.push(
                Diagnostic::warning(Code::LINT_INDEX_BELOW_ONE, headline)
                    .label(homogeneous.ior.span, "below 1")
                    .why("The index of a medium is against a vacuum; that of one medium against another follows from both.")
                    .help("for a bubble in glass write `dielectric { inside: air, outside: glass }`, with the index of each medium"),
            );
        }
    }
}
