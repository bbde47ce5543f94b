//! What is where: colours, shaded by a light at the camera. No lamps, no shadows.

use super::carrier::Carrier;
use super::{Ray, World};

/// The preview integrator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preview;

impl Preview {
    /// The colour of the surface times the cosine to the viewer, and what the surface or the
    /// background shines, so that lamps are seen for what they are.
    pub fn radiance(&self, world: &World, ray: &Ray, carrier: &mut Carrier) {
        carrier.start();
        let Some(hit) = world.geometry.closest(ray) else {
            carrier.radiance = world.lights.seen(ray.direction);
            return;
        };
        let material = &world.materials[hit.material as usize];
        // One unit of radiance in the scene's own units, whatever the unit of light within.
        let headlight = (1.0 / world.light_unit) as f32;
        let shaded = material.colour(&hit) * (headlight * hit.ns.dot(ray.direction).abs());
        carrier.object = Some(hit.object);
        // No light is followed, and so it came by no path.
        carrier.radiance = shaded + material.emission(&hit, -ray.direction);
    }
}
