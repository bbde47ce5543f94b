//! The stages of a path, each for all samples of a wave before the next: to a surface, what shines
//! there, what lamps send, and on.

use super::carrier::{Branch, Carrier};
use super::flight::{Flight, Surface};
use super::path::Path;
use super::{Source, Wave};
use crate::render::geometry::Hit;
use crate::render::lights::{Arrival, Site};
use crate::render::materials::{Matter, Scatter, Scattered};

impl Path {
    /// Radiance along the rays of a wave.
    ///
    /// Each turn takes every path that is in flight to its next surface, and from there on.
    pub fn follow<M: Matter>(&self, wave: &mut Wave, flight: &mut Flight<M>) {
        flight.begin(wave);
        while !flight.lanes.is_empty() {
            flight.meet(wave.world);
            self.arrive(wave, flight);
            self.ask(wave, flight);
            self.go_on(wave, flight);
            flight.turn();
            wave.follow(flight.lanes.len());
            if wave.given_up {
                return;
            }
        }
    }

    /// Brings home what the surfaces shine that were met, and what is beyond all of them; finds what
    /// surfaces do with light.
    fn arrive<M: Matter>(&self, wave: &mut Wave, flight: &mut Flight<M>) {
        let world = wave.world;
        flight.surfaces.clear();
        flight.sites.clear();
        for (place, (&lane, hit)) in flight.lanes.iter().zip(&mut flight.hits).enumerate() {
            let (branch, carrier) = (&mut flight.branches[lane], &mut wave.carriers[lane]);
            branch.pass(world, hit);
            let Some(hit) = hit else {
                self.escaped(world, branch, carrier);
                flight.next.end(lane, branch, carrier);
                continue;
            };
            let surfaces = branch.scattered + branch.mirrored;
            if surfaces == 0 {
                carrier.object = Some(hit.object);
            }
            let material = &world.materials[hit.material as usize];
            let emission = material.emission(hit, -branch.ray.direction);
            if !emission.is_black() {
                let weight = self.weight_of_met(world, branch, hit);
                let light = branch.throughput * emission * weight;
                carrier.add(branch.trail, light, || Source::Point(hit.position));
            }
            if surfaces >= self.depth {
                flight.next.end(lane, branch, carrier);
                continue;
            }
            let bsdf = M::at(material, hit, -branch.ray.direction);
            let site = Site::new(hit, &bsdf);
            let split = self.split(branch, &bsdf);
            flight.sites.push(&site);
            let scatters = bsdf.lambert_of(split.part);
            flight.lit.put(flight.surfaces.len(), scatters, (branch.throughput, split.rays));
            flight.surfaces.push(Surface { lane, place, site, bsdf, split });
        }
    }

    /// Brings home what the surfaces scatter of the light of lamps.
    fn ask<M: Matter>(&self, wave: &mut Wave, flight: &mut Flight<M>) {
        let Some(lighting) = &self.lighting else { return };
        let world = wave.world;
        let Flight { branches, hits, surfaces, sites, trails, arrivals, lit, questions, .. } =
            flight;
        trails.clear();
        for Surface { lane, place, bsdf, .. } in &*surfaces {
            let carrier = &mut wave.carriers[*lane];
            let scatters = bsdf.scatters().zip(hits[*place].as_ref());
            let trail =
                scatters.map(|(event, hit)| carrier.after(branches[*lane].trail, event, hit));
            trails.push(trail.filter(|trail| !carrier.is_hidden(*trail)));
        }
        if lighting.is_plain() {
            for asked in lighting.rounds(world.lights.all.len()) {
                let takes_numbers = world.lights.takes_numbers(asked);
                wave.fours.clear();
                for (surface, trail) in surfaces.iter().zip(&*trails) {
                    let stream = &mut wave.streams[surface.lane];
                    match trail {
                        Some(_) if takes_numbers => wave.fours.push(stream),
                        Some(_) => wave.fours.pass(stream),
                        None => wave.fours.skip(),
                    }
                }
                wave.fours.draw();
                world.lights.sample_all(&world.geometry, (sites, &wave.fours), asked, arrivals);
                for (nth, light) in lit.find(surfaces.len(), (self, lighting), arrivals) {
                    if let Some(trail) = trails[nth] {
                        let answer = (world, lighting.shadows, &mut *wave.carriers);
                        let lane = surfaces[nth].lane;
                        questions.ask(answer, lane, arrivals.shadow(nth), (trail, light));
                    }
                }
            }
            return questions.answer(world, &mut wave.carriers);
        }
        for (surface, trail) in surfaces.iter().zip(trails) {
            let Surface { lane, site, bsdf, split, .. } = surface;
            let Some((trail, (lambert, chance))) = trail.zip(bsdf.lambert_of(split.part)) else {
                continue;
            };
            let seen = (branches[*lane].throughput, lambert, [split.rays as f32, chance]);
            lighting.ask(world, site, &mut wave.streams[*lane], |arrival, taken| {
                let Arrival { wi, irradiance, pdf_w, shadow } = *arrival;
                let arrived = (wi, irradiance);
                let (light, some) = self.light_of(lighting, seen, arrived, (pdf_w, taken));
                if some {
                    let answer = (world, lighting.shadows, &mut *wave.carriers);
                    questions.ask(answer, *lane, shadow, (trail, light));
                }
            });
        }
        questions.answer(world, &mut wave.carriers);
    }

    /// Sends the paths on. Where several rays go on from a surface, they wait.
    fn go_on<M: Matter>(&self, wave: &mut Wave, flight: &mut Flight<M>) {
        let Flight { branches, hits, surfaces, sites, cosines, next, .. } = flight;
        wave.fours.clear();
        for surface in &*surfaces {
            match surface.split.is_any() {
                true => wave.fours.skip(),
                false => wave.fours.push(&mut wave.streams[surface.lane]),
            }
        }
        wave.fours.draw();
        if M::BY_COSINE {
            cosines.sample(surfaces.len(), sites.normals(), wave.fours.rows());
        }
        for (nth, surface) in surfaces.iter().enumerate() {
            let Surface { lane, place, site, bsdf, split } = surface;
            let Some(hit) = &hits[*place] else { continue };
            let (branch, carrier) = (&mut branches[*lane], &mut wave.carriers[*lane]);
            let goes_on = if split.is_any() {
                let stream = &mut wave.streams[*lane];
                self.split_on(branch, hit, (site, bsdf, *split), stream, carrier);
                false
            } else {
                let u = wave.fours.at(nth);
                let way = M::way(bsdf, cosines, nth, u);
                way.is_some_and(|way| self.way_on(branch, hit, (site, way, u[3]), carrier))
            };
            if goes_on {
                next.lanes.push(*lane);
            } else {
                next.end(*lane, branch, carrier);
            }
            wave.given_up |= carrier.given_up;
        }
    }

    /// Turns a path to a way on. Whether it takes it, by a `chance` in [0, 1) that decides nothing
    /// else.
    #[inline(always)]
    fn way_on(
        &self,
        branch: &mut Branch,
        hit: &Hit,
        (site, mut way, chance): (&Site, Scattered, f64),
        carrier: &mut Carrier,
    ) -> bool {
        let surfaces = branch.scattered + branch.mirrored;
        if surfaces >= self.roulette_after {
            let throughput = branch.throughput * way.weight / branch.squeeze;
            let survival = self.roulette.survival(way.weight, throughput, surfaces);
            if chance >= f64::from(survival) {
                return false;
            }
            way.weight = way.weight / survival;
        }
        branch.turn(site, &way, 1);
        carrier.behind(branch, way.event, hit)
    }
}
