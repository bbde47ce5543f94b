//! Whether two pictures have the same expectation, block by block: a z-test where each pixel
//! knows its variance, Welch's t where there are batches [Jung20]. Each of the many blocks is
//! held to a level that leaves the stated chance for all of them together [Sidak67].

use std::fmt;

use super::distributions::{sidak, student_t_two_sided};
use super::estimate::{Estimate, ROUNDING, components};
use super::moments::Moments;
use crate::math::Picture;

/// What all blocks together say; printed, it tells its figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Blocks times channels.
    pub tests: u64,
    /// The chance that two pictures of equal expectation are refused.
    pub alpha: f64,
    /// The level each block was held to.
    pub level: f64,
    /// How many fell below it.
    pub refused: u64,
    /// The least likely block.
    pub worst: Option<Extreme>,
}

/// One channel of one block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// Left column.
    pub x: usize,
    /// Top row.
    pub y: usize,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// 0 red, 1 green, 2 blue.
    pub channel: usize,
    /// Mean of the block in the first picture.
    pub a: f64,
    /// Mean of the block in the second.
    pub b: f64,
    /// Standard error of their difference.
    pub standard_error: f64,
    /// The difference, less what rounding may have made, in standard errors.
    pub score: f64,
    /// How likely so large a score is by accident.
    pub p: f64,
}

impl Outcome {
    /// Whether no block is refused (and there was one to refuse).
    pub fn agrees(&self) -> bool {
        self.tests > 0 && self.refused == 0
    }

    fn of(extremes: impl Iterator<Item = Extreme>, alpha: f64) -> Self {
        let all: Vec<Extreme> = extremes.collect();
        let level = sidak(alpha, all.len() as u64);
        let refused = all.iter().filter(|it| it.p < level).count() as u64;
        let worst = all.iter().copied().min_by(|a, b| {
            // Where both are too unlikely for an f64, the larger score is the worse.
            a.p.total_cmp(&b.p).then(b.score.abs().total_cmp(&a.score.abs()))
        });
        Self { tests: all.len() as u64, alpha, level, refused, worst }
    }
}

/// Welch's test of two means with unequal variances: the difference in standard errors, its
/// degrees of freedom [Welch47], and how likely so large a difference is by accident.
///
/// # Panics
/// If either has fewer than two values.
pub fn welch(a: &Moments, b: &Moments) -> (f64, f64, f64) {
    assert!(a.count() >= 2 && b.count() >= 2, "a variance needs two values");
    let (u, v) = (a.standard_error().powi(2), b.standard_error().powi(2));
    let shares = u * u / (a.count() - 1) as f64 + v * v / (b.count() - 1) as f64;
    let freedom = if shares > 0.0 { (u + v).powi(2) / shares } else { f64::INFINITY };
    let score = score(a.mean(), b.mean(), (u + v).sqrt());
    (score, freedom, student_t_two_sided(score, freedom))
}

/// Compares two estimates in blocks of `side` × `side` pixels (smaller at the right and the
/// bottom), each channel by itself; equal expectations are refused with the chance `alpha`.
///
/// The sum over a block is taken for normal: blocks should hold some 64 pixels when variances
/// come from halves. The freedom of a block's variance is Satterthwaite's.
///
/// # Panics
/// If the estimates differ in size or `side` is 0.
pub fn z_blocks(a: &Estimate, b: &Estimate, side: usize, alpha: f64) -> Outcome {
    assert_eq!((a.width, a.height), (b.width, b.height), "estimates of one size");
    let blocks = blocks(a.width, a.height, side);
    Outcome::of(blocks.map(|(block, channel)| z_block(a, b, block, channel)), alpha)
}

/// Compares two sets of independent batches in tiles as [`z_blocks`] does, by Welch's t of the
/// tile's mean in each batch. Eight batches or more on each side give it some power.
///
/// # Panics
/// If a side has fewer than two batches, the batches differ in size, or `side` is 0.
pub fn welch_tiles(a: &[Picture], b: &[Picture], side: usize, alpha: f64) -> Outcome {
    assert!(a.len() >= 2 && b.len() >= 2, "a variance needs two batches");
    let (width, height) = (a[0].width, a[0].height);
    for batch in a.iter().chain(b) {
        assert_eq!((batch.width, batch.height), (width, height), "batches of one size");
    }
    let side_means = |batches: &[Picture]| -> Vec<Vec<[f64; 3]>> {
        batches.iter().map(|batch| components(batch).collect()).collect()
    };
    let (a, b) = (side_means(a), side_means(b));
    let extremes = blocks(width, height, side).map(|(block, channel)| {
        let moments = |batches: &[Vec<[f64; 3]>]| -> Moments {
            batches.iter().map(|batch| block.sum(batch, width, channel) / block.area()).collect()
        };
        let (a, b) = (moments(&a), moments(&b));
        let (score, _, p) = welch(&a, &b);
        let standard_error = a.standard_error().hypot(b.standard_error());
        block.extreme(channel, a.mean(), b.mean(), standard_error, score, p)
    });
    Outcome::of(extremes, alpha)
}

