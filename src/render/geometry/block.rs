//! Eight triangles side by side, as a leaf of the tree holds them, and the quick f32 test that
//! throws out those a ray certainly misses, keeps those it certainly meets, and leaves the few that
//! remain to f64.
//!
//! The test is Woop's [Woop13], with a bound on its own error for the whole block, u = 2⁻²⁴. Let Z
//! bound the depth of corners from the origin, and S their sheared coordinates, (x − o) − s·z with
//! |s| ≤ 1. Those err by less than δ = u·(7Z + 3S), the rounding of s included. A part is a difference
//! of two products of them, and errs by 4S·δ + 2δ² + 4u·S² at most. With q = 32u·Z and S + q in place
//! of S, that is less than (S + q)·(q + 20u·(S + q)). [`LEAST`] is for products below the normal
//! numbers. Where corners and the ray are off by something more, δ grows by twice that, and q by eight
//! times.
//!
//! A ray is tested that passes the block's box, or passes it by 17u·Z and by what is off. Seen along
//! the ray no corner is farther from it than twice the greatest extent e of that box and twice as
//! much: so S + q is less than 2e + 3q. Z is less than the depth of any one corner and e, and e no
//! more than that. So the error is less than Z·([`SPANS`]·e + [`DEPTHS`]·Z).

use super::lanes::{LANES, Lanes};
use super::ray::{Axis, Probe};
use super::shapes::{Primitive, Shapes};
use super::triangle::Face;

/// u, half the gap between one and the next float.
const UNIT: f32 = f32::EPSILON / 2.0;

/// 144u and a little more: of 2e·q and 20u·(2e)².
const SPANS: f32 = 150.0 * UNIT;

/// 3072u² and what is left.
const DEPTHS: f32 = 4000.0 * UNIT * UNIT;

/// The least error of a part, in square world units.
const LEAST: f32 = f32::MIN_POSITIVE;

/// Up to eight triangles: five cache lines.
#[repr(C, align(64))]
pub(super) struct Block {
    /// Axis, then corner; a lane a triangle. World units, as they were pushed; no numbers in lanes
    /// without a triangle, which are so never met.
    corners: [[[f32; LANES]; 3]; 3],
    primitives: [u32; LANES],
}

/// The corners' coordinates along an axis: bytes from the beginning of a block.
#[derive(Clone, Copy)]
pub(super) struct Across(u32);

impl Across {
    pub const fn of(axis: Axis) -> Self {
        Self(axis as u32 * size_of::<[[f32; LANES]; 3]>() as u32)
    }
}

/// What the test of a block found out, seen along the ray, with the triangles that may be met.
pub(super) struct Seen<L: Lanes> {
    /// A bit for each lane not certainly missed.
    pub possible: u32,
    /// Depths of the three corners behind the ray's origin.
    depths: [L::Eight; 3],
    /// Twice the areas of the three parts.
    parts: [L::Eight; 3],
    /// How far the least of them is from a miss.
    clear: L::Eight,
    /// How far parts may be off.
    error: f32,
    /// Depths are less, and those of a triangle less than this apart.
    reach: [f32; 2],
}

/// Where a ray meets lanes.
pub(super) struct Bounded<L: Lanes> {
    /// A bit for each lane whose edges the ray certainly passes inside of.
    pub inside: u32,
    /// Of those: bounds of the parameter where the ray meets the triangle.
    pub between: [L::Eight; 2],
}

impl Block {
    /// One to eight triangles.
    pub fn new(shapes: &Shapes, triangles: &[Primitive]) -> Self {
        let mut block =
            Self { corners: [[[f32::NAN; LANES]; 3]; 3], primitives: [triangles[0].bits(); LANES] };
        for (lane, primitive) in triangles.iter().enumerate() {
            block.primitives[lane] = primitive.bits();
            for (k, corner) in shapes.corners(primitive.index()).into_iter().enumerate() {
                for (all, coordinate) in block.corners.iter_mut().zip(corner.to_array()) {
                    all[k][lane] = coordinate;
                }
            }
        }
        block
    }

    /// The triangle of a lane.
    #[inline(always)]
    pub fn primitive(&self, lane: usize) -> Primitive {
        Primitive::from_bits(self.primitives[lane])
    }

    #[inline(always)]
    fn across(&self, across: Across) -> &[[f32; LANES]; 3] {
        // SAFETY: the corners are what a block begins with, and an `Across` is one of the three.
        unsafe { &*(&raw const self.corners).byte_add(across.0 as usize).cast() }
    }

    /// A bit for each triangle that the ray is not to meet.
    #[inline(always)]
    pub fn left_out<L: Lanes>(&self, lanes: L, probe: &Probe) -> u32 {
        lanes.either(&self.primitives, probe.left_out)
    }

