//! Closed surfaces, each around one medium, and which of them a point is inside of.

use std::collections::HashMap;
use std::sync::OnceLock;

use glam::DVec3;

use super::crossing;
use super::layers::Layers;
use super::seams::{Seams, side};
use super::surfaces::{SURROUNDINGS, Surfaces};
use super::tree::{self, Item, Tree};
use super::yields::Yields;
use crate::math::Bounds;

/// A closed surface with one medium on one of its sides.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solid {
    pub medium: u32,
    /// In cubic metres; negative if the medium is all around it.
    pub volume: f64,
    pub bounds: Bounds,
    /// A face behind which the medium is, if there is one, or a ball.
    pub within: Option<Item>,
    /// The skin of one of its surfaces.
    pub skin: u32,
}

/// All closed surfaces.
pub(super) struct Solids<'s> {
    pub surfaces: &'s Surfaces<'s>,
    pub all: Vec<Solid>,
    /// Of each side of a face and of a ball, if it has a medium: which it belongs to.
    of_side: Vec<u32>,
    /// Of each face and ball: those that hang together have the same.
    pub sheets: Vec<u32>,
    /// The same, of one object.
    pub pieces: Vec<u32>,
    tree: OnceLock<Tree>,
    layers: Layers,
    yields: &'s Yields,
    /// The objects of each, where some yield to others.
    owners: Vec<Vec<u32>>,
}

/// No solid.
const NONE: u32 = u32::MAX;

/// Directions in which a point looks for what is around it; of an odd number, most are right even
/// if some go through an edge.
const WAYS: [DVec3; 5] = [
    DVec3::new(0.561_267, 0.347_591, 0.751_113),
    DVec3::new(-0.267_949, 0.813_797, 0.515_717),
    DVec3::new(0.414_214, -0.718_281, 0.559_017),
    DVec3::new(-0.577_216, -0.236_068, 0.781_716),
    DVec3::new(0.141_593, 0.302_585, -0.942_541),
];

/// How often each solid goes round a point: 1 inside of one whose faces look outward.
type Turns = Vec<(u32, i32)>;

impl<'s> Solids<'s> {
    /// Of surfaces that are closed.
    pub fn of(surfaces: &'s Surfaces<'s>, seams: &mut Seams, yields: &'s Yields) -> Self {
        let (faces, balls) = (surfaces.faces.len(), surfaces.balls.len());
        let mut solids = Self {
            surfaces,
            all: Vec::new(),
            of_side: vec![NONE; 2 * (faces + balls)],
            sheets: (0..faces).map(|face| seams.sheets.least(face) as u32).collect(),
            pieces: Vec::new(),
            tree: OnceLock::new(),
            layers: Layers::of(surfaces),
            yields,
            owners: Vec::new(),
        };
        solids.sheets.extend((faces..faces + balls).map(|item| item as u32));
        let mut pieces: HashMap<(u32, u32), u32> = HashMap::new();
        let piece = |(item, sheet): (usize, &u32)| {
            let skin = surfaces.skins[crossing::skin(surfaces, item) as usize];
            *pieces.entry((*sheet, skin.object)).or_insert(item as u32)
        };
        solids.pieces = solids.sheets.iter().enumerate().map(piece).collect();
        let mut known: HashMap<usize, u32> = HashMap::new();
        for face in 0..faces {
            let skin = surfaces.skin(face);
            for (medium, before) in [(Some(skin.inside), false), (skin.outside, true)] {
                let Some(medium) = medium else { continue };
                let side = side(face, before);
                let number = *known.entry(seams.bodies.least(side)).or_insert_with(|| {
                    solids.all.push(Solid {
                        medium,
                        volume: 0.0,
                        bounds: Bounds::EMPTY,
                        within: None,
                        skin: surfaces.faces[face].skin,
                    });
                    (solids.all.len() - 1) as u32
                });
                solids.of_side[side] = number;
                let solid = &mut solids.all[number as usize];
                solid.bounds = solid.bounds.union(surfaces.bounds_of(face));
                if !before {
                    solid.within.get_or_insert(face);
                }
            }
        }
        solids.measure();
        for (i, ball) in surfaces.balls.iter().enumerate() {
            let skin = surfaces.skins[ball.skin as usize];
            let volume = 4.0 / 3.0 * std::f64::consts::PI * ball.radius.powi(3);
            let bounds = Bounds { min: ball.centre - ball.radius, max: ball.centre + ball.radius };
            for (medium, before) in [(Some(skin.inside), false), (skin.outside, true)] {
                let Some(medium) = medium else { continue };
                solids.of_side[side(faces + i, before)] = solids.all.len() as u32;
                solids.all.push(Solid {
                    medium,
                    volume: if before { -volume } else { volume },
                    bounds,
                    within: (!before).then_some(faces + i),
                    skin: ball.skin,
                });
            }
        }
        solids.own();
        solids
    }

