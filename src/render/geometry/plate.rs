//! A triangle as many rays at once want it, and the quick test by which f32 tells those that
//! certainly miss it and those that certainly meet it from the few that f64 must decide about.
//!
//! The plane of the triangle is z = k − nₓ·x − n_y·y along the axis z of its normal's greatest
//! coordinate, so that |nₓ|, |n_y| ≤ 1; the weights of its second and third corner are linear in the
//! x and y of a point of it [Havel10]. All that is made once in f64 and rounded.
//!
//! What f32 errs by, u = 2⁻²⁴: let R be the greatest coordinate of the origin, and no coordinate of
//! the direction above 1.05. The height over the plane, k − nₓ·oₓ − n_y·o_y − o_z, is off by less
//! than u·(4|k| + 10R), its change along the ray, D, by less than 16u. Where |D| ≥ 64u, t is their
//! quotient, off by less than (4/3)·(u·(4|k| + 10R) + 16u·|t|) / |D|, and its own rounding. With room,
//! that is e = u·(12|k| + 32R + 40|t|) / |D|, for |D| < 3.2. A weight is off by 1.05·c·e, where c is
//! the sum of the sizes of its factors, and by the rounding of the sum and of the point; that is
//! less than 9u·c·(R + 1.05|t|), and so than c·e, and 6u·(|u₀| + |v₀|) + 3u. Where |D| < 64u, or
//! anything is no number, nothing is certain.

use glam::DVec3;

use super::shapes::Primitive;
use super::triangle::Face;
use super::wide::{Row, Wide};

/// u, half the gap between one and the next float.
const UNIT: f32 = f32::EPSILON / 2.0;

/// What is lost below the normal numbers, with room to spare: in world units, and the weights'
/// greatest factor that keeps it from mattering.
const LEAST: f64 = 1.0 / (1_u128 << 100) as f64;
const STEEPEST: f64 = (1_u128 << 90) as f64;

/// More than a few operations of f64 lose, in parts of the terms.
const LOST: f64 = 16.0 * f64::EPSILON;

/// A triangle for many rays.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Plate {
    /// The axes x, y and z of the plane.
    axes: [u8; 3],
    /// nₓ, n_y, and k.
    plane: [f32; 3],
    /// Of the weights of the second and of the third corner: their factors of x and y, and what they
    /// begin with.
    weights: [[f32; 3]; 2],
    /// u·12|k| and more.
    height_error: f32,
    /// 3c, and the error of a weight beside 3c·e.
    weight_error: [f32; 2],
    /// The number of the triangle.
    pub primitive: u32,
    /// Whether rays cross its plane as that of the one before.
    pub joins: bool,
}

/// Rows for coordinates: one more than there are, so that any number of two bits names one.
pub(super) const AXES: usize = 4;

/// Rays side by side: what the test wants of them.
pub(super) struct Beam {
    pub origin: [Row; AXES],
    pub direction: [Row; AXES],
    /// u·32 times the greatest coordinate of the origin, without its sign.
    pub reach: Row,
}

/// The part of the greatest coordinate that [`Beam::reach`] is.
pub(super) const REACH: f32 = 32.0 * UNIT;

/// What f32 knows of where rays cross the plane of a triangle.
#[derive(Clone, Copy)]
pub(super) struct Crossing<W: Wide> {
    /// Bounds of the parameter there.
    pub low: W::Values,
    pub high: W::Values,
    /// Half of what is between them; no number where the ray runs along the plane.
    error: W::Values,
    /// The place, along the axes x and y of the plane.
    place: [W::Values; 2],
}

impl<W: Wide> Crossing<W> {
    /// Of no plane.
    #[inline(always)]
    pub fn none(wide: W) -> Self {
        let zero = wide.splat(0.0);
        Self { low: zero, high: zero, error: zero, place: [zero; 2] }
    }
}

/// What f32 knows of where rays pass a triangle.
pub(super) struct Known<W: Wide> {
    /// Where the ray certainly passes outside of the edges.
    pub outside: W::Mask,
    /// Where it certainly passes inside of them.
    pub inside: W::Mask,
}

