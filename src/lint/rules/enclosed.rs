//! An object wholly inside of another that is closed: it is not seen, and shines on nothing.

use glam::DVec3;

use crate::bodies::{Body, Placed};
use crate::diag::{Code, Diagnostic};
use crate::lint::Shot;
use crate::lint::inside::{Side, side};
use crate::math::Bounds;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    let Some((eye, _)) = shot.eye() else { return };
    let shells = Shells::new(shot.things.iter(), eye);
    for thing in shot.things.iter().filter(|thing| !thing.bounds().is_empty()) {
        if let Some(outer) = shells.around(thing) {
            found.push(enclosed(thing, outer));
        }
    }
}

/// Objects that hide what is inside of them, by where their boxes begin along x.
struct Shells<'a> {
    all: Vec<(&'a Placed<'a>, Bounds)>,
    /// How far the boxes up to each one reach along x: where that is too little for a thing, none
    /// of them is around it.
    reach: Vec<f64>,
}

impl<'a> Shells<'a> {
    fn new(things: impl Iterator<Item = &'a Placed<'a>>, eye: DVec3) -> Self {
        let hides = |thing: &Placed, space: &Bounds| {
            let sees_in = || space.holds(eye) && side(thing, space, eye) != Side::Outside;
            let closed = matches!(thing.body, Body::Sphere { .. } | Body::Mesh { .. });
            closed && !space.is_empty() && !thing.transmits() && !sees_in()
        };
        let all = things.map(|thing| (thing, thing.bounds()));
        let mut all: Vec<_> = all.filter(|(thing, space)| hides(thing, space)).collect();
        all.sort_by(|(_, a), (_, b)| a.min.x.total_cmp(&b.min.x));
        let mut farthest = f64::NEG_INFINITY;
        let reach = all.iter().map(|(_, space)| {
            farthest = farthest.max(space.max.x);
            farthest
        });
        Self { reach: reach.collect(), all }
    }

    /// One that is wholly around a thing.
    fn around(&self, thing: &Placed) -> Option<&'a Placed<'a>> {
        let bounds = thing.bounds();
        let begun = self.all.partition_point(|(_, space)| space.min.x <= bounds.min.x);
        let reaching = (0..begun).rev().take_while(|at| self.reach[*at] >= bounds.max.x);
        let around = reaching.map(|at| &self.all[at]).find(|(outer, space)| {
            !std::ptr::eq(thing, *outer)
                && space.holds(bounds.min)
                && space.holds(bounds.max)
                && bounds.corners().into_iter().all(|p| side(outer, space, p) != Side::Outside)
        });
        around.map(|(outer, _)| *outer)
    }
}

fn enclosed(thing: &Placed, outer: &Placed) -> Diagnostic {
    let (name, around) = (&thing.name().value, &outer.name().value);
    let (what, label) = match thing.shines() {
        true => ("lamp", "shines on the inside of the other alone"),
        false => ("object", "is seen by nobody"),
    };
    let headline = format!("the {what} `{name}` is wholly inside of `{around}`");
    Diagnostic::warning(Code::LINT_ENCLOSED, headline)
        .label(thing.name().span, label)
        .label(outer.name().span, "is closed, and lets no light through")
        .help(format!("move `{name}` out of it, or take it away"))
}
