//! Surfaces of two bodies that lie on each other, one of which ends where the other begins: the
//! bodies are pushed into each other by more than rounding, and so a ray meets their surfaces in
//! the order that is meant. What is left of the one that ends is the same.

use std::collections::HashMap;

use glam::DVec3;
use rayon::prelude::*;

use super::crossing::{is_one, lies_on, meet, pairs, skin};
use super::solids::Solids;
use super::surfaces::{Face, Surfaces, Wall};
use super::tree::Item;
use super::triangles::Contact;
use super::yields::Yields;

/// How far a surface is pushed, as a multiple of what rounding takes.
const PUSH: f64 = 4.0;
/// A corner is pushed by at most so much more, where faces meet at a sharp angle.
const SHARP: f64 = 64.0;
/// Rounds in which a way out of several faces is looked for.
const ROUNDS: usize = 64;

/// A surface that lies on one of another object.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flush {
    /// The face that is to be pushed, and where; None: both are round or without end.
    push: Option<(Item, DVec3)>,
    /// The objects of both, first the one that yields.
    pub objects: [u32; 2],
    /// Where they touch, in metres.
    pub at: DVec3,
}

/// All that lie on each other.
pub(super) fn find(solids: &Solids, yields: &Yields, together: f64) -> Vec<Flush> {
    let surfaces = solids.surfaces;
    let object = |item: Item| surfaces.skins[skin(surfaces, item) as usize].object;
    let wall_of = |wall: &Wall| surfaces.skins[wall.skin as usize].object;
    let ordered = |one: u32, other: u32| {
        if yields.yields(one, other) { [one, other] } else { [other, one] }
    };
    let count = surfaces.faces.len();
    let of = |one: Item| {
        let mut found = Vec::new();
        pairs(solids, one, together, |other| {
            if !yields.are_related(object(one), object(other)) {
                return;
            }
            if let Some(Contact::On(at)) = meet(surfaces, one, other, together) {
                let objects = ordered(object(one), object(other));
                let [face, to] = match objects[0] == object(one) {
                    true => [one, other],
                    false => [other, one],
                };
                let push = (one.max(other) < count).then(|| (face, -front(surfaces, to)));
                found.push(Flush { push, objects, at });
            }
        });
        for wall in surfaces.walls.iter().filter(|_| one < count) {
            let (of, to) = (object(one), wall_of(wall));
            if yields.are_related(of, to) && lies_on(surfaces, one, wall, together) {
                // Planes stay where they are: the other one is pushed either way.
                let way = if yields.yields(of, to) { -wall.normal } else { front(surfaces, one) };
                let push = Some((one, way));
                found.push(Flush { push, objects: ordered(of, to), at: solids.place(one) });
            }
        }
        found
    };
    let items = count + surfaces.balls.len();
    let mut all: Vec<Flush> = (0..items).into_par_iter().flat_map_iter(of).collect();
    for (i, wall) in surfaces.walls.iter().enumerate() {
        for other in &surfaces.walls[..i] {
            let (one, to) = (wall_of(wall), wall_of(other));
            if yields.are_related(one, to) && is_one(wall, other, together) {
                all.push(Flush { push: None, objects: ordered(one, to), at: wall.point });
            }
        }
    }
    all
}

fn front(surfaces: &Surfaces, face: Item) -> DVec3 {
    let [a, b, c] = surfaces.corners(face);
    (b - a).cross(c - a).normalize_or_zero()
}

/// Corners that are pushed.
pub(super) struct Pushed {
    /// For a point as a corner of an object's surface: its place among `places`.
    of: HashMap<(u32, u32), u32>,
    /// In metres.
    places: Vec<DVec3>,
}

impl Pushed {
    /// By what lies on what. Where there is no way out: what lies there.
    pub fn of(solids: &Solids, all: &[Flush], together: f64) -> Result<Self, Flush> {
        let surfaces = solids.surfaces;
        let mut known: HashMap<(u32, u32), usize> = HashMap::new();
        let mut ways: Vec<((u32, u32), &Flush, Vec<DVec3>)> = Vec::new();
        for flush in all {
            let Some((face, way)) = flush.push else { return Err(*flush) };
            let [Some(solid), _] = solids.sides(face) else { continue };
            for corner in surfaces.faces[face].corners {
                let at = *known.entry((corner, solid)).or_insert_with(|| {
                    ways.push(((corner, solid), flush, Vec::new()));
                    ways.len() - 1
                });
                ways[at].2.push(way);
            }
        }
        let mut pushed = Self { of: HashMap::new(), places: Vec::new() };
        for ((corner, solid), flush, ways) in ways {
            let to = out_of(&ways, PUSH * together).ok_or(*flush)?;
            let number = pushed.places.len() as u32;
            pushed.places.push(surfaces.points[corner as usize] + to);
            // All that bounds the body goes with it; what is of one medium may be one with the other.
            let owners = solids.owners(solid);
            let both = flush.objects.iter().all(|object| owners.contains(object));
            let own = flush.push.map(|(face, _)| surfaces.skin(face).object);
            for owner in owners.iter().filter(|owner| !both || Some(**owner) == own) {
                pushed.of.entry((corner, *owner)).or_insert(number);
            }
        }
        Ok(pushed)
    }

    /// Moves the corners of surfaces; each is told with its object and its number there.
    pub fn push(&self, surfaces: &mut Surfaces, mut moved: impl FnMut((u32, u32), DVec3)) {
        let first = surfaces.points.len() as u32;
        surfaces.points.extend(&self.places);
        let Surfaces { faces, skins, numbers, .. } = surfaces;
        for Face { corners, skin, .. } in faces {
            let object = skins[*skin as usize].object;
            for corner in corners {
                if let Some(place) = self.of.get(&(*corner, object)) {
                    *corner = first + place;
                }
            }
        }
        for (object, numbers) in numbers {
            for (corner, number) in numbers.iter_mut().enumerate() {
                if let Some(place) = self.of.get(&(*number, *object)) {
                    moved((*object, corner as u32), self.places[*place as usize]);
                    *number = first + place;
                }
            }
        }
    }
}

/// The shortest way, about, that goes at least so far along each of some directions.
fn out_of(ways: &[DVec3], far: f64) -> Option<DVec3> {
    let mut to = DVec3::ZERO;
    for _ in 0..ROUNDS {
        for way in ways {
            to += way * (far - to.dot(*way)).max(0.0);
        }
    }
    let is_out = ways.iter().all(|way| to.dot(*way) > 0.9 * far);
    (is_out && to.length() <= SHARP * far).then_some(to)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_go_far_enough_out_of_all_faces() {
        let slanted = DVec3::new(0.6, 0.8, 0.0);
        for ways in [&[DVec3::X, DVec3::Y, DVec3::Z][..], &[DVec3::X; 9], &[DVec3::X, slanted]] {
            let to = out_of(ways, 2.0).unwrap();
            assert!(ways.iter().all(|way| to.dot(*way) > 1.999), "{to}");
            assert!(to.length() < 2.0 * 3.0_f64.sqrt() + 1e-9, "{to}");
        }
        // There is no way out of two faces that look at each other.
        assert_eq!(out_of(&[DVec3::X, -DVec3::X], 2.0), None);
    }
}
