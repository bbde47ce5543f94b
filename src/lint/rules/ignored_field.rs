//! A field that is stated and changes nothing, because nothing asks for it in any render.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::placed::Thing;
use crate::lint::{Shot, everywhere};
use crate::scene::Integrator;

pub(in crate::lint) fn look(shots: &[Shot], found: &mut Vec<Diagnostic>) {
    found.extend(everywhere(shots, |shot| {
        let scene = &shot.stage.scene;
        let mut places = Vec::new();
        if let Integrator::Direct(direct) = &scene.integrator.value {
            let lamps = shot.things.iter().any(Thing::shines);
            let field = direct.area_lights.span;
            let why =
                "It chooses points of lamps, which are objects with an emission; here are none.";
            places.push((field, scene.integrator.span, lamps, "area_lights", why));
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

fn ignored(field: &str, why: &str, at: Span) -> Diagnostic {
    Diagnostic::warning(Code::LINT_IGNORED_FIELD, format!("`{field}` changes nothing here"))
        .label(at, "no picture depends on it")
        .why(why)
        .help("take it away, or add what it speaks of")
}
