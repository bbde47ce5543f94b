//! A field that is stated and changes nothing, because nothing asks for it in any render.

use crate::bodies::Placed;
use crate::diag::{Code, Diagnostic, Span};
use crate::lint::{Shot, everywhere};
use crate::plan::{Feature, Plan};
use crate::scene::{Guide, Integrator, Light, Roulette, Scene, SunForm};

const DIRECT: &str = "It speaks of lights that surfaces ask; `direct: off` asks none.";
const GUIDE: &str = "It speaks of light that lamps or the sun's disc send by mirrors, glass and \
                     metal to what scatters it; here is none.";
const LAMPS: &str =
    "It chooses points of lamps, which are objects with an emission; here are none.";
const MIRRORS: &str = "It speaks of rays that go on by mirrors, glass and metal; here are none.";
const NEXT_EVENT: &str = "It speaks of lights that are asked; `next_event: off` asks none.";
const REUSE: &str = "It speaks of light that goes straight from one simply diffuse surface to \
                     another; here is none.";
const ROULETTE: &str = "It speaks of paths that are ended by chance; `roulette: off` ends none.";

pub(in crate::lint) fn look(shots: &[Shot], found: &mut Vec<Diagnostic>) {
    found.extend(everywhere(shots, |shot| {
        let scene = &shot.stage.scene;
        let mut places = Vec::new();
        let integrator = &scene.integrator;
        let materials = || shot.things.iter().flat_map(|thing| &thing.materials);
        let lamps = shot.things.iter().any(Placed::shines);
        let mirrors = materials().any(|material| !material.value.scatters());
        let mut said = |field: Span, used: bool, name: &'static str, why: &'static str| {
            places.push((field, integrator.span, used, name, why));
        };
        match &integrator.value {
            Integrator::Ambient(ambient) => {
                said(ambient.specular_depth.span, mirrors, "specular_depth", MIRRORS);
                said(ambient.roulette.span, mirrors, "roulette", MIRRORS);
                let direct = ambient.direct.0;
                said(ambient.lights.span, direct, "lights", DIRECT);
                said(ambient.light_samples.span, direct, "light_samples", DIRECT);
            }
            Integrator::Direct(direct) => {
                said(direct.area_lights.span, lamps, "area_lights", LAMPS);
                said(direct.specular_depth.span, mirrors, "specular_depth", MIRRORS);
                said(direct.roulette.span, mirrors, "roulette", MIRRORS);
            }
            Integrator::Path(path) => {
                let asks = path.next_event.0;
                said(path.mis.span, asks, "mis", NEXT_EVENT);
                said(path.lights.span, asks, "lights", NEXT_EVENT);
                said(path.light_samples.span, asks, "light_samples", NEXT_EVENT);
                let ends = path.roulette.value != Roulette::Off;
                said(path.roulette_after.span, ends, "roulette_after", ROULETTE);
                let caustics = mirrors && (lamps || suns(scene));
                let shared = Plan::of(shot.stage).requires(Feature::Reuse);
                said(path.reuse.span, shared || path.reuse.0 == 1, "reuse", REUSE);
                said(path.guide.span, caustics || path.guide.value == Guide::Off, "guide", GUIDE);
            }
            Integrator::Preview(_) => {}
        }
        let stop = &scene.stop;
        let field = stop.adaptive.span;
        let why =
            "It ends parts of the picture that have reached the `error`; no error is asked for.";
        places.push((field, stop.span, stop.error.value.is_some(), "adaptive", why));
        // A default stands where the record is that left it out.
        places.retain(|(field, record, ..)| field != record);
        let told = |(at, _, used, name, why): (Span, Span, bool, &str, &str)| {
            (at, (!used).then(|| ignored(name, why, at)))
        };
        places.into_iter().map(told).collect()
    }));
}

/// Whether the sun of a sky is a disc.
fn suns(scene: &Scene) -> bool {
    scene.lights.iter().any(|light| match &light.value.value {
        Light::Preetham(sky) => matches!(*sky.sun, SunForm::SunDisc(_)),
        _ => false,
    })
}

fn ignored(field: &str, why: &str, at: Span) -> Diagnostic {
    Diagnostic::warning(Code::LINT_IGNORED_FIELD, format!("`{field}` changes nothing here"))
        .label(at, "no picture depends on it")
        .why(why)
        .help("take it away, or add what it speaks of")
}
