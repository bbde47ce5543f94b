//! A surface of triangles around a figure: surface nets on a grid [Gibson98]. A cell through
//! which the surface goes has one vertex for each piece of the figure in it, and an edge of the
//! grid that leads into the figure has a quad of the four cells around it.

use glam::DVec3;

use crate::field::Figure;
use crate::mesh::Mesh;

/// Points along each side of a block of the grid.
const BLOCK: usize = 8;
/// A block is off the surface when its middle is farther than so many half diagonals: distances
/// are not exact.
const FAR: f64 = 1.5;

/// The points of a grid.
struct Grid {
    low: DVec3,
    cell: f64,
    counts: [usize; 3],
    /// The distance at each, x fastest.
    values: Vec<f64>,
}

/// Makes the surface within a box from `low` to `high`, with cells of the side `cell`. The figure
/// must end inside the box.
pub fn surface(figure: &Figure, low: DVec3, high: DVec3, cell: f64) -> Mesh {
    let grid = Grid::new(figure, low, high, cell);
    let mut mesh = Mesh::default();
    // Of each cell on the surface, the vertex for each of its corners inside.
    let mut cells: Vec<[usize; 8]> = Vec::new();
    let mut cell_at = vec![usize::MAX; grid.values.len()];
    for at in points([0; 3], grid.counts.map(|count| count - 1)) {
        let corners: [(DVec3, f64); 8] = std::array::from_fn(|corner| {
            let p = [0, 1, 2].map(|axis| at[axis] + (corner >> axis & 1));
            (grid.place(p), grid.values[grid.index(p)])
        });
        let inside = corners.iter().filter(|(_, distance)| *distance < 0.0).count();
        if inside % 8 != 0 {
            cell_at[grid.index(at)] = cells.len();
            cells.push(vertices(figure, &corners, &mut mesh));
        }
    }
    for at in points([1; 3], grid.counts.map(|count| count - 1)) {
        for axis in 0..3 {
            let mut next = at;
            next[axis] += 1;
            let inside = [at, next].map(|p| grid.values[grid.index(p)] < 0.0);
            if inside[0] == inside[1] {
                continue;
            }
            let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
            let around = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[back_b, back_c]| {
                let mut cell = at;
                cell[b] -= back_b;
                cell[c] -= back_c;
                let corner = back_b << b | back_c << c | usize::from(inside[1]) << axis;
                cells[cell_at[grid.index(cell)]][corner]
            });
            let [p, q, r, s] = around;
            mesh.push_quad(if inside[0] { around } else { [s, r, q, p] });
        }
    }
    mesh
}

/// All points from one to before another, x fastest.
fn points(first: [usize; 3], end: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    (first[2]..end[2]).flat_map(move |z| {
        (first[1]..end[1]).flat_map(move |y| (first[0]..end[0]).map(move |x| [x, y, z]))
    })
}

/// Adds the vertices of a cell: for each piece of corners inside that hang together along the
/// cell's edges, the mean of the points where edges leave it.
fn vertices(figure: &Figure, corners: &[(DVec3, f64); 8], mesh: &mut Mesh) -> [usize; 8] {
    let inside = |corner: usize| corners[corner].1 < 0.0;
    let mut vertices = [usize::MAX; 8];
    for start in 0..8 {
        if !inside(start) || vertices[start] != usize::MAX {
            continue;
        }
        let (mut sum, mut count) = (DVec3::ZERO, 0.0);
        let mut found = vec![start];
        vertices[start] = mesh.positions.len();
        while let Some(corner) = found.pop() {
            for next in [1, 2, 4].map(|axis| corner ^ axis) {
                if !inside(next) {
                    let ((p, near), (q, far)) = (corners[corner], corners[next]);
                    sum += p + (q - p) * (near / (near - far));
                    count += 1.0;
                } else if vertices[next] == usize::MAX {
                    vertices[next] = mesh.positions.len();
                    found.push(next);
                }
            }
        }
        mesh.positions.push(figure.projected(sum / count));
    }
    vertices
}

impl Grid {
    fn new(figure: &Figure, low: DVec3, high: DVec3, cell: f64) -> Grid {
        let counts = ((high - low) / cell).ceil().to_array().map(|count| count as usize + 1);
        let values = vec![0.0; counts.iter().product()];
        let mut grid = Grid { low, cell, counts, values };
        for block in points([0; 3], counts.map(|count| count.div_ceil(BLOCK))) {
            let first = block.map(|b| b * BLOCK);
            let end = [0, 1, 2].map(|axis| (first[axis] + BLOCK).min(counts[axis]));
            let (from, to) = (grid.place(first), grid.place(end));
            let middle = figure.distance(from.midpoint(to));
            let off = middle.abs() > FAR * from.distance(to) / 2.0;
            for p in points(first, end) {
                let index = grid.index(p);
                grid.values[index] = if off { middle } else { figure.distance(grid.place(p)) };
            }
        }
        grid
    }

    fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.counts[1] + y) * self.counts[0] + x
    }

    fn place(&self, p: [usize; 3]) -> DVec3 {
        self.low + DVec3::from(p.map(|i| i as f64)) * self.cell
    }
}
