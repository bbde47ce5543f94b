//! What is where: colours, shaded by a light at the camera. No lamps, no shadows.

use super::{Ray, Sample, World};

/// The preview integrator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preview;

impl Preview {
    /// The colour of the surface times the cosine to the viewer, and what the surface or the
    /// background shines, so that lamps are seen for what they are.
    pub fn radiance(&self, world: &World, ray: &Ray) -> Sample {
        let Some(hit) = world.geometry.closest(ray) else {
            return Sample { radiance: world.lights.background, object: None };
        };
        let material = &world.materials[hit.material as usize];
        // One unit of radiance in the scene's own units, whatever the unit of light within.
        let headlight = (1.0 / world.light_unit) as f32;
        let mut radiance = material.colour() * (headlight * hit.ns.dot(ray.direction).abs());
        if hit.ng.dot(ray.direction) < 0.0 {
            radiance += material.emission();
        }
        Sample { radiance, object: Some(hit.object) }
    }
}
