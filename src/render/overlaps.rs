//! Bodies that overlap, of which one ends where the other begins [Schmidt02]: rays know which of
//! them they are inside of, by a bit for each.

use super::geometry::{Geometry, Hit, Ray};

/// What is known of surfaces where bodies overlap.
#[derive(Clone, Debug, PartialEq)]
pub struct Overlaps {
    /// Bits of the bodies around the camera.
    pub camera: u64,
    /// For each material, by number.
    pub materials: Vec<Overlap>,
}

/// What is known of the surfaces that have a material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overlap {
    /// The bit of the body behind the surface; 0: it is none of them.
    pub behind: u64,
    /// The bit of the body before it, likewise.
    pub before: u64,
    /// Bits of the bodies inside of which the surface is not there.
    pub hidden: u64,
    /// Bits of bodies that end at the surface, the first that is there counts: each with the
    /// material that the surface has there.
    pub within: Vec<(u64, u32)>,
}

impl Overlaps {
    /// Inside of which bodies a ray is that has gone through a surface.
    pub fn beyond(&self, inside: u64, hit: &Hit, direction: glam::Vec3) -> u64 {
        let Overlap { behind, before, .. } = self.materials[hit.material as usize];
        match hit.ng.dot(direction) < 0.0 {
            true => inside & !before | behind,
            false => inside & !behind | before,
        }
    }

    /// From the first surface that a ray has met to the first that is there: what it is of, and
    /// inside of which bodies the ray is before it.
    pub fn first(
        &self,
        geometry: &Geometry,
        mut hit: Hit,
        direction: glam::Vec3,
        mut inside: u64,
    ) -> Option<(Hit, u64)> {
        loop {
            let overlap = &self.materials[hit.material as usize];
            if overlap.hidden & inside == 0 {
                let within = overlap.within.iter().find(|(bit, _)| inside & bit != 0);
                hit.material = within.map_or(hit.material, |(_, material)| *material);
                return Some((hit, inside));
            }
            inside = self.beyond(inside, &hit, direction);
            let on: Ray = hit.ray(direction);
            hit = geometry.closest(&on)?;
        }
    }
}
