//! The stages of a path, each for all samples of a wave before the next: to a surface, what shines
//! there, what lamps send, and on.

use glam::Vec3;

use super::carrier::{Branch, Carrier};
use super::flight::{Flight, Surface};
use super::lighting::Lighting;
use super::path::{Path, Split, power};
use super::{Source, Wave};
use crate::math::Rgb;
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
            flight.surfaces.push(Surface { lane, place, site, bsdf, split });
        }
    }

    /// Brings home what the surfaces scatter of the light of lamps.
    fn ask<M: Matter>(&self, wave: &mut Wave, flight: &mut Flight<M>) {
        let Some(lighting) = &self.lighting else { return };
        let world = wave.world;
        let Flight { branches, hits, surfaces, sites, trails, arrivals, questions, .. } = flight;
        let together = lighting.is_plain();
        trails.clear();
        wave.fours.clear();
        for Surface { lane, place, bsdf, .. } in &*surfaces {
            let carrier = &mut wave.carriers[*lane];
            let scatters = bsdf.scatters().zip(hits[*place].as_ref());
            let trail =
                scatters.map(|(event, hit)| carrier.after(branches[*lane].trail, event, hit));
            let trail = trail.filter(|trail| !carrier.is_hidden(*trail));
            trails.push(trail);
            match trail {
                Some(_) if together => wave.fours.push(&mut wave.streams[*lane]),
                _ => wave.fours.skip(),
            }
        }
        if together {
            wave.fours.draw();
            world.lights.sample_all(&world.geometry, sites, &wave.fours, arrivals);
        }
        for (nth, (surface, trail)) in surfaces.iter().zip(trails).enumerate() {
            let Some(trail) = *trail else { continue };
            let lane = surface.lane;
            let seen = (branches[lane].throughput, surface);
            if together {
                let arrived = (arrivals.wi(nth), arrivals.irradiance(nth));
                let light = self.light_of(lighting, seen, arrived, arrivals.density(nth));
                if let Some(light) = light {
                    let answer = (world, lighting.shadows, &mut *wave.carriers);
                    questions.ask(answer, lane, arrivals.shadow(nth), (trail, light));
                }
                continue;
            }
            lighting.ask(world, &surface.site, &mut wave.streams[lane], |arrival, taken| {
                let Arrival { wi, irradiance, pdf_w, shadow } = *arrival;
                let light = self.light_of(lighting, seen, (wi, irradiance), (pdf_w, taken));
                if let Some(light) = light {
                    let answer = (world, lighting.shadows, &mut *wave.carriers);
                    questions.ask(answer, lane, shadow, (trail, light));
                }
            });
        }
        questions.answer(world, &mut wave.carriers);
    }

    /// What a light that was asked brings if nothing is in its way: one that arrives at a surface by a
    /// path of this throughput. Its direction was found with density `pdf_w`, in so many samples.
    #[inline(always)]
    fn light_of<M: Matter>(
        &self,
        lighting: &Lighting,
        (throughput, surface): (Rgb, &Surface<M>),
        (wi, irradiance): (Vec3, Rgb),
        (pdf_w, taken): (f32, f32),
    ) -> Option<Rgb> {
        let scattered = lighting.scattered(&surface.bsdf, wi, irradiance)?;
        let density = taken * pdf_w;
        // No other way finds it, or none is to count.
        let part = if density == 0.0 || !self.mis {
            1.0
        } else {
            let Split { rays, part, .. } = surface.split;
            power(density, rays as f32 * surface.bsdf.pdf_w(part, wi))
        };
        Some(throughput * scattered * (part / taken))
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