impl Plate {
    /// Of corners in world units, and [`Face::exact_normal`] of them.
    pub fn new(face: &Face, normal: DVec3, primitive: Primitive) -> Self {
        let size = normal.abs();
        let z = if size.y > size.x { 1 } else { 0 };
        let z = if size.z > size[z] { 2 } else { z };
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let [a, b, c] = face.corners.map(|corner| DVec3::from_array(corner.map(f64::from)));
        let (nx, ny) = (normal[x] / normal[z], normal[y] / normal[z]);
        let k = a[z] + nx * a[x] + ny * a[y];
        let row = |ux: f64, uy: f64| {
            let (ux, uy) = (ux / normal[z], uy / normal[z]);
            [ux, uy, -(ux * a[x] + uy * a[y])]
        };
        let second = row(c[y] - a[y], a[x] - c[x]);
        let third = row(a[y] - b[y], b[x] - a[x]);
        let factor = second[0].abs() + second[1].abs() + third[0].abs() + third[1].abs();
        let start = second[2].abs() + third[2].abs() + 1.0;
        // What f64 loses, in parts: much of a sliver, and then nothing is certain.
        let (e, f) = (b - a, c - a);
        let terms =
            [(x, y), (y, z), (z, x)].map(|(i, j)| (e[i] * f[j]).abs() + (e[j] * f[i]).abs());
        let lost = LOST * terms.iter().sum::<f64>() / size[z];
        let clear = factor < STEEPEST && lost < f64::from(UNIT) / 4.0;
        let sure = |error: f64| if clear { error as f32 } else { f32::NAN };
        let (unit, far) = (f64::from(UNIT), lost * (a.x.abs() + a.y.abs() + a.z.abs()));
        Self {
            axes: [x as u8, y as u8, z as u8],
            plane: [nx as f32, ny as f32, k as f32],
            weights: [second.map(|w| w as f32), third.map(|w| w as f32)],
            height_error: sure(12.0 * unit * k.abs() + far + LEAST),
            primitive: primitive.bits(),
            joins: false,
            weight_error: [sure(3.0 * factor), sure(8.0 * unit * start + factor * far)],
        }
    }

    /// Names itself one that is crossed just as `first` is, and in whose place that may be asked, if
    /// their planes are the same to the bit, as those of a rectangle along the axes can be. The first
    /// is then unsure enough for both.
    pub fn join(&mut self, first: &mut Self) -> bool {
        self.joins = self.axes == first.axes
            && self.plane == first.plane
            && (self.height_error + first.height_error).is_finite();
        if self.joins {
            first.height_error = first.height_error.max(self.height_error);
        }
        self.joins
    }

    /// What is known of where rays cross its plane.
    #[inline(always)]
    pub fn cross<W: Wide>(&self, wide: W, beam: &Beam) -> Crossing<W> {
        let [x, y, z] = self.axes;
        let (x, y, z) = (usize::from(x) % AXES, usize::from(y) % AXES, usize::from(z) % AXES);
        let (ox, oy, oz) =
            (wide.load(&beam.origin[x]), wide.load(&beam.origin[y]), wide.load(&beam.origin[z]));
        let (dx, dy, dz) = (
            wide.load(&beam.direction[x]),
            wide.load(&beam.direction[y]),
            wide.load(&beam.direction[z]),
        );
        let [nx, ny, k] = self.plane;
        let (nx, ny, k) = (wide.splat(nx), wide.splat(ny), wide.splat(k));
        let height = wide.sub_mul(ny, oy, wide.sub_mul(nx, ox, wide.sub(k, oz)));
        let steepness = wide.mul_add(ny, dy, wide.mul_add(nx, dx, dz));
        let inverse = wide.div(wide.splat(1.0), steepness);
        let t = wide.mul(height, inverse);
        let place = [wide.mul_add(t, dx, ox), wide.mul_add(t, dy, oy)];
        // How much t may be off; no number where the ray runs along the plane.
        let spread = wide.abs(inverse);
        let error = wide.add(wide.splat(self.height_error), wide.load(&beam.reach));
        let error = wide.mul_add(wide.abs(t), wide.splat(40.0 * UNIT), error);
        let error = wide.mul(error, spread);
        let along = wide.less(wide.splat(1.0 / (64.0 * UNIT)), spread);
        let error = wide.select(along, wide.splat(f32::NAN), error);
        Crossing { low: wide.sub(t, error), high: wide.add(t, error), error, place }
    }

