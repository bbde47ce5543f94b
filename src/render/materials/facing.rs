//! How a surface is seen: its normals, turned to the side of the viewer.

use glam::Vec3;

use crate::render::geometry::Hit;

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

impl Facing {
    /// A hit, seen from `wo`. Seen from behind, a surface is as if it were turned round.
    pub fn new(hit: &Hit, wo: Vec3) -> Self {
        let front = hit.ng.dot(wo) >= 0.0;
        let side = if front { 1.0 } else { -1.0 };
        Self { wo, ng: side * hit.ng, ns: side * hit.ns, front }
    }

    /// The viewer's direction mirrored at the shading normal; None if that is below the surface.
    pub fn mirrored(&self) -> Option<Vec3> {
        let wi = (2.0 * self.wo.dot(self.ns) * self.ns - self.wo).normalize();
        (wi.dot(self.ng) > 0.0).then_some(wi)
    }
}
