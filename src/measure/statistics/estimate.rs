//! A picture that knows its error: the mean of every pixel, and the variance of that mean.

use super::moments::Moments;
use crate::math::Picture;

/// Pictures are kept in f32: blocks whose means differ by less than this part are called equal.
pub const ROUNDING: f64 = 1.0 / (1u64 << 20) as f64;

/// Means with their variances, row by row from the top left, as a [`Picture`] has them.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Red, green, blue of each pixel.
    pub mean: Vec<[f64; 3]>,
    /// Variance of each mean: its standard error squared.
    pub variance: Vec<[f64; 3]>,
    /// Degrees of freedom each variance was estimated with; infinite where it is known.
    pub freedom: f64,
}

impl Estimate {
    /// A picture without error: a truth.
    pub fn exact(picture: &Picture) -> Self {
        Self {
            width: picture.width,
            height: picture.height,
            mean: components(picture).collect(),
            variance: vec![[0.0; 3]; picture.pixels.len()],
            freedom: f64::INFINITY,
        }
    }

    /// The mean of two independent halves of equal samples; variance (a − b)²/4, one degree of
    /// freedom a pixel.
    ///
    /// # Panics
    /// If the halves differ in size.
    pub fn from_halves(a: &Picture, b: &Picture) -> Self {
        Self::from_batches(&[a.clone(), b.clone()])
    }

    /// The mean of two or more independent pictures of equal samples.
    ///
    /// # Panics
    /// On fewer than two, or if they differ in size.
    pub fn from_batches(batches: &[Picture]) -> Self {
        assert!(batches.len() >= 2, "a variance needs two batches");
        let (width, height) = (batches[0].width, batches[0].height);
        let mut moments = vec![[Moments::default(); 3]; width * height];
        for batch in batches {
            assert_eq!((batch.width, batch.height), (width, height), "batches of one size");
            for (pixel, values) in moments.iter_mut().zip(components(batch)) {
                for (moment, value) in pixel.iter_mut().zip(values) {
                    moment.add(value);
                }
            }
        }
        Self {
            width,
            height,
            mean: moments.iter().map(|pixel| pixel.map(|m| m.mean())).collect(),
            variance: moments.iter().map(|p| p.map(|m| m.standard_error().powi(2))).collect(),
            freedom: (batches.len() - 1) as f64,
        }
    }
}

/// Each pixel in f64.
pub(super) fn components(picture: &Picture) -> impl Iterator<Item = [f64; 3]> {
    picture.pixels.iter().map(|pixel| pixel.to_array().map(f64::from))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    fn one(r: f32, g: f32, b: f32) -> Picture {
        Picture { width: 1, height: 1, pixels: vec![Rgb::new(r, g, b)] }
    }

    #[test]
    fn halves_give_a_quarter_of_the_squared_difference() {
        let both = Estimate::from_halves(&one(1.0, 2.0, 0.5), &one(3.0, 2.0, 0.0));
        assert_eq!(both.mean, [[2.0, 2.0, 0.25]]);
        assert_eq!(both.variance, [[1.0, 0.0, 0.0625]]);
        assert_eq!(both.freedom, 1.0);
    }

    #[test]
    fn batches_give_the_variance_of_their_mean() {
        let batches = [one(1.0, 0.0, 0.0), one(2.0, 0.0, 0.0), one(6.0, 0.0, 3.0)];
        let all = Estimate::from_batches(&batches);
        assert_eq!(all.mean, [[3.0, 0.0, 1.0]]);
        // 1, 2, 6: squares from the mean 4 + 1 + 9 = 14, /2 /3.
        assert!((all.variance[0][0] - 14.0 / 6.0).abs() < 1e-14);
        assert!((all.variance[0][2] - 1.0).abs() < 1e-14);
        assert_eq!(all.freedom, 2.0);
    }

    #[test]
    fn a_truth_has_no_error() {
        let truth = Estimate::exact(&one(1.0, 2.0, 3.0));
        assert_eq!((truth.mean[0], truth.variance[0]), ([1.0, 2.0, 3.0], [0.0; 3]));
        assert_eq!(truth.freedom, f64::INFINITY);
    }
}
