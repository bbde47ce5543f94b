//! The mean of a pixel's samples, and how well it is known.

/// Red, green and blue of a pixel as the mean of its samples; all in one unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeanPixel {
    /// The mean.
    pub mean: [f64; 3],
    /// Variance of the mean: its standard error squared.
    pub variance: [f64; 3],
    /// What the largest sample brings to the mean, at least 0.
    pub largest: [f64; 3],
}