/// A rectangle of pixels.
#[derive(Clone, Copy)]
struct Block {
    x: usize,
    y: usize,
    width: usize,
    height: usize,
}

impl Block {
    fn area(&self) -> f64 {
        (self.width * self.height) as f64
    }

    /// The pixels of the block in a picture of rows `row` long.
    fn pixels(&self, row: usize) -> impl Iterator<Item = usize> {
        let Self { x, y, width, height } = *self;
        (y..y + height).flat_map(move |y| (x..x + width).map(move |x| y * row + x))
    }

    fn sum(&self, plane: &[[f64; 3]], row: usize, channel: usize) -> f64 {
        self.pixels(row).map(|at| plane[at][channel]).sum()
    }

    fn extreme(
        &self,
        channel: usize,
        a: f64,
        b: f64,
        standard_error: f64,
        score: f64,
        p: f64,
    ) -> Extreme {
        let Self { x, y, width, height } = *self;
        Extreme { x, y, width, height, channel, a, b, standard_error, score, p }
    }
}

/// Every block with every channel.
fn blocks(width: usize, height: usize, side: usize) -> impl Iterator<Item = (Block, usize)> {
    assert!(side > 0, "a block has pixels");
    let rows = (0..height).step_by(side);
    rows.flat_map(move |y| (0..width).step_by(side).map(move |x| (x, y))).flat_map(move |(x, y)| {
        let block = Block { x, y, width: side.min(width - x), height: side.min(height - y) };
        (0..3).map(move |channel| (block, channel))
    })
}

fn z_block(a: &Estimate, b: &Estimate, block: Block, channel: usize) -> Extreme {
    let area = block.area();
    let mean_a = block.sum(&a.mean, a.width, channel) / area;
    let mean_b = block.sum(&b.mean, b.width, channel) / area;
    let mut variance = 0.0;
    // Σ v²/(ν + 2): each estimated v² is too large by the part 2/ν, so this and the −2 below make
    // Satterthwaite's freedom right where every pixel has but one or two degrees.
    let mut shares = 0.0;
    for of in [a, b] {
        for at in block.pixels(of.width) {
            let v = of.variance[at][channel];
            variance += v;
            shares += v * v / (of.freedom + 2.0);
        }
    }
    let freedom =
        if shares > 0.0 { (variance * variance / shares - 2.0).max(1.0) } else { f64::INFINITY };
    let standard_error = variance.sqrt() / area;
    let score = score(mean_a, mean_b, standard_error);
    block.extreme(
        channel,
        mean_a,
        mean_b,
        standard_error,
        score,
        student_t_two_sided(score, freedom),
    )
}

