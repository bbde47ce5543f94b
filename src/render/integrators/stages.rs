//! The stages of a path, each for all samples of a wave before the next: to a surface, what shines
//! there, what lamps send, and on.

use glam::Vec3;

use super::carrier::Branch;
use super::flight::{Flight, Surface};
use super::guided;
use super::path::Path;
use super::{Source, Wave};
use crate::math::paths::Event;
use crate::render::geometry::Hit;
use crate::render::lights::{Arrival, Site};
use crate::render::materials::{Many, Material, Matter};

impl Path {
    /// Radiance along the rays of a wave.
    ///
    /// Each turn takes every path that is in flight to its next surface, and from there on.
    pub fn follow<M: Matter>(&self, wave: &mut Wave, flight: &mut Flight<M>) {
        flight.begin();
        flight.reuse.begin(if self.shares() { wave.rays.len() } else { 0 }, wave.world.film.layers);
        while flight.enter(wave) {
            flight.meet(wave.world);
            self.arrive(wave, flight);
            if self.shares() {
                self.note(wave, flight);
            }
            self.ask(wave, flight);
            self.go_on(wave, flight);
            flight.turn();
            wave.follow(flight.lanes.len());
            if wave.given_up {
                return;
            }
        }
        if self.shares() {
            self.share(wave, flight);
        }
    }

    /// Brings home what the surfaces shine that were met, and what is beyond all of them; finds what
    /// surfaces do with light.
    fn arrive<M: Matter>(&self, wave: &mut Wave, flight: &mut Flight<M>) {
        let world = wave.world;
        flight.forget();
        let Flight { branches, lanes, next, hits, later, parted, .. } = flight;
        let Flight { surfaces, many, sites, lit, turns, .. } = flight;
        let mut see = |place: usize, branch: &Branch, hit: &Hit, material: &Material| {
            let seen = many.push(material, hit, -branch.ray.direction);
            let split = self.split(branch, &seen);
            let (nth, lane, scatters) = (surfaces.len(), lanes[place], seen.lambert.is_some());
            let normal = seen.lambert.as_ref().map_or(Vec3::ZERO, |lambert| lambert.side());
            let site = Site { point: hit.point(), normal };
            match M::rank(material) {
                0 => sites.push(&site),
                _ => sites.add(&site),
            }
            turns.put(nth, branch, self.limit(branch.scattered + branch.mirrored));
            let chance = many.chance(split.part);
            lit.put(nth, seen.lambert.as_ref().map(|lambert| (lambert, chance)), split.rays);
            surfaces.push(Surface { lane, place, site, scatters, split });
        };
        if world.overlaps.is_some() {
            for (&lane, hit) in lanes.iter().zip(&mut *hits) {
                branches[lane].pass(world, hit);
            }
        }
        let [met, gone] = parted.by(lanes.len(), |place| hits[place].is_some());
        for &place in gone {
            let lane = lanes[place as usize];
            let (branch, carrier) = (&mut branches[lane], &mut wave.carriers[lane]);
            self.escaped(world, branch, carrier);
            next.end(lane, branch, carrier);
        }
        for &place in met {
            let place = place as usize;
            let (lane, Some(hit)) = (lanes[place], &hits[place]) else { continue };
            let (branch, carrier) = (&mut branches[lane], &mut wave.carriers[lane]);
            let met = branch.scattered + branch.mirrored;
            if met == 0 {
                carrier.object = Some(hit.object);
            }
            let material = &world.materials[hit.material as usize];
            let emission = material.emission(hit, -branch.ray.direction);
            if !emission.is_black() {
                let weight = self.weight_of_met(world, branch, hit);
                let light = branch.throughput * emission * weight;
                carrier.add(branch.trail, light, || Source::Point(hit.position));
            }
            if met >= self.depth {
                next.end(lane, branch, carrier);
                continue;
            }
            match M::rank(material) {
                0 => see(place, branch, hit, material),
                rank => later[rank - 1].push(place as u32),
            }
        }
        // None for matter of one rank, as the compiler is to know.
        for &place in later[..M::RANKS - 1].iter().flatten() {
            let place = place as usize;
            let (branch, Some(hit)) = (&branches[lanes[place]], &hits[place]) else { continue };
            see(place, branch, hit, &world.materials[hit.material as usize]);
        }
    }

