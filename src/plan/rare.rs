//! Light that paths find by chance alone, and hardly ever: small lamps and the sun's disc, by way of
//! smooth mirrors and glass. No setting is wrong and no mean; but few samples tell nothing of it,
//! and an error stated from them is too small.

use std::f64::consts::PI;

use glam::DVec3;

use super::bias::{Bias, Kind};
use super::survey::Survey;
use crate::bodies::{self, Body, Placed};
use crate::diag::words::grouped;
use crate::load::Stage;
use crate::math::Bounds;
use crate::scene::{At, Integrator, Light, Named, Object, SunForm};

/// Of lights that fill less, in steradians, fewer than one path of 15,000 finds one: the sun fills
/// 6.8e-5.
const RARE: f64 = 2e-4;

/// One for each such light.
pub(super) fn biases(stage: &Stage, survey: &Survey, integrator: &At<Integrator>) -> Vec<Bias> {
    // Photons find what paths do not: those of a sun are sent about what is bounded.
    let guided = integrator.is_guided();
    let bounded = |it: &Named<Object>| !matches!(it.value.value, Object::Plane(_));
    let helped = guided && stage.scene.objects.iter().any(bounded);
    if !matches!(integrator.value, Integrator::Path(_)) || helped {
        return Vec::new();
    }
    let mirrors = survey.mirrors();
    let (Some(by), Some(lit)) = (mirrors.first(), survey.brightest()) else { return Vec::new() };
    let bias = |(name, is_sun, fills): (&At<String>, bool, f64)| {
        let what =
            if is_sun { format!("the sun of `{}`", **name) } else { format!("`{}`", **name) };
        let met = rounded(PI / fills);
        Bias {
            kind: Kind::RareCaustics,
            setting: format!("{what} by way of `{by}`"),
            at: name.span,
            effect: format!(
                "by way of `{by}` a path from surfaces such as `{}` meets {what} once in {met}, and \
                 the stated error does not know of what was not met",
                *lit.object.name
            ),
            brief: format!(
                "met by one path in {met}: the stated error may be too small by what was not met"
            ),
            bound: None,
            instead_write: match is_sun {
                _ if guided => {
                    "photons are sent from the sun to what is bounded, and here all are planes: write \
                     `disk` or `quad` in place of the `plane` that mirrors; give the sun a larger \
                     `half_angle`, which makes its caustics softer and easier to find; or render until \
                     they are smooth"
                }
                true => {
                    "write `guide: photons` in `path`, which sends paths to where this light comes \
                     from; give the sun a larger `half_angle`, which makes its caustics softer and easier \
                     to find; or render until they are smooth"
                }
                false => {
                    "write `guide: photons` in `path`, which sends paths to where this light comes \
                     from; make the lamp larger and dimmer, which makes its caustics softer and easier to \
                     find; or render until they are smooth"
                }
            },
            instead: None,
        }
    };
    let suns = survey.discs.iter().filter_map(|light| {
        let Light::Preetham(sky) = &light.value.value else { return None };
        let SunForm::SunDisc(disc) = &sky.sun.value else { return None };
        let fills = 2.0 * PI * (1.0 - disc.half_angle.0.cos());
        (fills < RARE).then_some((&light.name, true, fills))
    });
    suns.chain(lamps(stage, survey)).map(bias).collect()
}

/// Small lamps far from all that mirrors, and the most, about, that they fill seen from there.
fn lamps<'a>(stage: &'a Stage, survey: &Survey<'a>) -> Vec<(&'a At<String>, bool, f64)> {
    if survey.lamp().is_none() {
        return Vec::new();
    }
    let placed = bodies::place(stage, &mut Vec::new());
    let sends = |it: &&Placed| it.all_parts().any(|part| !part.value.scatters());
    let mirrors: Vec<&Placed> = placed.iter().filter(sends).collect();
    let lamps = placed.iter().filter(|it| it.shines() && !it.bounds().is_empty());
    let fills = |lamp: &Placed| {
        let (at, radius) = (lamp.bounds().centre(), 0.5 * lamp.bounds().size());
        let nearest = mirrors.iter().map(|it| distance(it, at)).fold(f64::INFINITY, f64::min);
        PI * (radius / nearest).powi(2)
    };
    let all = lamps.map(|lamp| (&lamp.object.name, false, fills(lamp)));
    all.filter(|(_, _, fills)| *fills > 0.0 && *fills < RARE).collect()
}

/// From the box around an object, or a plane, to a point; in metres.
fn distance(object: &Placed, at: DVec3) -> f64 {
    match &object.body {
        Body::Plane { point, normal, .. } => normal.dot(at - point).abs(),
        _ => {
            let Bounds { min, max } = object.bounds();
            at.clamp(min, max).distance(at)
        }
    }
}

/// "46,000": two digits.
fn rounded(count: f64) -> String {
    let step = 10.0_f64.powf(count.log10().floor() - 1.0);
    grouped(((count / step).round() * step) as u64)
}
