//! A tree of boxes over faces and balls, in f64: which of them a ray meets, which are near a box.
//!
//! Its items are halved by the middle one along the longest side, and so it needs no pointers: the
//! children of node n are 2n + 1 and 2n + 2.

use glam::DVec3;
use rayon::prelude::*;

use super::surfaces::Surfaces;
use crate::math::Bounds;

/// Items in a leaf, about.
const LEAF: usize = 4;
/// Fewer are ordered by one thread.
const FEW: usize = 4096;

/// A face, or, from the number of faces on, a ball.
pub(super) type Item = usize;

pub(super) struct Tree {
    items: Vec<u32>,
    /// A power of two.
    leaves: usize,
    boxes: Vec<Bounds>,
    /// The sheet that all items below a node belong to, or [`MANY`].
    sheets: Vec<u32>,
}

/// More than one sheet.
const MANY: u32 = u32::MAX;

/// In the place of a sheet: items of all of them are near.
pub(super) const ALL: u32 = u32::MAX;

/// The box around an item.
pub(super) fn bounds(surfaces: &Surfaces, item: Item) -> Bounds {
    match item.checked_sub(surfaces.faces.len()) {
        None => surfaces.bounds_of(item),
        Some(ball) => {
            let ball = &surfaces.balls[ball];
            Bounds { min: ball.centre - ball.radius, max: ball.centre + ball.radius }
        }
    }
}

impl Tree {
    /// Over all faces and balls; `sheets` has the sheet of each.
    pub fn new(surfaces: &Surfaces, sheets: &[u32]) -> Self {
        let count = surfaces.faces.len() + surfaces.balls.len();
        let boxes: Vec<Bounds> =
            (0..count).into_par_iter().map(|item| bounds(surfaces, item)).collect();
        Self::of(&boxes, |item| sheets[item as usize])
    }

    /// Over boxes: these are its items.
    pub fn over(boxes: &[Bounds]) -> Self {
        Self::of(boxes, |_| MANY)
    }

    fn of(boxes: &[Bounds], sheet_of: impl Fn(u32) -> u32) -> Self {
        let count = boxes.len();
        let mut items: Vec<u32> = (0..count as u32).collect();
        let leaves = count.div_ceil(LEAF).next_power_of_two();
        let mut tree = Self {
            items: Vec::new(),
            leaves,
            boxes: vec![Bounds::EMPTY; 2 * leaves - 1],
            sheets: vec![MANY; 2 * leaves - 1],
        };
        order(&mut items, boxes, (0, leaves), (count, leaves));
        tree.items = items;
        for node in (0..2 * leaves - 1).rev() {
            let (around, sheet) = match tree.leaf(node) {
                Some(items) => {
                    let all = items.iter().map(|item| boxes[*item as usize]);
                    let mut known = items.iter().map(|item| sheet_of(*item));
                    let first = known.next().unwrap_or(MANY);
                    let one = known.all(|sheet| sheet == first);
                    (all.fold(Bounds::EMPTY, Bounds::union), if one { first } else { MANY })
                }
                None => {
                    let [a, b] = [2 * node + 1, 2 * node + 2];
                    let one = tree.sheets[a] == tree.sheets[b];
                    let around = tree.boxes[a].union(tree.boxes[b]);
                    (around, if one { tree.sheets[a] } else { MANY })
                }
            };
            (tree.boxes[node], tree.sheets[node]) = (around, sheet);
        }
        tree
    }

    /// Items of a leaf; None: it is none.
    fn leaf(&self, node: usize) -> Option<&[u32]> {
        let leaf = (node + 1).checked_sub(self.leaves)?;
        let from = |leaf: usize| leaf * self.items.len() / self.leaves;
        Some(&self.items[from(leaf)..from(leaf + 1)])
    }

    fn visit(&self, wanted: impl Fn(usize) -> bool, mut found: impl FnMut(Item)) {
        let mut open = vec![0];
        while let Some(node) = open.pop() {
            if !wanted(node) {
                continue;
            }
            match self.leaf(node) {
                Some(items) => items.iter().for_each(|item| found(*item as usize)),
                None => open.extend([2 * node + 2, 2 * node + 1]),
            }
        }
    }

    /// Items of other sheets whose boxes may touch this one.
    pub fn near(&self, around: &Bounds, sheet: u32, found: impl FnMut(Item)) {
        let wanted = |node: usize| {
            let space = &self.boxes[node];
            space.touches(around) && (self.sheets[node] == MANY || self.sheets[node] != sheet)
        };
        self.visit(wanted, found);
    }

    /// Items that a ray may meet; no component of its direction is zero.
    pub fn along(&self, from: DVec3, direction: DVec3, found: impl FnMut(Item)) {
        let inverse = direction.recip();
        let wanted = |node: usize| {
            let space = &self.boxes[node];
            let (low, high) = ((space.min - from) * inverse, (space.max - from) * inverse);
            let (enters, leaves) = (low.min(high).max_element(), low.max(high).min_element());
            // A little more, for the rounding of both.
            !space.is_empty() && enters <= leaves * (1.0 + 1e-9) + 1e-300 && leaves >= 0.0
        };
        self.visit(wanted, found);
    }
}

/// Orders items so that those of each leaf are side by side.
fn order(
    items: &mut [u32],
    boxes: &[Bounds],
    (low, high): (usize, usize),
    (count, leaves): (usize, usize),
) {
    if high - low <= 1 || items.len() <= 1 {
        return;
    }
    let middle = |item: &u32| boxes[*item as usize].centre();
    let around = Bounds::around(items.iter().map(middle));
    let axis = around.half().max_position();
    let between = (low + high) / 2;
    let split = between * count / leaves - low * count / leaves;
    if split < items.len() {
        items.select_nth_unstable_by(split, |a, b| {
            middle(a)[axis].total_cmp(&middle(b)[axis]).then(a.cmp(b))
        });
    }
    let many = items.len() > FEW;
    let (left, right) = items.split_at_mut(split);
    let mut one = || order(left, boxes, (low, between), (count, leaves));
    let mut other = || order(right, boxes, (between, high), (count, leaves));
    if many {
        rayon::join(one, other);
    } else {
        one();
        other();
    }
}
