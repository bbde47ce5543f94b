//! The near surfaces of a group of samples, and the far ones that each might have found.

use super::{Far, Kind, Near};
use crate::math::Rgb;
use crate::render::World;
use crate::render::geometry::{Ray, between};
use crate::render::lanes::{LANES, Row, Rows, by_processor, get, padded, put};
use crate::render::lights::{Site, Sites};

/// Those of one group, of as many samples as there are lanes at most.
#[derive(Default)]
pub(super) struct Group {
    /// Near surfaces, one lane for each.
    lanes: Lanes,
    samples: Vec<usize>,
    kinds: Vec<Kind>,
    chances: Vec<f32>,
    throughputs: Vec<Rgb>,
    /// The far surfaces.
    fars: Vec<Found>,
    /// For each far surface, by which density each near one finds it, up to a factor of all.
    densities: Vec<f32>,
    /// Questions whether they see each other, and of which of these.
    rays: Vec<Ray>,
    asked: Vec<usize>,
    hidden: Vec<bool>,
}

/// Where near surfaces are and how they face, and how they find a far one.
struct Lanes {
    /// With shading normals.
    sites: Sites,
    /// Geometric normals on the same side.
    ng: Rows,
    density: Row,
    /// Of the rays to it.
    origin: Rows,
    direction: Rows,
    t_max: Row,
}

/// A far surface.
#[derive(Clone, Copy)]
struct Found {
    /// The lane of the near surface that has found it.
    by: usize,
    /// Whether others are to have its light.
    is_shared: bool,
}

impl Default for Lanes {
    fn default() -> Self {
        let (row, rows) = ([0.0; LANES], [[0.0; LANES]; 3]);
        let [ng, origin, direction] = [rows; 3];
        Self { sites: Sites::default(), ng, density: row, origin, direction, t_max: row }
    }
}

impl Group {
    /// Forgets all of them.
    pub fn clear(&mut self) {
        self.lanes.sites.clear();
        self.samples.clear();
        self.kinds.clear();
        self.chances.clear();
        self.throughputs.clear();
        self.fars.clear();
        self.densities.clear();
        self.rays.clear();
        self.asked.clear();
    }

    /// One more near surface, of a sample by its number in the group.
    pub fn push_near(&mut self, sample: usize, near: &Near) {
        put(&mut self.lanes.ng, self.samples.len(), near.lambert.normal());
        self.lanes.sites.push(&Site { point: near.point, normal: near.lambert.side() });
        self.samples.push(sample);
        self.kinds.push(near.kind);
        self.chances.push(near.chosen.own);
        self.throughputs.push(near.throughput);
    }

    /// One more far surface, found from the near one of that lane, whose light others are to have as
    /// well, or not. All near ones have come before. Returns how many rays it takes to see them.
    ///
    /// The near one that has found it is asked like all others: where bodies overlap rays pass surfaces
    /// that hide light from others, and where gaps are no wider than rounding a shadow ray may end
    /// elsewhere. What is not seen so is that sample's alone.
    pub fn push_far(&mut self, far: &Far, by: usize, is_shared: bool) -> u64 {
        let (asked, first) = (self.asked.len(), self.densities.len());
        let (lanes, reaches) = (&mut self.lanes, far.point.sheet);
        find(far, lanes);
        self.densities.extend_from_slice(&lanes.density[..self.samples.len()]);
        for (lane, density) in self.densities[first..].iter_mut().enumerate() {
            if !is_shared || self.kinds[lane] != self.kinds[by] {
                *density = 0.0;
            } else if *density > 0.0 {
                let (origin, direction) = (get(&lanes.origin, lane), get(&lanes.direction, lane));
                let (t_max, leaves) = (lanes.t_max[lane], lanes.sites.point(lane).sheet);
                self.rays.push(Ray { origin, direction, t_max, leaves, reaches });
                self.asked.push(first + lane);
            }
        }
        self.fars.push(Found { by, is_shared });
        (self.asked.len() - asked) as u64
    }

    /// Takes away what does not see each other.
    pub fn look(&mut self, world: &World) {
        self.hidden.clear();
        self.hidden.resize(self.rays.len(), false);
        world.geometry.occluded_all(&self.rays, &mut self.hidden);
        for (asked, hidden) in self.asked.iter().zip(&self.hidden) {
            if *hidden {
                self.densities[*asked] = 0.0;
            }
        }
    }

    /// How many rays that took.
    pub fn rays(&self) -> usize {
        self.rays.len()
    }

    /// Which part of the light of a far surface each sample has, by what that brings to the camera.
    pub fn parts(&self, nth: usize) -> impl Iterator<Item = (usize, Rgb)> {
        let count = self.samples.len();
        let Found { by, is_shared, .. } = self.fars[nth];
        let densities = &self.densities[nth * count..(nth + 1) * count];
        let of_all: f32 = densities.iter().zip(&self.chances).map(|(a, b)| a * b).sum();
        // Where it is not seen, or numbers have no place for them, it is that sample's alone.
        let alone = !(is_shared && densities[by] > 0.0 && of_all < f32::INFINITY);
        let part = move |lane: usize| match alone {
            true if lane == by => 1.0 / self.chances[by],
            true => 0.0,
            false => densities[lane] / of_all,
        };
        let parts = (0..count).map(move |lane| (lane, part(lane)));
        let some = parts.filter(|(_, part)| *part > 0.0);
        some.map(|(lane, part)| (self.samples[lane], self.throughputs[lane] * part))
    }
}

by_processor! {
    /// By which density each near surface finds a far one if it sees it, as an area's: cosines over
    /// the square of the distance; and along which ray it sees it.
    #[inline(never)]
    fn find(far: &Far, lanes: &mut Lanes) {
        for lane in 0..padded(lanes.sites.lanes().end) {
            let point = lanes.sites.point(lane);
            let way = far.point.position - point.position;
            let square = way.dot(way);
            let (up, out) = (lanes.sites.normal(lane).dot(way), -far.ng.dot(way));
            let sees = (get(&lanes.ng, lane).dot(way) > 0.0) & (up > 0.0) & (out > 0.0);
            let density = (up / square) * (out / square);
            lanes.density[lane] = if sees { density } else { 0.0 };
            let ray = between(&point, &far.point);
            put(&mut lanes.origin, lane, ray.origin);
            put(&mut lanes.direction, lane, ray.direction);
            lanes.t_max[lane] = ray.t_max;
        }
    }
}
