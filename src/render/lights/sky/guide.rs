//! Where a surface is to look in a sky: for many normals a coarse table of what the sky gives to a
//! surface that faces so, luminance times cosine, and its sums.
//!
//! Normals of one table differ by a few degrees, and so do the cosines; what a table leaves dark by
//! that, and the ground, is found by a part of the samples that goes by the cosine alone.

use glam::{Vec2, Vec3};

use super::{Chosen, HALF, Table, on_grid};
use crate::math::{Rgb, warp};

/// Cells of a table along a side of the square of the sky.
const CELLS: usize = 16;

/// Normals along a side of an octahedron that is unfolded to a square. An odd number: the six along
/// the axes have tables of their own.
const FACES: usize = 17;

/// The part of samples that goes by the cosine at least.
const ASIDE: f64 = 0.125;

/// So far may the cosine of a direction be from that to the normal of its table.
const TURNED: f32 = 1.5 / (FACES - 1) as f32;

/// Tables for all normals, and one for what has none.
#[derive(Clone, Debug)]
pub(super) struct Guides {
    all: Vec<Guide>,
}

/// A table.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(super) struct Guide {
    /// The part of rows up to and including each, and of each row the part of cells likewise.
    rows: [f32; CELLS],
    cells: [[f32; CELLS]; CELLS],
    /// Density in solid angle at the corners of cells, row by row; bilinear between them.
    nodes: [[f32; CELLS + 1]; CELLS + 1],
    /// The part of samples that goes by the table.
    pub part: f32,
}

/// Where in a cell, by the part of its light, a sample lies.
#[derive(Clone, Copy, Default)]
pub(super) struct Cell {
    pub column: f32,
    pub row: f32,
    /// Light on the one side of it along x and along y, each in [0, 1].
    pub parts: Vec2,
    /// Density at (0, 0), (1, 0), (0, 1), (1, 1).
    pub corners: [f32; 4],
}

impl Guides {
    pub fn new(light: &Table, ground: Rgb) -> Self {
        let luminance = blurred(light);
        let ground = f64::from(ground.luminance());
        let facing = (0..FACES * FACES).map(|face| {
            let normal = normal_of(face);
            let below = 0.25 * f64::from(HALF) * ground * f64::from(1.0 - normal.z);
            let of = |w: Vec3| softly(normal.dot(w));
            Guide::new(&luminance, of, below, ASIDE)
        });
        let free = Guide::new(&luminance, |_| 1.0, f64::from(HALF) * ground, 0.0);
        Self { all: facing.chain([free]).collect() }
    }

    /// The number of the table of a normal, or of none: of unit length, or zero.
    #[inline(always)]
    pub fn facing(normal: Vec3) -> u32 {
        let p = Vec2::new(normal.x, normal.y) / normal.abs().element_sum();
        let folded = Vec2::new((1.0 - p.y.abs()).copysign(p.x), (1.0 - p.x.abs()).copysign(p.y));
        let p = if normal.z < 0.0 { folded } else { p };
        let at = |x: f32| ((0.5 * x + 0.5) * (FACES - 1) as f32 + 0.5) as u32;
        let face = at(p.y) * FACES as u32 + at(p.x);
        if normal == Vec3::ZERO { (FACES * FACES) as u32 } else { face }
    }

    #[inline(always)]
    pub fn of(&self, facing: u32) -> &Guide {
        // A normal that is no number has none.
        &self.all[(facing as usize).min(FACES * FACES)]
    }
}

/// The normal of a table, by its number: the inverse of [`Guides::facing`].
fn normal_of(face: usize) -> Vec3 {
    let at = |i: usize| 2.0 * i as f32 / (FACES - 1) as f32 - 1.0;
    let p = Vec2::new(at(face % FACES), at(face / FACES));
    let z = 1.0 - p.x.abs() - p.y.abs();
    let folded = Vec2::new((1.0 - p.y.abs()).copysign(p.x), (1.0 - p.x.abs()).copysign(p.y));
    (if z < 0.0 { folded } else { p }).extend(z).normalize()
}

/// About the mean of cosines, cut off at 0, that are near to this one.
fn softly(cos: f32) -> f32 {
    if cos.abs() < TURNED { (cos + TURNED).powi(2) / (4.0 * TURNED) } else { cos.max(0.0) }
}

/// Luminance at the corners of the cells of a coarse table: the mean of what is around.
fn blurred(light: &Table) -> Vec<f64> {
    let fine = (light.side.div_ceil(CELLS) * CELLS).max(2 * CELLS);
    let (mut sums, mut weights) = (vec![0.0; NODES], vec![0.0; NODES]);
    let middle = |i: usize| (i as f32 + 0.5) / fine as f32;
    for (y, x) in (0..fine).flat_map(|y| (0..fine).map(move |x| (y, x))) {
        let square = Vec2::new(middle(x), middle(y));
        let luminance = f64::from(light.between(square).w);
        let ([column, row], within) = on_grid(square, CELLS);
        for (down, right) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let share = |right: usize, part: f32| if right == 1 { part } else { 1.0 - part };
            let weight = f64::from(share(right, within.x) * share(down, within.y));
            let node = (row + down) * (CELLS + 1) + column + right;
            sums[node] += weight * luminance;
            weights[node] += weight;
        }
    }
    sums.iter().zip(weights).map(|(sum, weight)| sum / weight).collect()
}

const NODES: usize = (CELLS + 1) * (CELLS + 1);

