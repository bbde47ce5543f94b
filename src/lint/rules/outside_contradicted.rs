//! A surface that says what is before it, where the bodies around it make it something else.

use crate::bodies::{self, Contradicted};
use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::math::Spectrum;
use crate::scene::{Material, Medium, Named};

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    // Elsewhere bodies are not looked at, and may be open.
    if !shot.stage.scene.integrator.follows_light() {
        return;
    }
    let all = bodies::contradicted(shot.stage, &shot.things);
    let doubted = all.iter().filter(|it| !is_alike(it.said, it.around));
    found.extend(doubted.filter_map(contradicted));
}

/// Whether light goes the same way in both; None is a vacuum.
fn is_alike(said: &Named<Medium>, around: Option<&Named<Medium>>) -> bool {
    let Medium::Homogeneous(medium) = &said.value.value;
    let empty = medium.ior.n == Spectrum::Constant(1.0) && !medium.absorbs() && !medium.scatters();
    around.map_or(empty, |around| said.value == around.value)
}

fn contradicted(it: &Contradicted) -> Option<Diagnostic> {
    let Material::Dielectric(dielectric) = &it.material.value.value else { return None };
    let (name, said) = (&it.object.name().value, &it.said.name.value);
    let around = it.around.map_or("a vacuum".to_string(), |medium| format!("`{}`", *medium.name));
    let headline = format!("`{name}` says that `{said}` is around it, and stands in {around}");
    let help = match it.around {
        Some(_) => "leave `outside` out: what is around a body follows from where it stands".into(),
        None => format!(
            "write `surroundings: {said}` if it is everywhere; or leave `outside` out: what is \
             around a body follows from where it stands"
        ),
    };
    let fault = Diagnostic::warning(Code::LINT_OUTSIDE_CONTRADICTED, headline)
        .label(dielectric.outside.span, format!("no body of `{said}` reaches here …"))
        .label(it.object.name().span, "… to the surface of this")
        .why(format!("It refracts as if it stood in `{said}`: light is bent by a wrong angle."));
    Some(fault.help(help))
}
