//! The sums of a tile while a block of samples is being taken.
//!
//! Samples come in rounds, which the sampler spreads together; only rounds are independent of each
//! other. So the variance of a picture is that of its rounds. Until there are two of them, the
//! spread of single samples stands in for it: it tells too much for samples that were spread
//! evenly, never too little on average.

use serde::{Deserialize, Serialize};

use super::sums::{Sums, square};
use crate::render::samplers::Rhythm;

/// Sums of a tile over the samples of a block that is begun.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Begun {
    /// Sums over the whole rounds of the block.
    pub(super) whole: Sums,
    /// Sums over the round that is begun; empty if a round is one sample.
    pub(super) part: Vec<[f64; 3]>,
    /// Σ(x − mean)² of the samples of the first two rounds of a render; empty where rounds are
    /// single samples, or the first block is over.
    pub(super) within: Vec<[f64; 3]>,
}

/// The same of one pixel, for the loop over its samples.
#[derive(Clone, Copy, Debug)]
pub struct PixelSums {
    sum: [f64; 3],
    squares: [f64; 3],
    largest: [f32; 3],
    part: [f64; 3],
    /// Whether a round is whole.
    whole: bool,
    /// None where it is not asked for.
    within: Option<[f64; 3]>,
}

impl Begun {
    /// Nothing yet of so many pixels and layers, in the block of that number.
    pub fn new([pixels, layers]: [usize; 2], block: u64, rhythm: Rhythm) -> Self {
        let nothing = |needed: bool| vec![[0.0; 3]; if needed { pixels } else { 0 }];
        let rounds = rhythm.round > 1;
        Self {
            whole: Sums::new(pixels, layers),
            part: nothing(rounds),
            within: nothing(rounds && block == 0),
        }
    }

    /// The sums of one pixel.
    pub fn pixel(&self, index: usize) -> PixelSums {
        PixelSums {
            sum: self.whole.sums.get(index).copied().unwrap_or_default(),
            squares: self.whole.squares.get(index).copied().unwrap_or_default(),
            largest: self.whole.largest[index],
            part: self.part.get(index).copied().unwrap_or_default(),
            whole: !self.whole.sums.is_empty(),
            within: self.within.get(index).copied(),
        }
    }

    /// Puts the sums of a pixel back.
    pub fn put(&mut self, index: usize, pixel: &PixelSums) {
        if pixel.whole {
            self.whole.make_rounds();
            self.whole.sums[index] = pixel.sum;
            self.whole.squares[index] = pixel.squares;
        }
        self.whole.largest[index] = pixel.largest;
        if let Some(part) = self.part.get_mut(index) {
            *part = pixel.part;
        }
        if let Some(within) = pixel.within {
            self.within[index] = within;
        }
    }

    /// The sums of every layer of a pixel, of which there are so many.
    pub fn layers(&mut self, index: usize, layers: usize) -> &mut [[f64; 3]] {
        &mut self.whole.layers[index * layers..(index + 1) * layers]
    }

    /// What is counted beside light.
    pub fn counts(&mut self) -> &mut crate::render::tiles::Counts {
        &mut self.whole.counts
    }
}

impl PixelSums {
    /// Takes in sample number `nth` of the block, counted from 0.
    pub fn add(&mut self, value: [f64; 3], nth: u64, rhythm: Rhythm) {
        for (largest, value) in self.largest.iter_mut().zip(value) {
            *largest = largest.max(value.abs() as f32);
        }
        self.whole |= (nth + 1).is_multiple_of(rhythm.round);
        if rhythm.round == 1 {
            take(&mut self.sum, &mut self.squares, value, nth + 1);
            return;
        }
        let taken = nth + 1;
        if let Some(within) = self.within.as_mut().filter(|_| taken <= 2 * rhythm.round) {
            let [sum, part] = [self.sum, self.part];
            let mut all = [sum[0] + part[0], sum[1] + part[1], sum[2] + part[2]];
            take(&mut all, within, value, taken);
        }
        for (part, value) in self.part.iter_mut().zip(value) {
            *part += value;
        }
        if taken.is_multiple_of(rhythm.round) {
            take(&mut self.sum, &mut self.squares, self.part, taken / rhythm.round);
            self.part = [0.0; 3];
        }
    }
}

/// Takes in the n-th value, n from 1: its sum, and Σ(x − mean)² [Youngs71].
fn take(sum: &mut [f64; 3], squares: &mut [f64; 3], value: [f64; 3], n: u64) {
    for channel in 0..3 {
        sum[channel] += value[channel];
    }
    if n > 1 {
        let n = n as f64;
        let scale = 1.0 / (n * (n - 1.0));
        for channel in 0..3 {
            squares[channel] += square(n * value[channel] - sum[channel]) * scale;
        }
    }
}
