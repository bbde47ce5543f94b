//! Samplers: streams of random numbers. Each is a pure function of (seed, pixel, sample,
//! dimension). Numbers come in fours, which are spread evenly together: by `sobol` all four, by
//! `stratified` two and two. Fours among each other are not (padding: an independent shuffle each).

mod fours;
mod sobol;

pub use fours::Fours;

use serde::{Deserialize, Serialize};

use crate::math::random;

/// Where the random numbers come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampler {
    /// Every number by itself.
    Independent,
    /// Owen-scrambled Sobol points, scrambled anew for each pixel and round [Burley20].
    Sobol {
        /// Samples of a round, 1 to 65,536.
        round: u32,
    },
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
            Self::Sobol { round } => u64::from(round),
            Self::Stratified { grid } => u64::from(grid) * u64::from(grid),
        };
        Rhythm { round, block: LEAST_BLOCK.max(2 * round).next_multiple_of(round) }
    }

    /// The numbers of one sample of one pixel. `pixel` counts through the whole film, so that a
    /// crop sees the numbers the whole picture sees.
    pub fn stream(&self, seed: u64, pixel: u64, sample: u64) -> Stream {
        let pixel = random::at(random::mix(seed), pixel);
        let own = random::at(pixel, sample);
        let round = |length: u64| (random::at(!pixel, sample / length), (sample % length) as u32);
        let spread = match *self {
            Self::Independent => Spread::None,
            Self::Sobol { round: length } => {
                let (round, index) = round(u64::from(length));
                Spread::Sobol { round, index }
            }
            Self::Stratified { grid } => {
                let (round, index) = round(u64::from(grid) * u64::from(grid));
                Spread::Strata(Strata { grid, index, round })
            }
        };
        Stream { own, dimension: 0, spread }
    }
}

/// How the numbers of a sample are spread among those of others.
#[derive(Clone, Copy, Debug)]
enum Spread {
    None,
    Strata(Strata),
    Sobol {
        /// The round: it chooses the scrambles, anew for every dimension.
        round: u64,
        /// Which sample of the round it is.
        index: u32,
    },
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

/// The numbers of one sample, taken one dimension after the other. A dimension has four numbers.
#[derive(Clone, Debug)]
pub struct Stream {
    /// Of this sample alone.
    own: u64,
    dimension: u64,
    spread: Spread,
}

impl Stream {
    /// The next two numbers, uniform in [0, 1)².
    #[inline(always)]
    pub fn pair(&mut self) -> [f64; 2] {
        let [a, b, ..] = self.four();
        [a, b]
    }

    /// The next four numbers, uniform in [0, 1)⁴.
    #[inline(always)]
    pub fn four(&mut self) -> [f64; 4] {
        self.fan(1).four(0)
    }

    /// The next numbers for so many rays that go on side by side: four for each of them. What is
    /// not asked for costs nothing.
    #[inline(always)]
    pub fn fan(&mut self, count: u32) -> Fan {
        let dimension = self.dimension;
        self.dimension += 1;
        Fan { own: self.own, dimension, spread: self.spread, count }
    }
}

/// So many dimensions are spread evenly. Those beyond are hashes, which are quicker: what they
/// decide is too far from the camera for their spread to matter.
const LEADING: u64 = 8;

/// sobol_burley knows no points beyond.
const MOST_POINTS: u64 = 1 << 16;

/// Numbers for several rays of one sample that go on side by side: spread evenly among each other
/// and among those of other samples.
#[derive(Clone, Copy, Debug)]
pub struct Fan {
    own: u64,
    dimension: u64,
    spread: Spread,
    count: u32,
}

impl Fan {
    /// The four numbers of the `nth`, uniform in [0, 1)⁴.
    #[inline(always)]
    pub fn four(&self, nth: u32) -> [f64; 4] {
        debug_assert!(nth < self.count);
        if !matches!(self.spread, Spread::None)
            && self.dimension < LEADING
            && let Some(spread) = self.spread_four(nth)
        {
            return spread;
        }
        let bits = random::at(self.own, self.place(nth));
        let ([a, b], [c, d]) = (random::unit_pair(bits), random::unit_pair(random::mix(bits)));
        [a, b, c, d]
    }

    #[inline(always)]
    fn place(&self, nth: u32) -> u64 {
        self.dimension | u64::from(nth) << 32
    }

