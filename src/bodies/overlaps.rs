//! Bodies that overlap, of which one ends where the other begins: each has a bit, which tells
//! whether a point is within its surface.

use std::collections::HashMap;

use super::solids::Solids;

/// The bodies that yield, and those they yield to.
#[derive(Clone, Debug, Default)]
pub struct Overlaps {
    /// Of an object's surfaces around a medium: which body.
    of: HashMap<(u32, u32), u32>,
    bodies: Vec<Body>,
    /// Bits of the bodies around the camera.
    pub camera: u64,
}

#[derive(Clone, Copy, Debug)]
struct Body {
    medium: u32,
    /// Bits of those that it yields to.
    yields_to: u64,
}

impl Overlaps {
    /// As many bodies as there are bits.
    pub const MOST: usize = u64::BITS as usize;

    /// None: there are too many of them.
    pub(super) fn of(solids: &Solids) -> Option<Self> {
        let related: Vec<u32> = (0..solids.all.len() as u32)
            .filter(|one| {
                let mut others = 0..solids.all.len() as u32;
                others.any(|other| solids.yields(*one, other) || solids.yields(other, *one))
            })
            .collect();
        let mut overlaps = Self::default();
        let mut of_solid: HashMap<u32, u32> = HashMap::new();
        for solid in &related {
            let medium = solids.all[*solid as usize].medium;
            let keys = solids.owners(*solid).iter().map(|owner| (*owner, medium));
            // Parts of one object's surface around one medium are one body.
            let known = keys.clone().find_map(|key| overlaps.of.get(&key).copied());
            let number = known.unwrap_or_else(|| {
                overlaps.bodies.push(Body { medium, yields_to: 0 });
                overlaps.bodies.len() as u32 - 1
            });
            overlaps.of.extend(keys.map(|key| (key, number)));
            of_solid.insert(*solid, number);
        }
        if overlaps.bodies.len() > Self::MOST {
            return None;
        }
        for one in &related {
            for other in related.iter().filter(|other| solids.yields(*one, **other)) {
                overlaps.bodies[of_solid[one] as usize].yields_to |= 1 << of_solid[other];
            }
        }
        Some(overlaps)
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// The bit of the body around a medium that some of an object's surfaces bound; 0: of none.
    pub fn bit(&self, object: usize, medium: u32) -> u64 {
        self.of.get(&(object as u32, medium)).map_or(0, |body| 1 << body)
    }

    /// Bits of the bodies inside of which the body of such a surface is not.
    pub fn hidden(&self, object: usize, medium: u32) -> u64 {
        let body = self.of.get(&(object as u32, medium));
        body.map_or(0, |body| self.bodies[*body as usize].yields_to)
    }

    /// The bodies that end where this one begins, each with its medium: those that yield to others
    /// of them come last.
    pub fn ending_at(&self, object: usize, medium: u32) -> Vec<(u64, u32)> {
        let bit = self.bit(object, medium);
        let all = self.bodies.iter().enumerate().filter(|(_, body)| body.yields_to & bit != 0);
        let mut all: Vec<_> =
            all.map(|(i, body)| (body.yields_to.count_ones(), 1 << i, body.medium)).collect();
        all.sort_unstable();
        all.into_iter().map(|(_, bit, medium)| (bit, medium)).collect()
    }

    /// Bits of solids around a point.
    pub(super) fn bits(&self, solids: &Solids, around: impl Iterator<Item = u32>) -> u64 {
        let bit = |solid: u32| {
            let medium = solids.all[solid as usize].medium;
            let owner = solids.owners(solid).first();
            owner.map_or(0, |owner| self.bit(*owner as usize, medium))
        };
        around.fold(0, |bits, solid| bits | bit(solid))
    }
}
