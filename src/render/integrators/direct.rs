//! Light that went from a light to a surface that scatters it, and from there to the camera,
//! straight or by mirrors, glass and metal; and no further. Beside it, if asked for, the light of
//! what surrounds the scene, by rays that meet nothing (ambient occlusion).

use super::carrier::{Branch, Carrier};
use super::lighting::Lighting;
use super::roulette::Roulette;
use super::{Ray, Stream, World};
use crate::math::Rgb;
use crate::render::geometry::Hit;
use crate::render::lights::Site;
use crate::render::materials::{Bsdf, Part};

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
    pub fn radiance(&self, world: &World, ray: &Ray, stream: &mut Stream, carrier: &mut Carrier) {
        let trail = carrier.start();
        carrier.waiting.push(Branch::first(ray, trail));
        while let Some(branch) = carrier.waiting.pop() {
            let Some(hit) = world.geometry.closest(&branch.ray) else {
                let seen = world.lights.seen(branch.ray.direction);
                carrier.add(branch.trail, branch.throughput * seen);
                continue;
            };
            if branch.mirrored == 0 {
                carrier.object = Some(hit.object);
            }
            let material = &world.materials[hit.material as usize];
            let emission = material.emission(&hit, -branch.ray.direction);
            carrier.add(branch.trail, branch.throughput * emission);

            let bsdf = material.at(&hit, -branch.ray.direction);
            if let Some(event) = bsdf.scatters() {
                let trail = carrier.after(branch.trail, event);
                let scattered = self.scattered(world, &hit, &bsdf, stream, carrier);
                carrier.add(trail, branch.throughput * scattered);
            }
            if branch.mirrored < self.specular_depth {
                self.go_on(&branch, &hit, &bsdf, stream, carrier);
            }
        }
    }

    /// What the surface scatters of all light that comes straight to it.
    fn scattered(
        &self,
        world: &World,
        hit: &Hit,
        bsdf: &Bsdf,
        stream: &mut Stream,
        carrier: &mut Carrier,
    ) -> Rgb {
        let mut sum = Rgb::BLACK;
        if let Some(lighting) = &self.lighting {
            let site = Site::new(hit, bsdf);
            let counts = &mut carrier.counts;
            sum += lighting.scattered(world, (&site, bsdf), stream, counts, |_, _| 1.0);
        }
        if let Some(ambient) = &self.ambient {
            let fan = stream.fan(ambient.rays);
            for nth in 0..ambient.rays {
                let Some(way) = bsdf.sample(Part::Scattering, fan.four(nth)) else { continue };
                let ray = Ray { t_max: ambient.distance, ..hit.ray(way.wi) };
                let light = way.weight * world.lights.ambient(way.wi);
                carrier.counts.shadow_rays += 1;
                if !light.is_black() && !world.geometry.occluded(&ray) {
                    sum += light / ambient.rays as f32;
                }
            }
        }
        sum
    }

    /// Sends rays on by mirrors, glass and metal.
    fn go_on(
        &self,
        branch: &Branch,
        hit: &Hit,
        bsdf: &Bsdf,
        stream: &mut Stream,
        carrier: &mut Carrier,
    ) {
        if branch.mirrored < self.splits {
            for way in bsdf.specular().into_iter().flatten() {
                let trail = carrier.after(branch.trail, way.event);
                carrier.waiting.push(branch.mirrored(hit, &way, trail));
            }
            return;
        }
        if !bsdf.is_specular() {
            return;
        }
        let [u, v, lobe, chance] = stream.four();
        let Some(mut way) = bsdf.sample(Part::Specular, [u, v, lobe, chance]) else { return };
        let throughput = branch.throughput * way.weight;
        let survival = self.roulette.survival(way.weight, throughput, branch.mirrored);
        if chance >= f64::from(survival) {
            return;
        }
        way.weight = way.weight / survival;
        let trail = carrier.after(branch.trail, way.event);
        carrier.waiting.push(branch.mirrored(hit, &way, trail));
    }
}
