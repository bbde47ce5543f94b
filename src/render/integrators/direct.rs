//! Light that went from a light to a surface that scatters it, and from there to the camera,
//! straight or by mirrors, glass and metal; and no further. Beside it, if asked for, the light of
//! what surrounds the scene, by rays that meet nothing (ambient occlusion).

use super::carrier::{Branch, Carrier, Trail};
use super::lighting::Lighting;
use super::roulette::{self, Roulette};
use super::{Ray, Source, Stream, World};
use crate::math::Rgb;
use crate::render::geometry::Hit;
use crate::render::lights::{Arrival, Site};
use crate::render::materials::{Matter, Part, Scatter};

/// The direct integrator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direct {
    /// How lights are asked, if they are.
    pub lighting: Option<Lighting>,
    /// How what surrounds the scene is looked for, if it is.
    pub ambient: Option<Ambient>,
    /// How often light is mirrored at most.
    pub specular_depth: u32,
    /// The first so many mirrors, panes of glass and metals, where all ways on are followed.
    pub splits: u32,
    /// By what chance a ray goes on at the others.
    pub roulette: Roulette,
}

/// Rays from a point towards what surrounds the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ambient {
    /// How many, 1 or more.
    pub rays: u32,
    /// How far a surface may be to hide what is behind it; world units, may be +∞.
    pub distance: f32,
}

impl Direct {
    /// Radiance along the ray.
    pub fn radiance<M: Matter>(
        &self,
        world: &World,
        ray: &Ray,
        stream: &mut Stream,
        carrier: &mut Carrier,
    ) {
        let trail = carrier.start();
        carrier.waiting.push(Branch::first(world, ray, trail));
        while let Some(mut branch) = carrier.waiting.pop() {
            let Some(hit) = branch.meet(world) else {
                let direction = branch.ray.direction;
                let seen = branch.throughput * world.lights.seen(direction);
                carrier.add(branch.trail, seen, || Source::Direction(direction));
                continue;
            };
            if branch.mirrored == 0 {
                carrier.object = Some(hit.object);
            }
            let material = &world.materials[hit.material as usize];
            let emission = material.emission(&hit, -branch.ray.direction);
            let light = branch.throughput * emission;
            carrier.add(branch.trail, light, || Source::Point(hit.position));

            let bsdf = M::at(material, &hit, -branch.ray.direction);
            let site = Site::new(&hit, &bsdf);
            if let Some(event) = bsdf.scatters() {
                let trail = carrier.after(branch.trail, event, hit.position);
                if !carrier.is_hidden(trail) {
                    let on = (trail, branch.throughput);
                    self.scattered(world, (&site, &bsdf), stream, on, carrier);
                }
            }
            if branch.mirrored < self.specular_depth {
                self.go_on(&branch, &hit, (&site, &bsdf), stream, carrier);
            }
        }
    }

    /// Brings home what the surface scatters of all light that comes straight to it, on a path
    /// that has scattered there, times the throughput so far.
    fn scattered(
        &self,
        world: &World,
        (site, bsdf): (&Site, &impl Scatter),
        stream: &mut Stream,
        (trail, throughput): (Trail, Rgb),
        carrier: &mut Carrier,
    ) {
        if let Some(lighting) = &self.lighting {
            lighting.ask(world, site, stream, |arrival, taken| {
                let Arrival { wi, irradiance, shadow, .. } = arrival;
                let (scattered, is_seen) = lighting.scattered(bsdf, *wi, *irradiance);
                if is_seen {
                    let light = throughput * scattered * (1.0 / taken);
                    carrier.ask(world, lighting.shadows, shadow, (trail, light));
                }
            });
        }
        if let Some(ambient) = &self.ambient {
            let fan = stream.fan(ambient.rays);
            for nth in 0..ambient.rays {
                let Some(way) = bsdf.sample(Part::Scattering, fan.four(nth)) else { continue };
                let ray = Ray { t_max: ambient.distance, ..site.point.ray(way.wi) };
                let light = way.weight * world.lights.ambient(way.wi);
                carrier.shadow_rays += 1;
                if !light.is_black() && !world.geometry.occluded(&ray) {
                    let light = throughput * light / ambient.rays as f32;
                    carrier.add(trail, light, || Source::Direction(way.wi));
                }
            }
        }
    }

    /// Sends rays on by mirrors, glass and metal.
    fn go_on(
        &self,
        branch: &Branch,
        hit: &Hit,
        (site, bsdf): (&Site, &impl Scatter),
        stream: &mut Stream,
        carrier: &mut Carrier,
    ) {
        if branch.mirrored < self.splits {
            for way in bsdf.specular().into_iter().flatten() {
                carrier.follow(branch.turned(site, &way, 1), way.event, hit);
            }
            return;
        }
        if !bsdf.is_specular() {
            return;
        }
        let [u, v, lobe, chance] = stream.four();
        let Some(mut way) = bsdf.sample(Part::Specular, [u, v, lobe, chance]) else { return };
        let throughput = branch.throughput * way.weight / branch.squeeze;
        let limit = roulette::most(branch.mirrored);
        let survival = self.roulette.survival(way.weight, throughput, limit);
        if chance >= f64::from(survival) {
            return;
        }
        way.weight = way.weight / survival;
        carrier.follow(branch.turned(site, &way, 1), way.event, hit);
    }
}
