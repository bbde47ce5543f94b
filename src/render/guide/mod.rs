//! Where the light of lamps comes from that reached a surface by mirrors and glass: directions that
//! paths from the camera hardly ever find by chance.
//!
//! Photons are sent from the lamps beforehand, and where they have landed they tell the directions
//! from which they came [Jensen95]. Paths then look there as well as by the surface's own density,
//! and are weighed by both together: so the guide changes the noise of a picture, never its mean,
//! however wrong it is. It depends on the world alone: not on the seed, the film, or threads.

mod lobes;
pub(super) mod photons;

pub use lobes::Lobes;

use glam::{BVec3, Vec3, Vec3Swizzles};
use rayon::prelude::*;

use super::geometry::{Bounds, Geometry};
use super::lanes::{LANES, Row, by_processor, padded};
use super::lights::{Lights, Sites, Sources};
use super::materials::{Material, Ways};
use lobes::MOST;
use photons::Photon;

/// So many photons are wanted.
const WANTED: usize = 120_000;
/// So many are sent at a time, and so often at most.
const SENT: u64 = 1 << 16;
const MOST_SENT: u64 = 32 * SENT;

/// Directions of light that came by mirrors and glass, place by place.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    /// A binary tree over places, level by level: behind node n are 2n + 1 and 2n + 2. All its leaves
    /// are at the same depth, so that no jump depends on a place.
    branches: Vec<Branch>,
    depth: u32,
    leaves: Vec<Lobes>,
}

/// Places from `at` on along an axis are behind the second of its two nodes, others behind the first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Branch {
    at: f32,
    axis: u32,
}

impl Guide {
    /// The guide of a world. None where hardly any light goes by mirrors and glass to what scatters
    /// it.
    pub fn build(geometry: &Geometry, materials: &[Material], lights: &Lights) -> Option<Self> {
        let sources = Sources::new(lights, geometry);
        if sources.is_empty() {
            return None;
        }
        let mut photons = Vec::new();
        let mut sent = 0;
        while photons.len() < WANTED && sent < MOST_SENT {
            let more: Vec<Photon> = (sent..sent + SENT)
                .into_par_iter()
                .flat_map_iter(|number| photons::follow(geometry, materials, &sources, number))
                .collect();
            photons.extend(more);
            sent += SENT;
        }
        Self::of(&mut photons, sent as f32 / surface(&geometry.bounds()))
    }

    /// Of photons, where so many on an area are what all that were sent would be, spread evenly.
    pub(super) fn of(photons: &mut [Photon], even: f32) -> Option<Self> {
        if photons.is_empty() || !even.is_finite() {
            return None;
        }
        let count = photons.len().div_ceil(MOST).next_power_of_two();
        let branches = vec![Branch::default(); count - 1];
        let mut guide = Self { branches, depth: count.ilog2(), leaves: Vec::with_capacity(count) };
        guide.split(0, photons, even);
        Some(guide)
    }

    /// Makes a node of photons: half of them on each side, down to the leaves.
    fn split(&mut self, node: usize, photons: &mut [Photon], even: f32) {
        let Some(branch) = self.branches.get_mut(node) else {
            return self.leaves.push(Lobes::new(photons, even));
        };
        let (low, high) = photons::around(photons);
        let axis = (high - low).max_position();
        let middle = photons.len() / 2;
        photons.select_nth_unstable_by(middle, |a, b| a.at[axis].total_cmp(&b.at[axis]));
        *branch = Branch { at: photons[middle].at[axis], axis: axis as u32 };
        let (before, behind) = photons.split_at_mut(middle);
        self.split(2 * node + 1, before, even);
        self.split(2 * node + 2, behind, even);
    }

    /// Number of the leaf that a place belongs to.
    pub fn leaf(&self, place: Vec3) -> u32 {
        let last = (0..self.depth).fold(0, |node, _| self.below(node, place));
        last - self.branches.len() as u32
    }

    /// Numbers of the leaves that so many sites belong to.
    pub fn leaves(&self, sites: &Sites, count: usize) -> Row<u32> {
        let mut nodes = [0; LANES];
        search(self, sites, count, &mut nodes);
        nodes
    }

