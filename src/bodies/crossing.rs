//! Surfaces of bodies that cross or lie on each other: of two bodies there, either could be meant.

use glam::DVec3;
use rayon::prelude::*;

use super::flat::Flat;
use super::surfaces::{Surfaces, Wall};
use super::tree::{Item, Tree, bounds};
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

/// Nearer than this part of their size surfaces touch; that is no crossing yet.
const TOUCH: f64 = 1e-9;

/// The first meeting of two surfaces that may not, in the order of the surfaces. `may` tells of
/// skins.
pub(super) fn find(
    surfaces: &Surfaces,
    tree: &Tree,
    sheets: &[u32],
    may: &(dyn Fn(u32, u32) -> bool + Sync),
) -> Option<Meeting> {
    let count = surfaces.faces.len() + surfaces.balls.len();
    let first = (0..count).into_par_iter().find_map_first(|item| {
        let mut found = None;
        tree.near(&bounds(surfaces, item), sheets[item], |other| {
            // Each pair once.
            if found.is_none() && other > item && sheets[other] != sheets[item] {
                let skins = [skin(surfaces, item), skin(surfaces, other)];
                let meets = || meet(surfaces, item, other);
                found = (!may(skins[0], skins[1]))
                    .then(meets)
                    .flatten()
                    .map(|(at, coincide)| Meeting { skins, at, coincide });
            }
        });
        found
    });
    first.or_else(|| walls(surfaces, may))
}

/// The skin of a face or a ball.
pub(super) fn skin(surfaces: &Surfaces, item: Item) -> u32 {
    match item.checked_sub(surfaces.faces.len()) {
        None => surfaces.faces[item].skin,
        Some(ball) => surfaces.balls[ball].skin,
    }
}

/// Where two items meet, and whether they lie on each other there.
fn meet(surfaces: &Surfaces, one: Item, other: Item) -> Option<(DVec3, bool)> {
    let faces = surfaces.faces.len();
    match (one.checked_sub(faces), other.checked_sub(faces)) {
        (None, None) => triangles(surfaces.corners(one), surfaces.corners(other)),
        (None, Some(ball)) => {
            let ball = surfaces.balls[ball];
            pierced(ball.centre, ball.radius, surfaces.corners(one)).map(|at| (at, false))
        }
        (Some(one), Some(other)) => {
            let (one, other) = (surfaces.balls[one], surfaces.balls[other]);
            let way = other.centre - one.centre;
            let (apart, sum) = (way.length(), one.radius + other.radius);
            let touch = TOUCH * sum;
            let difference = (one.radius - other.radius).abs();
            if apart <= touch && difference <= touch {
                return Some((one.centre + one.radius * DVec3::X, true));
            }
            let crosses = apart < sum - touch && apart > difference + touch;
            // On the circle that they have in common.
            crosses.then(|| {
                let along =
                    (apart * apart + one.radius.powi(2) - other.radius.powi(2)) / (2.0 * apart);
                let up = (one.radius.powi(2) - along * along).max(0.0).sqrt();
                let way = way / apart;
                (one.centre + along * way + up * way.any_orthonormal_vector(), false)
            })
        }
        (Some(_), None) => meet(surfaces, other, one),
    }
}

/// A point of a triangle on a sphere, if the triangle goes through it.
fn pierced(centre: DVec3, radius: f64, corners: [DVec3; 3]) -> Option<DVec3> {
    let far =
        corners.into_iter().max_by(|a, b| a.distance(centre).total_cmp(&b.distance(centre)))?;
    let near = nearest(centre, corners);
    let touch = TOUCH * radius;
    let crosses = near.distance(centre) < radius - touch && far.distance(centre) > radius + touch;
    crosses.then_some(0.5 * (near + far))
}

/// The point of a triangle that is nearest to another point [Ericson05, 5.1.5].
fn nearest(p: DVec3, [a, b, c]: [DVec3; 3]) -> DVec3 {
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

/// Where two triangles meet, if they cross or lie on each other; not if they touch.
fn triangles(one: [DVec3; 3], other: [DVec3; 3]) -> Option<(DVec3, bool)> {
    let size = Bounds::around(one).size().min(Bounds::around(other).size());
    let touch = TOUCH * size;
    for (edges, face) in [(one, other), (other, one)] {
        for i in 0..3 {
            if let Some(at) = through(edges[i], edges[(i + 1) % 3], face, touch) {
                return Some((at, false));
            }
        }
    }
    let flat = |corners: [DVec3; 3]| Flat::face(corners.to_vec());
    let (a, b) = (flat(one)?, flat(other)?);
    a.overlaps(&b).then(|| ((one[0] + one[1] + one[2]) / 3.0, true))
}

/// Where an edge goes through the middle of a triangle, and not only touches it.
fn through(from: DVec3, to: DVec3, [a, b, c]: [DVec3; 3], touch: f64) -> Option<DVec3> {
    let normal = (b - a).cross(c - a).try_normalize()?;
    let (above, below) = (normal.dot(from - a), normal.dot(to - a));
    if above.abs() <= touch || below.abs() <= touch || (above > 0.0) == (below > 0.0) {
        return None;
    }
    let at = from + (to - from) * (above / (above - below));
    let inside = [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
        let side = to - from;
        normal.dot(side.cross(at - from)) > touch * side.length()
    });
    inside.then_some(at)
}

/// The same with planes.
fn walls(surfaces: &Surfaces, may: &(dyn Fn(u32, u32) -> bool + Sync)) -> Option<Meeting> {
    for (i, wall) in surfaces.walls.iter().enumerate() {
        for other in &surfaces.walls[..i] {
            let apart = wall.normal.dot(other.point - wall.point).abs();
            let size = wall.point.distance(other.point).max(1.0);
            let parallel = wall.normal.cross(other.normal).length() <= TOUCH;
            let coincide = parallel && apart <= TOUCH * size;
            if (!parallel || coincide) && !may(other.skin, wall.skin) {
                let skins = [other.skin, wall.skin];
                return Some(Meeting { skins, at: wall.point, coincide });
            }
        }
        if let Some((item, at)) = cut(surfaces, wall, may) {
            let skins = [skin(surfaces, item), wall.skin];
            return Some(Meeting { skins, at, coincide: false });
        }
    }
    None
}

/// A ball or a face that a plane cuts.
fn cut(
    surfaces: &Surfaces,
    wall: &Wall,
    may: &(dyn Fn(u32, u32) -> bool + Sync),
) -> Option<(Item, DVec3)> {
    let height = |p: DVec3| wall.normal.dot(p - wall.point);
    let balls = surfaces.balls.iter().enumerate().find_map(|(i, ball)| {
        let off = height(ball.centre);
        let cuts = off.abs() < ball.radius * (1.0 - TOUCH) && !may(ball.skin, wall.skin);
        cuts.then(|| (surfaces.faces.len() + i, ball.centre - off * wall.normal))
    });
    balls.or_else(|| {
        (0..surfaces.faces.len()).into_par_iter().find_map_first(|face| {
            let corners = surfaces.corners(face);
            let heights = corners.map(height);
            let touch = TOUCH * Bounds::around(corners).size();
            let cuts = heights.iter().any(|h| *h > touch) && heights.iter().any(|h| *h < -touch);
            let cuts = cuts && !may(surfaces.faces[face].skin, wall.skin);
            cuts.then(|| (face, (corners[0] + corners[1] + corners[2]) / 3.0))
        })
    })
}
