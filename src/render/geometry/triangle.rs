//! Triangles, watertight [Woop13]: of two triangles that share an edge, one at least is met.

use glam::{DVec3, Vec2, Vec3};

use super::Bounds;
use super::exact::Exact;
use super::ray::{Point, Probe, Surface};
use super::rounding;
use super::shapes::Shapes;

/// Twice the signed areas of the three parts into which the ray cuts the triangle, seen along the
/// ray; they are the barycentric weights, not yet divided by their sum.
///
/// In f64 the corners relative to the origin are exact or nearly, and two triangles compute the
/// same numbers on the edge they share. A difference of rounded products is of the right sign or
/// zero, since rounding keeps order; zero counts as inside. So no gap is left between them.
#[inline(always)]
fn parts(probe: &Probe, [a, b, c]: [DVec3; 3]) -> Exact {
    let [x, y, z] = probe.axes;
    let origin = probe.origin();
    let across = |axis: usize| Exact::new(a[axis], b[axis], c[axis]) - Exact::splat(origin[axis]);
    let depth = across(z);
    let x = across(x) - depth * probe.shear[0];
    let y = across(y) - depth * probe.shear[1];
    // Of the corners after and before each one: c and b, a and c, b and a.
    let (next, last) = (x.turned(), y.turned());
    next.turned() * last - last.turned() * next
}

/// Normal by the corners' order, not of unit length. Differences of f32 fit f64, and so mostly do
/// their products: slivers have normals too.
#[inline(always)]
pub(super) fn normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    exact_normal([a.into(), b.into(), c.into()]).to_array().into()
}

#[inline(always)]
fn exact_normal([a, b, c]: [Exact; 3]) -> Exact {
    (b - a).cross(c - a)
}

/// Where the ray meets the plane of the triangle.
#[inline(always)]
fn parameter(probe: &Probe, normal: Exact, corner: Exact) -> f64 {
    normal.dot(corner - probe.origin().into()) / normal.dot(probe.direction().into())
}

/// The parameter t > 0 at which the ray meets the triangle, edges included; `inside` if it is known
/// to pass inside of the edges.
///
/// It comes from the plane of the triangle, so that its sign says on which side the origin is: a
/// ray that leaves the triangle never comes back to it.
#[inline(always)]
pub(super) fn meet(probe: &Probe, corners: [DVec3; 3], inside: bool) -> Option<f32> {
    if !inside {
        let [u, v, w] = parts(probe, corners).to_array();
        let (least, most) = (u.min(v).min(w), u.max(v).max(w));
        // Seen edge on, or too small to be seen: those around it are met.
        if (least < 0.0 && most > 0.0) || (least == 0.0 && most == 0.0) {
            return None;
        }
    }
    let corners = corners.map(Exact::from);
    let t = parameter(probe, exact_normal(corners), corners[0]);
    (t > 0.0 && t.is_finite()).then_some(t as f32)
}

/// The place where the ray meets it, and its parameter.
#[inline(always)]
pub(super) fn surface(probe: &Probe, shapes: &Shapes, index: usize) -> (Surface, f32) {
    let corners = shapes.exact_corners(index);
    let parts = parts(probe, corners);
    // The ray may pass outside by rounding: the nearest weights inside stand for it.
    let weights = (parts * parts.sum().signum()).positive();
    let sum = weights.sum();
    let weights = if sum > 0.0 { weights * (1.0 / sum) } else { Exact::splat(1.0 / 3.0) };
    let [u, v, w] = weights.to_array();
    let [a, b, c] = corners.map(Exact::from);
    let exact = a * u + b * v + c * w;
    let (position, error) = rounding::near(exact, a.abs() + b.abs() + c.abs());
    let normal = exact_normal([a, b, c]);
    let t = parameter(probe, normal, a) as f32;
    let length = normal.dot(normal).sqrt();
    let ng = if length > 0.0 && length < f64::INFINITY {
        normal * (1.0 / length)
    } else {
        DVec3::Z.into()
    };
    let ns = match shapes.corner_normals(index) {
        None => ng.to_f32(),
        Some(normals) => shading_normal(ng, normals, [u, v, w]),
    };
    let point = Point { position, error, ng: ng.to_f32() };
    (Surface { point, ns, uv: Vec2::new(v as f32, w as f32) }, t)
}

/// The mean of the corners' normals, on the side of the geometric one.
fn shading_normal(ng: Exact, [a, b, c]: [DVec3; 3], [u, v, w]: [f64; 3]) -> Vec3 {
    let n = (u * a + v * b + w * c).normalize_or_zero();
    match ng.dot(n.into()) {
        cos if cos > 0.0 => n.as_vec3(),
        cos if cos < 0.0 => -n.as_vec3(),
        _ => ng.to_f32(),
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
