//! Eight triangles side by side, as a leaf of the tree holds them, and the quick f32 test that
//! throws out those a ray certainly misses, keeps those it certainly meets, and leaves the few that
//! remain to f64.
//!
//! The test is Woop's [Woop13], with a bound on its own error, u = 2⁻²⁴. Let Z be the greatest depth
//! of a triangle's corners from the origin, and S the greatest of its sheared coordinates,
//! (x − o) − s·z with |s| ≤ 1. Those err by less than δ = u·(7Z + 3S), the rounding of s included. A
//! part is a difference of two products of them, and errs by 4S·δ + 2δ² + 4u·S² at most. With
//! q = 32u·Z and S + q in place of S, that is less than (S + q)·(q + 20u·(S + q)), and so it stays
//! when that is rounded. [`LEAST`] is for products below the normal numbers. Where corners and the
//! ray are off by something more, δ grows by twice that, and q by eight times.

use super::lanes::{LANES, Lanes};
use super::ray::Probe;
use super::shapes::{Primitive, Shapes};
use super::triangle::Face;

/// u, half the gap between one and the next float.
const UNIT: f32 = f32::EPSILON / 2.0;

/// The least error of a part, in square world units.
const LEAST: f32 = f32::MIN_POSITIVE;

/// Up to eight triangles: five cache lines.
#[repr(align(64))]
pub(super) struct Block {
    /// Axis, then corner; a lane a triangle. World units, as they were pushed; no numbers in lanes
    /// without a triangle, which are so never met.
    corners: [[[f32; LANES]; 3]; 3],
    primitives: [u32; LANES],
}

/// Lanes that a ray may meet.
pub(super) struct Candidates<L: Lanes> {
    /// A bit for each lane not certainly missed.
    pub possible: u32,
    /// A bit for each lane whose edges the ray certainly passes inside of.
    pub inside: u32,
    /// Of lanes passed inside: bounds of the parameter where the ray meets the triangle.
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

    /// Which triangles the ray may meet.
    #[inline(always)]
    pub fn candidates<L: Lanes>(&self, lanes: L, probe: &Probe) -> Candidates<L> {
        self.candidates_within(lanes, probe, None)
    }

    /// The same where corners and the ray's origin are off by so much together, along each axis.
    #[inline(always)]
    pub fn candidates_within<L: Lanes>(
        &self,
        lanes: L,
        probe: &Probe,
        off: Option<f32>,
    ) -> Candidates<L> {
        let [x, y, z] = probe.axes;
        let (x, y, z) = (x as usize, y as usize, z as usize);
        let (xs, ys, zs) = (&self.corners[x], &self.corners[y], &self.corners[z]);
        let nothing = [lanes.splat(0.0); 2];
        if probe.extreme {
            let zs = lanes.load(&zs[0]);
            return Candidates { possible: lanes.at_most(zs, zs), inside: 0, between: nothing };
        }
        let [ox, oy, oz] = probe.turned;
        let (ox, oy, oz) = (lanes.splat(ox), lanes.splat(oy), lanes.splat(oz));
        let (sx, sy) = (lanes.splat(probe.shear[0]), lanes.splat(probe.shear[1]));
        let az = lanes.sub(lanes.load(&zs[0]), oz);
        let bz = lanes.sub(lanes.load(&zs[1]), oz);
        let cz = lanes.sub(lanes.load(&zs[2]), oz);
        let ax = lanes.sub_mul(sx, az, lanes.sub(lanes.load(&xs[0]), ox));
        let bx = lanes.sub_mul(sx, bz, lanes.sub(lanes.load(&xs[1]), ox));
        let cx = lanes.sub_mul(sx, cz, lanes.sub(lanes.load(&xs[2]), ox));
        let ay = lanes.sub_mul(sy, az, lanes.sub(lanes.load(&ys[0]), oy));
        let by = lanes.sub_mul(sy, bz, lanes.sub(lanes.load(&ys[1]), oy));
        let cy = lanes.sub_mul(sy, cz, lanes.sub(lanes.load(&ys[2]), oy));
        let u = lanes.mul_sub(cx, by, lanes.mul(cy, bx));
        let v = lanes.mul_sub(ax, cy, lanes.mul(ay, cx));
        let w = lanes.mul_sub(bx, ay, lanes.mul(by, ax));
        let depth = lanes.max(lanes.max(lanes.abs(az), lanes.abs(bz)), lanes.abs(cz));
        let left = lanes.max(lanes.max(lanes.abs(ax), lanes.abs(bx)), lanes.abs(cx));
        let up = lanes.max(lanes.max(lanes.abs(ay), lanes.abs(by)), lanes.abs(cy));
        let q = lanes.mul(depth, lanes.splat(32.0 * UNIT));
        let q = match off {
            Some(off) => lanes.add(q, lanes.splat(8.0 * off)),
            None => q,
        };
        let side = lanes.add(lanes.max(left, up), q);
        let error = lanes.mul_add(side, lanes.splat(20.0 * UNIT), q);
        let error = lanes.mul_add(side, error, lanes.splat(LEAST));
        let least = lanes.min(lanes.min(u, v), w);
        let most = lanes.max(lanes.max(u, v), w);
        let zero = lanes.splat(0.0);
        // Missed if one part is certainly below zero, and another certainly above.
        let possible = lanes.at_most(lanes.min(lanes.sub(zero, least), most), error);
        if possible == 0 {
            return Candidates { possible, inside: 0, between: nothing };
        }
        let clear = lanes.max(least, lanes.sub(zero, most));
        let inside = !lanes.at_most(clear, lanes.add(error, error)) & possible;
        // The mean of the corners' depths by their weights. As each is at least twice its error, the
        // mean is off by less than three errors over half their sum, of the way between the least
        // depth and the greatest; and by rounding.
        let sum = lanes.add(lanes.add(u, v), w);
        let mean = lanes.mul_add(w, cz, lanes.mul_add(v, bz, lanes.mul(u, az)));
        let (low, high) = (lanes.min(lanes.min(az, bz), cz), lanes.max(lanes.max(az, bz), cz));
        let scale = lanes.div(lanes.splat(probe.per_depth), sum);
        let t = lanes.mul(mean, scale);
        let rounding = lanes.mul(depth, lanes.splat(16.0 * UNIT * probe.per_depth.abs()));
        let rounding = match off {
            Some(off) => lanes.add(rounding, lanes.splat(2.0 * off * probe.per_depth.abs())),
            None => rounding,
        };
        let far = lanes.mul(lanes.mul(lanes.abs(scale), lanes.splat(6.0)), lanes.sub(high, low));
        let slack = lanes.mul_add(far, error, rounding);
        let between = [lanes.sub(t, slack), lanes.add(t, slack)];
        Candidates { possible, inside, between }
    }
}
