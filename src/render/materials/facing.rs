//! How a surface is seen: its normals, turned to the side of the viewer.

use glam::{BVec3, Vec3};

use crate::render::geometry::Hit;
use crate::render::lanes::{LANES, Rows, get, put};

/// The normals at a hit, and the viewer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facing {
    /// Towards the viewer, unit length.
    pub wo: Vec3,
    /// Geometric normal on the viewer's side.
    pub ng: Vec3,
    /// Shading normal on the same side.
    pub ns: Vec3,
    /// Whether the viewer sees the front.
    pub front: bool,
}

/// How far above a surface, or below it, light goes on that would be on its wrong side, in
/// radians: well above the rounding of directions, and not to be seen.
const LEAST: f32 = 1e-6;

impl Facing {
    /// A hit, seen from `wo`. Seen from behind, a surface is as if it were turned round.
    #[inline(always)]
    pub fn new(hit: &Hit, wo: Vec3) -> Self {
        let front = hit.ng.dot(wo) >= 0.0;
        let side = if front { 1.0 } else { -1.0 };
        Self { wo, ng: side * hit.ng, ns: side * hit.ns, front }
    }

    /// The direction that is mirrored to the viewer, and the normal it is mirrored at: the shading
    /// normal, bent towards the geometric one just so far that the direction is above the surface,
    /// and the viewer before the normal [Keller17]. So no light is lost where interpolated normals
    /// and the surface disagree, as they do along silhouettes. Without jumps, so that a loop over it
    /// becomes vectors.
    #[inline(always)]
    pub fn mirrored(&self) -> (Vec3, Vec3) {
        let Self { wo, ng, ns, .. } = *self;
        let wi = (2.0 * wo.dot(ns) * ns - wo).normalize();
        let height = wi.dot(ng);
        let above = BVec3::splat(height > 0.0);
        let bent = (wi + (LEAST - height) * ng).normalize();
        let between = (wo + bent).normalize();
        (Vec3::select(above, wi, bent), Vec3::select(above, ns, between))
    }

    /// A direction as it is, or bent just so far that it is below the surface.
    #[inline(always)]
    pub fn below(&self, wi: Vec3) -> Vec3 {
        let height = wi.dot(self.ng);
        let bent = (wi - (LEAST + height) * self.ng).normalize();
        Vec3::select(BVec3::splat(height < 0.0), wi, bent)
    }
}

/// Surfaces, each seen by its viewer, one lane for each; without which side is seen.
pub struct Facings {
    wo: Rows,
    ng: Rows,
    ns: Rows,
}

impl Default for Facings {
    fn default() -> Self {
        let rows = [[0.0; LANES]; 3];
        Self { wo: rows, ng: rows, ns: rows }
    }
}

impl Facings {
    /// Gives a lane its surface.
    #[inline(always)]
    pub fn put(&mut self, lane: usize, facing: &Facing) {
        put(&mut self.wo, lane, facing.wo);
        put(&mut self.ng, lane, facing.ng);
        put(&mut self.ns, lane, facing.ns);
    }

    /// The surface of a lane, as if its front were seen.
    #[inline(always)]
    pub fn at(&self, lane: usize) -> Facing {
        let (wo, ng, ns) = (get(&self.wo, lane), get(&self.ng, lane), get(&self.ns, lane));
        Facing { wo, ng, ns, front: true }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::math::random;

    /// Unit vectors above the surface, some of them hardly.
    pub fn above(place: u64) -> Vec3 {
        let [u, v] = random::unit_pair(random::at(5, place));
        let height = (u as f32).powi(if place.is_multiple_of(2) { 1 } else { 8 });
        let (sin, cos) = (std::f32::consts::TAU * v as f32).sin_cos();
        let across = (1.0 - height * height).max(0.0).sqrt();
        Vec3::new(across * cos, across * sin, height).normalize()
    }

    /// A surface that faces +z.
    pub fn seen(wo: Vec3, ns: Vec3) -> Facing {
        Facing { wo, ng: Vec3::Z, ns, front: true }
    }

    #[test]
    fn what_is_mirrored_is_above_the_surface_and_obeys_its_law() {
        for i in 0..100_000 {
            let facing = seen(above(i), above(i + 1_000_000));
            let (wi, ns) = facing.mirrored();
            assert!(wi.z > 0.0 && facing.wo.dot(ns) > 0.0, "{facing:?}: {wi} {ns}");
            assert!((wi.length() - 1.0).abs() < 1e-6 && (ns.length() - 1.0).abs() < 1e-6);
            let again = 2.0 * facing.wo.dot(ns) * ns - facing.wo;
            // Half-way between directions that are nearly opposite it is known to less digits.
            let close = 1e-6 + 2e-6 / (facing.wo + wi).length();
            assert!(again.distance(wi) < close, "{facing:?}: {wi}, not {again}");
            // Where the shading normal will do, it is taken.
            let plain = 2.0 * facing.wo.dot(facing.ns) * facing.ns - facing.wo;
            assert!(plain.z <= 1e-6 || ns == facing.ns);
        }
    }

    #[test]
    fn a_flat_mirror_is_not_bent() {
        for i in 0..10_000 {
            let facing = seen(above(i), Vec3::Z);
            let (wi, ns) = facing.mirrored();
            assert_eq!(ns, Vec3::Z);
            assert!((wi - facing.wo * Vec3::new(-1.0, -1.0, 1.0)).length() < 1e-6);
        }
        // Not even one that is seen edge on, more than can be told.
        let (wi, _) = seen(Vec3::X, Vec3::Z).mirrored();
        assert!(wi.z > 0.0 && wi.z < 2e-6 && wi.x < 0.0);
    }
}
