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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::film::{Filter, Window};

    fn block(value: f64) -> Sums {
        vec![TileSums { pixels: vec![[value, 2.0 * value, -value]], counts: Counts::default() }]
    }

    fn sum(total: &Total, begun: Option<&Sums>) -> f64 {
        total.with(begun).map_or(0.0, |sums| sums[0].pixels[0][0])
    }

    #[test]
    fn blocks_are_added_as_a_binary_tree() {
        let values: Vec<f64> = (0..13).map(|i| 1.0 / (f64::from(i) + 3.0)).collect();
        let mut total = Total::default();
        assert!(total.with(None).is_none());
        values.iter().for_each(|value| total.push(block(*value)));
        let pair = |v: &[f64]| v[0] + v[1];
        let four = |v: &[f64]| pair(&v[..2]) + pair(&v[2..4]);
        let eight = four(&values[..4]) + four(&values[4..8]);
        // 13 = 8 + 4 + 1: small before large.
        assert_eq!(sum(&total, None), (values[12] + four(&values[8..12])) + eight);
        let begun = block(1e-3);
        assert_eq!(sum(&total, Some(&begun)), ((1e-3 + values[12]) + four(&values[8..12])) + eight);
        assert_eq!(Total::digits_after(13 * BLOCK), 4);
        assert_eq!(Total::digits_after(BLOCK - 1), 0);
    }

    #[test]
    fn many_blocks_keep_their_digits() {
        // A hundred million samples of 0.1, of which f32 would have lost four fifths.
        let mut total = Total::default();
        let blocks = 100_000_000 / BLOCK;
        (0..blocks).for_each(|_| total.push(block(0.1 * BLOCK as f64)));
        let mean = sum(&total, None) / (blocks * BLOCK) as f64;
        assert!((mean / 0.1 - 1.0).abs() < 1e-14, "{mean}");
    }

    #[test]
    fn what_is_too_bright_for_a_picture_is_clipped_and_counted() {
        let window = Window { x0: 0, y0: 0, x1: 1, y1: 1 };
        let film = Film { size: [1, 1], window, filter: Filter::Box { radius: 0.5 } };
        let developed = film.develop(block(4.0).iter().map(Some), 2, 1e38);
        assert_eq!(developed.clipped, 1);
        assert_eq!(developed.picture.at(0, 0), Rgb::new(2e38, f32::MAX, -2e38));
        assert_eq!(film.develop(block(4.0).iter().map(Some), 2, 1.0).clipped, 0);
        assert_eq!(film.develop([None], 2, 1.0).picture.at(0, 0), Rgb::BLACK);
    }
}
