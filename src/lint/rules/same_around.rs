//! A body that stands in its own medium: its surface does nothing.

use crate::bodies;
use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    if !shot.stage.scene.integrator.follows_light() {
        return;
    }
    for (object, medium) in bodies::unseen(shot.stage, &shot.things) {
        let (name, medium) = (object.name(), &medium.name.value);
        let headline = format!("`{}` is of `{medium}`, and stands in `{medium}`", **name);
        found.push(
            Diagnostic::warning(Code::LINT_SAME_AROUND, headline)
                .label(name.span, "has the same medium on both sides of its surface")
                .help(
                    "such a surface cannot be seen: let it be of another medium, or take it away",
                ),
        );
    }
}
