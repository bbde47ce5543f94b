//! Triangles, watertight [Woop13]: of two triangles that share an edge, one at least is met.

use glam::{BVec3, DVec3, Vec2, Vec3};

use super::Bounds;
use super::lanes::{Lanes, Portable};
use super::ray::{Point, Probe, Sheet, Surface};
use super::rounding;

/// A triangle taken from its block.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    /// World units.
    pub corners: [[f32; 3]; 3],
}

impl Face {
    /// Twice the signed areas of the three parts into which the ray cuts the triangle, seen along
    /// the ray; they are the barycentric weights, not yet divided by their sum.
    ///
    /// In f64 the corners relative to the origin are exact or nearly, and two triangles compute the
    /// same numbers on the edge they share. A difference of rounded products is of the right sign or
    /// zero, since rounding keeps order; zero counts as inside. So no gap is left between them.
    #[inline(always)]
    fn parts<L: Lanes>(&self, lanes: L, probe: &Probe) -> L::Exact {
        let [x, y, z] = probe.turn.axes();
        let depth = self.across(lanes, probe, z);
        let x = self.across(lanes, probe, x);
        let y = self.across(lanes, probe, y);
        let shear = probe.exact_shear();
        let x = lanes.exact_sub(x, lanes.exact_scale(depth, shear[0]));
        let y = lanes.exact_sub(y, lanes.exact_scale(depth, shear[1]));
        // Of the corners after and before each one: c and b, a and c, b and a.
        let (after, last) = (lanes.exact_turn(x), lanes.exact_turn(y));
        let (next, other) = (lanes.exact_turn(after), lanes.exact_turn(last));
        lanes.exact_sub(lanes.exact_mul(next, last), lanes.exact_mul(other, after))
    }

    /// The three corners along an axis, from the origin.
    #[inline(always)]
    fn across<L: Lanes>(&self, lanes: L, probe: &Probe, axis: usize) -> L::Exact {
        let [a, b, c] = &self.corners;
        let origin = lanes.exact_splat(f64::from(probe.near_origin[axis]));
        lanes.exact_sub(lanes.exact([a[axis], b[axis], c[axis]]), origin)
    }

    /// By the corners' order, not of unit length. Differences of f32 fit f64, and so mostly do their
    /// products: slivers have normals too.
    #[inline(always)]
    fn normal<L: Lanes>(&self, lanes: L) -> L::Exact {
        let [a, b, c] = self.corners;
        let (a, b, c) = (lanes.exact(a), lanes.exact(b), lanes.exact(c));
        lanes.exact_cross(lanes.exact_sub(b, a), lanes.exact_sub(c, a))
    }

    /// The same in numbers.
    pub fn exact_normal(&self) -> [f64; 3] {
        Portable.exact_store(self.normal(Portable))
    }

    /// Where a ray meets the triangle that is known to meet it.
    #[inline(always)]
    pub fn parameter<L: Lanes>(&self, lanes: L, probe: &Probe) -> f32 {
        self.in_plane(lanes, probe, self.normal(lanes)) as f32
    }

    /// Where the ray meets the plane of the triangle.
    #[inline(always)]
    fn in_plane<L: Lanes>(&self, lanes: L, probe: &Probe, normal: L::Exact) -> f64 {
        let origin = lanes.exact(probe.near_origin.to_array());
        let direction = lanes.exact(probe.near_direction.to_array());
        let way = lanes.exact_sub(lanes.exact(self.corners[0]), origin);
        lanes.exact_dot(normal, way) / lanes.exact_dot(normal, direction)
    }

    /// The parameter t > 0 at which the ray meets the triangle, edges included; `inside` if it is
    /// known to pass inside of the edges.
    ///
    /// It comes from the plane of the triangle, so that its sign says on which side the origin is: a
    /// ray that leaves the triangle never comes back to it.
    #[inline(always)]
    pub fn meet<L: Lanes>(&self, lanes: L, probe: &Probe, inside: bool) -> Option<f32> {
        if !inside {
            let [u, v, w] = lanes.exact_store(self.parts(lanes, probe));
            let mixed = (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0);
            // Seen edge on, or too small to be seen: those around it are met.
            if mixed || (u == 0.0 && v == 0.0 && w == 0.0) {
                return None;
            }
        }
        let t = self.in_plane(lanes, probe, self.normal(lanes));
        (t > 0.0 && t < f64::INFINITY).then_some(t as f32)
    }

