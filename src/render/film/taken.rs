//! The samples taken so far, tile by tile, in an order that nothing can change.
//!
//! Samples form fixed blocks. Within a block a pixel's samples are added round by round; blocks are
//! added in one fixed binary tree, of which the whole branches are kept. So a sum depends on which
//! samples went into it alone, not on how they were cut into passes, shards or sessions, and it errs
//! like a block and log₂(blocks) roundings of f64 instead of one for each sample.

use serde::{Deserialize, Serialize};

use super::begun::Begun;
use super::sums::Sums;
use super::{Film, Tile, Window};
use crate::math::MeanPixel;
use crate::render::samplers::Rhythm;
use crate::render::tiles::Counts;

/// What was taken of a film, or of a slice of its samples.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Taken {
    /// The first sample: a whole number of blocks, 0 but for a slice.
    first: u64,
    rhythm: Rhythm,
    /// Layers of each pixel.
    layers: usize,
    /// In the order of [`Film::tiles`].
    tiles: Vec<TileTaken>,
}

/// What was taken of one tile.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct TileTaken {
    /// One past the last sample taken, counted from the first of the whole render.
    end: u64,
    /// Whole branches of the tree over blocks, from the first block to the last.
    branches: Vec<Branch>,
    /// The block after these, if it is begun.
    begun: Option<Begun>,
}

/// The sums of the 2ˡᵉᵛᵉˡ blocks from index · 2ˡᵉᵛᵉˡ on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Branch {
    level: u32,
    index: u64,
    sums: Sums,
}

impl Branch {
    fn rounds(&self, rhythm: Rhythm) -> u64 {
        (rhythm.block / rhythm.round) << self.level
    }
}

/// What the samples of a tile tell of its pixels.
#[derive(Clone, Debug)]
pub struct TileMeans {
    /// Where it lies on the film.
    pub tile: Tile,
    /// Samples of each pixel; 0: there are none, and the means are 0.
    pub samples: u64,
    /// Degrees of freedom of each variance. 0: nothing is known of it, and it is 0.
    pub freedom: u64,
    /// Whether the variances are only bounds from above: there are no two rounds yet.
    pub bound: bool,
    /// Row by row from the top left, in W/m²/sr.
    pub pixels: Vec<MeanPixel>,
}

impl Taken {
    /// Nothing yet, of samples from `first` on, which is a whole number of blocks.
    pub fn new(film: &Film, rhythm: Rhythm, first: u64) -> Self {
        assert!(first.is_multiple_of(rhythm.block), "slices are of whole blocks");
        let nothing = TileTaken { end: first, branches: Vec::new(), begun: None };
        let tiles = vec![nothing; film.tiles().len()];
        Self { first, rhythm, layers: film.layers, tiles }
    }

    /// Whether this can be of such a part of a film with so many layers, and all parts of it fit
    /// together: to be asked of what was read from a file.
    pub fn fits(&self, window: &Window, layers: usize, rhythm: Rhythm) -> bool {
        if !window.has_tiles(self.tiles.len()) {
            return false;
        }
        let tiles = window.tiles();
        let whole = |tile: &Tile, taken: &TileTaken| {
            let pixels = tile.pixels() as usize;
            let mut block = self.first / rhythm.block;
            let last = taken.end / rhythm.block;
            let branches = taken.branches.iter().all(|branch| {
                let blocks = 1_u64.checked_shl(branch.level).unwrap_or(u64::MAX);
                let start = branch.index.checked_mul(blocks);
                let end = block.saturating_add(blocks);
                let sums = branch.sums.fits(pixels, layers, true);
                let fits = start == Some(block) && end <= last && sums;
                block = end;
                fits
            });
            let begun = taken.end.checked_sub(block.saturating_mul(rhythm.block));
            branches
                && match (&taken.begun, begun) {
                    (None, begun) => begun == Some(0),
                    (Some(sums), Some(begun)) => {
                        let like = Begun::new([pixels, 0], block, rhythm);
                        (1..rhythm.block).contains(&begun)
                            && sums.whole.fits(pixels, layers, begun >= rhythm.round)
                            && sums.part.len() == like.part.len()
                            && sums.within.len() == like.within.len()
                    }
                    (Some(_), None) => false,
                }
        };
        (self.layers, self.rhythm) == (layers, rhythm)
            && self.first.is_multiple_of(rhythm.block)
            && tiles.iter().zip(&self.tiles).all(|(tile, taken)| whole(tile, taken))
    }

