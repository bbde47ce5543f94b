//! What a ray meets at the ends of the tree: f32 tells of a block which triangles are certainly missed
//! and which are certainly met, and f64 decides about the rest.

use super::best::{self, Best};
use super::block::{Bounded, Seen};
use super::lanes::{LANES, Lanes, Task};
use super::ray::Probe;
use super::shapes::{Kind, Primitive, Shapes};
use super::tree::Tree;
use super::{disk, sphere};

/// A ray and the shapes of the world, in their tree; with `ANY`, whichever it meets will do.
pub(super) struct Asked<'a, const ANY: bool> {
    pub tree: &'a Tree,
    pub shapes: &'a Shapes,
    pub probe: &'a Probe,
    pub best: &'a mut Best,
}

impl<const ANY: bool> Asked<'_, ANY> {
    /// Offers the triangles of a block that the ray meets; with `ANY`, whether it meets one of them.
    #[inline(always)]
    pub fn block<L: Lanes>(&mut self, lanes: L, number: usize, span: f32) -> bool {
        let blocks = &self.tree.blocks;
        let block = &blocks[number];
        if self.probe.extreme {
            return lanes.apart(Rest { asked: self, number, lanes: block.all(), inside: 0 });
        }
        let mut seen = block.seen(lanes, self.probe, span);
        if seen.possible != 0 {
            seen.possible &= !block.left_out(lanes, self.probe);
        }
        if seen.possible == 0 {
            return false;
        }
        let found = self.found(lanes, &seen);
        self.offer(lanes, number, &found)
    }

    /// What f32 knows of a block in a box of a `span`; without a jump, for rays that are not extreme.
    #[inline(always)]
    pub fn look<L: Lanes>(&self, lanes: L, number: usize, span: f32) -> Found<L> {
        let block = &self.tree.blocks[number];
        let mut seen = block.seen(lanes, self.probe, span);
        seen.possible &= !block.left_out(lanes, self.probe);
        self.found(lanes, &seen)
    }

    /// With that of lanes that may be met.
    #[inline(always)]
    fn found<L: Lanes>(&self, lanes: L, seen: &Seen<L>) -> Found<L> {
        let Bounded { inside, between: [least, most] } = seen.bounded(lanes, self.probe);
        let tiny = lanes.splat(f32::MIN_POSITIVE);
        let ahead = inside & lanes.at_most(tiny, least);
        let behind = inside & lanes.at_most(most, lanes.sub(lanes.splat(0.0), tiny));
        let first = ahead & lanes.at_most(least, lanes.splat(self.best.t));
        // Neither certainly behind the origin, nor certainly met.
        let left = seen.possible & !(ahead | behind);
        Found { first, left, inside, between: [least, most] }
    }

    /// Offers what was found of a block; with `ANY`, whether the ray meets any of it.
    #[inline(always)]
    pub fn offer<L: Lanes>(&mut self, lanes: L, number: usize, found: &Found<L>) -> bool {
        let blocks = &self.tree.blocks;
        let Found { first, left, inside, between: [least, most] } = *found;
        if ANY {
            let met = first & lanes.at_most(most, lanes.splat(self.best.t.next_down()));
            let left = left | first;
            return met != 0
                || left != 0 && lanes.apart(Rest { asked: self, number, lanes: left, inside });
        }
        if first != 0 {
            let (least, most) = (lanes.store(least), lanes.store(most));
            let mut first = first;
            while first != 0 {
                let lane = first.trailing_zeros() as usize % LANES;
                first &= first - 1;
                let place = best::place(number, lane);
                self.best.offer_within([least[lane], most[lane]], (blocks, place), self.probe);
            }
        }
        left != 0 && lanes.apart(Rest { asked: self, number, lanes: left, inside })
    }

    /// Offers what stands for itself; with `ANY`, whether the ray meets it.
    #[inline(always)]
    pub fn round<L: Lanes>(&mut self, lanes: L, primitive: Primitive) -> bool {
        if let Some(t) = meet_round(self.shapes, self.probe, primitive) {
            self.best.settle(lanes, &self.tree.blocks, self.probe);
            self.best.offer(t, primitive);
            return ANY && self.best.primitive.is_some();
        }
        false
    }
}

/// What f32 knows of where a ray meets triangles of a block.
pub(super) struct Found<L: Lanes> {
    /// A bit for each that is certainly met, and may be first.
    first: u32,
    /// A bit for each that f64 must decide about.
    left: u32,
    /// A bit for each whose edges the ray certainly passes inside of.
    inside: u32,
    /// Bounds of the parameter.
    between: [L::Eight; 2],
}

impl<L: Lanes> Found<L> {
    /// Whether anything may be met.
    #[inline(always)]
    pub fn any(&self) -> bool {
        self.first | self.left != 0
    }
}

/// Triangles of a block that f32 is not sure about.
struct Rest<'a, 'w, const ANY: bool> {
    asked: &'a mut Asked<'w, ANY>,
    number: usize,
    /// A bit for each.
    lanes: u32,
    /// A bit for each whose edges the ray is known to pass inside of.
    inside: u32,
}

impl<const ANY: bool> Task for Rest<'_, '_, ANY> {
    type Answer = bool;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> bool {
        let Asked { tree, probe, best, .. } = self.asked;
        let block = &tree.blocks[self.number];
        let mut left = self.lanes;
        while left != 0 {
            let lane = left.trailing_zeros() as usize % LANES;
            left &= left - 1;
            let inside = self.inside & (1 << lane) != 0;
            if let Some(t) = block.face(lane).meet(lanes, probe, inside) {
                best.settle(lanes, &tree.blocks, probe);
                best.offer_at(t, block.primitive(lane), best::place(self.number, lane));
                if ANY && best.primitive.is_some() {
                    return true;
                }
            }
        }
        false
    }
}

#[inline(never)]
fn meet_round(shapes: &Shapes, probe: &Probe, primitive: Primitive) -> Option<f32> {
    match primitive.kind() {
        Kind::Sphere => sphere::meet(probe, &shapes.spheres[primitive.index()]),
        _ => disk::meet(probe, &shapes.disks[primitive.index()]),
    }
}