    /// Notes whose surfaces solids have.
    fn own(&mut self) {
        if self.yields.is_empty() {
            return;
        }
        self.owners = vec![Vec::new(); self.all.len()];
        let count = self.surfaces.faces.len() + self.surfaces.balls.len();
        for side in 0..2 * count {
            let Some(owners) = self.owners.get_mut(self.of_side[side] as usize) else { continue };
            let skin = crossing::skin(self.surfaces, side / 2);
            let object = self.surfaces.skins[skin as usize].object;
            if !owners.contains(&object) {
                owners.push(object);
            }
        }
    }

    /// The objects whose surfaces a solid has, where some objects yield to others.
    pub fn owners(&self, solid: u32) -> &[u32] {
        self.owners.get(solid as usize).map_or(&[], Vec::as_slice)
    }

    /// The solids behind a face or a ball, and before it.
    pub fn sides(&self, item: Item) -> [Option<u32>; 2] {
        [false, true]
            .map(|before| self.of_side[side(item, before)])
            .map(|it| (it != NONE).then_some(it))
    }

    /// Whether two faces or balls bound one solid together.
    pub fn are_of_one(&self, one: Item, other: Item) -> bool {
        let sides = [one, other].map(|item| self.sides(item));
        sides[0].iter().flatten().any(|it| sides[1].contains(&Some(*it)))
    }

    /// How often a solid goes round a point that lies on no surface.
    pub fn goes_round(&self, solid: u32, at: DVec3) -> i32 {
        let turns = self.turns(at, None);
        turns.iter().find(|(number, _)| *number == solid).map_or(0, |(_, turns)| *turns)
    }

    /// Whether one solid ends where another begins.
    pub fn yields(&self, one: u32, to: u32) -> bool {
        let ends = |o: &u32| self.owners(to).iter().any(|t| self.yields.yields(*o, *t));
        one != to && self.owners(one).iter().any(ends)
    }

    /// Sums up the volumes below faces, each from the middle of its solid.
    fn measure(&mut self) {
        for face in 0..self.surfaces.faces.len() {
            for before in [false, true] {
                let number = self.of_side[side(face, before)];
                let Some(solid) = self.all.get_mut(number as usize) else { continue };
                let middle = solid.bounds.centre();
                let [a, b, c] = self.surfaces.corners(face).map(|corner| corner - middle);
                let below = a.dot(b.cross(c)) / 6.0;
                solid.volume += if before { -below } else { below };
            }
        }
    }

    /// The tree over all surfaces.
    pub fn tree(&self) -> &Tree {
        self.tree.get_or_init(|| Tree::new(self.surfaces, &self.pieces))
    }