    /// Below a node, the one that a place belongs to. Without jumps: no processor foretells them.
    #[inline(always)]
    fn below(&self, node: u32, place: Vec3) -> u32 {
        let Branch { at, axis } = self.branches[node as usize];
        let along = Vec3::select(BVec3::splat(axis == 1), place.yyy(), place.xxx());
        let along = Vec3::select(BVec3::splat(axis == 2), place.zzz(), along).x;
        2 * node + 1 + u32::from(along >= at)
    }

    /// What the photons of a leaf tell near a place, if any landed there.
    #[inline(always)]
    pub fn lobes(&self, leaf: u32, place: Vec3) -> Option<&Lobes> {
        self.leaves.get(leaf as usize).filter(|lobes| lobes.are_near(place))
    }

    /// Densities in solid angle, by what the photons of these leaves tell, of the ways on from sites:
    /// of some lanes.
    pub fn pdf_w(&self, lanes: &[u32], leaves: &Row<u32>, (sites, ways): (&Sites, &Ways)) -> Row {
        let mut pdf_w = [0.0; LANES];
        densities(self, lanes, leaves, (sites, ways), &mut pdf_w);
        pdf_w
    }
}

by_processor! {
    #[inline(never)]
    fn search(guide: &Guide, sites: &Sites, count: usize, nodes: &mut Row<u32>) {
        // Level by level: one place does not wait for the other.
        for _ in 0..guide.depth {
            for (lane, node) in nodes.iter_mut().enumerate().take(padded(count)) {
                *node = guide.below(*node, sites.point(lane).position);
            }
        }
        let first = guide.branches.len() as u32;
        nodes.iter_mut().take(padded(count)).for_each(|node| *node -= first);
    }
}

by_processor! {
    #[inline(never)]
    fn densities(
        guide: &Guide,
        lanes: &[u32],
        leaves: &Row<u32>,
        of: (&Sites, &Ways),
        pdf_w: &mut Row,
    ) {
        let (sites, ways) = of;
        for &lane in lanes {
            let lane = lane as usize;
            let lobes = &guide.leaves[leaves[lane] as usize];
            pdf_w[lane] = lobes.pdf_w(sites.point(lane).position, ways.wi(lane));
        }
    }
}

/// The surface of a box.
fn surface(bounds: &Bounds) -> f32 {
    if bounds.is_empty() {
        return 0.0;
    }
    let size = bounds.max - bounds.min;
    2.0 * (size.x * size.y + size.y * size.z + size.z * size.x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::random;
    use crate::render::lights::Site;

    fn found(guide: &Guide, place: Vec3) -> bool {
        let mut sites = Sites::default();
        sites.push(&Site::free(place));
        assert_eq!(guide.leaves(&sites, 1)[0], guide.leaf(place));
        guide.lobes(guide.leaf(place), place).is_some()
    }

    #[test]
    fn every_photon_is_found_where_it_landed() {
        let place = |i| {
            let [a, b] = random::unit_pair(random::at(51, i));
            Vec3::new(a as f32, (a * b) as f32, b as f32)
        };
        for count in [1, 2, MOST as u64, MOST as u64 + 1, 10_000] {
            let mut photons: Vec<Photon> =
                (0..count).map(|i| Photon { at: place(i), from: Vec3::Y }).collect();
            let guide = Guide::of(&mut photons, 1.0).unwrap();
            assert_eq!(guide.leaves.len(), guide.branches.len() + 1);
            assert!((0..count).all(|i| found(&guide, place(i))));
            assert!(!found(&guide, Vec3::splat(5.0)));
        }
        assert_eq!(Guide::of(&mut [], 1.0), None);
    }

    #[test]
    fn photons_that_landed_at_one_point_make_a_guide() {
        let mut same = vec![Photon { at: Vec3::ONE, from: Vec3::Y }; 1000];
        let guide = Guide::of(&mut same, f32::MIN_POSITIVE).unwrap();
        assert!(found(&guide, Vec3::ONE));
        assert!(!found(&guide, Vec3::ZERO));
    }
}
