//! Surfaces of bodies that cross or lie on each other: of two bodies there, either could be meant.

use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::solids::Solids;
use super::straddling;
use super::surfaces::{Surfaces, Wall};
use super::tree::{Item, bounds};
use super::triangles::{Contact, TOUCH, contact};
use crate::math::Bounds;

/// How two surfaces meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Meeting {
    /// Skins of both.
    pub skins: [u32; 2],
    /// A place where they do, in metres.
    pub at: DVec3,
    /// Whether they lie on each other there; else they cross.
    pub coincide: bool,
}

/// The first meeting of two surfaces that may not, in the order of the surfaces. `may` tells of
/// skins; surfaces nearer than `together`, in metres, lie on each other.
pub(super) fn find(
    solids: &Solids,
    may: &(dyn Fn(u32, u32) -> bool + Sync),
    together: f64,
) -> Option<Meeting> {
    let surfaces = solids.surfaces;
    let count = surfaces.faces.len() + surfaces.balls.len();
    let touched = AtomicBool::new(false);
    let first = (0..count).into_par_iter().find_map_first(|item| {
        let mut found = None;
        pairs(solids, item, together, |other| {
            if found.is_some() {
                return;
            }
            let skins = [skin(surfaces, item), skin(surfaces, other)];
            if may(skins[0], skins[1]) {
                return;
            }
            match meet(surfaces, item, other, together) {
                Some(Contact::Cross(at)) => found = Some(Meeting { skins, at, coincide: false }),
                Some(Contact::On(at)) => found = Some(Meeting { skins, at, coincide: true }),
                Some(Contact::Touch(_)) => touched.store(true, Ordering::Relaxed),
                None => {}
            }
        });
        found
    });
    let hidden = || touched.into_inner().then(|| straddling::find(solids, may, together)).flatten();
    first.or_else(|| walls(solids, may, together)).or_else(hidden)
}

/// The items that one may meet: each pair of them once.
pub(super) fn pairs(solids: &Solids, item: Item, within: f64, mut found: impl FnMut(Item)) {
    let piece = solids.pieces[item];
    let Bounds { min, max } = bounds(solids.surfaces, item);
    let around = Bounds { min: min - within, max: max + within };
    solids.tree().near(&around, piece, |other| {
        if other > item && solids.pieces[other] != piece {
            found(other);
        }
    });
}

/// The skin of a face or a ball.
pub(super) fn skin(surfaces: &Surfaces, item: Item) -> u32 {
    match item.checked_sub(surfaces.faces.len()) {
        None => surfaces.faces[item].skin,
        Some(ball) => surfaces.balls[ball].skin,
    }
}

/// How two items meet.
pub(super) fn meet(surfaces: &Surfaces, one: Item, other: Item, together: f64) -> Option<Contact> {
    let faces = surfaces.faces.len();
    match (one.checked_sub(faces), other.checked_sub(faces)) {
        (None, None) => contact(surfaces.corners(one), surfaces.corners(other), together),
        (None, Some(ball)) => {
            let ball = surfaces.balls[ball];
            pierced(ball.centre, ball.radius, surfaces.corners(one)).map(Contact::Cross)
        }
        (Some(one), Some(other)) => {
            let (one, other) = (surfaces.balls[one], surfaces.balls[other]);
            let way = other.centre - one.centre;
            let (apart, sum) = (way.length(), one.radius + other.radius);
            let touch = TOUCH * sum;
            let difference = (one.radius - other.radius).abs();
            if apart + difference <= touch.max(together) {
                let at = one.centre + one.radius * DVec3::X;
                return Some(Contact::On(at));
            }
            let crosses = apart < sum - touch && apart > difference + touch;
            // On the circle that they have in common.
            crosses.then(|| {
                let along =
                    (apart * apart + one.radius.powi(2) - other.radius.powi(2)) / (2.0 * apart);
                let up = (one.radius.powi(2) - along * along).max(0.0).sqrt();
                let way = way / apart;
                Contact::Cross(one.centre + along * way + up * way.any_orthonormal_vector())
            })
        }
        (Some(_), None) => meet(surfaces, other, one, together),
    }
}

/// A point of a triangle on a sphere, if the triangle goes through it.
fn pierced(centre: DVec3, radius: f64, corners: [DVec3; 3]) -> Option<DVec3> {
    let far =
        corners.into_iter().max_by(|a, b| a.distance(centre).total_cmp(&b.distance(centre)))?;
    let near = nearest(centre, corners);
    let touch = TOUCH * radius;
    let crosses = near.distance(centre) < radius - touch && far.distance(centre) > radius + touch;
    crosses.then(|| {
        // Where the way from within to without leaves the sphere.
        let (from, way) = (near - centre, far - near);
        let (a, b) = (way.length_squared(), from.dot(way));
        let c = from.length_squared() - radius * radius;
        near + way * ((-b + (b * b - a * c).max(0.0).sqrt()) / a).clamp(0.0, 1.0)
    })
}