/// The difference less its rounding, in standard errors; NaN for what is not a number.
fn score(a: f64, b: f64, standard_error: f64) -> f64 {
    let off = a - b;
    let rounding = ROUNDING * a.abs().max(b.abs());
    if off.abs() <= rounding { 0.0 } else { (off - rounding.copysign(off)) / standard_error }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { tests, alpha, level, refused, worst } = self;
        let Some(it) = worst else { return write!(f, "no pixels to compare") };
        write!(
            f,
            "{refused} of {tests} tests refused (each at {level:.1e}, all at {alpha}); the worst \
             is {} of pixels x {}–{}, y {}–{}: {:.6e} against {:.6e}, {:.1} standard errors of \
             {:.2e}, p {:.1e}",
            ["red", "green", "blue"][it.channel],
            it.x,
            it.x + it.width - 1,
            it.y,
            it.y + it.height - 1,
            it.a,
            it.b,
            it.score.abs(),
            it.standard_error,
            it.p
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Rgb, random};

    /// Uniform in [0, 1), a function of its place.
    fn uniform(seed: u64, place: u64) -> f64 {
        (random::mix(random::mix(seed) ^ place) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// 24 × 20 pixels around `mean`: 8 samples each, skewed (u⁴), as light often is.
    fn noisy(seed: u64, mean: f32) -> Picture {
        let pixel = |at: u64, channel: u64| {
            let sum: f64 = (0..8).map(|s| uniform(seed, (at * 3 + channel) * 8 + s).powi(4)).sum();
            mean * (5.0 * sum / 8.0) as f32
        };
        let pixels = (0..24 * 20).map(|i| Rgb::new(pixel(i, 0), pixel(i, 1), pixel(i, 2)));
        Picture { width: 24, height: 20, pixels: pixels.collect() }
    }

    fn batches(seed: u64, count: u64, mean: f32) -> Vec<Picture> {
        (0..count).map(|i| noisy(seed * 1000 + i, mean)).collect()
    }

    #[test]
    fn equal_expectations_are_refused_at_the_stated_rate() {
        let mut by_halves = 0;
        let mut by_batches = 0;
        for seed in 0..60 {
            let a = batches(2 * seed, 8, 1.0);
            let b = batches(2 * seed + 1, 8, 1.0);
            let halves = |it: &[Picture]| Estimate::from_halves(&it[0], &it[1]);
            by_halves += u32::from(!z_blocks(&halves(&a), &halves(&b), 8, 0.1).agrees());
            by_batches += u32::from(!welch_tiles(&a, &b, 8, 0.1).agrees());
        }
        // Binomial(60, 0.1): 6 ± 2.3.
        assert!((1..=14).contains(&by_halves), "{by_halves} of 60 by halves");
        assert!((1..=14).contains(&by_batches), "{by_batches} of 60 by batches");
    }

    #[test]
    fn a_bias_of_one_block_is_found_and_placed() {
        let a = batches(1, 16, 1.0);
        let mut b = batches(2, 16, 1.0);
        for batch in &mut b {
            for y in 8..16 {
                for x in 16..24 {
                    batch.pixels[y * 24 + x].g *= 1.2;
                }
            }
        }
        for outcome in [
            welch_tiles(&a, &b, 8, 0.01),
            z_blocks(&Estimate::from_batches(&a), &Estimate::from_batches(&b), 8, 0.01),
        ] {
            assert!(!outcome.agrees(), "{outcome}");
            let worst = outcome.worst.unwrap();
            assert_eq!((worst.x, worst.y, worst.channel), (16, 8, 1), "{outcome}");
            assert_eq!(outcome.tests, 27);
            assert!(outcome.to_string().contains("green of pixels x 16–23, y 8–15"), "{outcome}");
        }
    }

    #[test]
    fn a_truth_is_held_against_an_estimate() {
        let estimate = Estimate::from_batches(&batches(5, 16, 1.0));
        let flat = |grey: f32| {
            let pixels = vec![Rgb::grey(grey); 24 * 20];
            Estimate::exact(&Picture { width: 24, height: 20, pixels })
        };
        let same = z_blocks(&estimate, &flat(1.0), 8, 0.01);
        assert!(same.agrees(), "{same}");
        let off = z_blocks(&estimate, &flat(1.1), 8, 0.01);
        assert!(!off.agrees(), "{off}");
    }

    #[test]
    fn without_noise_only_rounding_is_forgiven() {
        let flat = |grey: f32| {
            let pixels = vec![Rgb::grey(grey); 9];
            Estimate::exact(&Picture { width: 3, height: 3, pixels })
        };
        assert!(z_blocks(&flat(1.0), &flat(1.0 + 5e-7), 2, 0.01).agrees());
        let off = z_blocks(&flat(1.0), &flat(1.0 + 5e-6), 2, 0.01);
        assert_eq!(off.refused, 12, "{off}");
    }

    #[test]
    fn what_is_not_a_number_is_refused() {
        let good = batches(7, 4, 1.0);
        let mut bad = batches(8, 4, 1.0);
        bad[2].pixels[0].b = f32::NAN;
        assert!(!welch_tiles(&good, &bad, 8, 0.01).agrees());
        let (good, bad) = (Estimate::from_batches(&good), Estimate::from_batches(&bad));
        assert!(!z_blocks(&good, &bad, 8, 0.01).agrees());
        assert!(!z_blocks(&bad, &good, 8, 0.01).agrees());
    }

    #[test]
    fn a_variance_of_few_degrees_widens_the_tails() {
        let truth = Estimate::exact(&Picture::black(1, 1));
        let mut estimate = truth.clone();
        (estimate.mean[0], estimate.variance[0], estimate.freedom) = ([2.0; 3], [1.0; 3], 3.0);
        let worst = z_blocks(&estimate, &truth, 1, 0.01).worst.unwrap();
        // Two standard errors, 2 · t.sf(2, 3) of SciPy; a normal would say 0.0455.
        assert!((worst.p - 0.139_326).abs() < 1e-5, "{}", worst.p);
    }

    #[test]
    fn welch_by_hand() {
        let a: Moments = [1.0, 2.0, 3.0, 4.0].into_iter().collect();
        let b: Moments = [5.0, 5.5, 9.0].into_iter().collect();
        let (t, freedom, p) = welch(&a, &b);
        // scipy.stats.ttest_ind(a, b, equal_var=False), less the rounding forgiven.
        assert!((t + 2.828_427).abs() < 1e-4, "{t}");
        assert!((freedom - 3.050_309).abs() < 1e-4, "{freedom}");
        assert!((p - 0.065_004).abs() < 1e-4, "{p}");
    }

    #[test]
    fn nothing_compared_is_no_agreement() {
        let none = Estimate::exact(&Picture::black(0, 0));
        assert!(!z_blocks(&none, &none, 8, 0.01).agrees());
    }
}
