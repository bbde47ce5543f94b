//! How far a mesh reaches wherever it is placed, without a look at all of its corners.

use glam::{DMat3, DVec3};

use super::{Bounds, Mesh, Transform};

/// Triangles of a piece, and pieces of a group.
const PIECE: usize = 32;
const GROUP: usize = 64;

/// Rounding of a mapped coordinate, as a part of the magnitudes it is made of; with room to spare.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Boxes around a mesh's triangles, piece by piece in the order of the file, and around groups of
/// pieces: most of them lie too far inside to matter.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reach {
    pieces: Vec<Bounds>,
    groups: Vec<Bounds>,
}

impl Reach {
    /// Of a mesh.
    pub fn of(mesh: &Mesh) -> Self {
        let around = |piece: &[[u32; 3]]| Bounds::around(corners(mesh, piece));
        let pieces: Vec<_> = mesh.triangles.chunks(PIECE).map(around).collect();
        let join = |group: &[Bounds]| group.iter().copied().fold(Bounds::EMPTY, Bounds::union);
        Self { groups: pieces.chunks(GROUP).map(join).collect(), pieces }
    }

    /// The box around all corners of the mesh's triangles where a map puts them: the same numbers as
    /// by mapping each of them.
    pub fn bounds(&self, mesh: &Mesh, map: Transform) -> Bounds {
        let mut all = Bounds::EMPTY;
        let look = |all: &mut Bounds, piece: usize| {
            let piece = mesh.triangles.chunks(PIECE).nth(piece).unwrap_or_default();
            *all = all.union(Bounds::around(corners(mesh, piece).map(|p| map.point(p))));
        };
        let groups: Vec<Bounds> = self.groups.iter().map(|group| mapped(*group, map)).collect();
        let pieces = |group: usize| {
            let pieces = self.pieces.chunks(GROUP).nth(group).unwrap_or_default();
            let pieces: Vec<Bounds> = pieces.iter().map(|piece| mapped(*piece, map)).collect();
            (group * GROUP, pieces)
        };
        // Those that may reach farthest first: the others then seldom reach beyond them.
        for side in 0..6 {
            if let Some(group) = farthest(&groups, side) {
                let (first, pieces) = pieces(group);
                farthest(&pieces, side).into_iter().for_each(|piece| look(&mut all, first + piece));
            }
        }
        for (group, bounds) in groups.iter().enumerate() {
            if bounds.union(all) == all {
                continue;
            }
            let (first, pieces) = pieces(group);
            for (piece, bounds) in pieces.iter().enumerate() {
                if bounds.union(all) != all {
                    look(&mut all, first + piece);
                }
            }
        }
        all
    }
}

/// The box that reaches farthest along x, y or z (0 to 2), or against it (3 to 5).
fn farthest(boxes: &[Bounds], side: usize) -> Option<usize> {
    let reach = |b: &Bounds| if side < 3 { b.max[side] } else { -b.min[side - 3] };
    let all = boxes.iter().map(reach).enumerate();
    all.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(number, _)| number)
}

fn corners(mesh: &Mesh, triangles: &[[u32; 3]]) -> impl Iterator<Item = DVec3> {
    triangles.iter().flatten().map(|i| mesh.positions[*i as usize])
}

/// A box that everything in a box is mapped into.
fn mapped(bounds: Bounds, map: Transform) -> Bounds {
    let matrix = map.0.matrix3;
    let size = DMat3::from_cols(matrix.x_axis.abs(), matrix.y_axis.abs(), matrix.z_axis.abs());
    let (centre, half) = (map.point(bounds.centre()), size * bounds.half());
    let magnitude = size * bounds.min.abs().max(bounds.max.abs()) + map.0.translation.abs();
    let reach = half + ROUNDING * magnitude;
    Bounds { min: centre - reach, max: centre + reach }
}

#[cfg(test)]
mod tests {
    use glam::DAffine3;

    use super::*;
    use crate::math::random;

    fn unit(number: u64) -> f64 {
        let [x, _] = random::unit_pair(random::mix(number));
        2.0 * x - 1.0
    }

    #[test]
    fn boxes_are_those_of_all_corners() {
        let point = |i: u64| DVec3::new(unit(3 * i), unit(3 * i + 1), unit(3 * i + 2));
        // A crooked line of triangles, far from the origin; the last vertex is nobody's corner.
        let at = |i: u64| {
            let turn = i as f64 / 300.0;
            DVec3::new(1e3 + turn.sin(), turn.cos(), (2.0 * turn).sin()) + 1e-3 * point(i)
        };
        let mut positions: Vec<DVec3> = (0..9000).map(at).collect();
        let triangles: Vec<[u32; 3]> = (0..8998).map(|i| [i, i + 1, i + 2]).collect();
        positions.push(DVec3::splat(1e6));
        let mesh = Mesh { positions, triangles, ..Mesh::default() };
        let reach = Reach::of(&mesh);
        for seed in (10_000..).step_by(100).take(50) {
            let columns = [0, 1, 2].map(|i| point(seed + i));
            let matrix = DMat3::from_cols(columns[0], columns[1], 1e-6 * columns[2]);
            let map = Transform(DAffine3 { matrix3: matrix, translation: point(seed + 4) });
            let all = corners(&mesh, &mesh.triangles).map(|p| map.point(p));
            assert_eq!(reach.bounds(&mesh, map), Bounds::around(all));
        }
        assert!(Reach::default().bounds(&Mesh::default(), Transform::IDENTITY).is_empty());
    }
}
