//! How far a mesh reaches wherever it is placed, without a look at all of its corners.

use glam::DVec3;

use super::{Bounds, Mesh, Transform};

/// Triangles that share a box.
const PIECE: usize = 128;

/// Rounding of a mapped coordinate, as a part of the magnitudes it is made of; with room to spare.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Boxes around a mesh's triangles, piece by piece in the order of the file: most pieces lie too far
/// inside to matter.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reach {
    pieces: Vec<Bounds>,
}

impl Reach {
    /// Of a mesh.
    pub fn of(mesh: &Mesh) -> Self {
        let around = |piece: &[[u32; 3]]| Bounds::around(corners(mesh, piece));
        Self { pieces: mesh.triangles.chunks(PIECE).map(around).collect() }
    }

    /// The box around all corners of the mesh's triangles where a map puts them: the same numbers as
    /// by mapping each of them.
    pub fn bounds(&self, mesh: &Mesh, map: Transform) -> Bounds {
        let mut all = Bounds::EMPTY;
        let order: Vec<(Bounds, usize)> =
            self.pieces.iter().map(|piece| mapped(*piece, map)).zip(0..).collect();
        let look = |all: &mut Bounds, number: usize| {
            let piece = &mesh.triangles[number * PIECE..];
            let piece = &piece[..piece.len().min(PIECE)];
            *all = all.union(Bounds::around(corners(mesh, piece).map(|p| map.point(p))));
        };
        // Those that may reach farthest first: the others then seldom reach beyond them.
        for (axis, side) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0), (2, 1.0), (2, -1.0)] {
            let by = |(bounds, _): &(Bounds, usize)| match side > 0.0 {
                true => bounds.max[axis],
                false => -bounds.min[axis],
            };
            if let Some((_, number)) = order.iter().max_by(|a, b| by(a).total_cmp(&by(b))) {
                look(&mut all, *number);
            }
        }
        for (bounds, number) in order {
            if bounds.union(all) != all {
                look(&mut all, number);
            }
        }
        all
    }
}

fn corners(mesh: &Mesh, triangles: &[[u32; 3]]) -> impl Iterator<Item = DVec3> {
    triangles.iter().flatten().map(|i| mesh.positions[*i as usize])
}

/// A box that everything in a box is mapped into.
fn mapped(bounds: Bounds, map: Transform) -> Bounds {
    let matrix = map.0.matrix3;
    let size =
        glam::DMat3::from_cols(matrix.x_axis.abs(), matrix.y_axis.abs(), matrix.z_axis.abs());
    let (centre, half) = (map.point(bounds.centre()), size * bounds.half());
    let magnitude = size * bounds.min.abs().max(bounds.max.abs()) + map.0.translation.abs();
    let reach = half + ROUNDING * magnitude;
    Bounds { min: centre - reach, max: centre + reach }
}

#[cfg(test)]
mod tests {
    use glam::{DAffine3, DMat3};

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
        let mut positions: Vec<DVec3> = (0..3000).map(at).collect();
        let triangles: Vec<[u32; 3]> = (0..2998).map(|i| [i, i + 1, i + 2]).collect();
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