    /// Brings home what the surfaces scatter of the light of lamps.
    fn ask<M: Matter>(&self, wave: &mut Wave, flight: &mut Flight<M>) {
        let Some(lighting) = &self.lighting else { return };
        let world = wave.world;
        let Flight { branches, surfaces, sites, trails, arrivals, lit, .. } = flight;
        let (turns, questions) = (&flight.turns, &mut flight.questions);
        let surfaces = &surfaces[sites.lanes()];
        trails.clear();
        for Surface { lane, site, scatters, .. } in surfaces {
            let carrier = &mut wave.carriers[*lane];
            let trail = scatters.then(|| {
                let event = Event::DiffuseReflection;
                carrier.after(branches[*lane].trail, event, site.point.position)
            });
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
                let arrived = (&*arrivals, turns);
                for (nth, light) in lit.find(surfaces.len(), (self, lighting), arrived) {
                    if let Some(trail) = trails[nth] {
                        let answer = (world, lighting.shadows, &mut *wave.carriers);
                        let lane = surfaces[nth].lane;
                        questions.ask(answer, lane, || arrivals.shadow(nth), (trail, light));
                    }
                }
            }
            return questions.answer(world, &mut wave.carriers);
        }
        for (nth, (surface, trail)) in surfaces.iter().zip(trails).enumerate() {
            let Surface { lane, site, split, .. } = surface;
            let Some(trail) = *trail else { continue };
            let (lambert, chance) = lit.lamberts.at(nth);
            let seen = (branches[*lane].throughput, &lambert, [split.rays as f32, chance]);
            lighting.ask(world, site, &mut wave.streams[*lane], |arrival, taken| {
                let Arrival { wi, irradiance, pdf_w, shadow } = *arrival;
                let arrived = (wi, irradiance);
                let (light, some) = self.light_of(lighting, seen, arrived, (pdf_w, taken));
                if some {
                    let answer = (world, lighting.shadows, &mut *wave.carriers);
                    questions.ask(answer, *lane, || shadow, (trail, light));
                }
            });
        }
        questions.answer(world, &mut wave.carriers);
    }

    /// Sends the paths on. Where several rays go on from a surface, they wait.
    fn go_on<M: Matter>(&self, wave: &mut Wave, flight: &mut Flight<M>) {
        let Flight { branches, hits, surfaces, many, sites, lit, turns, .. } = flight;
        let (parted, next) = (&mut flight.parted, &mut flight.next);
        let count = surfaces.len();
        wave.fours.clear();
        for surface in &*surfaces {
            match surface.split.is_any() {
                true => wave.fours.skip(),
                false => wave.fours.push(&mut wave.streams[surface.lane]),
            }
        }
        wave.fours.draw();
        let materials = &wave.world.materials;
        many.ways(materials, &lit.lamberts, &wave.fours, &mut turns.ways);
        if let Some(guide) = &wave.world.guide {
            let (of, reuse) = ((&*sites, &lit.lamberts), &mut flight.reuse);
            guided::ways(guide, of, &wave.fours, &mut turns.ways, |nth, chosen| {
                reuse.choose(surfaces[nth].lane, chosen);
            });
        }
        flight.reuse.end_strays(&mut turns.ways);
        turns.decide(count, self.roulette, sites, &wave.fours);
        let [going, ended] =
            parted.by(count, |nth| turns.goes_on(nth) & !surfaces[nth].split.is_any());
        for &nth in going {
            let Surface { lane, place, site, .. } = &surfaces[nth as usize];
            let (branch, carrier) = (&mut branches[*lane], &mut wave.carriers[*lane]);
            let (way, ray, throughput) = turns.way(nth as usize, sites);
            branch.take(site, &way, (ray, throughput), 1);
            let at = (way.event, site.point.position);
            match carrier.behind(branch, at, || hits[*place].as_ref()) {
                true => next.lanes.push(*lane),
                false => next.end(*lane, branch, carrier),
            }
            wave.given_up |= carrier.given_up;
        }
        for &nth in ended {
            let Surface { lane, place, site, split, .. } = &surfaces[nth as usize];
            let (branch, carrier) = (&mut branches[*lane], &mut wave.carriers[*lane]);
            if let Some(hit) = &hits[*place]
                && split.is_any()
            {
                let stream = &mut wave.streams[*lane];
                let material = &materials[hit.material as usize];
                let bsdf = M::at(material, hit, -branch.ray.direction);
                self.split_on(branch, hit, (site, &bsdf, *split), stream, carrier);
            }
            next.end(*lane, branch, carrier);
            wave.given_up |= carrier.given_up;
        }
    }
}
