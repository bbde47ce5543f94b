//! Triangles over shared vertices, counter-clockwise seen from outside.

use glam::DVec3;

/// The least cosine between a triangle before and after one of its corners moves.
const TURN: f64 = 0.3;
/// The least quality of a moved triangle that was no worse before.
const QUALITY: f64 = 0.2;

/// A surface.
#[derive(Default)]
pub struct Mesh {
    /// Where the vertices are.
    pub positions: Vec<DVec3>,
    /// Corners, indices into `positions`.
    pub triangles: Vec<[usize; 3]>,
}

impl Mesh {
    /// Adds a quad as two triangles, cut along its shorter diagonal.
    pub fn push_quad(&mut self, [a, b, c, d]: [usize; 4]) {
        let length = |p: usize, q: usize| self.positions[p].distance_squared(self.positions[q]);
        let halves = if length(a, c) <= length(b, d) {
            [[a, b, c], [a, c, d]]
        } else {
            [[b, c, d], [b, d, a]]
        };
        self.triangles.extend(halves);
    }

    /// The triangles around each vertex.
    pub fn around(&self) -> Vec<Vec<usize>> {
        let mut around = vec![Vec::new(); self.positions.len()];
        for (i, triangle) in self.triangles.iter().enumerate() {
            for &corner in triangle {
                around[corner].push(i);
            }
        }
        around
    }

    /// Moves one vertex after the other where `target` says, given its place and the mean of its
    /// neighbours; but none that would fold the surface or make a sliver.
    pub fn shift(&mut self, target: impl Fn(DVec3, DVec3) -> DVec3) {
        for (vertex, triangles) in self.around().into_iter().enumerate() {
            let corners = triangles.iter().flat_map(|&i| self.triangles[i]);
            let others = corners.filter(|&corner| corner != vertex);
            let sum: DVec3 = others.map(|corner| self.positions[corner]).sum();
            let from = self.positions[vertex];
            let to = target(from, sum / (2 * triangles.len()) as f64);
            let keeps = triangles.iter().all(|&i| {
                let before = self.corners(i);
                let after = self.triangles[i]
                    .map(|corner| if corner == vertex { to } else { self.positions[corner] });
                may_become(before, after)
            });
            if keeps {
                self.positions[vertex] = to;
            }
        }
    }

    /// The corners of a triangle.
    pub fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|corner| self.positions[corner])
    }

    /// The mean of the faces' normals around each vertex, weighed by their angles there.
    pub fn smooth_normals(&self) -> Vec<DVec3> {
        let mut sums = vec![DVec3::ZERO; self.positions.len()];
        for &triangle in &self.triangles {
            let [a, b, c] = triangle.map(|corner| self.positions[corner]);
            let normal = (b - a).cross(c - a).normalize();
            for (corner, [before, here, after]) in
                triangle.into_iter().zip([[c, a, b], [a, b, c], [b, c, a]])
            {
                sums[corner] += normal * (before - here).angle_between(after - here);
            }
        }
        sums.into_iter().map(DVec3::normalize).collect()
    }
}

/// Whether a triangle may be moved so: it does not turn over, and becomes no sliver.
pub fn may_become(before: [DVec3; 3], after: [DVec3; 3]) -> bool {
    let twice = |[a, b, c]: [DVec3; 3]| (b - a).cross(c - a);
    let (old, new) = (twice(before), twice(after));
    old.dot(new) > TURN * old.length() * new.length()
        && quality(after) > quality(before).min(QUALITY)
}

/// How near a triangle is to an equilateral one, which has 1; a line has 0.
fn quality([a, b, c]: [DVec3; 3]) -> f64 {
    let sides = a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a);
    2.0 * 3f64.sqrt() * (b - a).cross(c - a).length() / sides
}
