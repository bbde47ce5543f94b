//! Eight triangles side by side, as a leaf of the tree holds them, and the quick f32 test that
//! throws out those a ray certainly misses, keeps those it certainly meets, and leaves the few that
//! remain to f64.
//!
//! Corners are kept as whole numbers of a quantum from the block's lowest corner, in 16
//! bits: a block is three cache lines. The exact corners are in their faces.
//!
//! The test is Woop's [Woop13] in units of the quantum. With E = 65535 the size of the block's
//! cube, the ray in these units is x(z) = c + s·z, |s| ≤ 1, along the axis z of its depth, and c is
//! computed in f64 and rounded once. A ray that meets a triangle passes through the cube, so
//! -E ≤ c ≤ 2E; all others are thrown out first. What remains has sheared corners x − c − s·z of at
//! most 3E. They err by half a quantum in x and s·z each, by u·2E for c, and by u·6E in arithmetic:
//! by less than δ = 1.25 together. A part is a difference of two products of them, which so errs by
//! less than 4·3E·(δ + δ²) + 4u·(3E)² < 2²⁰; [`PART_ERROR`] is that.

use glam::Vec3;

use super::lanes::{LANES, Lanes};
use super::ray::Probe;
use super::triangle::Face;

/// The greatest whole number: the side of the cube around a block, in quanta.
const SIDE: f32 = 65_535.0;

/// Bound of a part's error, in square quanta.
const PART_ERROR: f32 = 1_048_576.0;

/// A bit for every lane.
const ALL: u32 = (1 << LANES) - 1;

/// How far c may be from the middle of the cube, with some quanta to spare.
const REACH: f32 = 1.5 * SIDE + 8.0;

/// Where the origin is so many quanta (2⁴⁵) from that of the world, or from the block, f64 is off by
/// a tenth of one: all is left to triangle.rs.
const FAR: f32 = 35_184_372_088_832.0;

/// The least quantum, 2⁻¹⁰⁰ world units, so that nothing underflows. The greatest, of corners as far
/// apart as f32 has them, is 2¹¹³.
const LEAST: f64 = 1.0 / (1_u128 << 100) as f64;

/// How far the test is off in addition.
#[derive(Clone, Copy)]
pub(super) struct Slack {
    /// Corners and the ray, in quanta.
    quanta: f32,
    /// Bound of a part's error, in square quanta.
    part: f32,
}

impl Slack {
    const NONE: Self = Self { quanta: 0.0, part: PART_ERROR };
}

/// δ, as told above.
const DELTA: f32 = 1.25;

/// Rounding in the two products of a part, in square quanta; with room for [`LOOSEST`].
const ARITHMETIC: f32 = 16_384.0;

/// With more slack than so many quanta the test is left out.
const LOOSEST: f32 = 4096.0;

/// Up to eight triangles.
#[repr(align(64))]
pub(super) struct Block {
    /// The lowest corner of the box around all, world units.
    low: [f32; 3],
    /// The bits of how many quanta are in a world unit. That is a power of two: its lowest bits,
    /// free therefore, tell which lanes hold a triangle.
    scale: u32,
    /// Axis, then corner; a lane a triangle. In quanta, from the lowest corner.
    corners: [[[u16; LANES]; 3]; 3],
    /// The number of the first lane's face; the others follow.
    pub first: u32,
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
    /// One to eight triangles: faces from a number on.
    pub fn new(first: usize, faces: &[Face]) -> Self {
        let all = || faces.iter().flat_map(|face| face.corners.map(Vec3::from_array));
        let low = all().fold(Vec3::INFINITY, Vec3::min);
        let high = all().fold(Vec3::NEG_INFINITY, Vec3::max);
        let extent = (high.as_dvec3() - low.as_dvec3()).max_element();
        let quantum = quantum(extent);
        let mut block = Self {
            low: low.to_array(),
            scale: ((1.0 / quantum) as f32).to_bits() | ((1 << faces.len()) - 1),
            corners: [[[0; LANES]; 3]; 3],
            first: first as u32,
        };
        for (lane, face) in faces.iter().enumerate() {
            for (k, corner) in face.corners.into_iter().enumerate() {
                let from_low = Vec3::from_array(corner).as_dvec3() - low.as_dvec3();
                let whole = (from_low / quantum).round().to_array();
                for (all, coordinate) in block.corners.iter_mut().zip(whole) {
                    all[k][lane] = coordinate as u16;
                }
            }
        }
        block
    }

    /// Which triangles the ray may meet.
    #[inline(always)]
    pub fn candidates<L: Lanes>(&self, lanes: L, probe: &Probe) -> Candidates<L> {
        self.candidates_within(lanes, probe, &Slack::NONE)
    }

    /// How much looser the test has to be where corners and the ray's origin are off by so much.
    #[inline(always)]
    pub fn slack(&self, off: f32) -> Slack {
        let quanta = off * f32::from_bits(self.scale & !ALL);
        let delta = DELTA + quanta;
        Slack { quanta, part: 4.0 * (3.0 * SIDE + 2.0 * delta) * delta + ARITHMETIC }
    }