    /// How solids go round a point; those of the item's own sides are left out, and the item.
    fn turns(&self, at: DVec3, item: Option<Item>) -> Turns {
        let own =
            item.map_or([NONE; 2], |item| [false, true].map(|it| self.of_side[side(item, it)]));
        let mut around = self.all.iter().enumerate();
        let other = |number: usize| !own.contains(&(number as u32));
        if !around.any(|(number, solid)| other(number) && solid.bounds.holds(at)) {
            return Turns::new();
        }
        let mut seen: Vec<(Turns, usize)> = Vec::new();
        for way in WAYS {
            let mut turns = self.crossed(at, way, item);
            turns.retain(|(number, turns)| *turns != 0 && other(*number as usize));
            turns.sort_unstable();
            match seen.iter_mut().find(|(known, _)| *known == turns) {
                Some((_, count)) => *count += 1,
                None => seen.push((turns, 1)),
            }
            // Three of five are most.
            if let Some(at) = seen.iter().position(|(_, count)| *count == 3) {
                return seen.swap_remove(at).0;
            }
        }
        seen.into_iter().max_by_key(|(_, count)| *count).map_or(Turns::new(), |(turns, _)| turns)
    }

    /// What a ray to infinity goes out of, less what it goes into.
    fn crossed(&self, from: DVec3, way: DVec3, but: Option<Item>) -> Turns {
        let mut turns = Turns::new();
        let mut add = |item: Item, outward: i32| {
            for (before, sign) in [(false, outward), (true, -outward)] {
                let number = self.of_side[side(item, before)];
                match turns.iter_mut().find(|(known, _)| *known == number) {
                    _ if number == NONE => {}
                    Some((_, count)) => *count += sign,
                    None => turns.push((number, sign)),
                }
            }
        };
        let faces = self.surfaces.faces.len();
        self.tree().along(from, way, |item| {
            if Some(item) == but {
                return;
            }
            match item.checked_sub(faces) {
                None => {
                    if let Some(outward) = crosses(from, way, self.surfaces.corners(item)) {
                        add(item, outward);
                    }
                }
                Some(ball) => {
                    // In and out again, or from within.
                    let ball = self.surfaces.balls[ball];
                    if from.distance(ball.centre) < ball.radius {
                        add(item, 1);
                    }
                }
            }
        });
        turns
    }

    /// Solids around a point from the outermost in, without those that are hollow there: `turns`
    /// are those of bounded ones.
    fn nested(&self, mut turns: Turns) -> Vec<u32> {
        // Of those around one point, the larger are around the smaller.
        let size = |number: u32| self.all[number as usize].volume.abs();
        turns.sort_by(|a, b| size(b.0).total_cmp(&size(a.0)).then(a.1.cmp(&b.1)));
        let mut inside: Vec<u32> = Vec::new();
        for (number, turns) in turns {
            let medium = |number: u32| self.all[number as usize].medium;
            if turns > 0 {
                inside.push(number);
            } else if let Some(at) = inside.iter().rposition(|it| medium(*it) == medium(number)) {
                inside.remove(at);
            }
        }
        let all = inside.clone();
        inside.retain(|one| !all.iter().any(|other| self.yields(*one, *other)));
        inside
    }

    /// All solids around a point that lies on no surface, those that yield there among them.
    pub fn all_around(&self, at: DVec3) -> impl Iterator<Item = u32> {
        let turns = self.turns(at, None).into_iter();
        turns.filter(|(_, turns)| *turns > 0).map(|(number, _)| number)
    }

    /// Solids around a point that lies on no surface, from the outermost in.
    pub fn around(&self, at: DVec3) -> Vec<u32> {
        self.nested(self.turns(at, None))
    }

    /// Solids before a face or a ball, from the outermost in; and how often its own medium, without
    /// it, is behind it.
    pub fn before(&self, item: Item) -> (Vec<u32>, i32) {
        let at = self.place(item);
        let mut turns = self.turns(at, Some(item));
        for before in [false, true] {
            let number = self.of_side[side(item, before)];
            let Some(solid) = self.all.get(number as usize) else { continue };
            // Its own faces have the medium on the side that they say, and not on the other.
            let own = i32::from(before) - i32::from(solid.volume < 0.0);
            if own != 0 {
                turns.push((number, own));
            }
        }
        let own = self.of_side[side(item, false)];
        let medium = self.all[own as usize].medium;
        let same = |(number, _): &&(u32, i32)| self.all[*number as usize].medium == medium;
        let there = turns.iter().filter(same).map(|(_, turns)| turns).sum::<i32>() + 1;
        // Where one of two ends within the other there is no such surface; elsewhere only one is.
        turns.retain(|(number, _)| !self.yields(own, *number) && !self.yields(*number, own));
        (self.nested(turns), there)
    }

