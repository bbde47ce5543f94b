//! A mesh a thousand times as large as all else together, or a thousand times as small: its unit
//! is probably another one. Shapes that the scene itself measures out are taken at their word.

use crate::bodies::Placed;
use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::math::Bounds;
use crate::scene::Object;

/// The factor between neighbouring units of length, and between a slip and a choice.
const FACTOR: f64 = 1000.0;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let boxes: Vec<(&Placed, Bounds)> =
        shot.things.iter().map(|thing| (thing, thing.bounds())).collect();
    for (i, (thing, bounds)) in boxes.iter().enumerate() {
        let Object::Mesh(mesh) = &thing.object.value.value else { continue };
        let others = boxes.iter().enumerate().filter(|(j, _)| *j != i);
        let rest = others.fold(Bounds::EMPTY, |all, (_, (_, bounds))| all.union(*bounds));
        if rest.is_empty() || rest.size() == 0.0 {
            continue;
        }
        let ratio = bounds.size() / rest.size();
        // A lamp may be a point.
        if ratio >= FACTOR || ratio <= 1.0 / FACTOR && !thing.shines() {
            found.push(suspicious(thing.name(), ratio, mesh.unit.span));
        }
    }
}

fn suspicious(name: &str, ratio: f64, unit: Span) -> Diagnostic {
    let (times, word) = if ratio > 1.0 { (ratio, "large") } else { (1.0 / ratio, "small") };
    let headline = format!("`{name}` is {} times as {word} as all else together", rounded(times));
    let other = if ratio > 1.0 { "smaller" } else { "larger" };
    Diagnostic::warning(Code::LINT_SUSPICIOUS_UNIT, headline)
        .label(unit, "one unit of the file is so long")
        .why("Files of meshes do not say their unit; many are in millimetres or in metres.")
        .help(format!("write the {other} unit if that is meant, such as `mm`, `cm` or `m`"))
}

/// Two digits of a number: 1234 is "1200".
fn rounded(x: f64) -> String {
    let step = 10_f64.powf(x.log10().floor() - 1.0);
    format!("{:.0}", (x / step).round() * step)
}