/// The point of a triangle that is nearest to another point [Ericson05, 5.1.5].
pub(super) fn nearest(p: DVec3, [a, b, c]: [DVec3; 3]) -> DVec3 {
    let (ab, ac) = (b - a, c - a);
    let normal = ab.cross(ac);
    let flat = p - normal * (normal.dot(p - a) / normal.length_squared());
    let sides = [(a, b, c), (b, c, a), (c, a, b)];
    if sides.iter().all(|(from, to, _)| (*to - *from).cross(flat - *from).dot(normal) >= 0.0) {
        return flat;
    }
    let on_side = |(from, to, _): (DVec3, DVec3, DVec3)| {
        let way = to - from;
        from + way * (way.dot(p - from) / way.length_squared()).clamp(0.0, 1.0)
    };
    let mut all = sides.map(on_side);
    all.sort_by(|a, b| a.distance_squared(p).total_cmp(&b.distance_squared(p)));
    all[0]
}

/// The same with planes.
fn walls(
    solids: &Solids,
    may: &(dyn Fn(u32, u32) -> bool + Sync),
    together: f64,
) -> Option<Meeting> {
    let surfaces = solids.surfaces;
    for (i, wall) in surfaces.walls.iter().enumerate() {
        for other in &surfaces.walls[..i] {
            let parallel = wall.normal.cross(other.normal).length() <= TOUCH;
            let coincide = is_one(wall, other, together);
            if (!parallel || coincide) && !may(other.skin, wall.skin) {
                // Along the plane, square to the line that they have in common.
                let way = other.normal - wall.normal.dot(other.normal) * wall.normal;
                let far = other.normal.dot(other.point - wall.point) / way.dot(other.normal);
                let at = if parallel { wall.point } else { wall.point + far * way };
                return Some(Meeting { skins: [other.skin, wall.skin], at, coincide });
            }
        }
        if let Some((item, at)) = cut(solids, wall, may) {
            let skins = [skin(surfaces, item), wall.skin];
            return Some(Meeting { skins, at, coincide: false });
        }
        let mut faces = 0..surfaces.faces.len();
        let on = |face: &Item| {
            !may(surfaces.faces[*face].skin, wall.skin) && lies_on(surfaces, *face, wall, together)
        };
        if let Some(face) = faces.find(on) {
            let skins = [surfaces.faces[face].skin, wall.skin];
            return Some(Meeting { skins, at: solids.place(face), coincide: true });
        }
    }
    None
}

/// Whether two planes lie on each other.
pub(super) fn is_one(one: &Wall, other: &Wall, together: f64) -> bool {
    let apart = one.normal.dot(other.point - one.point).abs();
    one.normal.cross(other.normal).length() <= TOUCH && apart <= together
}

/// Whether a face lies in a plane.
pub(super) fn lies_on(surfaces: &Surfaces, face: Item, wall: &Wall, together: f64) -> bool {
    let near = |p: DVec3| wall.normal.dot(p - wall.point).abs() <= together;
    surfaces.corners(face).into_iter().all(near)
}

/// A ball or a face that a plane cuts, and a place where it does.
fn cut(
    solids: &Solids,
    wall: &Wall,
    may: &(dyn Fn(u32, u32) -> bool + Sync),
) -> Option<(Item, DVec3)> {
    let surfaces = solids.surfaces;
    let height = |p: DVec3| wall.normal.dot(p - wall.point);
    let balls = surfaces.balls.iter().enumerate().find_map(|(i, ball)| {
        let off = height(ball.centre);
        let cuts = off.abs() < ball.radius * (1.0 - TOUCH) && !may(ball.skin, wall.skin);
        cuts.then(|| {
            // On the circle that they have in common.
            let out = (ball.radius * ball.radius - off * off).max(0.0).sqrt();
            let middle = ball.centre - off * wall.normal;
            (surfaces.faces.len() + i, middle + out * wall.normal.any_orthonormal_vector())
        })
    });
    balls.or_else(|| {
        // Whether each piece goes above the plane, and below it.
        let mut reach: HashMap<u32, [bool; 2]> = HashMap::new();
        let face = (0..surfaces.faces.len()).find(|face| {
            if may(surfaces.faces[*face].skin, wall.skin) {
                return false;
            }
            let corners = surfaces.corners(*face);
            let heights = corners.map(height);
            let touch = TOUCH * Bounds::around(corners).size();
            let [above, below] = reach.entry(solids.pieces[*face]).or_default();
            *above |= heights.iter().any(|h| *h > touch);
            *below |= heights.iter().any(|h| *h < -touch);
            *above && *below
        })?;
        // It may be the first below all that are above: some edge of the piece comes through.
        let piece =
            (0..surfaces.faces.len()).filter(|it| solids.pieces[*it] == solids.pieces[face]);
        let through = |face: Item| {
            let corners = surfaces.corners(face);
            (0..3).find_map(|i| {
                let (from, to) = (corners[i], corners[(i + 1) % 3]);
                let (high, low) = (height(from), height(to));
                (high * low <= 0.0 && high != low).then(|| from.lerp(to, high / (high - low)))
            })
        };
        let at = piece.into_iter().find_map(through).unwrap_or_else(|| solids.place(face));
        Some((face, at))
    })
}
