//! The near surfaces of a group of samples, and the far ones that each might have found.

use glam::Vec3;

use super::{Far, Kind, Near};
use crate::math::Rgb;
use crate::render::World;
use crate::render::geometry::{Point, Ray, between};
use crate::render::lanes::{LANES, Row, Rows, by_processor, get, padded, put};

/// Those of one group, of as many samples as there are lanes at most.
pub(super) struct Group {
    /// Near surfaces, one lane for each.
    lanes: Lanes,
    points: Vec<Point>,
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

/// Where near surfaces are, and how they face.
struct Lanes {
    position: Rows,
    ng: Rows,
    ns: Rows,
    density: Row,
}

/// A far surface.
#[derive(Clone, Copy)]
struct Found {
    /// The lane of the near surface that has found it.
    by: usize,
    /// Whether others are to have its light.
    is_shared: bool,
}

impl Default for Group {
    fn default() -> Self {
        let rows = [[0.0; LANES]; 3];
        Self {
            lanes: Lanes { position: rows, ng: rows, ns: rows, density: [0.0; LANES] },
            points: Vec::new(),
            samples: Vec::new(),
            kinds: Vec::new(),
            chances: Vec::new(),
            throughputs: Vec::new(),
            fars: Vec::new(),
            densities: Vec::new(),
            rays: Vec::new(),
            asked: Vec::new(),
            hidden: Vec::new(),
        }
    }
}

impl Group {
    /// Forgets all of them.
    pub fn clear(&mut self) {
        self.points.clear();
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
        let lane = self.samples.len();
        put(&mut self.lanes.position, lane, near.point.position);
        put(&mut self.lanes.ng, lane, near.lambert.normal());
        put(&mut self.lanes.ns, lane, near.lambert.side());
        self.points.push(near.point);
        self.samples.push(sample);
        self.kinds.push(near.kind);
        self.chances.push(near.chance);
        self.throughputs.push(near.throughput);
    }

    /// One more far surface, found from the near one of that lane, whose light others are to have as
    /// well, or not. All near ones have come before. Returns how many rays it takes to see them.
    pub fn push_far(&mut self, far: &Far, by: usize, is_shared: bool) -> u64 {
        let asked = self.asked.len();
        let count = self.samples.len();
        find(count, far.point.position, far.ng, &mut self.lanes);
        let first = self.densities.len();
        self.densities.extend_from_slice(&self.lanes.density[..count]);
        let densities = &mut self.densities[first..];
        for (lane, density) in densities.iter_mut().enumerate() {
            if !is_shared || self.kinds[lane] != self.kinds[by] {
                *density = 0.0;
            } else if lane != by && *density > 0.0 {
                self.rays.push(between(&self.points[lane], &far.point));
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
        // Where numbers have no place for them it is that sample's alone.
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
    /// the square of the distance.
    #[inline(never)]
    fn find(count: usize, position: Vec3, ng: Vec3, lanes: &mut Lanes) {
        for lane in 0..padded(count) {
            let way = position - get(&lanes.position, lane);
            let square = way.dot(way);
            let (up, out) = (get(&lanes.ns, lane).dot(way), -ng.dot(way));
            let sees = (get(&lanes.ng, lane).dot(way) > 0.0) & (up > 0.0) & (out > 0.0);
            let density = (up / square) * (out / square);
            lanes.density[lane] = if sees { density } else { 0.0 };
        }
    }
}