    /// Whether it [fits](Self::fits) such a part of a film, with some sampler's rhythm: to be asked
    /// where there is no world.
    pub fn is_sound(&self, window: &Window, layers: usize) -> bool {
        self.rhythm.is_sound() && self.fits(window, layers, self.rhythm)
    }

    /// The first sample: 0 but for a slice.
    pub fn first(&self) -> u64 {
        self.first
    }

    /// One past the last sample of a tile.
    pub fn end(&self, tile: usize) -> u64 {
        self.tiles[tile].end
    }

    /// How many tiles there are.
    pub fn tiles(&self) -> usize {
        self.tiles.len()
    }

    /// One past the last sample of each tile.
    pub fn ends(&self) -> impl Iterator<Item = u64> {
        self.tiles.iter().map(|tile| tile.end)
    }

    /// The sums that the next samples of a tile go on from; None at the beginning of a block.
    pub fn begun(&self, tile: usize) -> Option<&Begun> {
        self.tiles[tile].begun.as_ref()
    }

    /// Puts the sums of a tile's block in, which has samples up to `end` now.
    pub fn put(&mut self, tile: usize, begun: Begun, end: u64) {
        let rhythm = self.rhythm;
        let taken = &mut self.tiles[tile];
        taken.end = end;
        if end.is_multiple_of(rhythm.block) {
            let branch = Branch { level: 0, index: end / rhythm.block - 1, sums: begun.whole };
            taken.begun = None;
            push(&mut taken.branches, branch, rhythm);
        } else {
            taken.begun = Some(begun);
        }
    }

    /// Adds the slice that follows, of the same film. None if it does not follow at once.
    pub fn join(mut self, next: Self) -> Option<Self> {
        let follows = (self.rhythm, self.layers) == (next.rhythm, next.layers)
            && self.tiles.len() == next.tiles.len()
            && self.tiles.iter().all(|tile| tile.begun.is_none() && tile.end == next.first);
        if !follows {
            return None;
        }
        for (tile, next) in self.tiles.iter_mut().zip(next.tiles) {
            for branch in next.branches {
                push(&mut tile.branches, branch, self.rhythm);
            }
            tile.begun = next.begun;
            tile.end = next.end;
        }
        Some(self)
    }

    /// What was counted in all tiles.
    pub fn counts(&self) -> Counts {
        let mut all = Counts::default();
        for tile in &self.tiles {
            tile.branches.iter().for_each(|branch| all.add(&branch.sums.counts));
            tile.begun.iter().for_each(|begun| all.add(&begun.whole.counts));
        }
        all
    }

    /// Bytes a pixel with so many layers while a render goes on to so many samples: the sums kept,
    /// and those of the pass at work.
    pub fn bytes_a_pixel(samples: u64, layers: usize, rhythm: Rhythm) -> u64 {
        let rounds = if samples < rhythm.round { 0 } else { 2 };
        let sums = ((rounds + layers) * size_of::<[f64; 3]>() + size_of::<[f32; 3]>()) as u64;
        let begun = if rhythm.round > 1 { 2 * size_of::<[f64; 3]>() as u64 } else { 0 };
        let branches = u64::from(u64::BITS - (samples / rhythm.block).leading_zeros());
        branches * sums + 2 * (sums + begun)
    }

    /// The means of every layer of the first pixel of a tile, of the second, and so on; nothing
    /// where there is no sample. `light_unit` as in [`crate::render::World`].
    pub fn layer_means(&self, tile: usize, light_unit: f64) -> Vec<[f64; 3]> {
        let taken = &self.tiles[tile];
        let Some((sums, _)) = self.sums(taken) else { return Vec::new() };
        let scale = light_unit / (taken.end - self.first) as f64;
        sums.layers.iter().map(|sum| sum.map(|value| value * scale)).collect()
    }

    /// Layers of each pixel.
    pub fn layers(&self) -> usize {
        self.layers
    }

