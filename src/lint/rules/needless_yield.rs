//! `yields_to` between bodies whose surfaces do not meet: one of them is not there, or nothing
//! ends.

use crate::bodies::{self, Because, Needless};
use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    if shot.stage.scene.integrator.follows_light() {
        found.extend(bodies::needless(shot.stage, &shot.things).iter().map(needless));
    }
}

fn needless(it: &Needless) -> Diagnostic {
    let (name, to) = (&it.object.name().value, &it.to.name().value);
    let (headline, label, help) = match it.because {
        Because::Apart => (
            format!("`{name}` yields to `{to}`, and their surfaces do not meet"),
            "nothing ends by this",
            format!("leave it out; or move `{name}`, if it is meant to reach into `{to}`"),
        ),
        Because::Gone => (
            format!("nothing is left of `{name}`, which yields to `{to}` and is inside of it"),
            "it ends where the other begins",
            format!(
                "leave `yields_to` out: then it is a body inside of `{to}`; or take `{name}` away"
            ),
        ),
        Because::Opaque => (
            format!("`{name}` yields to `{to}`, and not both are bodies of clear matter"),
            "nothing ends by this",
            "leave it out: what is inside of an opaque body is not seen".to_string(),
        ),
    };
    Diagnostic::warning(Code::LINT_NEEDLESS_YIELD, headline)
        .label(it.object.object.value.yields_to().span, label)
        .label(it.to.name().span, "the other")
        .help(help)
}
