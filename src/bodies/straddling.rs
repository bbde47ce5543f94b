//! Bodies whose surfaces cross where edges of one lie in faces or edges of the other: no triangle
//! goes through another there, but some of the surface of one is inside of the other, and some is
//! not.

use std::collections::HashMap;

use glam::DVec3;
use rayon::prelude::*;

use super::crossing::{Meeting, meet, nearest, pairs, skin};
use super::solids::Solids;
use super::surfaces::Surfaces;
use super::tree::{Item, bounds};
use super::triangles::{Contact, TOUCH};
use crate::math::Bounds;

/// At most so many places where triangles touch are looked at, evenly.
const MOST: usize = 1024;

/// How far points lie from where two triangles touch, as parts of the way to a corner.
const STEPS: [f64; 2] = [0.5, 1.0 / 32.0];

/// A triangle that touches another one.
struct Touch {
    face: Item,
    other: Item,
    at: DVec3,
}

/// The first surface of a body that is inside of another one and outside of it.
pub(super) fn find(
    solids: &Solids,
    may: &(dyn Fn(u32, u32) -> bool + Sync),
    together: f64,
) -> Option<Meeting> {
    let all = touches(solids, may, together);
    let step = all.len().div_ceil(MOST).max(1);
    let seen: Vec<Vec<_>> =
        all.par_iter().step_by(step).map(|touch| turns(solids, touch)).collect();
    // Of the surface around a body: how often another one goes round a point of it.
    let mut known: HashMap<(u32, u32), i32> = HashMap::new();
    for (touch, seen) in all.iter().step_by(step).zip(seen) {
        for (body, other, turns) in seen {
            if *known.entry((body, other)).or_insert(turns) != turns {
                let skins = [touch.face, touch.other].map(|it| skin(solids.surfaces, it));
                return Some(Meeting { skins, at: touch.at, coincide: false });
            }
        }
    }
    None
}

/// All triangles that touch those of other bodies.
fn touches(solids: &Solids, may: &(dyn Fn(u32, u32) -> bool + Sync), together: f64) -> Vec<Touch> {
    let surfaces = solids.surfaces;
    let of = |item: Item| {
        let mut found = Vec::new();
        pairs(solids, item, together, |other| {
            if !may(skin(surfaces, item), skin(surfaces, other))
                && let Some(Contact::Touch(at)) = meet(surfaces, item, other, together)
                && !solids.are_of_one(item, other)
            {
                found.push(Touch { face: item, other, at });
                found.push(Touch { face: other, other: item, at });
            }
        });
        found
    };
    (0..surfaces.faces.len()).into_par_iter().flat_map_iter(of).collect()
}

/// How often the bodies of one triangle go round points of the other: of the latter's body and
/// each of the former's.
fn turns(solids: &Solids, touch: &Touch) -> Vec<(u32, u32, i32)> {
    let [Some(body), _] = solids.sides(touch.face) else { return Vec::new() };
    let corners = solids.surfaces.corners(touch.face);
    let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    let mut seen = Vec::new();
    for to in corners.into_iter().chain([middle]) {
        for step in STEPS {
            let at = touch.at.lerp(to, step);
            for other in solids.sides(touch.other).into_iter().flatten() {
                if is_clear(solids, at, touch.other) {
                    seen.push((body, other, solids.goes_round(other, at)));
                }
            }
        }
    }
    seen
}

/// Whether a point lies farther from a surface than rounding goes.
fn is_clear(solids: &Solids, at: DVec3, from: Item) -> bool {
    let surfaces: &Surfaces = solids.surfaces;
    let of = solids.sides(from);
    let size = of.into_iter().flatten().map(|body| solids.all[body as usize].bounds);
    let size = size.fold(Bounds::around([at]), Bounds::union).size();
    let rounding = 16.0 * TOUCH * size;
    let mut clear = true;
    let around = Bounds { min: at - rounding, max: at + rounding };
    solids.tree().near(&around, u32::MAX, |item| {
        let same = || solids.sides(item).iter().flatten().any(|it| of.contains(&Some(*it)));
        if !clear || !bounds(surfaces, item).touches(&around) || !same() {
            return;
        }
        let apart = match item.checked_sub(surfaces.faces.len()) {
            None => nearest(at, surfaces.corners(item)).distance(at),
            Some(ball) => {
                let ball = surfaces.balls[ball];
                (ball.centre.distance(at) - ball.radius).abs()
            }
        };
        clear = apart > rounding;
    });
    clear
}
