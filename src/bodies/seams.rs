//! Edges at which faces meet: whether the surface around each medium is closed, and which faces
//! hang together.

use std::collections::HashSet;

use glam::DVec3;
use rayon::prelude::*;

use super::surfaces::{Face, Skin, Surfaces};

/// An edge of a face, of one of the media on its sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Edge {
    /// Both points, the lesser one first.
    ends: (u32, u32),
    medium: u32,
    /// The side of a face: see [`side`].
    side: u32,
    /// From the lesser to the greater one, as the face is seen from outside of the medium.
    along: bool,
}

/// The number of a side of a face: behind it, or before it where that is said.
pub(super) fn side(face: usize, before: bool) -> usize {
    2 * face + usize::from(before)
}

/// An edge at which the surface around a medium does not go on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Open {
    pub from: u32,
    pub to: u32,
    pub medium: u32,
    pub face: u32,
    /// How many faces of the medium meet there.
    pub faces: u32,
}

/// What was found along all edges.
pub(super) struct Seams {
    /// Where surfaces do not go on.
    pub open: Vec<Open>,
    /// Where two faces look different ways.
    pub turned: Vec<Open>,
    /// Sides of faces that bound one body of one medium together.
    pub bodies: Sets,
    /// Faces that say nothing of what is before them, and have the same there.
    pub patches: Sets,
    /// Faces that hang together in any way.
    pub sheets: Sets,
}

impl Seams {
    pub fn of(surfaces: &Surfaces) -> Self {
        let count = surfaces.faces.len();
        let mut seams = Self {
            open: Vec::new(),
            turned: Vec::new(),
            bodies: Sets::new(2 * count),
            patches: Sets::new(count),
            sheets: Sets::new(count),
        };
        let edges = edges(surfaces);
        for around in edges.chunk_by(|a, b| a.ends == b.ends) {
            let alone = around[0].medium == around[around.len() - 1].medium;
            for pair in around.windows(2) {
                seams.sheets.join(pair[0].side / 2, pair[1].side / 2);
            }
            for group in around.chunk_by(|a, b| a.medium == b.medium) {
                seams.meet(surfaces, group, alone);
            }
        }
        seams
    }

    /// The sides of faces around one edge that have the same medium; `alone`: they are all.
    fn meet(&mut self, surfaces: &Surfaces, group: &[Edge], alone: bool) {
        let first = group[0];
        let unsaid = |edge: &Edge| {
            edge.side.is_multiple_of(2) && surfaces.skin(edge.side as usize / 2).outside.is_none()
        };
        for other in &group[1..] {
            self.bodies.join(first.side, other.side);
        }
        if alone && group.iter().all(unsaid) {
            for other in &group[1..] {
                self.patches.join(first.side / 2, other.side / 2);
            }
        }
        let along = group.iter().filter(|edge| edge.along).count();
        let back = group.len() - along;
        if along == back {
            return;
        }
        let (low, high) = first.ends;
        let (from, to) = if along > back { (low, high) } else { (high, low) };
        let faces = group.len() as u32;
        let open = Open { from, to, medium: first.medium, face: first.side / 2, faces };
        match group.len().is_multiple_of(2) {
            true => self.turned.push(open),
            false => self.open.extend(std::iter::repeat_n(open, along.abs_diff(back))),
        }
    }
}

/// All edges, those between the same points side by side.
fn edges(surfaces: &Surfaces) -> Vec<Edge> {
    let of_face = |face: usize| {
        let skin = surfaces.skin(face);
        let [a, b, c] = surfaces.faces[face].corners;
        let sides = [(Some(skin.inside), false), (skin.outside, true)];
        sides.into_iter().flat_map(move |(medium, before)| {
            let edge = move |(from, to): (u32, u32)| {
                let ends = (from.min(to), from.max(to));
                let along = (from < to) != before;
                let side = side(face, before) as u32;
                medium.filter(|_| from != to).map(|medium| Edge { ends, medium, side, along })
            };
            [(a, b), (b, c), (c, a)].into_iter().filter_map(edge)
        })
    };
    let mut all: Vec<Edge> =
        (0..surfaces.faces.len()).into_par_iter().flat_map_iter(of_face).collect();
    all.par_sort_unstable();
    all
}

/// Sets of numbers, joined one by one.
pub struct Sets(Vec<u32>);

impl Sets {
    /// So many, each by itself.
    pub fn new(count: usize) -> Self {
        Self((0..count as u32).collect())
    }

    /// The least number of a set.
    pub fn least(&mut self, of: usize) -> usize {
        let mut at = of as u32;
        while self.0[at as usize] != at {
            let next = self.0[at as usize];
            // Halves the way for the next one who asks.
            self.0[at as usize] = self.0[next as usize];
            at = next;
        }
        at as usize
    }

    /// Makes the sets of two numbers one.
    pub fn join(&mut self, one: u32, other: u32) {
        let (one, other) = (self.least(one as usize), self.least(other as usize));
        self.0[one.max(other)] = one.min(other) as u32;
    }
}

impl Open {
    /// The skins of all faces at some edges, each once.
    pub fn skins<'s>(edges: &[Self], surfaces: &'s Surfaces) -> Vec<&'s Skin> {
        let ends: HashSet<(u32, u32)> =
            edges.iter().map(|edge| (edge.from.min(edge.to), edge.from.max(edge.to))).collect();
        let meets = |face: &Face| {
            let [a, b, c] = face.corners;
            [(a, b), (b, c), (c, a)].iter().any(|(p, q)| ends.contains(&(*p.min(q), *p.max(q))))
        };
        let mut skins: Vec<u32> =
            surfaces.faces.iter().filter(|face| meets(face)).map(|face| face.skin).collect();
        skins.sort_unstable();
        skins.dedup();
        skins.iter().map(|skin| &surfaces.skins[*skin as usize]).collect()
    }

    /// Its middle.
    pub fn place(&self, points: &[DVec3]) -> DVec3 {
        0.5 * (points[self.from as usize] + points[self.to as usize])
    }
}
