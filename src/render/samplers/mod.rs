//! Samplers: streams of random numbers. Each is a pure function of (seed, pixel, sample,
//! dimension); two dimensions are stratified together, dimensions among each other are not
//! (padding: an independent shuffle each).

use serde::{Deserialize, Serialize};

use crate::math::random;

/// Where the random numbers come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampler {
    /// Every number by itself.
    Independent,
    /// Jittered: grid × grid cells, each sample in a cell of its own.
    Stratified {
        /// Cells along each side, 1 to 1024.
        grid: u32,
    },
}

/// How samples belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Rhythm {
    /// So many samples are spread evenly together; only rounds are independent of each other.
    pub round: u64,
    /// Whole rounds, at least two, that are summed apart from others: what a render is cut into.
    pub block: u64,
}

impl Rhythm {
    /// Whether samples can belong together so: to be asked of what was read from a file.
    pub fn is_sound(&self) -> bool {
        let Self { round, block } = *self;
        (1..=MOST_ROUND).contains(&round)
            && block == LEAST_BLOCK.max(2 * round).next_multiple_of(round)
    }
}

/// No sampler spreads more samples together.
const MOST_ROUND: u64 = 1024 * 1024;

/// A block has at least so many samples. Changing it changes the last bits of every picture.
const LEAST_BLOCK: u64 = 64;

impl Sampler {
    /// How samples belong together.
    pub fn rhythm(&self) -> Rhythm {
        let round = match *self {
            Self::Independent => 1,
            Self::Stratified { grid } => u64::from(grid) * u64::from(grid),
        };
        Rhythm { round, block: LEAST_BLOCK.max(2 * round).next_multiple_of(round) }
    }

    /// The numbers of one sample of one pixel. `pixel` counts through the whole film, so that a
    /// crop sees the numbers the whole picture sees.
    pub fn stream(&self, seed: u64, pixel: u64, sample: u64) -> Stream {
        let pixel = random::at(random::mix(seed), pixel);
        match *self {
            Self::Independent => {
                Stream { place: random::at(pixel, sample), dimension: 0, strata: None }
            }
            Self::Stratified { grid } => {
                let cells = u64::from(grid) * u64::from(grid);
                let index = (sample % cells) as u32;
                let strata = Strata { grid, index, round: random::at(!pixel, sample / cells) };
                Stream { place: random::at(pixel, sample), dimension: 0, strata: Some(strata) }
            }
        }
    }
}

/// The cells of a sample's round: grid² samples that fill every cell once.
#[derive(Clone, Copy, Debug)]
struct Strata {
    grid: u32,
    /// Which sample of the round it is.
    index: u32,
    /// The round: it chooses the order in which cells are filled, anew for every dimension.
    round: u64,
}

/// The numbers of one sample, taken one dimension after the other.
#[derive(Clone, Debug)]
pub struct Stream {
    place: u64,
    dimension: u64,
    strata: Option<Strata>,
}

impl Stream {
    /// The next two numbers, uniform in [0, 1)².
    pub fn pair(&mut self) -> [f64; 2] {
        let dimension = self.dimension;
        self.dimension += 1;
        let [x, y] = random::unit_pair(random::at(self.place, dimension));
        let Some(Strata { grid, index, round }) = self.strata else { return [x, y] };
        let cell = random::shuffled(index, grid * grid, random::at(round, dimension));
        let side = f64::from(grid);
        [(f64::from(cell % grid) + x) / side, (f64::from(cell / grid) + y) / side]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::chi_squared;

    const STRATIFIED: Sampler = Sampler::Stratified { grid: 4 };

    fn bin([x, y]: [f64; 2], side: usize) -> usize {
        assert!((0.0..1.0).contains(&x) && (0.0..1.0).contains(&y));
        (y * side as f64) as usize * side + (x * side as f64) as usize
    }

    #[test]
    fn each_round_fills_each_cell_once_in_each_dimension() {
        for (pixel, round) in [(0, 0), (77, 0), (77, 1), (1 << 40, 1_000_000)] {
            let mut seen = [[false; 16]; 3];
            for i in 0..16 {
                let mut stream = STRATIFIED.stream(1, pixel, round * 16 + i);
                seen.iter_mut().for_each(|cells| cells[bin(stream.pair(), 4)] = true);
            }
            assert_eq!(seen, [[true; 16]; 3]);
        }
    }

    #[test]
    fn every_sample_is_uniform_by_itself() {
        // So every prefix of a round is unbiased, not only whole rounds.
        for sampler in [Sampler::Independent, STRATIFIED, Sampler::Stratified { grid: 3 }] {
            for sample in [0, 1, 8, 15, 16, 1_000_003] {
                for dimension in 0..2 {
                    let mut counts = [0; 64];
                    for pixel in 0..20_000 {
                        let mut stream = sampler.stream(5, pixel, sample);
                        (0..dimension).for_each(|_| _ = stream.pair());
                        counts[bin(stream.pair(), 8)] += 1;
                    }
                    chi_squared::assert_fits(&counts, &[1.0 / 64.0; 64]);
                }
            }
        }
    }

    #[test]
    fn dimensions_rounds_pixels_and_seeds_are_independent() {
        let first = |seed, pixel, sample| STRATIFIED.stream(seed, pixel, sample).pair();
        let mut counts = [[0; 256]; 4];
        for i in 0..40_000 {
            let mut stream = STRATIFIED.stream(3, i, 5);
            let a = bin(stream.pair(), 4);
            let others = [stream.pair(), first(3, i, 21), first(3, i + 1, 5), first(4, i, 5)];
            for (counts, b) in counts.iter_mut().zip(others) {
                counts[a * 16 + bin(b, 4)] += 1;
            }
        }
        counts.iter().for_each(|c| chi_squared::assert_fits(c, &[1.0 / 256.0; 256]));
    }
}
