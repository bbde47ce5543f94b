//! Sums over samples, in an order that nothing can change.
//!
//! Samples form fixed blocks of [`BLOCK`]. Within a block a pixel's samples are added one after
//! the other; blocks are added in one fixed binary tree, kept as a binary counter. So the sum
//! depends on the number of samples alone, not on how they were cut into passes, and it errs like
//! BLOCK + log₂(blocks) roundings of f64 instead of one for each sample. A block is a unit that
//! can be computed, kept and sent by itself.

use super::{Film, Window};
use crate::math::{Picture, Rgb};
use crate::render::tiles::{Counts, TileSums};

/// Samples of each pixel in a block. Changing it changes the last bits of every picture.
pub const BLOCK: u64 = 64;

/// The sums of a film's tiles, in the order of [`Film::tiles`].
pub type Sums = Vec<TileSums>;

/// Sums of whole blocks: a binary counter, whose digit of 2ⁿ holds the sum of 2ⁿ blocks.
#[derive(Clone, Debug, Default)]
pub struct Total {
    digits: Vec<Option<Sums>>,
}

impl Total {
    /// Adds the next block.
    pub fn push(&mut self, block: Sums) {
        let mut carry = block;
        for digit in &mut self.digits {
            match digit.take() {
                None => return *digit = Some(carry),
                Some(mut earlier) => {
                    add(&mut earlier, &carry);
                    carry = earlier;
                }
            }
        }
        self.digits.push(Some(carry));
    }

    /// The sum of everything: of a block begun, if there is one, and the whole ones, small before
    /// large. None if there is nothing.
    pub fn with(&self, begun: Option<&Sums>) -> Option<Sums> {
        let mut parts = begun.into_iter().chain(self.digits.iter().flatten());
        let mut sum = parts.next()?.clone();
        parts.for_each(|part| add(&mut sum, part));
        Some(sum)
    }

    /// Digits of the counter after so many samples: each holds as much as one film.
    pub fn digits_after(samples: u64) -> u32 {
        u64::BITS - (samples / BLOCK).leading_zeros()
    }
}

fn add(sum: &mut Sums, other: &Sums) {
    for (sum, other) in sum.iter_mut().zip(other) {
        for (sum, other) in sum.pixels.iter_mut().flatten().zip(other.pixels.iter().flatten()) {
            *sum += other;
        }
        sum.counts.add(&other.counts);
    }
}

/// A picture, and how many of its pixels were brighter than a picture can tell.
#[derive(Clone, Debug, PartialEq)]
pub struct Developed {
    /// The window of the film, in W/m²/sr.
    pub picture: Picture,
    /// Pixels beyond the largest f32, which stand at the largest f32.
    pub clipped: u64,
}

impl Film {
    /// Sums over `samples` samples as a picture; tiles that are None are black.
    pub fn develop<'a>(
        &self,
        sums: impl IntoIterator<Item = Option<&'a TileSums>>,
        samples: u64,
        light_unit: f64,
    ) -> Developed {
        let Window { x0, y0, .. } = self.window;
        let mut picture =
            Picture::black(self.window.width() as usize, self.window.height() as usize);
        let mut clipped = 0;
        let limit = f64::from(f32::MAX);
        for (tile, sums) in self.tiles().iter().zip(sums) {
            let Some(sums) = sums else { continue };
            for ((x, y), sum) in tile.places().zip(&sums.pixels) {
                let [r, g, b] = sum.map(|sum| sum / samples as f64 * light_unit);
                clipped += u64::from([r, g, b].iter().any(|value| value.abs() > limit));
                let [r, g, b] = [r, g, b].map(|value| value.clamp(-limit, limit) as f32);
                let place = (y - y0) as usize * picture.width + (x - x0) as usize;
                picture.pixels[place] = Rgb::new(r, g, b);
            }
        }
        Developed { picture, clipped }
    }
}

/// What was counted in all tiles.
pub fn counts<'a>(sums: impl IntoIterator<Item = &'a TileSums>) -> Counts {
    let mut all = Counts::default();
    sums.into_iter().for_each(|tile| all.add(&tile.counts));
    all
}
