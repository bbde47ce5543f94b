//! From a figure to a closed mesh of few triangles, with materials.

use glam::DVec3;

use crate::field::Figure;
use crate::mesh::Mesh;
use crate::{nets, simplify};

/// Rounds of evening out before triangles are saved.
const RELAXATIONS: usize = 2;
/// A vertex is drawn onto the border of two materials from so many cells away.
const BORDER_REACH: f64 = 0.6;

/// A mesh whose triangles have materials.
pub struct Sculpture {
    /// The surface.
    pub mesh: Mesh,
    /// The index of each triangle's material.
    pub materials: Vec<usize>,
}

/// Makes the surface of a figure that ends within a box from `low` to `high`, with details as
/// fine as twice `cell`, of no more than `most` triangles.
pub fn sculpt(figure: &Figure, [low, high]: [DVec3; 2], cell: f64, most: usize) -> Sculpture {
    let mut fine = nets::surface(figure, low, high, cell);
    for _ in 0..RELAXATIONS {
        fine.shift(|p, mean| figure.projected(p.midpoint(mean)));
    }
    fine.shift(|p, _| figure.on_border(p, BORDER_REACH * cell));
    let middle = |i| fine.corners(i).into_iter().sum::<DVec3>() / 3.0;
    let materials: Vec<usize> =
        (0..fine.triangles.len()).map(|i| figure.material(middle(i))).collect();
    let (mut mesh, materials) = simplify::simplify(&fine, &materials, most);
    mesh.shift(|p, _| figure.projected(p));
    Sculpture { mesh, materials }
}