    /// The same, spread evenly; None if there are no points left for them.
    #[inline(never)]
    fn spread_four(&self, nth: u32) -> Option<[f64; 4]> {
        match self.spread {
            Spread::None => None,
            Spread::Sobol { round, index } => {
                let point = u64::from(index) * u64::from(self.count) + u64::from(nth);
                let scramble = random::at(round, self.dimension) as u32;
                let point = (point < MOST_POINTS).then_some(point as u32)?;
                Some(sobol::four(point, scramble))
            }
            Spread::Strata(strata) => {
                let bits = random::at(self.own, self.place(nth));
                let order = random::at(strata.round, self.place(nth));
                let [a, b] = strata.jittered(random::unit_pair(bits), order);
                let [c, d] = strata.jittered(random::unit_pair(random::mix(bits)), !order);
                Some([a, b, c, d])
            }
        }
    }
}

impl Strata {
    /// Two numbers moved into the cell of the square that is this sample's turn.
    fn jittered(&self, [x, y]: [f64; 2], key: u64) -> [f64; 2] {
        let cell = random::shuffled(self.index, self.grid * self.grid, key);
        let side = f64::from(self.grid);
        [(f64::from(cell % self.grid) + x) / side, (f64::from(cell / self.grid) + y) / side]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::chi_squared;

    const STRATIFIED: Sampler = Sampler::Stratified { grid: 4 };
    const SOBOL: Sampler = Sampler::Sobol { round: 64 };

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
        let stratified = Sampler::Stratified { grid: 3 };
        for sampler in [Sampler::Independent, STRATIFIED, stratified, SOBOL] {
            for sample in [0, 1, 8, 15, 16, 1_000_003] {
                for dimension in 0..3 {
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
        for (sampler, round) in [(STRATIFIED, 16), (SOBOL, 64)] {
            let first = |seed, pixel, sample| sampler.stream(seed, pixel, sample).pair();
            let mut counts = [[0; 256]; 5];
            for i in 0..40_000 {
                let mut stream = sampler.stream(3, i, 5);
                let a = bin(stream.pair(), 4);
                let others = [
                    stream.pair(),
                    stream.pair(),
                    first(3, i, 5 + round),
                    first(3, i + 1, 5),
                    first(4, i, 5),
                ];
                for (counts, b) in counts.iter_mut().zip(others) {
                    counts[a * 16 + bin(b, 4)] += 1;
                }
            }
            counts.iter().for_each(|c| chi_squared::assert_fits(c, &[1.0 / 256.0; 256]));
        }
    }

    #[test]
    fn sobol_fills_every_elementary_interval() {
        // Any 2ⁿ first samples of a round of at least so many: each box of 2⁻ᵃ × 2⁻ᵇ with
        // a + b = n holds one. (Of the second of two pairs that is nearly so.)
        for (pixel, round, dimension) in [(0, 0, 0), (5, 0, 0), (9, 3, 2), (1 << 40, 77, 4)] {
            for n in 0..=6_u32 {
                let points: Vec<[f64; 2]> = (0..1_u64 << n)
                    .map(|i| {
                        let mut stream = SOBOL.stream(1, pixel, round * 64 + i);
                        (0..dimension).for_each(|_| _ = stream.pair());
                        stream.pair()
                    })
                    .collect();
                for a in 0..=n {
                    let (columns, rows) = (f64::from(1 << a), f64::from(1 << (n - a)));
                    let cell = |[x, y]: &[f64; 2]| ((x * columns) as u32, (y * rows) as u32);
                    let seen: std::collections::HashSet<_> = points.iter().map(cell).collect();
                    assert_eq!(seen.len(), points.len(), "{n} {a}");
                }
            }
        }
    }

    #[test]
    fn numbers_beyond_the_leading_ones_are_uniform_and_of_each_sample_alone() {
        for sampler in [Sampler::Independent, STRATIFIED, SOBOL] {
            let mut counts = vec![0; 256];
            let at = |sample| {
                let mut stream = sampler.stream(2, 9, sample);
                (0..LEADING + 1).for_each(|_| _ = stream.fan(1));
                let [_, b, c, _] = stream.fan(3).four((sample % 3) as u32);
                bin([b, c], 4)
            };
            (0..40_000).for_each(|i| counts[at(2 * i) * 16 + at(2 * i + 1)] += 1);
            chi_squared::assert_fits(&counts, &[1.0 / 256.0; 256]);
        }
    }

    #[test]
    fn those_that_go_on_side_by_side_are_spread_like_as_many_samples() {
        // 16 samples of 4 each: a round of 64 points, which fill 8 × 8 cells.
        for pixel in 0..5 {
            let mut seen = [false; 64];
            for sample in 0..16 {
                let fan = SOBOL.stream(1, pixel, sample).fan(4);
                (0..4).for_each(|nth| {
                    let [a, b, ..] = fan.four(nth);
                    seen[bin([a, b], 8)] = true;
                });
            }
            assert_eq!(seen, [true; 64]);
        }
        // Too many for the points there are: plain numbers, and none twice.
        let fan = Sampler::Sobol { round: 65_536 }.stream(1, 0, 60_000).fan(1024);
        let firsts: std::collections::BTreeSet<u64> =
            (0..1024).map(|nth| fan.four(nth)[0].to_bits()).collect();
        assert_eq!(firsts.len(), 1024);
    }

    #[test]
    fn evenly_spread_samples_err_less() {
        // Root mean square error of the area of a quarter disk, and of a smooth product of two
        // pairs, by 64 samples: against independent ones.
        let error = |sampler: Sampler, value: fn([f64; 2], [f64; 2]) -> f64, truth: f64| {
            let pixels = 2000;
            let of_pixel = |pixel: u64| {
                let sample = |i: u64| {
                    let [a, b, c, d] = sampler.stream(7, pixel, i).four();
                    value([a, b], [c, d])
                };
                ((0..64).map(sample).sum::<f64>() / 64.0 - truth).powi(2)
            };
            ((0..pixels).map(of_pixel).sum::<f64>() / pixels as f64).sqrt()
        };
        let disk = |[x, y]: [f64; 2], _: [f64; 2]| f64::from(u8::from(x * x + y * y < 1.0));
        let area = std::f64::consts::FRAC_PI_4;
        let independent = error(Sampler::Independent, disk, area);
        let jittered = error(Sampler::Stratified { grid: 8 }, disk, area);
        let sobol = error(SOBOL, disk, area);
        assert!(sobol < 0.4 * independent && sobol < jittered, "{independent} {jittered} {sobol}");
        let product = |[x, y]: [f64; 2], [z, w]: [f64; 2]| x * y * z * w;
        let independent = error(Sampler::Independent, product, 1.0 / 16.0);
        let sobol = error(SOBOL, product, 1.0 / 16.0);
        assert!(sobol < 0.4 * independent, "{independent} {sobol}");
    }
}
