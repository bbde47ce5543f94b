//! Paths at many surfaces at once: which of them go on, and how.

use super::Ray;
use super::carrier::Branch;
use super::roulette::Roulette;
use crate::math::Rgb;
use crate::render::lanes::{LANES, Row, Rows, by_processor, get, padded, put};
use crate::render::lights::Sites;
use crate::render::materials::{Scattered, Ways};
use crate::render::samplers::Fours;

/// Paths that have come to surfaces, one lane for each.
pub(super) struct Turns {
    throughput: Rows,
    squeeze: Row,
    /// The largest chance to go on.
    limit: Row,
    /// Their ways on.
    pub ways: Ways,
    /// Where the rays along them begin, and what they bring to the camera.
    origin: Rows,
    behind: Rows,
    /// 1 where a path goes on.
    goes_on: Row<u32>,
}

impl Default for Turns {
    fn default() -> Self {
        let (row, rows) = ([0.0; LANES], [[0.0; LANES]; 3]);
        Self {
            throughput: rows,
            squeeze: row,
            limit: row,
            ways: Ways::default(),
            origin: rows,
            behind: rows,
            goes_on: [0; LANES],
        }
    }
}

impl Turns {
    /// Gives a lane its path, and the most of its chance to go on.
    #[inline(always)]
    pub fn put(&mut self, lane: usize, branch: &Branch, limit: f32) {
        self.put_parts(lane, (branch.throughput, branch.squeeze), limit);
    }

    #[inline(always)]
    fn put_parts(&mut self, lane: usize, (throughput, squeeze): (Rgb, f32), limit: f32) {
        put(&mut self.throughput, lane, throughput.to_array().into());
        self.squeeze[lane] = squeeze;
        self.limit[lane] = limit;
    }

    /// Begins a path anew with a throughput of one.
    pub fn begin_anew(&mut self, lane: usize) {
        self.put_parts(lane, (Rgb::ONE, 1.0), self.limit[lane]);
    }

    /// Gives a path another bound of its chance to go on.
    pub fn limit(&mut self, lane: usize, limit: f32) {
        self.limit[lane] = limit;
    }

    /// The throughput of the path that has come to a surface.
    #[inline(always)]
    pub fn throughput(&self, lane: usize) -> Rgb {
        rgb(&self.throughput, lane)
    }

    /// Decides of so many paths which go on along their ways, by the last of the lanes' numbers, and
    /// what becomes of those.
    pub fn decide(&mut self, count: usize, roulette: Roulette, sites: &Sites, fours: &Fours) {
        decide_all(count, roulette, sites, fours, self);
    }

    /// Whether the path of a lane goes on.
    #[inline(always)]
    pub fn goes_on(&self, lane: usize) -> bool {
        self.goes_on[lane] != 0
    }

    /// The way of a lane, and the ray along it with its throughput.
    #[inline(always)]
    pub fn way(&self, lane: usize, sites: &Sites) -> (Scattered, Ray, Rgb) {
        let (way, _) = self.ways.at(lane);
        let (origin, leaves) = (get(&self.origin, lane), sites.point(lane).sheet);
        let ray = Ray { leaves, ..Ray::new(origin, way.wi) };
        (way, ray, rgb(&self.behind, lane))
    }
}

#[inline(always)]
fn rgb(rows: &Rows, lane: usize) -> Rgb {
    let [r, g, b] = get(rows, lane).to_array();
    Rgb::new(r, g, b)
}

by_processor! {
    #[inline(never)]
    fn decide_all(
        count: usize,
        roulette: Roulette,
        sites: &Sites,
        fours: &Fours,
        turns: &mut Turns,
    ) {
        // A loop for each: none of them has jumps.
        match roulette {
            Roulette::Off => by(count, Roulette::Off, sites, fours, turns),
            Roulette::Mean => by(count, Roulette::Mean, sites, fours, turns),
            Roulette::Luminance => by(count, Roulette::Luminance, sites, fours, turns),
            Roulette::Throughput => by(count, Roulette::Throughput, sites, fours, turns),
        }
    }
}

#[inline(always)]
fn by(count: usize, roulette: Roulette, sites: &Sites, fours: &Fours, turns: &mut Turns) {
    for lane in 0..padded(count) {
        let [.., chance] = fours.at(lane);
        let (way, some) = turns.ways.at(lane);
        let throughput = turns.throughput(lane);
        let after = throughput * way.weight / turns.squeeze[lane];
        let survival = roulette.survival(way.weight, after, turns.limit[lane]);
        let behind = throughput * (way.weight / survival) * way.squeeze;
        put(&mut turns.behind, lane, behind.to_array().into());
        put(&mut turns.origin, lane, sites.point(lane).left(way.wi));
        turns.goes_on[lane] = u32::from(some & (chance < f64::from(survival)));
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;
    use crate::math::paths::Event;
    use crate::math::random;
    use crate::render::geometry::Point;
    use crate::render::integrators::roulette::{SAFE, most};
    use crate::render::lights::Site;
    use crate::render::samplers::Sampler;

    #[test]
    fn paths_that_are_decided_together_go_on_as_each_would() {
        let three = |from: u64, lane: usize| {
            let [x, y] = random::unit_pair(random::at(from, lane as u64));
            let [z, _] = random::unit_pair(random::at(from + 1, lane as u64));
            Vec3::new(x as f32, y as f32, z as f32)
        };
        let colour = |from: u64, lane: usize| {
            let [r, g, b] = three(from, lane).to_array();
            Rgb::new(r, g, b)
        };
        let site = |lane: usize| {
            let (position, ng) = (three(71, lane), (three(73, lane) - 0.5).normalize());
            let point =
                Point { position, error: 1e-6 * three(75, lane), ng, ..Point::free(position) };
            Site { point, normal: ng }
        };
        let way = |lane: usize| Scattered {
            wi: (three(77, lane) - 0.5).normalize(),
            weight: colour(79, lane),
            squeeze: 1.5,
            pdf_w: 0.5,
            event: Event::SpecularTransmission,
        };
        let all = [Roulette::Off, Roulette::Mean, Roulette::Luminance, Roulette::Throughput];
        for (roulette, count) in all.into_iter().flat_map(|it| [7, LANES].map(|count| (it, count)))
        {
            let (mut turns, mut sites, mut fours) =
                (Turns::default(), Sites::default(), Fours::default());
            let limit =
                |lane: usize| if lane.is_multiple_of(3) { SAFE } else { most(250 + lane as u32) };
            for lane in 0..count {
                sites.push(&site(lane));
                fours.push(&mut Sampler::Independent.stream(5, 1, lane as u64));
                turns.put_parts(lane, (colour(81, lane), 0.75), limit(lane));
                turns.ways.put(lane, (!lane.is_multiple_of(5)).then(|| way(lane)));
            }
            fours.draw();
            turns.decide(count, roulette, &sites, &fours);
            for lane in 0..count {
                let (way, from) = (way(lane), colour(81, lane));
                let after = from * way.weight / 0.75;
                let survival = roulette.survival(way.weight, after, limit(lane));
                let stays = !lane.is_multiple_of(5) && fours.at(lane)[3] < f64::from(survival);
                assert_eq!(turns.goes_on(lane), stays, "{roulette:?} {lane}");
                if stays {
                    let throughput = from * (way.weight / survival) * 1.5;
                    let told = (way, site(lane).point.ray(way.wi), throughput);
                    assert_eq!(turns.way(lane, &sites), told, "{roulette:?} {lane}");
                }
            }
        }
    }
}
