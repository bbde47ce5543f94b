//! Edges at which the surface of a lamp or of clear matter does not simply go on: more than two
//! faces meet there, or two that look different ways. What `matter` refuses is no lint.

use glam::DVec3;

use crate::bodies::{self, Body, Placed};
use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::lint::inside::same_corners;
use crate::math::Mesh;
use crate::scene::Sides;

/// Edges of one kind: how many, and the corners of the first.
type Edges = Option<(usize, [u32; 2])>;

/// What was found along the edges of some slots of a mesh.
#[derive(Clone, Copy)]
struct Seams {
    /// More than two faces meet there.
    crowded: Edges,
    /// Two faces meet there, one of which looks the other way.
    turned: Edges,
}

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    if !shot.stage.scene.integrator.follows_light() {
        return;
    }
    // Objects that name one mesh are alike, and told once.
    let mut known: Vec<(&Mesh, Vec<bool>)> = Vec::new();
    for thing in &shot.things {
        let Body::Mesh { mesh, to_metres } = &thing.body else { continue };
        let matters: Vec<bool> = (0..thing.parts.len()).map(|slot| matters(thing, slot)).collect();
        let is_known =
            |(other, slots): &(&Mesh, _)| std::ptr::eq(*other, *mesh) && *slots == matters;
        if !matters.contains(&true) || known.iter().any(is_known) {
            continue;
        }
        let seams = seams(mesh, &matters);
        let middle = |[a, b]: [u32; 2]| {
            let [a, b] = [a, b].map(|i| to_metres.point(mesh.positions[i as usize]));
            0.5 * (a + b)
        };
        found.extend(seams.crowded.map(|(count, at)| crowded(thing, count, middle(at))));
        found.extend(seams.turned.map(|(count, at)| turned(thing, count, middle(at))));
        known.push((mesh, matters));
    }
}

/// Whether the sides of a slot's faces do different things.
fn matters(thing: &Placed, slot: usize) -> bool {
    thing.parts[slot].iter().any(|(_, part)| {
        let part = &part.value.value;
        let one_way = part.glow().is_some_and(|(_, sides)| sides.value != Sides::Both);
        let ends = part.sides().is_some_and(|(inside, outside)| outside != Some(inside));
        part.shines() && one_way || ends
    })
}

/// Looks at the edges between faces of one slot, of those that matter.
fn seams(mesh: &Mesh, matters: &[bool]) -> Seams {
    let same = same_corners(mesh);
    let slot = |i: usize| mesh.slots.get(i).copied().unwrap_or(0);
    let faces = mesh.triangles.iter().enumerate().filter(|(i, _)| matters[slot(*i) as usize]);
    // Slot, both ends, whether from the lesser to the greater one, and the corners.
    let mut edges: Vec<(u32, [u32; 2], bool, [u32; 2])> = faces
        .flat_map(|(i, &[a, b, c])| {
            [[a, b], [b, c], [c, a]].map(|corners| {
                let [from, to] = corners.map(|i| same[i as usize]);
                (slot(i), [from.min(to), from.max(to)], from < to, corners)
            })
        })
        .collect();
    edges.sort_unstable();
    let mut seams = Seams { crowded: None, turned: None };
    for around in edges.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        let kind = match around {
            [one, other] if one.2 == other.2 => &mut seams.turned,
            [_] | [_, _] => continue,
            _ => &mut seams.crowded,
        };
        *kind = Some(kind.map_or((1, around[0].3), |(count, first)| (count + 1, first)));
    }
    seams
}

fn crowded(thing: &Placed, count: usize, at: DVec3) -> Diagnostic {
    let name = &thing.name().value;
    let why = match thing.shines() {
        true => {
            "Such a lamp has walls inside, or touches itself: some of its light goes where nobody sees it."
        }
        false => {
            "Its parts touch there in a line without width: mostly they were meant to be one, or to be apart."
        }
    };
    let headline = format!("more than two faces of `{name}` meet at an edge");
    Diagnostic::warning(Code::LINT_NON_MANIFOLD, headline)
        .label(thing.name().span, places(count, at))
        .why(why)
        .help(
            "join its parts in the program that made it, without walls inside; or move them apart",
        )
}

fn turned(thing: &Placed, count: usize, at: DVec3) -> Diagnostic {
    let headline = format!("faces of the lamp `{}` look different ways", thing.name().value);
    Diagnostic::warning(Code::LINT_NON_MANIFOLD, headline)
        .label(thing.name().span, format!("one of two is turned {}", places(count, at)))
        .why("A lamp shines from the front of its faces, from which their corners are counter-clockwise: the others are dark.")
        .help("turn all its faces the same way in the program that made it, or let both sides shine: `emits: both`")
}

fn places(count: usize, at: DVec3) -> String {
    let at = bodies::place_in_words(at);
    match count {
        1 => format!("at an edge near {at}"),
        _ => format!("at {count} edges, the first near {at}"),
    }
}