    /// The same with more slack.
    #[inline(always)]
    pub fn candidates_within<L: Lanes>(
        &self,
        lanes: L,
        probe: &Probe,
        slack: &Slack,
    ) -> Candidates<L> {
        let [x, y, z] = probe.axes;
        let per_unit = f32::from_bits(self.scale & !ALL);
        let (per, low) = (f64::from(per_unit), f64::from(self.low[z]));
        let cx = (probe.sheared[0] - (f64::from(self.low[x]) - probe.shear[0] * low)) * per;
        let cy = (probe.sheared[1] - (f64::from(self.low[y]) - probe.shear[1] * low)) * per;
        let (cx, cy) = (cx as f32, cy as f32);
        let depth = (probe.near_depth[0] - self.low[z]) * per_unit;
        let nothing = [lanes.splat(0.0); 2];
        if depth.abs() + probe.size * per_unit >= FAR || slack.quanta > LOOSEST {
            return Candidates { possible: self.scale & ALL, inside: 0, between: nothing };
        }
        let reach = REACH + slack.quanta;
        if (cx - SIDE / 2.0).abs() > reach || (cy - SIDE / 2.0).abs() > reach {
            return Candidates { possible: 0, inside: 0, between: nothing };
        }
        let (sx, sy) = (lanes.splat(probe.near_shear[0]), lanes.splat(probe.near_shear[1]));
        let (cx, cy) = (lanes.splat(cx), lanes.splat(cy));
        let (xs, ys, zs) = (&self.corners[x], &self.corners[y], &self.corners[z]);
        let (az, bz, cz) = (lanes.whole(&zs[0]), lanes.whole(&zs[1]), lanes.whole(&zs[2]));
        let ax = lanes.sub_mul(sx, az, lanes.sub(lanes.whole(&xs[0]), cx));
        let bx = lanes.sub_mul(sx, bz, lanes.sub(lanes.whole(&xs[1]), cx));
        let cx = lanes.sub_mul(sx, cz, lanes.sub(lanes.whole(&xs[2]), cx));
        let ay = lanes.sub_mul(sy, az, lanes.sub(lanes.whole(&ys[0]), cy));
        let by = lanes.sub_mul(sy, bz, lanes.sub(lanes.whole(&ys[1]), cy));
        let cy = lanes.sub_mul(sy, cz, lanes.sub(lanes.whole(&ys[2]), cy));
        let u = lanes.mul_sub(cx, by, lanes.mul(cy, bx));
        let v = lanes.mul_sub(ax, cy, lanes.mul(ay, cx));
        let w = lanes.mul_sub(bx, ay, lanes.mul(by, ax));
        let least = lanes.min(lanes.min(u, v), w);
        let most = lanes.max(lanes.max(u, v), w);
        let (zero, error) = (lanes.splat(0.0), lanes.splat(slack.part));
        // Missed if one part is certainly below zero, and another certainly above.
        let possible = lanes.at_most(lanes.min(lanes.sub(zero, least), most), error);
        let possible = possible & self.scale & ALL;
        if possible == 0 {
            return Candidates { possible, inside: 0, between: nothing };
        }
        let inside = !lanes.at_most(lanes.max(least, lanes.sub(zero, most)), error) & possible;
        if inside == 0 {
            return Candidates { possible, inside, between: nothing };
        }
        // The mean of the corners' depths, by weights that are each off by the error of a part.
        let sum = lanes.add(lanes.add(u, v), w);
        let mean = lanes.add(lanes.add(lanes.mul(u, az), lanes.mul(v, bz)), lanes.mul(w, cz));
        let (low, high) = (lanes.min(lanes.min(az, bz), cz), lanes.max(lanes.max(az, bz), cz));
        let off = lanes.splat(3.0 * slack.part);
        let far = lanes.div(lanes.mul(off, lanes.sub(high, low)), lanes.sub(lanes.abs(sum), off));
        let depths = 1.0 + slack.quanta + (depth.abs() + SIDE) * (4.0 * f32::EPSILON);
        let far = lanes.add(far, lanes.splat(depths));
        let scale = probe.near_depth[1] / per_unit;
        let t = lanes.mul(lanes.sub(lanes.div(mean, sum), lanes.splat(depth)), lanes.splat(scale));
        let far = lanes.mul(far, lanes.splat(scale.abs()));
        let between = [lanes.sub(t, far), lanes.add(t, far)];
        Candidates { possible, inside, between }
    }
}

/// The least power of two by which a box of this size is at most [`SIDE`].
fn quantum(extent: f64) -> f64 {
    let least = extent / f64::from(SIDE);
    let below = f64::from_bits(least.to_bits() >> 52 << 52);
    let quantum = if below < least { 2.0 * below } else { below };
    quantum.max(LEAST)
}