    /// The same, for f64 to decide about.
    #[inline(always)]
    pub fn face(&self, lane: usize) -> Face {
        let [x, y, z] = &self.corners;
        let corner = |k: usize| [x[k][lane], y[k][lane], z[k][lane]];
        Face { corners: [corner(0), corner(1), corner(2)] }
    }

    /// The corners of a lane's triangle along an axis.
    #[inline(always)]
    pub fn coordinates(&self, axis: usize, lane: usize) -> [f32; 3] {
        let [a, b, c] = &self.corners[axis];
        [a[lane], b[lane], c[lane]]
    }

    /// A bit for each triangle.
    pub fn all(&self) -> u32 {
        let lane = |(lane, x): (usize, &f32)| u32::from(!x.is_nan()) << lane;
        self.corners[0][0].iter().enumerate().map(lane).sum()
    }

    /// Which triangles a ray may meet that passes their box, of a `span`.
    #[inline(always)]
    pub fn seen<L: Lanes>(&self, lanes: L, probe: &Probe, span: f32) -> Seen<L> {
        self.seen_within(lanes, probe, span, None)
    }

    /// The same where corners and the ray's origin are off by so much together, along each axis.
    #[inline(always)]
    pub fn seen_within<L: Lanes>(
        &self,
        lanes: L,
        probe: &Probe,
        span: f32,
        off: Option<f32>,
    ) -> Seen<L> {
        let [x, y, z] = probe.turn.across;
        let (xs, ys, zs) = (self.across(x), self.across(y), self.across(z));
        let [ox, oy, oz] = probe.turned.to_array();
        let depth = (zs[0][0] - oz).abs() + span;
        // As much as adds eight times that to q.
        let depth = if let Some(off) = off { depth + off * (0.25 / UNIT) } else { depth };
        let error = depth * (depth * DEPTHS + span * SPANS) + LEAST;
        let (ox, oy, oz) = (lanes.splat(ox), lanes.splat(oy), lanes.splat(oz));
        let (sx, sy) = (lanes.splat(probe.shear.x), lanes.splat(probe.shear.y));
        // From the corners to the origin: two signs make none.
        let az = lanes.sub(oz, lanes.load(&zs[0]));
        let bz = lanes.sub(oz, lanes.load(&zs[1]));
        let cz = lanes.sub(oz, lanes.load(&zs[2]));
        let ax = lanes.sub_mul(sx, az, lanes.sub(ox, lanes.load(&xs[0])));
        let bx = lanes.sub_mul(sx, bz, lanes.sub(ox, lanes.load(&xs[1])));
        let cx = lanes.sub_mul(sx, cz, lanes.sub(ox, lanes.load(&xs[2])));
        let ay = lanes.sub_mul(sy, az, lanes.sub(oy, lanes.load(&ys[0])));
        let by = lanes.sub_mul(sy, bz, lanes.sub(oy, lanes.load(&ys[1])));
        let cy = lanes.sub_mul(sy, cz, lanes.sub(oy, lanes.load(&ys[2])));
        let u = lanes.mul_sub(cx, by, lanes.mul(cy, bx));
        let v = lanes.mul_sub(ax, cy, lanes.mul(ay, cx));
        let w = lanes.mul_sub(bx, ay, lanes.mul(by, ax));
        let least = lanes.min(lanes.min(u, v), w);
        let most = lanes.max(lanes.max(u, v), w);
        // Missed if one part is certainly below zero, and another certainly above.
        let clear = lanes.max(least, lanes.sub(lanes.splat(0.0), most));
        let possible = lanes.at_most(lanes.splat(-error), clear);
        let (depths, parts) = ([az, bz, cz], [u, v, w]);
        Seen { possible, depths, parts, clear, error, reach: [depth, span] }
    }
}

impl<L: Lanes> Seen<L> {
    /// Where the ray meets triangles.
    #[inline(always)]
    pub fn bounded(&self, lanes: L, probe: &Probe) -> Bounded<L> {
        let ([az, bz, cz], [u, v, w], [depth, span]) = (self.depths, self.parts, self.reach);
        let inside = !lanes.at_most(self.clear, lanes.splat(2.0 * self.error)) & self.possible;
        // The mean of the corners' depths by their weights. As each is at least twice its error, the
        // mean is off by less than three errors over half their sum, of the way between the least
        // depth and the greatest; and by rounding.
        let sum = lanes.add(lanes.add(u, v), w);
        let mean = lanes.mul_add(w, cz, lanes.mul_add(v, bz, lanes.mul(u, az)));
        let scale = lanes.div(lanes.splat(-probe.per_depth), sum);
        let t = lanes.mul(mean, scale);
        let rounding = depth * (16.0 * UNIT) * probe.per_depth.abs();
        let far = lanes.splat(6.0 * span * self.error);
        let slack = lanes.mul_add(lanes.abs(scale), far, lanes.splat(rounding));
        Bounded { inside, between: [lanes.sub(t, slack), lanes.add(t, slack)] }
    }
}
