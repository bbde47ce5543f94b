//! Fewer triangles for the same surface: edges are drawn together, cheapest first, by the squared
//! distances from the planes that met there [Garland97]. A closed surface stays closed, and each
//! edge keeps exactly two triangles.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use glam::{DMat3, DVec3};

use crate::mesh::{Mesh, may_become};

/// How heavily a plane along the border of two materials weighs against the planes of triangles.
const BORDER: f64 = 20.0;
/// A pull towards the middle of the edge, where the planes leave a vertex free to slide.
const PULL: f64 = 1e-3;

/// Draws edges together until there are no more than `most` triangles.
pub fn simplify(mesh: &Mesh, materials: &[usize], most: usize) -> (Mesh, Vec<usize>) {
    let mut work = Work::new(mesh, materials);
    let mut heap: BinaryHeap<Collapse> = BinaryHeap::new();
    for &[a, b, c] in &mesh.triangles {
        for (p, q) in [(a, b), (b, c), (c, a)] {
            if p < q {
                heap.push(work.collapse(p, q));
            }
        }
    }
    let mut left = mesh.triangles.len();
    while left > most
        && let Some(next) = heap.pop()
    {
        let current = next.versions == [work.versions[next.a], work.versions[next.b]];
        if !current || !work.allows(&next) {
            continue;
        }
        work.apply(&next);
        left -= 2;
        for other in work.neighbours(next.a) {
            heap.push(work.collapse(next.a.min(other), next.a.max(other)));
        }
    }
    work.finish()
}

/// The sum of squared distances from planes, as a quadratic form.
#[derive(Clone, Copy)]
struct Quadric {
    square: DMat3,
    linear: DVec3,
    constant: f64,
}

impl Quadric {
    const ZERO: Quadric = Quadric { square: DMat3::ZERO, linear: DVec3::ZERO, constant: 0.0 };

    /// Of a plane through `point`, with a weight.
    fn plane(normal: DVec3, point: DVec3, weight: f64) -> Quadric {
        let distance = -normal.dot(point);
        let square =
            DMat3::from_cols(normal * normal.x, normal * normal.y, normal * normal.z) * weight;
        Quadric {
            square,
            linear: normal * (distance * weight),
            constant: distance * distance * weight,
        }
    }

    /// Of the distance from a point.
    fn point(p: DVec3, weight: f64) -> Quadric {
        Quadric {
            square: DMat3::IDENTITY * weight,
            linear: -p * weight,
            constant: p.length_squared() * weight,
        }
    }

    fn add(&mut self, other: &Quadric) {
        self.square += other.square;
        self.linear += other.linear;
        self.constant += other.constant;
    }

    fn at(&self, p: DVec3) -> f64 {
        p.dot(self.square * p) + 2.0 * p.dot(self.linear) + self.constant
    }
}

/// An edge that may be drawn together: `b` goes into `a`, and `a` to a new place.
struct Collapse {
    cost: f64,
    a: usize,
    b: usize,
    to: DVec3,
    versions: [u32; 2],
}

impl Ord for Collapse {
    /// The cheapest is the greatest; of equals, the one with the smaller vertices.
    fn cmp(&self, other: &Collapse) -> Ordering {
        let by_cost = other.cost.total_cmp(&self.cost);
        by_cost.then((other.a, other.b).cmp(&(self.a, self.b)))
    }
}

