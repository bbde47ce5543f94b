//! Bodies, or gaps in them, that are so thin that single precision hardly tells their two sides
//! apart: light that enters at one is lost before the other, or meets it twice.
//!
//! Looked at from the middles of some faces of each body, evenly by area: what faces them, near by.
//! At a sharp edge, where only a little of the surface is thin, nothing is told.

use std::collections::HashMap;

use glam::DVec3;
use rayon::prelude::*;

use super::solids::Solids;
use super::tree::{ALL, Tree};
use crate::math::Bounds;

/// Of fewer steps of single precision, at the place where it is, light is lost in a body, or comes
/// out of it twice: at 1.7 steps a fifth of it, at 3.4 none was found.
pub(super) const LEAST: f64 = 4.0;
/// From so many on nothing is told.
pub(super) const FEW: f64 = 8.0;

/// At most so many places of a body are looked from.
const PLACES: f64 = 4096.0;
/// Less of the surface of a body, by area, may be as thin as it likes.
const PART: f64 = 1e-3;
/// Weights of a triangle's corners this far below zero are on its rim.
const RIM: f64 = 1e-9;

/// A thin part of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Thin {
    pub skin: u32,
    /// Between its sides, and before it what faces it, if it is a gap.
    pub at: DVec3,
    /// In metres.
    pub thickness: f64,
    /// The same in steps of single precision there.
    pub steps: f64,
    /// Whether the medium is not between the sides, but around them.
    pub gap: bool,
}

/// A place from which what faces a face is looked for.
struct Look {
    face: usize,
    at: DVec3,
    normal: DVec3,
    /// A step of single precision there, in metres.
    step: f64,
    /// For how many parts of the body's surface it stands.
    weight: f64,
}

/// What is thin of each solid, the thinnest part of it; `centre` is the middle of the scene.
pub(super) fn find(solids: &Solids, centre: DVec3) -> Vec<Thin> {
    let looks = looks(solids, centre);
    if looks.is_empty() {
        return Vec::new();
    }
    let reach = |look: &Look| {
        let way = FEW * look.step * look.normal;
        Bounds::around([look.at - way, look.at + way])
    };
    let tree = Tree::over(&looks.par_iter().map(reach).collect::<Vec<_>>());
    let surfaces = solids.surfaces;
    let met = |face: usize| {
        let mut met: Vec<(usize, f64)> = Vec::new();
        tree.near(&surfaces.bounds_of(face), ALL, |number| {
            let look = &looks[number];
            if face != look.face
                && solids.are_of_one(face, look.face)
                && let Some(far) = faces(look, surfaces.corners(face))
            {
                met.push((number, far));
            }
        });
        met
    };
    let all: Vec<(usize, f64)> =
        (0..surfaces.faces.len()).into_par_iter().flat_map_iter(met).collect();
    let mut nearest: Vec<Option<f64>> = vec![None; looks.len()];
    for (number, far) in all {
        let known = nearest[number].get_or_insert(far);
        if far.abs() < known.abs() {
            *known = far;
        }
    }
    // Of each solid: how much of it is thin, how much very, and where it is thinnest.
    let mut thin: HashMap<u32, ([f64; 2], Thin)> = HashMap::new();
    for (look, far) in looks.iter().zip(nearest) {
        let Some(far) = far else { continue };
        let here = Thin {
            skin: surfaces.faces[look.face].skin,
            at: look.at + 0.5 * far * look.normal,
            thickness: far.abs(),
            steps: far.abs() / look.step,
            gap: far > 0.0,
        };
        for solid in solids.sides(look.face).into_iter().flatten() {
            let (parts, thinnest) = thin.entry(solid).or_insert(([0.0; 2], here));
            parts[0] += look.weight;
            parts[1] += if here.steps < LEAST { look.weight } else { 0.0 };
            if here.steps < thinnest.steps {
                *thinnest = here;
            }
        }
    }
    let mut found: Vec<Thin> = thin
        .into_values()
        .filter(|([few, least], thin)| if thin.steps < LEAST { *least > PART } else { *few > PART })
        .map(|(_, thin)| thin)
        .collect();
    // Very thin ones first; each object once.
    let object = |thin: &Thin| surfaces.skins[thin.skin as usize].object;
    found.sort_by(|a, b| object(a).cmp(&object(b)).then(a.steps.total_cmp(&b.steps)));
    found.dedup_by_key(|thin| object(thin));
    found
}

/// Places on the faces of every solid, evenly by area.
fn looks(solids: &Solids, centre: DVec3) -> Vec<Look> {
    let surfaces = solids.surfaces;
    let across = |face: usize| {
        let [a, b, c] = surfaces.corners(face);
        (b - a).cross(c - a)
    };
    let first = |face: usize| solids.sides(face).into_iter().flatten().next();
    let mut areas = vec![0.0; solids.all.len()];
    for face in 0..surfaces.faces.len() {
        if let Some(solid) = first(face) {
            areas[solid as usize] += across(face).length();
        }
    }
    let mut before = vec![0.0; solids.all.len()];
    let mut all = Vec::new();
    for face in 0..surfaces.faces.len() {
        let Some(solid) = first(face).map(|solid| solid as usize) else { continue };
        let across = across(face);
        let parts = PLACES * across.length() / areas[solid];
        let (from, to): (f64, f64) = (before[solid], before[solid] + parts);
        before[solid] = to;
        let count = (to + 0.5).floor() - (from + 0.5).floor();
        let Some(normal) = across.try_normalize().filter(|_| count > 0.0) else { continue };
        let Bounds { min, max } = solids.all[solid].bounds;
        let farthest = (min - centre).abs().max((max - centre).abs()).max_element();
        all.push(Look {
            face,
            at: solids.place(face),
            normal,
            step: farthest * f64::from(f32::EPSILON),
            weight: count / PLACES,
        });
    }
    all
}

/// How far along the normal a triangle is met that looks the other way, if it is near.
fn faces(look: &Look, [a, b, c]: [DVec3; 3]) -> Option<f64> {
    let (u, v) = (b - a, c - a);
    let facing = u.cross(v).dot(look.normal);
    if facing >= 0.0 {
        return None;
    }
    let off = look.at - a;
    let far = -u.cross(v).dot(off) / facing;
    let p = off + far * look.normal;
    let first = p.cross(v).dot(look.normal) / facing;
    let second = u.cross(p).dot(look.normal) / facing;
    let inside = first >= -RIM && second >= -RIM && first + second <= 1.0 + RIM;
    (inside && far.abs() < FEW * look.step).then_some(far)
}
