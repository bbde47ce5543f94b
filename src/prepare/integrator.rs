//! Integrators and samplers of the scene → those of the world.

use super::errors::scene as errors;
use crate::diag::Diagnostic;
use crate::plan::{Feature, Plan};
use crate::render::integrators::{
    Ambient, AreaLights, Asked, Direct, Integrator, Lighting, Path, Preview, Roulette, Splits,
};
use crate::render::samplers::Sampler;
use crate::scene::{self, At, Count, Depth, LightCount};

/// How light is followed, by the plan of a stage with that integrator; `scale` in world units a
/// metre.
pub(super) fn prepare(integrator: &scene::Integrator, plan: &Plan, scale: f64) -> Integrator {
    let lighting = |lights: Option<LightCount>, points: &At<Count>| {
        plan.builds(Feature::Lights).then(|| Lighting {
            lights: match lights {
                Some(LightCount::All) => Asked::All,
                Some(LightCount::Chosen(count)) => Asked::Chosen(count as u32),
                None => Asked::AllOfFew,
            },
            points: points.0 as u32,
            shadows: plan.builds(Feature::ShadowRays),
            numbers: plan.builds(Feature::LampPoints),
            area_lights: match integrator.lamp_points() {
                Ok(()) => AreaLights::Random,
                Err(_) => AreaLights::Center,
            },
        })
    };
    match integrator {
        scene::Integrator::Ambient(ambient) => Integrator::Direct(Direct {
            lighting: lighting(Some(ambient.lights.value), &ambient.light_samples),
            ambient: Some(Ambient {
                rays: ambient.rays.0 as u32,
                distance: ambient
                    .distance
                    .as_ref()
                    .map_or(f32::INFINITY, |distance| (scale * distance.0) as f32),
            }),
            specular_depth: depth(&ambient.specular_depth),
            splits: ambient.splits.specular.0 as u32,
            roulette: roulette(&ambient.roulette),
        }),
        scene::Integrator::Direct(direct) => Integrator::Direct(Direct {
            lighting: lighting(Some(direct.lights.value), &direct.light_samples),
            ambient: None,
            specular_depth: depth(&direct.specular_depth),
            splits: direct.splits.specular.0 as u32,
            roulette: roulette(&direct.roulette),
        }),
        scene::Integrator::Path(path) => Integrator::Path(Path {
            lighting: lighting(path.lights.value, &path.light_samples),
            mis: path.mis.0,
            splits: Splits {
                specular: path.splits.specular.0 as u32,
                diffuse: path.splits.diffuse.0 as u32,
                rays: path.splits.rays.0 as u32,
            },
            roulette: roulette(&path.roulette),
            roulette_after: path.roulette_after.0 as u32,
            depth: depth(&path.depth),
            reuse: if plan.requires(Feature::Reuse) { path.reuse.0 as u32 } else { 1 },
        }),
        scene::Integrator::Preview(_) => Integrator::Preview(Preview),
    }
}

fn depth(depth: &Depth) -> u32 {
    depth.most().map_or(u32::MAX, |most| most as u32)
}

fn roulette(roulette: &scene::Roulette) -> Roulette {
    match roulette {
        scene::Roulette::Off => Roulette::Off,
        scene::Roulette::Mean => Roulette::Mean,
        scene::Roulette::Luminance => Roulette::Luminance,
        scene::Roulette::Throughput => Roulette::Throughput,
    }
}

/// Refuses paths that nothing ends.
pub(super) fn check(integrator: &scene::Integrator, found: &mut Vec<Diagnostic>) {
    let (depth, roulette) = match integrator {
        scene::Integrator::Ambient(it) => (&it.specular_depth, &it.roulette),
        scene::Integrator::Direct(it) => (&it.specular_depth, &it.roulette),
        scene::Integrator::Path(it) => (&it.depth, &it.roulette),
        scene::Integrator::Preview(_) => return,
    };
    if depth.value == Depth::Unlimited && roulette.value == scene::Roulette::Off {
        found.push(errors::endless_paths(depth.span, roulette.span));
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