impl PartialOrd for Collapse {
    fn partial_cmp(&self, other: &Collapse) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Collapse {
    fn eq(&self, other: &Collapse) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Collapse {}

struct Work {
    positions: Vec<DVec3>,
    quadrics: Vec<Quadric>,
    /// Counted up whenever a vertex moves.
    versions: Vec<u32>,
    /// The living triangles around each vertex.
    around: Vec<Vec<usize>>,
    triangles: Vec<Option<[usize; 3]>>,
    materials: Vec<usize>,
}

impl Work {
    fn new(mesh: &Mesh, materials: &[usize]) -> Work {
        let count = mesh.positions.len();
        let mut work = Work {
            positions: mesh.positions.clone(),
            quadrics: vec![Quadric::ZERO; count],
            versions: vec![0; count],
            around: mesh.around(),
            triangles: mesh.triangles.iter().map(|&triangle| Some(triangle)).collect(),
            materials: materials.to_vec(),
        };
        for (i, &triangle) in mesh.triangles.iter().enumerate() {
            let [a, b, c] = mesh.corners(i);
            let twice = (b - a).cross(c - a);
            let normal = twice.normalize_or_zero();
            let plane = Quadric::plane(normal, a, twice.length() / 2.0);
            for (k, &corner) in triangle.iter().enumerate() {
                work.quadrics[corner].add(&plane);
                let next = triangle[(k + 1) % 3];
                if work.on_border(corner, next, materials[i]) {
                    let (from, to) = (mesh.positions[corner], mesh.positions[next]);
                    let across = (to - from).cross(normal).normalize_or_zero();
                    let weight = BORDER * from.distance_squared(to);
                    let wall = Quadric::plane(across, from, weight);
                    work.quadrics[corner].add(&wall);
                    work.quadrics[next].add(&wall);
                }
            }
        }
        work
    }

    /// Whether an edge of a triangle has another material on its other side.
    fn on_border(&self, a: usize, b: usize, material: usize) -> bool {
        let other_side = |&i: &usize| {
            self.materials[i] != material && self.triangles[i].is_some_and(|t| t.contains(&b))
        };
        self.around[a].iter().any(other_side)
    }

    fn neighbours(&self, vertex: usize) -> Vec<usize> {
        let triangles = self.around[vertex].iter().filter_map(|&i| self.triangles[i]);
        let mut found: Vec<usize> = triangles.flatten().filter(|&v| v != vertex).collect();
        found.sort_unstable();
        found.dedup();
        found
    }

    fn collapse(&self, a: usize, b: usize) -> Collapse {
        let middle = self.positions[a].midpoint(self.positions[b]);
        let length = self.positions[a].distance_squared(self.positions[b]);
        let mut sum = self.quadrics[a];
        sum.add(&self.quadrics[b]);
        sum.add(&Quadric::point(middle, PULL * length));
        let solved = sum.square.inverse() * -sum.linear;
        let near = solved.distance_squared(middle) < 4.0 * length;
        let to = if near { solved } else { middle };
        let versions = [self.versions[a], self.versions[b]];
        Collapse { cost: sum.at(to), a, b, to, versions }
    }

    /// Whether the surface stays one: the ends have no common neighbours but the two across the
    /// edge, no triangle turns over, and none becomes a sliver.
    fn allows(&self, collapse: &Collapse) -> bool {
        let (a, b) = (collapse.a, collapse.b);
        let theirs = self.neighbours(b);
        let common = self.neighbours(a).iter().filter(|v| theirs.contains(v)).count();
        if common != 2 {
            return false;
        }
        let touched = self.around[a].iter().chain(&self.around[b]);
        let mut remaining = touched
            .filter_map(|&i| self.triangles[i])
            .filter(|triangle| !(triangle.contains(&a) && triangle.contains(&b)));
        remaining.all(|triangle| {
            let before = triangle.map(|v| self.positions[v]);
            let after =
                triangle.map(|v| if v == a || v == b { collapse.to } else { self.positions[v] });
            may_become(before, after)
        })
    }

    fn apply(&mut self, collapse: &Collapse) {
        let (a, b) = (collapse.a, collapse.b);
        for i in std::mem::take(&mut self.around[b]) {
            let Some(triangle) = self.triangles[i] else { continue };
            if triangle.contains(&a) {
                self.triangles[i] = None;
                for v in triangle.into_iter().filter(|&v| v != b) {
                    self.around[v].retain(|&other| other != i);
                }
            } else {
                self.triangles[i] = Some(triangle.map(|v| if v == b { a } else { v }));
                self.around[a].push(i);
            }
        }
        let theirs = self.quadrics[b];
        self.quadrics[a].add(&theirs);
        self.positions[a] = collapse.to;
        self.versions[a] += 1;
        self.versions[b] += 1;
    }

    /// What is left, with vertices in the order in which triangles first use them.
    fn finish(self) -> (Mesh, Vec<usize>) {
        let mut mesh = Mesh::default();
        let mut materials = Vec::new();
        let mut names = vec![usize::MAX; self.positions.len()];
        for (triangle, material) in self.triangles.into_iter().zip(self.materials) {
            let Some(triangle) = triangle else { continue };
            let triangle = triangle.map(|v| {
                if names[v] == usize::MAX {
                    names[v] = mesh.positions.len();
                    mesh.positions.push(self.positions[v]);
                }
                names[v]
            });
            mesh.triangles.push(triangle);
            materials.push(material);
        }
        (mesh, materials)
    }
}
