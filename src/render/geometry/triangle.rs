//! Triangles, watertight [Woop13]: of two triangles that share an edge, one at least is met.

use glam::{DVec3, Vec2, Vec3};

use super::Bounds;
use super::ray::{Point, Probe, Surface};
use super::rounding;
use super::shapes::Shapes;

/// Twice the signed areas of the three parts into which the ray cuts the triangle, seen along the
/// ray; they are the barycentric weights, not yet divided by their sum.
///
/// In f64 the corners relative to the origin are exact or nearly, and two triangles compute the
/// same numbers on the edge they share. A difference of rounded products is of the right sign or
/// zero, since rounding keeps order; zero counts as inside. So no gap is left between them.
fn parts(probe: &Probe, corners: [DVec3; 3]) -> DVec3 {
    let z = probe.axis;
    let (x, y) = ((z + 1) % 3, (z + 2) % 3);
    let sheared = |corner: DVec3| {
        let p = (corner - probe.origin).to_array();
        (p[x] - probe.shear[0] * p[z], p[y] - probe.shear[1] * p[z])
    };
    let (a, b, c) = (sheared(corners[0]), sheared(corners[1]), sheared(corners[2]));
    DVec3::new(c.0 * b.1 - c.1 * b.0, a.0 * c.1 - a.1 * c.0, b.0 * a.1 - b.1 * a.0)
}

/// Normal by the corners' order, not of unit length. Differences of f32 fit f64, and so mostly do
/// their products: slivers have normals too.
pub(super) fn normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a)
}

/// The parameter t > 0 at which the ray meets the triangle, edges included; `inside` if it is known
/// to pass inside of the edges.
///
/// It comes from the plane of the triangle, so that its sign says on which side the origin is: a
/// ray that leaves the triangle never comes back to it.
pub(super) fn meet(probe: &Probe, corners: [DVec3; 3], inside: bool) -> Option<f32> {
    if !inside {
        let parts = parts(probe, corners);
        let mixed = parts.min_element() < 0.0 && parts.max_element() > 0.0;
        // Seen edge on, or too small to be seen: those around it are met.
        if mixed || parts == DVec3::ZERO {
            return None;
        }
    }
    let normal = normal(corners);
    let t = normal.dot(corners[0] - probe.origin) / normal.dot(probe.direction);
    (t > 0.0 && t.is_finite()).then_some(t as f32)
}

/// The place where the ray meets it.
pub(super) fn surface(probe: &Probe, shapes: &Shapes, index: usize) -> Surface {
    let corners = shapes.exact_corners(index);
    let parts = parts(probe, corners);
    let sum = parts.element_sum();
    // The ray may pass outside by rounding: the nearest weights inside stand for it.
    let weights = if sum != 0.0 { (parts / sum).max(DVec3::ZERO) } else { DVec3::ONE };
    let weights = weights / weights.element_sum();
    let [a, b, c] = corners;
    let exact = weights.x * a + weights.y * b + weights.z * c;
    let (position, error) = rounding::position(exact, a.abs() + b.abs() + c.abs());
    let ng = normal(corners).normalize_or(DVec3::Z);
    let ns = shapes.corner_normals(index).map_or(ng, |[na, nb, nc]| {
        let n = (weights.x * na + weights.y * nb + weights.z * nc).normalize_or_zero();
        match n.dot(ng) {
            cos if cos > 0.0 => n,
            cos if cos < 0.0 => -n,
            _ => ng,
        }
    });
    Surface {
        point: Point { position, error, ng: ng.as_vec3() },
        ns: ns.as_vec3(),
        uv: Vec2::new(weights.y as f32, weights.z as f32),
    }
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
