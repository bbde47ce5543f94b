//! An exposure at which the PNG is white wherever a light falls straight, or black all over.

use std::f64::consts::PI;

use glam::DVec3;

use crate::bodies::Placed;
use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::math::Bounds;
use crate::optics::colour;
use crate::plan::daylight::Daylight;
use crate::plan::largest;
use crate::scene::{Light, Named, PointLight, SpotLight};

/// A surface that a light falls on straight may be so many times as bright as white: it is the
/// lit parts of a dark scene then.
const BRIGHTEST: f64 = 32.0;
/// Half a step of eight bits above black, in linear light.
const DARKEST: f64 = 0.5 / 255.0 / 12.92;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let scene = &shot.stage.scene;
    if !scene.integrator.follows_light() {
        return;
    }
    let exposure = &scene.film.exposure;
    let stops = exposure.value.0;
    // A default stands where the record is that left it out, and shows nothing there.
    let stated = (exposure.span != scene.film.span).then_some(exposure.span);
    let factor = stops.exp2();
    let most = |channels: [f64; 3]| channels.into_iter().fold(0.0, f64::max);
    let materials = || shot.things.iter().flat_map(|thing| thing.all_parts());
    let scattering = materials().filter(|material| material.value.scatters());
    let albedo = scattering.filter_map(|material| material.value.reflectance());
    let albedo = albedo.map(|albedo| most(largest(shot.stage, albedo))).fold(0.0, f64::max);
    let lamps = materials().filter_map(|material| material.value.emission());
    let lamps = lamps.map(|emission| most(colour::emitted(&emission.0)));
    // A lamp gives no surface more than if it filled all that the surface faces.
    let mut bound: f64 = lamps.map(|radiance| radiance * (1.0 + albedo)).sum();
    let mut lights = 0.0;
    // Of a light without extent: the least and the greatest irradiance it may give.
    let mut straight = |light: &Named<Light>, irradiance: [f64; 2], at: Span| {
        let [least, greatest] = irradiance.map(|irradiance| irradiance * albedo / PI);
        lights += greatest;
        if least * factor >= BRIGHTEST {
            let at = (at, stated);
            found.push(blown_out(&light.name.value, least * factor, stops, at));
        }
    };
    for light in &scene.lights {
        match &light.value.value {
            Light::Constant(sky) => bound += most(colour::emitted(&sky.radiance.0)),
            Light::Directional(sun) => {
                let irradiance = most(colour::emitted(&sun.irradiance.0));
                straight(light, [irradiance; 2], sun.irradiance.span);
            }
            Light::PointLight(PointLight { position, intensity })
            | Light::SpotLight(SpotLight { position, intensity, .. }) => {
                let value = most(colour::emitted(&intensity.0));
                let irradiance = distances(shot, position.0).map(|d| value / d.powi(2));
                straight(light, irradiance, intensity.span);
            }
            Light::Preetham(sky) => {
                let Some(day) = Daylight::of(sky) else { continue };
                // More than the sky is worth, by the little that is brighter beside the sun.
                bound += most(day.level_irradiance());
                straight(light, [most(day.sun_irradiance()); 2], light.value.span);
            }
        }
    }
    bound += lights;
    // Where nothing shines at all, that is told.
    if bound > 0.0 && bound * factor < DARKEST {
        found.push(black(bound, stated.unwrap_or(scene.integrator.span)));
    }
}

/// The greatest and the least distance of a point from surfaces. Planes reach any distance.
fn distances(shot: &Shot, p: DVec3) -> [f64; 2] {
    let boxes = || shot.things.iter().map(Placed::bounds);
    let bounded = boxes().filter(|bounds| !bounds.is_empty());
    let farthest = |bounds: Bounds| {
        bounds.corners().into_iter().map(|corner| corner.distance(p)).fold(0.0, f64::max)
    };
    let (mut near, mut far) = (f64::INFINITY, 0.0_f64);
    for bounds in bounded {
        near = near.min(p.clamp(bounds.min, bounds.max).distance(p));
        far = far.max(farthest(bounds));
    }
    if boxes().any(|bounds| bounds.is_empty()) { [f64::INFINITY, 0.0] } else { [far, near] }
}

fn blown_out(
    name: &str,
    times: f64,
    stops: f64,
    (at, exposure): (Span, Option<Span>),
) -> Diagnostic {
    let headline = format!("what `{name}` lights is white in the PNG, whatever its colour");
    let better = stops - times.log2().ceil();
    let fault = Diagnostic::warning(Code::LINT_EXPOSURE, headline)
        .label(at, format!("makes a surface {times:.0} times as bright as white"));
    let fault = match exposure {
        Some(exposure) => fault.label(exposure, "at this exposure"),
        None => fault,
    };
    fault.help(format!("write `film.exposure: {better} ev`; the EXR holds the light as it is"))
}

fn black(bound: f64, at: Span) -> Diagnostic {
    let better = -bound.log2().ceil();
    Diagnostic::warning(Code::LINT_EXPOSURE, "the PNG is black all over: there is too little light")
        .label(at, "nothing reaches the first step above black")
        .help(format!(
            "check the units of the lights, or write an exposure such as `film.exposure: {better} ev`"
        ))
}