impl Guide {
    /// Of luminance at the corners of cells, weighed by direction. `below`: what the ground gives
    /// beside it; at least the part `aside` goes by another way.
    fn new(luminance: &[f64], weight: impl Fn(Vec3) -> f32, below: f64, aside: f64) -> Self {
        let at = |i: usize| i as f32 / CELLS as f32;
        let mut nodes = [[0.0; CELLS + 1]; CELLS + 1];
        for (y, row) in nodes.iter_mut().enumerate() {
            for (x, node) in row.iter_mut().enumerate() {
                let w = warp::square_to_hemisphere(Vec2::new(at(x), at(y)));
                *node = luminance[y * (CELLS + 1) + x] * f64::from(weight(w));
            }
        }
        let mean = |y: usize, x: usize| {
            0.25 * (nodes[y][x] + nodes[y][x + 1] + nodes[y + 1][x] + nodes[y + 1][x + 1])
        };
        let row = |y: usize| (0..CELLS).map(|x| mean(y, x)).sum::<f64>();
        let sum: f64 = (0..CELLS).map(row).sum();
        let mut guide = Self {
            rows: up_to(row),
            cells: [[0.0; CELLS]; CELLS],
            nodes: [[0.0; CELLS + 1]; CELLS + 1],
            part: 0.0,
        };
        if sum <= 0.0 {
            return guide;
        }
        for (y, cells) in guide.cells.iter_mut().enumerate() {
            *cells = up_to(|x| mean(y, x));
        }
        let given = sum * f64::from(HALF) / (CELLS * CELLS) as f64;
        for (to, from) in guide.nodes.iter_mut().flatten().zip(nodes.iter().flatten()) {
            *to = (from / given) as f32;
        }
        guide.part = ((1.0 - aside) * given / (given + below)) as f32;
        guide
    }

    /// Where to look.
    #[inline(always)]
    pub fn choose(&self, [u, v]: [f32; 2]) -> Chosen {
        let by_table = u < self.part;
        let u = if by_table { u / self.part } else { (u - self.part) / (1.0 - self.part) };
        // Rounding may make it 1.
        let u = u.min(1.0 - f32::EPSILON / 2.0);
        let cell = self.cell([u, v]);
        Chosen { cell, aside: Vec2::new(u, v), by_table }
    }

    /// By its part of the table: one number chooses row and height, the other the column and where in
    /// it, so that stratified numbers stay stratified.
    #[inline(always)]
    fn cell(&self, [u, v]: [f32; 2]) -> Cell {
        let (row, up) = part_of(&self.rows, u);
        let (column, along) = part_of(&self.cells[row], v);
        let [a, b] = [self.nodes[row][column], self.nodes[row][column + 1]];
        let [c, d] = [self.nodes[row + 1][column], self.nodes[row + 1][column + 1]];
        Cell {
            column: column as f32,
            row: row as f32,
            parts: Vec2::new(along, up),
            corners: [a, b, c, d],
        }
    }

    /// The density in solid angle, of a place of the square, with which the table alone gives it.
    #[inline(always)]
    pub fn density(&self, square: Vec2) -> f32 {
        let ([column, row], within) = on_grid(square, CELLS);
        let (upper, lower) = (&self.nodes[row], &self.nodes[row + 1]);
        let above = upper[column] * (1.0 - within.x) + upper[column + 1] * within.x;
        let below = lower[column] * (1.0 - within.x) + lower[column + 1] * within.x;
        above * (1.0 - within.y) + below * within.y
    }
}

impl Cell {
    /// The point of the square of the sky.
    #[inline(always)]
    pub fn point(&self) -> Vec2 {
        let [a, b, c, d] = self.corners;
        let y = on_line(a + b, c + d, self.parts.y);
        let x = on_line(a + (c - a) * y, b + (d - b) * y, self.parts.x);
        Vec2::new(self.column + x, self.row + y) / CELLS as f32
    }
}

/// The parts of a sum up to and including each; the last is 1.
fn up_to(part: impl Fn(usize) -> f64) -> [f32; CELLS] {
    let mut sum = 0.0;
    let sums: [f64; CELLS] = std::array::from_fn(|i| {
        sum += part(i);
        sum
    });
    sums.map(|up_to| if sum > 0.0 { (up_to / sum) as f32 } else { 1.0 })
}

/// Which part of a sum holds the fraction `u` of it, and where in that part, in [0, 1].
#[inline(always)]
fn part_of(up_to: &[f32; CELLS], u: f32) -> (usize, f32) {
    // Counted, not searched: that is a comparison of vectors.
    let mut index = 0;
    for end in &up_to[..CELLS - 1] {
        index += usize::from(*end <= u);
    }
    let before = if index == 0 { 0.0 } else { up_to[index - 1] };
    let part = up_to[index] - before;
    let within = if part > 0.0 { (u - before) / part } else { 0.0 };
    (index, within.clamp(0.0, 1.0))
}

/// Where on [0, 1] the fraction `u` of a density ends that runs straight from `a` to `b`, both not
/// negative: the root of a quadratic, without the difference that rounds.
#[inline(always)]
pub(super) fn on_line(a: f32, b: f32, u: f32) -> f32 {
    // Over the larger: squares of small densities have no place in f32.
    let most = a.max(b);
    let (a, b) = (a / most, b / most);
    let root = (a * a + u * (b * b - a * a)).max(0.0).sqrt();
    let x = (u * (a + b) / (a + root)).min(1.0);
    // A density of zero everywhere, or the fraction zero of one that begins with it.
    if most > 0.0 && a + root > 0.0 { x } else { u }
}