    /// What the samples tell, tile by tile; `light_unit` as in [`crate::render::World`].
    pub fn means<'a>(
        &'a self,
        window: &Window,
        light_unit: f64,
    ) -> impl Iterator<Item = TileMeans> + use<'a> {
        let tiles = window.tiles();
        (0..tiles.len()).map(move |index| self.tile_means(index, tiles[index], light_unit))
    }

    fn tile_means(&self, index: usize, tile: Tile, light_unit: f64) -> TileMeans {
        let taken = &self.tiles[index];
        let samples = taken.end - self.first;
        let pixels = tile.pixels() as usize;
        let Some((sums, rounds)) = self.sums(taken) else {
            let pixels = vec![MeanPixel::default(); pixels];
            return TileMeans { tile, samples: 0, freedom: 0, bound: false, pixels };
        };
        let n = samples as f64;
        let round = self.rhythm.round as f64;
        let within = taken.begun.as_ref().filter(|begun| rounds < 2 && !begun.within.is_empty());
        // The variance of the mean, from Σ(y − mean)² of rounds, or of samples.
        let (squares, per_square, freedom) = match within {
            Some(begun) => (&begun.within, 1.0 / (n * (n - 1.0)), samples.saturating_sub(1)),
            None => {
                let k = rounds as f64;
                (&sums.squares, 1.0 / ((k - 1.0) * round * n), rounds.saturating_sub(1))
            }
        };
        let part = taken.begun.as_ref().map(|begun| &begun.part);
        let pixel = |i: usize| {
            let part = part.and_then(|part| part.get(i)).copied().unwrap_or_default();
            let each = |value: &dyn Fn(usize) -> f64| [value(0), value(1), value(2)];
            let scale = light_unit / n;
            MeanPixel {
                mean: each(&|c| (sums.sums[i][c] + part[c]) * scale),
                variance: match freedom {
                    0 => [0.0; 3],
                    _ => each(&|c| squares[i][c] * per_square * light_unit * light_unit),
                },
                largest: each(&|c| f64::from(sums.largest[i][c]) * scale),
            }
        };
        TileMeans {
            tile,
            samples,
            freedom,
            bound: within.is_some(),
            pixels: (0..pixels).map(pixel).collect(),
        }
    }

    /// The sum of everything: of a block begun, if there is one, and the branches, small before
    /// large; and the rounds that are whole. None if there is nothing.
    fn sums(&self, taken: &TileTaken) -> Option<(Sums, u64)> {
        let block = self.rhythm.block;
        let begun_rounds = (taken.end % block) / self.rhythm.round;
        let begun = taken.begun.as_ref().map(|begun| (&begun.whole, begun_rounds));
        let branches = taken.branches.iter().rev();
        let mut parts =
            begun.into_iter().chain(branches.map(|it| (&it.sums, it.rounds(self.rhythm))));
        let (first, mut rounds) = parts.next()?;
        let mut sums = first.clone().with_rounds();
        for (part, others) in parts {
            sums.add(rounds, part, others);
            rounds += others;
        }
        Some((sums, rounds))
    }
}

