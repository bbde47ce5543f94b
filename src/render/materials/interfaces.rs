//! What many smooth surfaces of clear matter do with light, one lane for each.

use super::facing::Facings;
use super::{Facing, Interface, Ways};
use crate::render::lanes::{LANES, Row, Rows, by_processor, padded, put};

/// Such surfaces side by side.
pub(super) struct Interfaces {
    count: usize,
    seen: Facings,
    /// The index on the viewer's side, and that beyond.
    indices: [Row<f64>; 2],
    /// The number that chooses between both ways.
    chance: Row<f64>,
    /// Where light comes from, and what it is squeezed.
    wi: Rows,
    squeeze: Row,
    /// 1 where it is reflected.
    reflected: Row<u32>,
}

impl Default for Interfaces {
    fn default() -> Self {
        Self {
            count: 0,
            seen: Facings::default(),
            indices: [[1.0; LANES]; 2],
            chance: [0.0; LANES],
            wi: [[0.0; LANES]; 3],
            squeeze: [1.0; LANES],
            reflected: [0; LANES],
        }
    }
}

impl Interfaces {
    /// Forgets them.
    pub fn clear(&mut self) {
        self.count = 0;
    }

    /// One more, of these indices here and beyond.
    #[inline]
    pub fn push(&mut self, facing: &Facing, [here, beyond]: [f64; 2]) {
        self.seen.put(self.count, facing);
        self.indices[0][self.count] = here;
        self.indices[1][self.count] = beyond;
        self.count += 1;
    }

    /// Their ways, from lane `first` on, chosen by numbers of those lanes.
    pub fn ways(&mut self, first: usize, chances: &Row<f64>, ways: &mut Ways) {
        if self.count > 0 {
            let lanes = first..first + self.count;
            self.chance[..self.count].copy_from_slice(&chances[lanes.clone()]);
            chosen(self.count, self);
            ways.pass(lanes, &self.wi, &self.squeeze, &self.reflected);
        }
    }
}

by_processor! {
    #[inline(never)]
    fn chosen(count: usize, all: &mut Interfaces) {
        let [here, beyond] = &all.indices;
        for lane in 0..padded(count) {
            let glass = Interface::new(&all.seen.at(lane), [here[lane], beyond[lane]]);
            let (wi, squeeze, reflected) = glass.way(all.chance[lane]);
            put(&mut all.wi, lane, wi);
            all.squeeze[lane] = squeeze;
            all.reflected[lane] = u32::from(reflected);
        }
    }
}