    /// A solid that would be everywhere but within its surface.
    pub fn inside_out(&self) -> Option<&Solid> {
        let inward = self.all.iter().filter(|solid| solid.volume < 0.0);
        let mut inward = inward.filter_map(|solid| Some((solid, solid.within?)));
        inward.find(|(_, within)| self.before(*within).1 <= 0).map(|(solid, _)| solid)
    }

    /// Whether any two pieces are nearer than `within`, in metres, to each other, or to a plane.
    pub fn could_meet(&self, within: f64) -> bool {
        let mut around: HashMap<u32, Bounds> = HashMap::new();
        for (item, piece) in self.pieces.iter().enumerate() {
            let known = around.entry(*piece).or_insert(Bounds::EMPTY);
            *known = known.union(tree::bounds(self.surfaces, item));
        }
        if !self.surfaces.walls.is_empty() {
            return around.len() + self.surfaces.walls.len() > 1;
        }
        let wider = |it: Bounds| Bounds { min: it.min - within, max: it.max + within };
        let mut boxes: Vec<Bounds> = around.into_values().map(wider).collect();
        boxes.sort_by(|a, b| a.min.x.total_cmp(&b.min.x));
        boxes.iter().enumerate().any(|(i, one)| {
            let near = boxes[i + 1..].iter().take_while(|other| other.min.x <= one.max.x);
            near.into_iter().any(|other| one.touches(other))
        })
    }

    /// Whether a surface may go through a box.
    pub fn cut(&self, around: &Bounds) -> bool {
        let walls = self.surfaces.walls.iter().any(|wall| {
            let heights = around.corners().map(|corner| wall.normal.dot(corner - wall.point));
            heights.iter().any(|h| *h > 0.0) && heights.iter().any(|h| *h < 0.0)
        });
        if walls || !self.all.iter().any(|solid| solid.bounds.touches(around)) {
            return walls;
        }
        let mut near = false;
        self.tree().near(around, NONE, |item| {
            near |= tree::bounds(self.surfaces, item).touches(around);
        });
        near
    }

    /// The medium at a point that lies on no surface, with the solids around it.
    pub fn medium(&self, around: &[u32], at: DVec3) -> u32 {
        match around.last() {
            Some(number) => self.all[*number as usize].medium,
            None => self.layers.at(at).unwrap_or(SURROUNDINGS),
        }
    }

    /// Which solid a side of a face or a ball belongs to; of one without a medium none of them.
    pub fn of_side(&self, side: usize) -> u32 {
        self.of_side[side]
    }

    /// What is before a plane.
    pub fn before_wall(&self, wall: usize) -> u32 {
        self.layers.before(wall).unwrap_or(SURROUNDINGS)
    }

    /// A point of a face or a ball, as far from its rim as it can be.
    pub fn place(&self, item: Item) -> DVec3 {
        match item.checked_sub(self.surfaces.faces.len()) {
            None => self.surfaces.corners(item).into_iter().sum::<DVec3>() / 3.0,
            Some(ball) => {
                let ball = self.surfaces.balls[ball];
                ball.centre + ball.radius * WAYS[0].normalize()
            }
        }
    }
}

/// Whether a ray goes through a triangle: 1 out of its front, -1 into it.
fn crosses(from: DVec3, way: DVec3, [a, b, c]: [DVec3; 3]) -> Option<i32> {
    let (u, v) = (b - a, c - a);
    let across = way.cross(v);
    let facing = u.dot(across);
    let off = from - a;
    let first = off.dot(across) / facing;
    let over = off.cross(u);
    let second = way.dot(over) / facing;
    let t = v.dot(over) / facing;
    let inside = first >= 0.0 && second >= 0.0 && first + second <= 1.0 && t > 0.0;
    // The normal is u × v, and way · (u × v) is -facing.
    (facing != 0.0 && inside).then_some(if facing < 0.0 { 1 } else { -1 })
}
