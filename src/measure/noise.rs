//! How wrong a picture is by its noise, told from its own samples.
//!
//! The error is relMSE, the mean over pixels and channels of (x − µ)² / (µ² + ε), where x is what
//! the picture shows, µ what it would show after endless samples, and ε = .01 · (median luminance of
//! the pixels that are not black)². Its estimate takes the variance of each mean for (x − µ)², and
//! x for µ.
//!
//! The interval is for the error of this very picture, not for the average of pictures like it: it
//! allows for what the variances do not know, and for the luck of these samples. Rare bright samples
//! (fireflies, caustics found by chance) make a pixel's variance and its mean rise together, so that
//! their ratio tells too little. At the interval's upper end each pixel's largest sample is
//! therefore left out of its µ: over samples that come like raindrops, the mean of f(without one of
//! them), weighted by that one, is the mean of f itself [Mecke67], so that on average the upper end
//! is not too low, however rare they are, if only some pixel has met one. At the lower end it is
//! counted twice.

use super::statistics::student_t_quantile;
use crate::math::MeanPixel;

/// ε of the error, in parts of the squared median luminance.
pub const EPSILON: f64 = 0.01;
/// Confidence of the interval.
pub const CONFIDENCE: f64 = 0.95;
/// A sample that brings more than this part of its pixel's light makes the pixel a doubtful one.
pub const LARGE_SHARE: f64 = 0.2;

/// How wrong a picture is by its noise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// Estimate of relMSE.
    pub relmse: f64,
    /// Lower end of its interval.
    pub low: f64,
    /// Upper end of its interval; at least `relmse`.
    pub high: f64,
    /// ε, in squared units of the picture.
    pub epsilon: f64,
    /// Pixels of which one sample brings more than [`LARGE_SHARE`].
    pub doubtful: u64,
    /// Their part of the error at the upper end, 0 to 1.
    pub doubtful_part: f64,
}

/// What some pixels of equal samples, near to each other, add to the noise of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Share {
    pixels: f64,
    freedom: f64,
    /// Of the estimate, and of what it is at the interval's ends.
    estimate: Sum,
    low: Sum,
    high: Sum,
    doubtful: f64,
    doubtful_high: f64,
}

/// Sums over pixels of one kind of estimate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Sum {
    /// Σx.
    total: f64,
    /// Variance of Σx about the true sum of errors.
    variance: f64,
}

/// ε of a picture whose pixels have these luminances.
pub fn epsilon(luminances: impl Iterator<Item = f64>) -> f64 {
    let mut lit: Vec<f64> = luminances.filter(|luminance| *luminance > 0.0).collect();
    if lit.is_empty() {
        return 0.0;
    }
    let middle = lit.len() / 2;
    let (_, median, _) = lit.select_nth_unstable_by(middle, f64::total_cmp);
    EPSILON * *median * *median
}

impl Share {
    /// Of pixels whose variances have so many degrees of freedom, at least 1; `bound` if the
    /// variances are only bounds from above.
    pub fn of(pixels: &[MeanPixel], freedom: u64, bound: bool, epsilon: f64) -> Self {
        let freedom = freedom as f64;
        let (mut estimate, mut low, mut high) =
            (Spread::default(), Spread::default(), Spread::default());
        let (mut doubtful, mut doubtful_high) = (0.0, 0.0);
        for pixel in pixels {
            let relative = |sign: f64| {
                let channel = |c: usize| {
                    let mean = (pixel.mean[c].abs() + sign * pixel.largest[c]).max(0.0);
                    match pixel.variance[c] {
                        variance if variance > 0.0 => variance / (mean * mean + epsilon),
                        _ => 0.0,
                    }
                };
                (channel(0) + channel(1) + channel(2)) / 3.0
            };
            let share = |c: usize| {
                let mean = pixel.mean[c].abs();
                if mean > 0.0 { (pixel.largest[c] / mean).min(1.0) } else { 0.0 }
            };
            let share = share(0).max(share(1)).max(share(2));
            let at_high = relative(-1.0);
            estimate.add(relative(0.0), share);
            low.add(if bound { 0.0 } else { relative(1.0) }, share);
            high.add(at_high, share);
            if share > LARGE_SHARE {
                doubtful += 1.0;
                doubtful_high += at_high;
            }
        }
        Self {
            pixels: pixels.len() as f64,
            freedom,
            estimate: estimate.sum(freedom),
            low: low.sum(freedom),
            high: high.sum(freedom),
            doubtful,
            doubtful_high,
        }
    }

    /// Of these pixels and others together.
    pub fn and(self, other: &Self) -> Self {
        let sum =
            |a: Sum, b: Sum| Sum { total: a.total + b.total, variance: a.variance + b.variance };
        Self {
            pixels: self.pixels + other.pixels,
            freedom: self.freedom.max(other.freedom),
            estimate: sum(self.estimate, other.estimate),
            low: sum(self.low, other.low),
            high: sum(self.high, other.high),
            doubtful: self.doubtful + other.doubtful,
            doubtful_high: self.doubtful_high + other.doubtful_high,
        }
    }

    /// The noise of a picture of these pixels, at least one. `epsilon` as for the shares.
    pub fn noise(&self, epsilon: f64) -> Noise {
        let t = student_t_quantile(0.5 + 0.5 * CONFIDENCE, self.freedom.max(self.pixels - 1.0));
        let end = |sum: Sum, sign: f64| {
            ((sum.total + sign * t * sum.variance.sqrt()) / self.pixels).max(0.0)
        };
        let relmse = self.estimate.total / self.pixels;
        let doubtful_part =
            if self.high.total > 0.0 { self.doubtful_high / self.high.total } else { 0.0 };
        Noise {
            relmse,
            low: end(self.low, -1.0).min(relmse),
            high: end(self.high, 1.0).max(relmse),
            epsilon,
            doubtful: self.doubtful as u64,
            doubtful_part,
        }
    }
}

/// Moments of one kind of estimate over pixels.
#[derive(Clone, Copy, Debug, Default)]
struct Spread {
    count: f64,
    total: f64,
    squares: f64,
    /// Σ Var((x − µ)²): of a normal mean twice its squared variance, and more by the part of the
    /// largest sample, as of a mean of few rare events.
    luck: f64,
}

impl Spread {
    fn add(&mut self, x: f64, share: f64) {
        self.count += 1.0;
        self.total += x;
        self.squares += x * x;
        self.luck += (2.0 + share) * x * x;
    }

    fn sum(&self, freedom: f64) -> Sum {
        // How far the estimates scatter is seen between the pixels, which differ besides; it is
        // not less than that of normal samples.
        let mean = self.total / self.count;
        let seen = (self.squares - self.total * mean).max(0.0)
            * (self.count / (self.count - 1.0).max(1.0));
        let normal = 2.0 * self.squares / freedom;
        Sum { total: self.total, variance: seen.max(normal) + self.luck }
    }
}
