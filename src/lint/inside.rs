//! Closed surfaces, and what is inside of them.

use std::collections::HashMap;
use std::f64::consts::PI;

use glam::DVec3;

use crate::bodies::{Body, Placed};
use crate::math::{Bounds, Mesh, Transform};

/// How a point lies to a closed surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// Not inside.
    Outside,
    /// Inside of a surface whose fronts look outward, as those of things do.
    Behind,
    /// Inside of a surface whose fronts look inward, as the walls of a room do.
    Before,
}

/// Whether `thing` is closed and has the point inside of it. Walks over all triangles of a mesh
/// whose box holds the point.
pub(super) fn side(thing: &Placed, bounds: &Bounds, p: DVec3) -> Side {
    match &thing.body {
        Body::Sphere { centre, radius, .. } if centre.distance(p) < *radius => Side::Behind,
        Body::Mesh { mesh, to_metres } if bounds.holds(p) => {
            let turns = winding(mesh, *to_metres, p);
            match turns {
                _ if turns.abs() < 0.5 || !is_closed(mesh) => Side::Outside,
                _ if turns > 0.0 => Side::Behind,
                _ => Side::Before,
            }
        }
        _ => Side::Outside,
    }
}

/// How often a mesh goes round a point: 1 inside of a closed one whose fronts look outward, -1
/// where they look inward, 0 outside: the sum of the solid angles of its triangles [VanOosterom83].
fn winding(mesh: &Mesh, to_metres: Transform, p: DVec3) -> f64 {
    let sign = if to_metres.mirrors() { -1.0 } else { 1.0 };
    let at = |i: u32| to_metres.point(mesh.positions[i as usize]) - p;
    let solid_angle = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(at);
        let (la, lb, lc) = (a.length(), b.length(), c.length());
        let over = a.dot(b.cross(c));
        let under = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        2.0 * over.atan2(under)
    };
    sign * mesh.triangles.iter().map(solid_angle).sum::<f64>() / (4.0 * PI)
}

/// Of each corner of a mesh a number: those at one position have the same.
pub(super) fn same_corners(mesh: &Mesh) -> Vec<u32> {
    let mut numbers: HashMap<[u64; 3], u32> = HashMap::new();
    let number = |p: &DVec3| {
        let next = numbers.len() as u32;
        // Adding zero turns -0 into 0.
        *numbers.entry(p.to_array().map(|x| (x + 0.0).to_bits())).or_insert(next)
    };
    mesh.positions.iter().map(number).collect()
}

/// Whether each edge of a mesh belongs to an even number of triangles. Corners at one position are
/// one corner.
pub(super) fn is_closed(mesh: &Mesh) -> bool {
    let same = same_corners(mesh);
    let mut odd: HashMap<(u32, u32), bool> = HashMap::new();
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| same[i as usize]);
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let edge = odd.entry((from.min(to), from.max(to))).or_default();
            *edge = !*edge;
        }
    }
    odd.values().all(|odd| !odd)
}

/// The volume behind the fronts of a closed mesh, in cubic metres; negative if they look inward.
pub(super) fn volume(mesh: &Mesh, to_metres: Transform) -> f64 {
    let sign = if to_metres.mirrors() { -1.0 } else { 1.0 };
    let centre = to_metres.point(mesh.positions.first().copied().unwrap_or_default());
    let at = |i: u32| to_metres.point(mesh.positions[i as usize]) - centre;
    let part = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(at);
        a.dot(b.cross(c)) / 6.0
    };
    sign * mesh.triangles.iter().map(part).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DAffine3;

    /// A tetrahedron from the origin along the axes, its fronts outward.
    fn corner() -> Mesh {
        Mesh {
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z],
            triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
            ..Mesh::default()
        }
    }

    #[test]
    fn a_closed_mesh_goes_round_what_is_inside() {
        let (mesh, here) = (corner(), Transform::IDENTITY);
        assert!((winding(&mesh, here, DVec3::splat(0.1)) - 1.0).abs() < 1e-12);
        assert!(winding(&mesh, here, DVec3::splat(0.5)).abs() < 1e-12);
        assert!((volume(&mesh, here) - 1.0 / 6.0).abs() < 1e-12);
        let mirror = Transform(DAffine3::from_scale(DVec3::new(-2.0, 2.0, 2.0)));
        assert!((winding(&mesh, mirror, DVec3::new(-0.1, 0.1, 0.1)) - 1.0).abs() < 1e-12);
        assert!((volume(&mesh, mirror) - 8.0 / 6.0).abs() < 1e-12);
        let mut inward = mesh;
        inward.triangles.iter_mut().for_each(|triangle| triangle.reverse());
        assert!((winding(&inward, here, DVec3::splat(0.1)) + 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_missing_face_opens_a_mesh_and_doubled_corners_do_not() {
        let mut mesh = corner();
        assert!(is_closed(&mesh));
        mesh.positions.push(DVec3::new(1.0, -0.0, 0.0));
        mesh.triangles[3] = [4, 2, 3];
        assert!(is_closed(&mesh));
        mesh.triangles.pop();
        assert!(!is_closed(&mesh));
    }
}
