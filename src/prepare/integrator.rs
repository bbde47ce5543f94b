//! Integrators and samplers of the scene → those of the world.

use crate::plan::{Feature, Plan};
use crate::render::integrators::{AreaLights, Direct, Integrator, Preview};
use crate::render::samplers::Sampler;
use crate::scene;

/// How light is followed, by the plan of a stage with that integrator.
pub(super) fn prepare(integrator: &scene::Integrator, plan: &Plan) -> Integrator {
    match integrator {
        scene::Integrator::Direct(direct) => Integrator::Direct(Direct {
            shadows: plan.builds(Feature::ShadowRays),
            numbers: plan.builds(Feature::LampPoints),
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
        scene::Sampler::Sobol(sobol) => Sampler::Sobol { round: sobol.round.0 as u32 },
        scene::Sampler::Stratified(stratified) => {
            Sampler::Stratified { grid: stratified.grid.0 as u32 }
        }
    }
}
