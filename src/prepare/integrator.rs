//! Integrators and samplers of the scene → those of the world.

use crate::render::integrators::{AreaLights, Direct, Integrator, Preview};
use crate::render::samplers::Sampler;
use crate::scene;

/// How light is followed.
pub(super) fn prepare(integrator: &scene::Integrator) -> Integrator {
    match integrator {
        scene::Integrator::Direct(direct) => Integrator::Direct(Direct {
            shadows: direct.shadows.0,
            area_lights: match direct.area_lights.value {
                scene::AreaLights::Center => AreaLights::Center,
                scene::AreaLights::Random => AreaLights::Random,
            },
        }),
        scene::Integrator::Preview(_) => Integrator::Preview(Preview),
    }
}

/// Where the random numbers come from.
pub(super) fn sampler(sampler: &scene::Sampler) -> Sampler {
    match sampler {
        scene::Sampler::Independent(_) => Sampler::Independent,
        scene::Sampler::Stratified(stratified) => {
            Sampler::Stratified { grid: stratified.grid.0 as u32 }
        }
    }
}