    /// The place where the ray meets it, and its parameter; `normals` are those at its corners.
    #[inline(always)]
    pub fn surface<L: Lanes>(
        &self,
        lanes: L,
        probe: &Probe,
        normals: Option<[Vec3; 3]>,
    ) -> (Surface, f32) {
        // All of one sign.
        let weights = lanes.exact_abs(self.parts(lanes, probe));
        let sum = lanes.exact_sum(weights);
        let weights = if sum > 0.0 {
            lanes.exact_scale(weights, 1.0 / sum)
        } else {
            lanes.exact_splat(1.0 / 3.0)
        };
        let [u, v, w] = lanes.exact_store(weights);
        let [a, b, c] = self.corners;
        let (a, b, c) = (lanes.exact(a), lanes.exact(b), lanes.exact(c));
        let exact = lanes.exact_add(lanes.exact_scale(a, u), lanes.exact_scale(b, v));
        let exact = lanes.exact_add(exact, lanes.exact_scale(c, w));
        let magnitude = lanes.exact_add(lanes.exact_abs(a), lanes.exact_abs(b));
        let magnitude = lanes.exact_add(magnitude, lanes.exact_abs(c));
        let (position, error) = rounding::near(lanes, exact, magnitude);
        let normal = self.normal(lanes);
        let t = self.in_plane(lanes, probe, normal) as f32;
        let length = lanes.exact_dot(normal, normal).sqrt();
        let ng = if length > 0.0 && length < f64::INFINITY {
            lanes.exact_scale(normal, 1.0 / length)
        } else {
            lanes.exact([0.0, 0.0, 1.0])
        };
        let ns = match normals {
            None => lanes.exact_round(ng).into(),
            Some(normals) => shading_normal(lanes.exact_store(ng), normals, [u, v, w]),
        };
        let point = Point { position, error, ng: lanes.exact_round(ng).into(), sheet: Sheet::NONE };
        (Surface { point, ns, uv: Vec2::new(v as f32, w as f32) }, t)
    }
}

/// The mean of the corners' normals, on the side of the geometric one. Without jumps, so that a loop
/// over it becomes vectors.
#[inline(always)]
pub(super) fn shading_normal(ng: [f64; 3], [a, b, c]: [Vec3; 3], [u, v, w]: [f64; 3]) -> Vec3 {
    let ng = DVec3::from_array(ng);
    let n = u * a.as_dvec3() + v * b.as_dvec3() + w * c.as_dvec3();
    let scale = 1.0 / n.length();
    let n = n * (if (scale > 0.0) & (scale < f64::INFINITY) { scale } else { 0.0 });
    let cos = ng.dot(n);
    let turned = Vec3::select(BVec3::splat(cos > 0.0), n.as_vec3(), -n.as_vec3());
    Vec3::select(BVec3::splat((cos > 0.0) | (cos < 0.0)), turned, ng.as_vec3())
}

/// Normal by the corners' order, not of unit length.
pub(super) fn normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a)
}

/// What [`Face::meet`] says, by plain instructions.
#[cfg(test)]
pub(super) fn meet(probe: &Probe, corners: [DVec3; 3], inside: bool) -> Option<f32> {
    let corners = corners.map(|corner| corner.as_vec3().to_array());
    Face { corners }.meet(super::lanes::Portable, probe, inside)
}

/// The box of the three corners.
pub(super) fn bounds(corners: [Vec3; 3]) -> Bounds {
    let [a, b, c] = corners;
    Bounds { min: a.min(b).min(c), max: a.max(b).max(c) }
}

/// In square world units.
pub(super) fn area(corners: [DVec3; 3]) -> f64 {
    normal(corners).length() / 2.0
}
