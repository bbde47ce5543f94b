//! Open edges that lie so near to each other that they are joined: by rounding, or by what a mesh
//! says of itself with `mend`.

use std::collections::{HashMap, HashSet};

use glam::DVec3;

use super::seams::Open;
use super::surfaces::{Face, Surfaces};
use crate::math::Bounds;
use crate::scene::Object;

/// Points nearer to each other than this part of the size of all bodies are one: single precision
/// does not tell them apart.
const ROUNDING: f64 = 1.0 / (1 << 24) as f64;

/// Gaps wider than this part of the size of all bodies, or of the one that is mended, are holes.
const GAP: f64 = 0.02;

/// More than this part of the triangles of a mesh are not lost by joining what lies at its gaps.
const LOST: f64 = 0.01;

/// For points that move: where to.
pub(super) type Moves = HashMap<u32, u32>;

/// How far points may be moved.
pub(super) struct Reach<'s> {
    surfaces: &'s Surfaces<'s>,
    /// What the objects that a point belongs to say, in metres, beyond rounding.
    said: HashMap<u32, f64>,
    rounding: f64,
}

impl<'s> Reach<'s> {
    pub fn of(surfaces: &'s Surfaces<'s>, open: &[Open]) -> Self {
        let mut said: HashMap<u32, f64> = HashMap::new();
        for edge in open {
            let owner = surfaces.owner(surfaces.skin(edge.face as usize));
            let mend = match &owner.object.value.value {
                Object::Mesh(mesh) => mesh.mend.0,
                _ => 0.0,
            };
            for end in [edge.from, edge.to] {
                let known = said.entry(end).or_insert(0.0);
                *known = known.max(mend);
            }
        }
        let size = Bounds::around(surfaces.points.iter().copied()).size();
        Self { surfaces, said, rounding: ROUNDING * size }
    }

    /// The joined points of open edges.
    pub fn moves(&self, open: &[Open]) -> Moves {
        joined(open, &self.surfaces.points, |p| self.said[&p].max(self.rounding))
    }

    /// The width of the gap between open edges, in metres; None: it is no gap, but a hole.
    pub fn gap(&self, open: &[Open]) -> Option<f64> {
        let most = GAP * self.rounding / ROUNDING;
        let points = &self.surfaces.points;
        let mut width = 2.0 * self.rounding;
        while width > 0.0 && width <= most {
            let moves = joined(open, points, |_| width);
            if is_closed(open, &moves) {
                if self.is_flattened(&moves) {
                    return None;
                }
                let far = |(from, to): (&u32, &u32)| {
                    points[*from as usize].distance(points[*to as usize])
                };
                return Some(moves.iter().map(far).fold(0.0, f64::max));
            }
            width *= 1.5;
        }
        None
    }

    /// Whether most of the faces that are touched would lie on others, or be gone.
    fn is_flattened(&self, moves: &Moves) -> bool {
        let joined: HashSet<u32> = moves.iter().flat_map(|(from, to)| [*from, *to]).collect();
        let touched = |face: &Face| face.corners.iter().filter(|p| joined.contains(p)).count();
        let all = self.surfaces.faces.iter().map(touched);
        let (whole, some) = all.fold((0, 0), |(whole, some), count| {
            (whole + usize::from(count == 3), some + usize::from(count > 0))
        });
        2 * whole >= some
    }
}

/// What is wrong with how far a mesh says that it may be mended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Wide {
    /// It is wider than a gap of the mesh can be: by what it says, and its size, in metres.
    Than { mend: f64, size: f64, most: f64 },
    /// So many of its triangles, of so many, would have no area.
    Loses { mend: f64, lost: usize, of: usize },
}

/// The first placed object, if any, that would lose its form by joining the points of its gaps.
pub(super) fn too_wide(surfaces: &Surfaces, moves: &Moves) -> Option<(u32, Wide)> {
    let mut lost: Vec<(u32, usize)> = Vec::new();
    for (number, face) in surfaces.faces.iter().enumerate() {
        let [a, b, c] = face.corners.map(|corner| moved(moves, corner));
        let touched = face.corners.iter().any(|corner| moves.contains_key(corner));
        if !touched {
            continue;
        }
        let object = surfaces.skin(number).object;
        let one = usize::from(a == b || b == c || c == a);
        match lost.iter_mut().find(|(known, _)| *known == object) {
            Some((_, count)) => *count += one,
            None => lost.push((object, one)),
        }
    }
    lost.into_iter().find_map(|(object, lost)| {
        let placed = &surfaces.placed[object as usize];
        let Object::Mesh(mesh) = &placed.object.value.value else { return None };
        let (mend, size) = (mesh.mend.0, placed.bounds().size());
        let (most, of) = (GAP * size, placed.body.triangles());
        let wide = match mend {
            _ if mend > most => Wide::Than { mend, size, most },
            _ if mend > 0.0 && lost as f64 > (LOST * of as f64).max(1.0) => {
                Wide::Loses { mend, lost, of }
            }
            _ => return None,
        };
        Some((object, wide))
    })
}

/// Where a point goes.
pub(super) fn moved(moves: &Moves, point: u32) -> u32 {
    moves.get(&point).copied().unwrap_or(point)
}

/// Whether open edges cancel each other, medium by medium, once points are moved.
fn is_closed(open: &[Open], moves: &Moves) -> bool {
    let mut sums: HashMap<(u32, u32, u32), i64> = HashMap::new();
    for edge in open {
        let (from, to) = (moved(moves, edge.from), moved(moves, edge.to));
        if from != to {
            let way = if from < to { 1 } else { -1 };
            *sums.entry((edge.medium, from.min(to), from.max(to))).or_default() += way;
        }
    }
    sums.values().all(|sum| *sum == 0)
}

/// Points of open edges, each moved to one within its reach, or within the other's; those with the
/// least reach stay where they are.
fn joined(open: &[Open], points: &[DVec3], reach: impl Fn(u32) -> f64) -> Moves {
    let mut ends: Vec<u32> = open.iter().flat_map(|edge| [edge.from, edge.to]).collect();
    ends.sort_unstable();
    ends.dedup();
    let most = ends.iter().map(|p| reach(*p)).fold(0.0, f64::max);
    if most == 0.0 {
        return Moves::new();
    }
    let cell = |p: u32| (points[p as usize] / most).floor().to_array().map(|x| x as i64);
    let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    for p in &ends {
        cells.entry(cell(*p)).or_default().push(*p);
    }
    ends.sort_by(|a, b| reach(*a).total_cmp(&reach(*b)).then(a.cmp(b)));
    let mut known = Moves::new();
    for p in ends {
        if known.contains_key(&p) {
            continue;
        }
        known.insert(p, p);
        let [x, y, z] = cell(p);
        for (i, j, k) in (0..27).map(|n| (n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1)) {
            for other in cells.get(&[x + i, y + j, z + k]).into_iter().flatten() {
                let apart = points[p as usize].distance(points[*other as usize]);
                if apart <= reach(p).max(reach(*other)) {
                    known.entry(*other).or_insert(p);
                }
            }
        }
    }
    known.retain(|from, to| from != to);
    known
}
