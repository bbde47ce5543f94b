//! Light that went from a lamp to a surface to the camera, and no further.

use super::{Counts, Ray, Sample, Stream, World};
use crate::math::Rgb;

/// The direct integrator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direct {
    /// Whether surfaces hide lamps.
    pub shadows: bool,
    /// Whether every light takes random numbers. Where none needs them the picture is the same
    /// without.
    pub numbers: bool,
    /// Which points of a lamp with an area shine.
    pub area_lights: AreaLights,
}

/// Which points of a lamp with an area shine on a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AreaLights {
    /// Its centre alone.
    Center,
    /// A random point for every sample.
    Random,
}

impl Direct {
    /// Radiance along the ray, in light units: emission of the first surface, and the light of
    /// every lamp that it scatters, each lamp sampled once.
    pub fn radiance(
        &self,
        world: &World,
        ray: &Ray,
        stream: &mut Stream,
        counts: &mut Counts,
    ) -> Sample {
        let Some(hit) = world.geometry.closest(ray) else {
            return Sample { radiance: world.lights.background, object: None };
        };
        let material = &world.materials[hit.material as usize];
        let front = hit.ng.dot(ray.direction) < 0.0;
        let mut radiance = if front { material.emission() } else { Rgb::BLACK };

        let surface = material.at(&hit, -ray.direction);
        let point = hit.point();
        for light in &world.lights.all {
            // Every lamp takes its numbers, whether they are needed or not, so that the numbers
            // of the next do not depend on where the ray went.
            let u = if self.numbers { stream.pair() } else { [0.0; 2] };
            let arrival = match self.area_lights {
                AreaLights::Center => light.at_centre(&point),
                AreaLights::Random => light.sample(&world.geometry, &point, u),
            };
            let Some(arrival) = arrival else { continue };
            let scattered = surface.scattered(arrival.wi) * arrival.irradiance;
            if scattered.is_black() {
                continue;
            }
            if self.shadows {
                // A surface hides first of all what is behind itself.
                if !surface.faces(arrival.wi) {
                    continue;
                }
                counts.shadow_rays += 1;
                if world.geometry.occluded(&arrival.shadow) {
                    continue;
                }
            }
            radiance += scattered;
        }
        Sample { radiance, object: Some(hit.object) }
    }
}
