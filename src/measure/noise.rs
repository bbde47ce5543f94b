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

    /// Of so many times as many pixels, which these stand for.
    pub fn times(self, factor: f64) -> Self {
        let sum =
            |sum: Sum| Sum { total: sum.total * factor, variance: sum.variance * factor * factor };
        Self {
            pixels: self.pixels * factor,
            freedom: self.freedom,
            estimate: sum(self.estimate),
            low: sum(self.low),
            high: sum(self.high),
            doubtful: self.doubtful * factor,
            doubtful_high: self.doubtful_high * factor,
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

#[cfg(test)]
mod tests {
    use super::*;

    fn pixel(mean: f64, variance: f64, largest: f64) -> MeanPixel {
        MeanPixel { mean: [mean; 3], variance: [variance; 3], largest: [largest; 3] }
    }

    #[track_caller]
    fn near(found: f64, wanted: f64) {
        assert!((found - wanted).abs() <= 1e-12 * wanted.abs(), "{found}, not {wanted}");
    }

    #[test]
    fn epsilon_is_of_the_median_of_what_is_lit() {
        let luminances = [0.0, 0.0, 0.0, 8.0, 1.0, 2.0, -1.0, 0.0];
        near(epsilon(luminances.into_iter()), 0.04);
        assert_eq!(epsilon([0.0, 0.0].into_iter()), 0.0);
    }

    #[test]
    fn two_pixels_by_hand() {
        let pixels = [pixel(2.0, 0.1, 0.5), pixel(-1.0, 0.3, 0.05)];
        let share = Share::of(&pixels, 10, false, 0.25);
        let noise = share.noise(0.25);
        let x = [0.1 / 4.25, 0.3 / 1.25];
        near(noise.relmse, (x[0] + x[1]) / 2.0);
        // The largest sample left out: 1.5 and .95; counted twice: 2.5 and 1.05.
        let y = [0.1 / 2.5, 0.3 / (0.95 * 0.95 + 0.25)];
        let z = [0.1 / 6.5, 0.3 / (1.05 * 1.05 + 0.25)];
        let t = student_t_quantile(0.975, 10.0);
        let reach = |x: [f64; 2]| {
            let seen = (x[0] - x[1]).powi(2);
            let normal = 0.2 * (x[0] * x[0] + x[1] * x[1]);
            let luck = 2.25 * x[0] * x[0] + 2.05 * x[1] * x[1];
            t * (seen.max(normal) + luck).sqrt()
        };
        near(noise.high, (y[0] + y[1] + reach(y)) / 2.0);
        assert_eq!(noise.low, ((z[0] + z[1] - reach(z)) / 2.0).max(0.0));
        // A quarter of the first pixel is one sample.
        assert_eq!(noise.doubtful, 1);
        near(noise.doubtful_part, y[0] / (y[0] + y[1]));
    }

    #[test]
    fn many_alike_pixels_are_sure_of_it() {
        let pixels = vec![pixel(1.0, 1e-4, 0.01); 10_000];
        let noise = Share::of(&pixels, 99, false, 0.0).noise(0.0);
        near(noise.relmse, 1e-4);
        assert!(noise.low > 0.95e-4 && noise.high < 1.05e-4, "{noise:?}");
        assert_eq!((noise.doubtful, noise.doubtful_part), (0, 0.0));
        let bound = Share::of(&pixels, 99, true, 0.0).noise(0.0);
        assert_eq!((bound.low, bound.high), (0.0, noise.high));
    }

    #[test]
    fn shares_add_up() {
        let pixels: Vec<MeanPixel> =
            (1..=8).map(|i| pixel(1.0, 0.01 * f64::from(i), 0.03 * f64::from(i))).collect();
        let parts = pixels.chunks(4).map(|part| Share::of(part, 20, false, 0.1));
        let noise = parts.fold(Share::default(), |all, share| all.and(&share)).noise(0.1);
        let whole = Share::of(&pixels, 20, false, 0.1).noise(0.1);
        near(noise.relmse, whole.relmse);
        assert_eq!(noise.doubtful, whole.doubtful);
        near(noise.doubtful_part, whole.doubtful_part);
        // Pixels that differ much from those beside them make it less sure, those far away do not.
        assert!(noise.high < whole.high);
    }

    #[test]
    fn a_share_stands_for_others_like_it() {
        let pixels = vec![pixel(1.0, 1e-4, 0.01), pixel(1.0, 3e-4, 0.01)];
        let one = Share::of(&pixels, 99, false, 0.0);
        let three = one.times(3.0).noise(0.0);
        near(three.relmse, one.noise(0.0).relmse);
        near(
            one.times(3.0)
                .and(&Share::of(&[pixel(1.0, 0.0, 0.0); 6], 99, false, 0.0))
                .noise(0.0)
                .relmse,
            1e-4,
        );
        // It is no surer for that.
        assert!(three.high > 0.99 * one.noise(0.0).high);
    }

    #[test]
    fn a_picture_without_noise_has_none() {
        let black = vec![pixel(0.0, 0.0, 0.0); 4];
        let noise = Share::of(&black, 3, false, 0.0).noise(0.0);
        assert_eq!((noise.relmse, noise.low, noise.high), (0.0, 0.0, 0.0));
        assert_eq!(noise.doubtful_part, 0.0);
        let even = vec![pixel(3.0, 0.0, 0.01); 4];
        assert_eq!(Share::of(&even, 3, false, 0.09).noise(0.09).high, 0.0);
    }

    #[test]
    fn the_largest_numbers_give_an_answer() {
        for scale in [1e-150, 1.0, 1e150] {
            let pixels = vec![pixel(scale, 0.01 * scale * scale, 0.1 * scale); 16];
            let noise = Share::of(&pixels, 15, false, 0.0).noise(0.0);
            near(noise.relmse, 0.01);
            assert!(noise.high.is_finite());
        }
    }
}