/// Adds a branch behind the others; two that make a whole become it.
fn push(branches: &mut Vec<Branch>, mut branch: Branch, rhythm: Rhythm) {
    let sibling = |last: &Branch, branch: &Branch| {
        last.level == branch.level && last.index.is_multiple_of(2) && last.index + 1 == branch.index
    };
    while let Some(last) = branches.pop_if(|last| sibling(last, &branch)) {
        let rounds = branch.rounds(rhythm);
        let mut sums = last.sums;
        sums.add(rounds, &branch.sums, rounds);
        branch = Branch { level: last.level + 1, index: last.index / 2, sums };
    }
    branches.push(branch);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::film::Filter;
    use crate::render::samplers::Sampler;

    /// Mean, and variance of one value, in two passes.
    fn moments(values: impl Iterator<Item = f64>) -> (f64, f64) {
        let values: Vec<f64> = values.collect();
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
        (mean, squares / (n - 1.0))
    }

    const ROUNDS: Rhythm = Rhythm { round: 4, block: 12 };
    const SINGLE: Rhythm = Rhythm { round: 1, block: 6 };

    fn film() -> Film {
        let window = Window { x0: 0, y0: 0, x1: 1, y1: 1 };
        Film { size: [1, 1], window, filter: Filter::Box { radius: 0.5 }, layers: 2 }
    }

    /// Sample i of the only pixel: irregular, and of a large mean.
    fn value(i: u64) -> f64 {
        1000.0 + crate::math::random::unit_pair(crate::math::random::mix(i))[0]
    }

    /// Takes samples from the end of what was taken up to the next of `cuts`, and so on.
    fn take(mut taken: Taken, rhythm: Rhythm, cuts: &[u64]) -> Taken {
        for &end in cuts {
            let start = taken.end(0);
            let fresh = || Begun::new([1, 2], start / rhythm.block, rhythm);
            let mut begun = taken.begun(0).cloned().unwrap_or_else(fresh);
            let mut pixel = begun.pixel(0);
            for i in start..end {
                pixel.add([value(i), -value(i), 0.0], i % rhythm.block, rhythm);
                begun.counts().rays += 1;
                for (layer, sum) in begun.layers(0, 2).iter_mut().enumerate() {
                    sum[layer] += value(i) / 3.0;
                }
            }
            begun.put(0, &pixel);
            taken.put(0, begun, end);
        }
        taken
    }

    fn from(first: u64, rhythm: Rhythm, cuts: &[u64]) -> Taken {
        take(Taken::new(&film(), rhythm, first), rhythm, cuts)
    }

    fn means(taken: &Taken) -> TileMeans {
        taken.means(&film().window, 1.0).next().unwrap()
    }

    #[test]
    fn means_and_variances_are_those_of_the_samples() {
        for end in [2, 5, 6, 7, 12, 36, 42, 45] {
            let mut cuts: Vec<u64> = (6..end).step_by(6).collect();
            cuts.push(end);
            let told = means(&from(0, SINGLE, &cuts));
            let (mean, variance) = moments((0..end).map(value));
            assert_eq!((told.samples, told.freedom, told.bound), (end, end - 1, false));
            let pixel = told.pixels[0];
            assert!((pixel.mean[0] - mean).abs() < 1e-9);
            assert!((pixel.variance[0] / (variance / end as f64) - 1.0).abs() < 1e-9, "{end}");
            assert_eq!((pixel.mean[1], pixel.variance[1]), (-pixel.mean[0], pixel.variance[0]));
            assert_eq!(pixel.variance[2], 0.0);
            let largest = (0..end).map(value).fold(0.0, f64::max) / end as f64;
            assert!((pixel.largest[0] / largest - 1.0).abs() < 1e-6);
            let layers = from(0, SINGLE, &cuts).layer_means(0, 1.0);
            assert_eq!((layers[0][1], layers[1][0], layers.len()), (0.0, 0.0, 2));
            assert!([layers[0][0], layers[1][1]].iter().all(|x| (3.0 * x - mean).abs() < 1e-9));
        }
    }

    #[test]
    fn the_variance_is_that_of_rounds_once_there_are_two() {
        for end in [8, 11, 12, 24, 30, 60, 63] {
            let mut cuts: Vec<u64> = (12..end).step_by(12).collect();
            cuts.push(end);
            let told = means(&from(0, ROUNDS, &cuts));
            let rounds = end / 4;
            let round = |j: u64| (4 * j..4 * j + 4).map(value).sum::<f64>() / 4.0;
            let (_, of_rounds) = moments((0..rounds).map(round));
            let (mean, _) = moments((0..end).map(value));
            assert_eq!((told.freedom, told.bound), (rounds - 1, false), "{end}");
            assert!((told.pixels[0].mean[0] - mean).abs() < 1e-9);
            let variance = of_rounds * 4.0 / end as f64;
            assert!((told.pixels[0].variance[0] / variance - 1.0).abs() < 1e-8, "{end}");
        }
    }

    #[test]
    fn before_two_rounds_samples_bound_it() {
        for end in [2, 3, 4, 7] {
            let told = means(&from(0, ROUNDS, &[end]));
            let variance = moments((0..end).map(value)).1 / end as f64;
            assert_eq!((told.freedom, told.bound), (end - 1, true));
            assert!((told.pixels[0].variance[0] / variance - 1.0).abs() < 1e-9, "{end}");
        }
        let one = means(&from(0, ROUNDS, &[1]));
        assert_eq!((one.freedom, one.pixels[0].variance), (0, [0.0; 3]));
        assert_eq!(means(&Taken::new(&film(), ROUNDS, 0)).samples, 0);
    }

    #[test]
    fn cuts_and_slices_change_no_bit() {
        let blocks =
            |range: std::ops::RangeInclusive<u64>| range.map(|b| b * 12).collect::<Vec<_>>();
        let mut whole = blocks(1..=13);
        whole.push(159);
        let whole = from(0, ROUNDS, &whole);
        let mut fine: Vec<u64> = (1..=159).collect();
        assert_eq!(from(0, ROUNDS, &fine), whole);
        for cuts in [[1, 2], [3, 11], [5, 6], [8, 12]] {
            fine = blocks(cuts[1] + 1..=13);
            fine.push(159);
            let slices = [
                from(0, ROUNDS, &blocks(1..=cuts[0])),
                from(cuts[0] * 12, ROUNDS, &blocks(cuts[0] + 1..=cuts[1])),
                from(cuts[1] * 12, ROUNDS, &fine),
            ];
            let [a, b, c] = slices;
            assert!(a.clone().join(c.clone()).is_none(), "there is a gap");
            assert!(c.clone().join(a.clone()).is_none(), "the end is not the beginning");
            assert_eq!(a.join(b).unwrap().join(c).unwrap(), whole);
        }
    }

    #[test]
    fn many_blocks_keep_their_digits() {
        // Twenty million samples of about a thousand, of which f32 would have lost four fifths.
        let rhythm = Sampler::Independent.rhythm();
        let mut taken = Taken::new(&film(), rhythm, 0);
        let mut block = Begun::new([1, 2], 1, rhythm);
        let mut pixel = block.pixel(0);
        (0..64).for_each(|i| pixel.add([0.1; 3], i, rhythm));
        block.put(0, &pixel);
        for i in 1..=20_000_000 / 64 {
            taken.put(0, block.clone(), i * 64);
        }
        let told = means(&taken);
        assert!((told.pixels[0].mean[0] / 0.1 - 1.0).abs() < 1e-14, "{:?}", told.pixels[0]);
        assert!(told.pixels[0].variance[0].sqrt() < 1e-12);
    }

    #[test]
    fn what_does_not_fit_together_is_refused() {
        let good = from(0, ROUNDS, &[12, 24, 36, 40]);
        assert!(good.fits(&film().window, 2, ROUNDS));
        assert!(from(24, ROUNDS, &[36, 48]).fits(&film().window, 2, ROUNDS));
        assert!(Taken::new(&film(), ROUNDS, 12).fits(&film().window, 2, ROUNDS));
        assert!(!good.fits(&film().window, 2, SINGLE));
        let mut wide = film();
        wide.window.x1 = 2;
        assert!(!good.fits(&wide.window, 2, ROUNDS));
        type Break = fn(&mut TileTaken);
        assert!(!good.fits(&film().window, 3, ROUNDS));
        let breaks: [Break; 10] = [
            |tile| tile.end = 41 + 12,
            |tile| tile.end = 36,
            |tile| tile.end = u64::MAX,
            |tile| tile.begun = None,
            |tile| drop(tile.branches.remove(0)),
            |tile| tile.branches[0].level = 64,
            |tile| tile.branches[1].index = u64::MAX,
            |tile| tile.branches[0].sums.squares.clear(),
            |tile| tile.branches[0].sums.layers.clear(),
            |tile| tile.begun.as_mut().unwrap().part.push([0.0; 3]),
        ];
        for (i, change) in breaks.into_iter().enumerate() {
            let mut bad = good.clone();
            change(&mut bad.tiles[0]);
            assert!(!bad.fits(&film().window, 2, ROUNDS), "{i}");
        }
        let mut bad = good.clone();
        bad.first = 5;
        assert!(!bad.fits(&film().window, 2, ROUNDS));
    }
}
