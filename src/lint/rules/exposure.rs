//! An exposure at which the PNG is white wherever a light falls straight, or black all over.

use std::f64::consts::PI;

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::optics::colour;
use crate::plan::daylight::Daylight;
use crate::scene::Light;

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
    let materials = || shot.things.iter().flat_map(|thing| &thing.materials);
    let scattering = materials().filter(|material| material.value.scatters());
    let albedo = scattering.filter_map(|material| material.value.reflectance());
    let albedo = albedo.map(|albedo| most(colour::reflected(&albedo.0))).fold(0.0, f64::max);
    let lamps = materials().filter_map(|material| material.value.emission());
    let lamps = lamps.map(|emission| most(colour::emitted(&emission.0)));
    // A lamp gives no surface more than if it filled all that the surface faces.
    let mut bound: f64 = lamps.map(|radiance| radiance * (1.0 + albedo)).sum();
    for light in &scene.lights {
        let (irradiance, at) = match &light.value.value {
            Light::Constant(sky) => {
                bound += most(colour::emitted(&sky.radiance.0));
                continue;
            }
            Light::Directional(sun) => {
                (most(colour::emitted(&sun.irradiance.0)), sun.irradiance.span)
            }
            Light::Preetham(sky) => {
                let Some(day) = Daylight::of(sky) else { continue };
                // More than the sky is worth, by the little that is brighter beside the sun.
                bound += most(day.level_irradiance());
                (most(day.sun_irradiance()), light.value.span)
            }
        };
        let straight = irradiance * albedo / PI;
        bound += straight;
        if straight * factor >= BRIGHTEST {
            let at = (at, stated);
            found.push(blown_out(&light.name.value, straight * factor, stops, at));
        }
    }
    // Where nothing shines at all, that is told.
    if bound > 0.0 && bound * factor < DARKEST {
        found.push(black(bound, stated.unwrap_or(scene.integrator.span)));
    }
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
