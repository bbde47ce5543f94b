//! Words that do nothing: a body that yields to one that it does not meet, and one that stands in
//! its own medium.

use super::asked::{Bodies, ask};
use super::crossing::{self, skin};
use super::placed::Placed;
use super::seams::side;
use super::surfaces::Surfaces;
use super::view;
use crate::load::Stage;
use crate::scene::{Medium, Named};

/// An object that yields to another one, and their surfaces do not meet.
pub struct Needless<'a> {
    /// What yields.
    pub object: &'a Placed<'a>,
    /// What it yields to.
    pub to: &'a Placed<'a>,
    /// Why nothing ends there.
    pub because: Because,
}

/// Why what yields to another one does not end there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Because {
    /// They do not meet.
    Apart,
    /// It is wholly inside of the other, and nothing of it is left.
    Gone,
    /// One of them is no body of clear matter.
    Opaque,
}

/// All of a scene without faults.
pub fn needless<'a>(stage: &'a Stage, placed: &'a [Placed<'a>]) -> Vec<Needless<'a>> {
    let of = |(number, object): (usize, &'a Placed<'a>)| {
        let name = object.object.value.yields_to().as_ref()?;
        let to = placed.iter().position(|other| *other.name().value == name.0.name)?;
        Some((number as u32, to as u32))
    };
    let pairs: Vec<(u32, u32)> = placed.iter().enumerate().filter_map(of).collect();
    if pairs.is_empty() {
        return Vec::new();
    }
    let together = view::together(&stage.scene.camera.value, placed);
    let all = ask(stage, placed, |bodies, _| {
        let of = |(one, to)| Some((one, to, bodies.because(one, to, together)?));
        pairs.into_iter().filter_map(of).collect::<Vec<_>>()
    });
    let told = |(one, to, because)| Needless {
        object: &placed[one as usize],
        to: &placed[to as usize],
        because,
    };
    all.into_iter().flatten().map(told).collect()
}

impl Bodies<'_, '_> {
    fn because(&self, one: u32, to: u32, together: f64) -> Option<Because> {
        let surfaces: &Surfaces = self.solids.surfaces;
        let bounds = |object: u32| surfaces.skins.iter().any(|skin| skin.object == object);
        if !bounds(one) || !bounds(to) {
            return Some(Because::Opaque);
        }
        let others = |a: u32, b: u32| {
            let [a, b] = [a, b].map(|skin| surfaces.skins[skin as usize].object);
            (a, b) != (one, to) && (b, a) != (one, to)
        };
        if crossing::find(self.solids, &others, together).is_some() {
            return None;
        }
        let count = surfaces.faces.len() + surfaces.balls.len();
        let of_one = |item: &usize| surfaces.skins[skin(surfaces, *item) as usize].object == one;
        let gone = (0..count).find(of_one).is_some_and(|item| {
            let around = self.solids.around(self.solids.place(item));
            around.iter().any(|solid| self.solids.owners(*solid).contains(&to))
        });
        Some(if gone { Because::Gone } else { Because::Apart })
    }
}

/// Objects of a scene without faults that stand in the medium that is inside of them. Those that
/// yield, or are yielded to, are left out, and parts of one mesh within each other.
pub fn unseen<'a>(
    stage: &'a Stage,
    placed: &'a [Placed<'a>],
) -> Vec<(&'a Placed<'a>, &'a Named<Medium>)> {
    let sides = placed.iter().enumerate().flat_map(|(number, object)| {
        let sides = object.all_parts().filter_map(|part| part.value.value.sides());
        sides.map(move |(inside, _)| (number, inside.name.as_str()))
    });
    let mut sides: Vec<(usize, &str)> = sides.collect();
    sides.dedup();
    let around = stage.scene.surroundings.as_ref().map(|name| name.name.as_str());
    let twice = |(number, name): &(usize, &str)| {
        let other = |(n, other): &(usize, &str)| n != number && name == other;
        around == Some(name) || sides.iter().any(other)
    };
    if !sides.iter().any(twice) {
        return Vec::new();
    }
    let all = ask(stage, placed, |bodies, media| {
        let (solids, surfaces) = (bodies.solids, bodies.solids.surfaces);
        let mut found: Vec<(u32, u32)> = Vec::new();
        let mut add = |skin: u32, before: &dyn Fn() -> u32| {
            let skin = surfaces.skins[skin as usize];
            let related = |other| bodies.yields.are_related(skin.object, other);
            let told = (skin.object, skin.inside);
            let skip = skin.outside.is_some() || found.contains(&told);
            if !skip && before() == skin.inside && !(0..placed.len() as u32).any(related) {
                found.push(told);
            }
        };
        let innermost = |item| solids.medium(&solids.before(item).0, solids.place(item));
        // No surface goes through another: before all faces of one there is the same.
        let mut known: Vec<(u32, u32)> = Vec::new();
        for (face, triangle) in surfaces.faces.iter().enumerate() {
            let of = (triangle.skin, solids.of_side(side(face, false)));
            if !known.contains(&of) {
                known.push(of);
                add(triangle.skin, &|| innermost(face));
            }
        }
        for (i, ball) in surfaces.balls.iter().enumerate() {
            add(ball.skin, &|| innermost(surfaces.faces.len() + i));
        }
        for (i, wall) in surfaces.walls.iter().enumerate() {
            add(wall.skin, &|| solids.before_wall(i));
        }
        let named = |(object, medium): (u32, u32)| Some((object, media[medium as usize]?));
        found.into_iter().filter_map(named).collect::<Vec<_>>()
    });
    let told = |(object, medium)| (&placed[object as usize], medium);
    all.into_iter().flatten().map(told).collect()
}
