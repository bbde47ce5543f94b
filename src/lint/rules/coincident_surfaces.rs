//! Two surfaces at one place: rounding decides, pixel by pixel, which of them a ray meets.

use glam::DVec3;

use crate::bodies::Flat;
use crate::bodies::{Body, Placed};
use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::scene::{Material, Named};

/// The same place, as a part of the size.
const SAME: f64 = 1e-9;
/// Pairs of flat surfaces looked at in one render; scenes with more are not made by hand.
const MOST: usize = 100_000;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let flats: Vec<Option<Flat>> = shot.things.iter().map(Flat::of).collect();
    let pairs = (0..shot.things.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    for (i, j) in pairs.take(MOST) {
        let (one, other) = (&shot.things[i], &shot.things[j]);
        if is_same(one, other) {
            found.push(same(one, other));
        } else if fights(one, other, (&flats[i], &flats[j])) {
            found.push(overlapping(one, other));
        }
    }
}

/// Whether two things fill the same place.
fn is_same(one: &Placed, other: &Placed) -> bool {
    let near = |a: DVec3, b: DVec3, size: f64| a.distance(b) <= SAME * size;
    match (&one.body, &other.body) {
        (Body::Mesh { mesh: a, to_metres: at }, Body::Mesh { mesh: b, to_metres: there }) => {
            std::ptr::eq(*a, *b) && at == there
        }
        (Body::Face { corners: a, .. }, Body::Face { corners: b, .. }) => {
            let size = one.bounds().size();
            let has = |p: &DVec3| b.iter().any(|q| near(*p, *q, size));
            a.len() == b.len() && a.iter().all(has)
        }
        (Body::Sphere { centre: a, radius: r, .. }, Body::Sphere { centre: b, radius: s, .. }) => {
            near(*a, *b, *r) && (r - s).abs() <= SAME * r
        }
        (
            Body::Disk { centre: a, radius: r, normal: n, .. },
            Body::Disk { centre: b, radius: s, normal: m, .. },
        ) => near(*a, *b, *r) && (r - s).abs() <= SAME * r && n.cross(*m).length() <= SAME,
        _ => false,
    }
}

/// Whether a difference between two flat surfaces in one plane can be seen.
fn fights(one: &Placed, other: &Placed, flats: (&Option<Flat>, &Option<Flat>)) -> bool {
    let lamp = one.shines() || other.shines();
    let seen = |a: &Flat, b: &Flat, differ: bool| {
        // The bottom of a box on a floor looks down: neither is seen there.
        let one_way = a.normal.dot(b.normal) > 0.0;
        differ && (one_way || lamp) && a.overlaps(b)
    };
    match (flats, &one.body, &other.body) {
        ((Some(a), Some(b)), _, _) => seen(a, b, !is_alike(one.materials[0], other.materials[0])),
        ((Some(flat), None), Body::Plane { .. } | Body::Face { .. } | Body::Disk { .. }, _) => {
            meets(flat, one, other, seen)
        }
        ((None, Some(flat)), _, Body::Plane { .. } | Body::Face { .. } | Body::Disk { .. }) => {
            meets(flat, other, one, seen)
        }
        _ => false,
    }
}

/// The same with a mesh; only lamps and planes are laid onto meshes by a slip.
fn meets(
    flat: &Flat,
    thing: &Placed,
    other: &Placed,
    seen: impl Fn(&Flat, &Flat, bool) -> bool,
) -> bool {
    let Body::Mesh { mesh, to_metres } = &other.body else { return false };
    if !thing.shines() && !matches!(thing.body, Body::Plane { .. }) {
        return false;
    }
    let mirrors = to_metres.mirrors();
    mesh.triangles.iter().enumerate().any(|(i, triangle)| {
        let [a, b, c] = triangle.map(|i| to_metres.point(mesh.positions[i as usize]));
        let corners = if mirrors { vec![a, c, b] } else { vec![a, b, c] };
        let slot = mesh.slots.get(i).copied().unwrap_or(0) as usize;
        let differ = other.materials.get(slot).is_none_or(|it| !is_alike(it, thing.materials[0]));
        Flat::face(corners).is_some_and(|face| seen(flat, &face, differ))
    })
}

fn is_alike(one: &Named<Material>, other: &Named<Material>) -> bool {
    one.value == other.value
}

fn same(one: &Placed, other: &Placed) -> Diagnostic {
    let headline = format!(
        "`{}` and `{}` are the same surface at the same place",
        other.name().value,
        one.name().value
    );
    Diagnostic::warning(Code::LINT_COINCIDENT_SURFACES, headline)
        .label(one.name().span, "fills the place …")
        .label(other.name().span, "… that this fills")
        .why("Rounding decides, ray by ray, which of the two is met; a lamp shines twice.")
        .help("move one of them, or take it away")
}

fn overlapping(one: &Placed, other: &Placed) -> Diagnostic {
    let headline = format!("`{}` and `{}` lie on each other", other.name().value, one.name().value);
    Diagnostic::warning(Code::LINT_COINCIDENT_SURFACES, headline)
        .label(one.name().span, "lies in one plane, and partly at one place …")
        .label(other.name().span, "… with this")
        .why("Rounding decides, ray by ray, which of the two is met: the picture gets spots.")
        .help("move one of them out of the plane, by a thousandth of its size")
}
