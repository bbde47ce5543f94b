//! Sums of a tile over whole rounds of samples, and how those of two parts become one.

use serde::{Deserialize, Serialize};

use crate::render::tiles::Counts;

/// Sums over samples of each pixel of a tile, row by row from the top left, in light units.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sums {
    /// Σx of red, green and blue; empty if there is no whole round.
    pub(super) sums: Vec<[f64; 3]>,
    /// Σ(y − mean)² over rounds, y the sum of a round; empty if there is none.
    pub(super) squares: Vec<[f64; 3]>,
    /// The largest |x|.
    pub(super) largest: Vec<[f32; 3]>,
    /// Σx of every layer of the first pixel, of the second, and so on; over all samples, those of
    /// a round that is begun too.
    pub(super) layers: Vec<[f64; 3]>,
    /// What was counted on the way.
    pub(super) counts: Counts,
}

impl Sums {
    /// Nothing yet.
    pub(super) fn new(pixels: usize, layers: usize) -> Self {
        Self {
            sums: Vec::new(),
            squares: Vec::new(),
            largest: vec![[0.0; 3]; pixels],
            layers: vec![[0.0; 3]; pixels * layers],
            counts: Counts::default(),
        }
    }

    /// The same with sums over rounds, if of none.
    pub(super) fn with_rounds(mut self) -> Self {
        self.make_rounds();
        self
    }

    /// Makes place for sums over rounds, if there is none.
    pub(super) fn make_rounds(&mut self) {
        let pixels = self.largest.len();
        self.sums.resize(pixels, [0.0; 3]);
        self.squares.resize(pixels, [0.0; 3]);
    }

    /// Whether there are so many pixels in every sum, and so many layers of each; with sums over
    /// rounds, or without.
    pub(super) fn fits(&self, pixels: usize, layers: usize, rounds: bool) -> bool {
        let of_rounds = if rounds { pixels } else { 0 };
        [self.sums.len(), self.squares.len(), self.largest.len()] == [of_rounds, of_rounds, pixels]
            && Some(self.layers.len()) == pixels.checked_mul(layers)
    }

    /// Adds the sums of other rounds of the same pixels. `rounds` and `others` are how many rounds
    /// went into each. Σ(y − mean)² by [Chan83].
    pub(super) fn add(&mut self, rounds: u64, other: &Self, others: u64) {
        let (n, m) = (rounds.max(1) as f64, others.max(1) as f64);
        // Of no round at all there is no mean to be apart.
        let weight = if rounds == 0 || others == 0 { 0.0 } else { n * (m / (n + m)) };
        for i in 0..self.sums.len() {
            for channel in 0..3 {
                let (sum, added) = (&mut self.sums[i][channel], other.sums[i][channel]);
                let apart = *sum / n - added / m;
                *sum += added;
                self.squares[i][channel] += other.squares[i][channel] + square(apart) * weight;
                let largest = &mut self.largest[i][channel];
                *largest = largest.max(other.largest[i][channel]);
            }
        }
        for (sum, added) in self.layers.iter_mut().zip(&other.layers) {
            (0..3).for_each(|channel| sum[channel] += added[channel]);
        }
        self.counts.add(&other.counts);
    }
}

pub(super) fn square(x: f64) -> f64 {
    x * x
}
