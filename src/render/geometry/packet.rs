//! Rays side by side: a packet, which asks of boxes and planes together.
//!
//! Only usual rays are part of it; others, of odd lengths or without end in numbers, are left to
//! those who ask one by one.

use super::plate::{AXES, Beam, REACH};
use super::ray::{LEAST, MODERATE, Ray};
use super::shapes::Primitive;
use super::walk::WIDEN;
use super::wide::{MOST, Numbers, Row, Wide};

/// Directions of other lengths, squared, are no part of a packet.
const UNIT_LENGTH: [f32; 2] = [0.9, 1.1];

/// Rays side by side.
pub(super) struct Packet {
    pub beam: Beam,
    /// 1/d, finite.
    inverse: [Row; 3],
    /// Where the rays end; -1 for those that are no part of it.
    pub end: Row,
    /// What each ray is not to meet, by number: two triangles, or none.
    pub left_out: [Numbers; 2],
    /// A bit for each ray that is a part of it.
    pub active: u32,
}

pub(super) const NONE: Row = Row([0.0; MOST]);

impl Packet {
    pub const EMPTY: Self = Self {
        beam: Beam { origin: [NONE; AXES], direction: [NONE; AXES], reach: NONE },
        inverse: [NONE; 3],
        end: NONE,
        left_out: [Numbers([0; MOST]); 2],
        active: 0,
    };

    /// Takes rays in place of those it had; one at least, no more than the width.
    #[inline(always)]
    pub fn fill<W: Wide>(&mut self, rays: &[Ray]) {
        let last = rays.len() - 1;
        let Beam { origin: [ox, oy, oz, _], direction: [dx, dy, dz, _], reach } = &mut self.beam;
        let [Numbers(leaves), Numbers(reaches)] = &mut self.left_out;
        for lane in 0..W::WIDTH {
            let ray = &rays[lane.min(last)];
            (ox.0[lane], oy.0[lane], oz.0[lane]) = ray.origin.into();
            (dx.0[lane], dy.0[lane], dz.0[lane]) = ray.direction.into();
            self.end.0[lane] = if lane <= last { ray.t_max } else { -1.0 };
            leaves[lane] = ray.leaves.bits();
            reaches[lane] = ray.reaches.bits();
        }
        let [ix, iy, iz] = &mut self.inverse;
        let mut active = 0;
        for lane in 0..W::WIDTH {
            let (x, y, z) = (ox.0[lane].abs(), oy.0[lane].abs(), oz.0[lane].abs());
            let farthest = greater(greater(x, y), z);
            let (x, y, z) = (dx.0[lane], dy.0[lane], dz.0[lane]);
            let length = x * x + y * y + z * z;
            let usual = (farthest < MODERATE)
                & (length > UNIT_LENGTH[0])
                & (length < UNIT_LENGTH[1])
                & (self.end.0[lane] > 0.0);
            reach.0[lane] = farthest * REACH;
            ix.0[lane] = inverse(x);
            iy.0[lane] = inverse(y);
            iz.0[lane] = inverse(z);
            self.end.0[lane] = if usual { self.end.0[lane] } else { -1.0 };
            active |= u32::from(usual) << lane;
        }
        self.active = active;
    }

    /// A bit for each ray that meets a box before its limit.
    #[inline(always)]
    pub fn enters<W: Wide>(&self, wide: W, planes: &[[f32; 2]; 3], limit: W::Values) -> u32 {
        let mut near = wide.splat(0.0);
        let mut far = limit;
        for (axis, [lower, upper]) in planes.iter().enumerate() {
            let origin = wide.load(&self.beam.origin[axis]);
            let inverse = wide.load(&self.inverse[axis]);
            let lower = wide.mul(wide.sub(wide.splat(*lower), origin), inverse);
            let upper = wide.mul(wide.sub(wide.splat(*upper), origin), inverse);
            near = wide.max(near, wide.min(lower, upper));
            far = wide.min(far, wide.max(lower, upper));
        }
        let far = wide.mul(far, wide.splat(WIDEN));
        !wide.bits(wide.less(far, near)) & self.active
    }

    /// Where the rays meet the plane of a triangle, if they do: [`super::triangle::Face::meet`] of those that are
    /// known to pass inside of the edges; -1 if they don't.
    #[inline(always)]
    pub fn parameters<W: Wide>(&self, normal: [f64; 3], corner: [f64; 3]) -> Row {
        let mut all = NONE;
        let [ox, oy, oz, _] = &self.beam.origin;
        let [dx, dy, dz, _] = &self.beam.direction;
        for lane in 0..W::WIDTH {
            let origin = [ox.0[lane], oy.0[lane], oz.0[lane]];
            let direction = [dx.0[lane], dy.0[lane], dz.0[lane]];
            all.0[lane] = parameter(normal, corner, origin, direction);
        }
        all
    }

    /// A bit for each ray that is not to meet a primitive.
    #[inline(always)]
    pub fn leaves_out<W: Wide>(&self, primitive: Primitive) -> u32 {
        let [Numbers(leaves), Numbers(reaches)] = &self.left_out;
        let mut bits = 0;
        for lane in 0..W::WIDTH {
            let one = (leaves[lane] == primitive.bits()) | (reaches[lane] == primitive.bits());
            bits |= u32::from(one) << lane;
        }
        bits
    }

    /// Whether a ray is not to meet a primitive.
    pub fn is_left_out(&self, lane: usize, primitive: Primitive) -> bool {
        self.left_out.iter().any(|numbers| numbers.0[lane % MOST] == primitive.bits())
    }

    /// A ray of it, without end.
    pub fn ray(&self, lane: usize) -> Ray {
        let at = |rows: &[Row; AXES]| [rows[0].0[lane], rows[1].0[lane], rows[2].0[lane]].into();
        Ray::new(at(&self.beam.origin), at(&self.beam.direction))
    }
}

/// Finite, whatever the coordinate of the direction: see [`super::ray`].
#[inline(always)]
fn inverse(d: f32) -> f32 {
    1.0 / greater(d.abs(), LEAST).copysign(d)
}

/// [`super::triangle::Face::meet`] where the ray is known to pass inside of the edges, by the same operations; -1 if
/// it meets nothing.
#[inline(always)]
pub(super) fn parameter(
    [nx, ny, nz]: [f64; 3],
    corner: [f64; 3],
    origin: [f32; 3],
    to: [f32; 3],
) -> f32 {
    let x = corner[0] - f64::from(origin[0]);
    let y = corner[1] - f64::from(origin[1]);
    let z = corner[2] - f64::from(origin[2]);
    let above = nx * x + ny * y + nz * z;
    let along = nx * f64::from(to[0]) + ny * f64::from(to[1]) + nz * f64::from(to[2]);
    let t = above / along;
    if (t > 0.0) & (t < f64::INFINITY) { t as f32 } else { -1.0 }
}

#[inline(always)]
fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
