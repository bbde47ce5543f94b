//! Four triangles side by side, as a leaf of the tree holds them, and the quick f32 test that
//! throws out those a ray certainly misses.
//!
//! The test is Woop's [Woop13] in f32, made conservative: whatever it keeps is decided in f64 by
//! triangle.rs, and it keeps everything that f64 would. Bound of its error, u = 2⁻²⁴, W the
//! triangle's greatest extent along an axis, S the shear (|S| ≤ 1), Z the depth of the first
//! corner: if the ray passes inside, every sheared coordinate is at most 2W, and made with an error
//! of at most 5u·(2W + |S|·(Z + W)), where Z + W bounds the depth of all corners. A part is the
//! difference of two products of such, so its error is below 32u·(2W + |Sx|·(Z + W))·
//! (2W + |Sy|·(Z + W)), to which the smallest normal number is added for gradual underflow.

use glam::{DVec3, Vec3, Vec4};

use super::ray::Probe;
use super::shapes::Primitive;
use super::tree::LANES;

/// 32u.
const PART_ERROR: f32 = 16.0 * f32::EPSILON;

/// Up to four triangles; the lanes that hold none are masked.
pub(super) struct Block {
    /// Corner, then axis; a lane a triangle. World units.
    corners: [[Vec4; 3]; 3],
    /// Greatest extent along an axis, world units.
    extent: Vec4,
    primitives: [Primitive; LANES],
    /// A bit for each lane that holds a triangle.
    lanes: u32,
}

/// Lanes that a ray may meet.
pub(super) struct Candidates {
    /// A bit for each lane not certainly missed.
    pub possible: u32,
    /// A bit for each lane whose edges the ray certainly passes inside of.
    pub inside: u32,
}

impl Block {
    /// At most four triangles with their corners.
    pub fn new(triangles: &[(Primitive, [Vec3; 3])]) -> Self {
        let first = triangles[0].0;
        let mut block = Self {
            corners: [[Vec4::ZERO; 3]; 3],
            extent: Vec4::ZERO,
            primitives: [first; LANES],
            lanes: 0,
        };
        for (lane, (primitive, corners)) in triangles.iter().enumerate() {
            for (all, corner) in block.corners.iter_mut().zip(corners) {
                for (axis, coordinate) in corner.to_array().into_iter().enumerate() {
                    all[axis][lane] = coordinate;
                }
            }
            let [a, b, c] = *corners;
            let extent = a.max(b).max(c) - a.min(b).min(c);
            block.extent[lane] = extent.max_element().next_up();
            block.primitives[lane] = *primitive;
            block.lanes |= 1 << lane;
        }
        block
    }

    /// Which triangles the ray may meet before `limit`.
    #[inline(always)]
    pub fn candidates<const AXIS: usize>(&self, probe: &Probe, limit: f32) -> Candidates {
        let (x, y, z) = ((AXIS + 1) % 3, (AXIS + 2) % 3, AXIS);
        let origin = probe.near_origin;
        let (ox, oy, oz) = (Vec4::splat(origin[x]), Vec4::splat(origin[y]), Vec4::splat(origin[z]));
        let (sx, sy) = (Vec4::splat(probe.near_shear[0]), Vec4::splat(probe.near_shear[1]));
        let corner = |k: usize| {
            let c = &self.corners[k];
            let depth = c[z] - oz;
            ((c[x] - ox) - sx * depth, (c[y] - oy) - sy * depth, depth)
        };
        let ((ax, ay, az), (bx, by, bz), (cx, cy, cz)) = (corner(0), corner(1), corner(2));
        let u = cx * by - cy * bx;
        let v = ax * cy - ay * cx;
        let w = bx * ay - by * ax;
        let (least, most) = (u.min(v).min(w), u.max(v).max(w));
        let depth = az.abs() + self.extent;
        let width = self.extent + self.extent;
        let error = (width + sx.abs() * depth) * (width + sy.abs() * depth) * PART_ERROR
            + Vec4::splat(f32::MIN_POSITIVE);
        let missed = least.cmplt(-error) & most.cmpgt(error);
        let possible = !missed.bitmask() & self.lanes;
        if possible == 0 {
            return Candidates { possible, inside: 0 };
        }
        // The meeting lies between the nearest and the farthest corner along the ray.
        let scale = Vec4::splat(probe.near_shear[2]);
        let (ta, tb, tc) = (az * scale, bz * scale, cz * scale);
        let within =
            ta.min(tb).min(tc).cmple(Vec4::splat(limit)) & ta.max(tb).max(tc).cmpge(Vec4::ZERO);
        let inside = least.cmpgt(error) | most.cmplt(-error);
        Candidates { possible: possible & within.bitmask(), inside: inside.bitmask() }
    }

    /// The triangle in a lane.
    #[inline(always)]
    pub fn primitive(&self, lane: usize) -> Primitive {
        self.primitives[lane]
    }

    /// Corners of the triangle in a lane.
    #[inline(always)]
    pub fn triangle(&self, lane: usize) -> [DVec3; 3] {
        let [a, b, c] = &self.corners;
        let corner = |[x, y, z]: &[Vec4; 3]| {
            let at = |axis: &Vec4| f64::from(AsRef::<[f32; LANES]>::as_ref(axis)[lane]);
            DVec3::new(at(x), at(y), at(z))
        };
        [corner(a), corner(b), corner(c)]
    }
}
