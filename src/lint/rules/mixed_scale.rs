//! A lamp or a body of clear matter, in one mesh with another ten thousand times as large: mostly
//! a stray part, or one in another unit.

use crate::bodies::{self, Body, Placed, Sets};
use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::lint::inside::same_corners;
use crate::math::{Bounds, Mesh, Transform};

/// Between the sizes of parts that are made together and those that are not.
const FACTOR: f64 = 1e4;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    if !shot.stage.scene.integrator.follows_light() {
        return;
    }
    // Objects that name one mesh have the same parts, and are told once.
    let mut known: Vec<&Mesh> = Vec::new();
    for thing in shot.things.iter().filter(|thing| thing.shines() || thing.transmits()) {
        let Body::Mesh { mesh, to_metres } = &thing.body else { continue };
        if known.iter().any(|other| std::ptr::eq(*other, *mesh)) {
            continue;
        }
        known.push(mesh);
        let parts = parts(mesh, *to_metres);
        let size = |of: &&Bounds| of.size();
        let least = parts.iter().min_by(|a, b| size(a).total_cmp(&size(b)));
        let most = parts.iter().map(Bounds::size).fold(0.0, f64::max);
        if let Some(least) = least.filter(|least| most >= FACTOR * least.size()) {
            found.push(mixed(thing, parts.len(), least, most));
        }
    }
}

/// The boxes, in metres, around the parts of a mesh: faces that share a corner are of one.
fn parts(mesh: &Mesh, to_metres: Transform) -> Vec<Bounds> {
    let same = same_corners(mesh);
    let mut sets = Sets::new(same.len());
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| same[i as usize]);
        sets.join(a, b);
        sets.join(a, c);
    }
    let mut around = vec![Bounds::EMPTY; same.len()];
    for (at, number) in mesh.positions.iter().zip(&same) {
        let part = &mut around[sets.least(*number as usize)];
        *part = part.union(Bounds::around([to_metres.point(*at)]));
    }
    around.retain(|part| part.size() > 0.0);
    around
}

fn mixed(thing: &Placed, parts: usize, least: &Bounds, most: f64) -> Diagnostic {
    let times = most / least.size();
    let step = 10.0_f64.powf(times.log10().floor() - 1.0);
    let times = (times / step).round() * step;
    let name = &thing.name().value;
    let headline =
        format!("`{name}` has parts of which one is {times:.0} times as large as another");
    let at = bodies::place_in_words(least.centre());
    Diagnostic::warning(Code::LINT_MIXED_SCALE, headline)
        .label(thing.name().span, format!("the smallest of its {parts} parts is near {at}"))
        .why("So small a part of a mesh is mostly left over, or in another unit; its form may be lost in single precision.")
        .help("take it away or scale it in the program that made the mesh; if it is meant, let it be an object of its own")
}