    /// What is known of where rays pass it that cross its plane so.
    #[inline(always)]
    pub fn meet<W: Wide>(&self, wide: W, crossing: &Crossing<W>) -> Known<W> {
        let [px, py] = crossing.place;
        let [[ux, uy, u], [vx, vy, v]] = self.weights;
        let u = wide.mul_add(wide.splat(uy), py, wide.splat(u));
        let v = wide.mul_add(wide.splat(vy), py, wide.splat(v));
        let u = wide.mul_add(wide.splat(ux), px, u);
        let v = wide.mul_add(wide.splat(vx), px, v);
        let w = wide.sub(wide.sub(wide.splat(1.0), u), v);
        let least = wide.min(wide.min(u, v), w);
        let [factor, start] = self.weight_error;
        let edge = wide.mul_add(wide.splat(factor), crossing.error, wide.splat(start));
        Known {
            outside: wide.less(wide.add(least, edge), wide.splat(0.0)),
            inside: wide.less(edge, least),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::geometry::lanes::Portable;
    use crate::render::geometry::packet::Packet;
    use crate::render::geometry::ray::Ray;
    use crate::render::geometry::shapes::Kind;
    use crate::render::geometry::tests::meshes::Chance;

    /// Weights of all corners and the parameter, in f64.
    fn exact(ray: &Ray, [a, b, c]: [DVec3; 3]) -> ([f64; 3], f64) {
        let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        let n = (b - a).cross(c - a);
        let t = n.dot(a - o) / n.dot(d);
        let p = o + t * d;
        let part = |i: DVec3, j: DVec3| (j - i).cross(p - i).dot(n) / n.length_squared();
        ([part(b, c), part(c, a), part(a, b)], t)
    }

    /// What is certain is so: triangles of all sizes and shapes near and far, rays near their edges.
    #[test]
    fn what_f32_knows_is_so() {
        let mut chance = Chance::new(80);
        let (mut inside, mut outside, mut open) = (0, 0, 0);
        for _ in 0..60_000 {
            let size = 10_f64.powf(2.0 * chance.signed());
            let thin = [1.0, 1.0, 1e-2, 1e-4][chance.below(4)];
            let far = [0.0, 1.0, 10_f64.powf(3.0 * chance.signed())][chance.below(3)];
            let a = chance.cube() * far;
            let b = a + chance.cube() * size;
            let c = a.lerp(b, 0.5) + chance.cube() * size * thin;
            let corners = [a, b, c].map(|p| p.as_vec3());
            let [a, b, c] = corners.map(|p| p.as_dvec3());
            let primitive = Primitive::new(Kind::Triangle, 0);
            let face = Face { corners: corners.map(|p| p.to_array()) };
            let plate = Plate::new(&face, face.exact_normal().into(), primitive);
            let rays: [Ray; 4] = std::array::from_fn(|_| {
                let off = 10_f64.powf(-6.0 * chance.unit());
                let (v, w) = (chance.unit(), off * chance.signed());
                let turn = chance.below(3);
                let [i, j, k] = [0, 1, 2].map(|n| [a, b, c][(n + turn) % 3]);
                let target = i + v * (j - i) + w * (k - i);
                let mut from = a + chance.cube() * far.max(size) * 10_f64.powf(chance.signed());
                // Some close to the plane, so that rays run along it; and some where errors of their
                // own are small.
                let kind = chance.below(5);
                if kind == 0 {
                    from *= 1e-4;
                }
                if kind == 1 {
                    let up = (b - a).cross(c - a).normalize_or_zero();
                    let over = size * 10_f64.powf(-3.0 - 5.0 * chance.unit());
                    from = target + 2.0 * chance.signed() * (b - a) + over * up;
                }
                let way = (target - from.as_vec3().as_dvec3()).normalize_or(DVec3::Z);
                Ray::new(from.as_vec3(), way.as_vec3())
            });
            let mut packet = Packet::EMPTY;
            packet.fill::<Portable>(&rays);
            let crossing = plate.cross(Portable, &packet.beam);
            let known = plate.meet(Portable, &crossing);
            for (lane, ray) in rays.iter().enumerate() {
                let (weights, t) = exact(ray, [a, b, c]);
                let least = weights.into_iter().fold(f64::INFINITY, f64::min);
                if known.inside.test(lane) {
                    inside += 1;
                    assert!(least > 0.0, "{ray:?} {face:?}");
                } else if known.outside.test(lane) {
                    outside += 1;
                    assert!(least < 0.0, "{ray:?} {face:?}");
                } else {
                    open += 1;
                }
                let (low, high) = (f64::from(crossing.low[lane]), f64::from(crossing.high[lane]));
                assert!(!(t < low || t > high), "{t} in {low} to {high}: {ray:?} {face:?}");
            }
        }
        assert!(inside > 20_000 && outside > 25_000, "{inside} {outside} {open}");
    }

    #[test]
    fn the_two_triangles_of_a_wall_are_crossed_together() {
        let plate = |corners: [[f32; 3]; 3]| {
            let face = Face { corners };
            Plate::new(&face, face.exact_normal().into(), Primitive::new(Kind::Triangle, 0))
        };
        let [a, b, c, d] = [[0.1, 0.0, 5.3], [4.7, 0.0, 5.3], [4.7, 3.1, 5.3], [0.1, 3.1, 5.3]];
        let mut first = plate([a, b, c]);
        let least = first.height_error;
        let mut far = plate([a.map(|x| 9.0 * x), c, d]);
        assert!(!far.join(&mut first) && first.height_error == least);
        let mut second = Plate { height_error: 2.0 * least, ..plate([a, c, d]) };
        assert!(second.join(&mut first) && first.height_error == 2.0 * least);
        let mut unsure = Plate { height_error: f32::NAN, ..second };
        assert!(!unsure.join(&mut first));
    }
}
