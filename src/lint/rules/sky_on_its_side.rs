//! A sky whose zenith is not above any floor: the scene has another direction up.

use glam::DVec3;

use crate::bodies::{Body, Placed};
use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::scene::{Light, Preetham};

/// A floor may slope so much, by the cosine: 60°.
const SLOPE: f64 = 0.5;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let planes: Vec<_> =
        shot.things.iter().filter_map(|thing| Some((thing, normal(thing)?))).collect();
    for light in &shot.stage.scene.lights {
        let Light::Preetham(sky) = &light.value.value else { continue };
        let level = |normal: DVec3| normal.dot(sky.up.0).abs() >= SLOPE;
        if let Some((plane, _)) = planes.first()
            && !planes.iter().any(|(_, normal)| level(*normal))
        {
            found.push(on_its_side(&light.name.value, sky, light.value.span, plane));
        }
    }
}

fn normal(thing: &Placed) -> Option<DVec3> {
    match thing.body {
        Body::Plane { normal, .. } => Some(normal),
        _ => None,
    }
}

fn on_its_side(name: &str, sky: &Preetham, light: Span, plane: &Placed) -> Diagnostic {
    let headline = format!("the sky `{name}` lies on its side");
    // A default's place is the record that left it out.
    let label = match sky.up.span == light {
        true => "its zenith is `y`, the default of `up` …",
        false => "its zenith lies along …",
    };
    Diagnostic::warning(Code::LINT_SKY_ON_ITS_SIDE, headline)
        .label(sky.up.span, label)
        .label(plane.name().span, "… this plane, which stands upright in it")
        .help("say which way is up: `north: y, up: z` for ground whose normal is `z`")
}
