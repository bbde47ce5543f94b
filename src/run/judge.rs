//! What the samples taken so far tell of a picture's noise, tile by tile and as a whole.

use crate::math::MeanPixel;
use crate::measure::noise::{self, Noise, Share};
use crate::render::film::{Taken, Window};

/// The noise of a picture, tile by tile.
pub(super) struct Judgement {
    epsilon: f64,
    /// In the order of the film's tiles.
    shares: Vec<Share>,
    /// Whether the variances are only bounds from above.
    pub bound: bool,
}

impl Judgement {
    /// Of the whole picture.
    pub fn whole(&self) -> Noise {
        let all = self.shares.iter().fold(Share::default(), |all, share| all.and(share));
        all.noise(self.epsilon)
    }

    /// Of one tile.
    pub fn tile(&self, index: usize) -> Noise {
        self.shares[index].noise(self.epsilon)
    }
}

/// None as long as nothing is known of the error of some tile.
pub(super) fn judge(window: &Window, light_unit: f64, taken: &Taken) -> Option<Judgement> {
    let means = || taken.means(window, light_unit);
    if means().any(|tile| tile.freedom == 0) {
        return None;
    }
    let epsilon = epsilon(means().flat_map(|tile| tile.pixels));
    let mut bound = false;
    let share = |tile: crate::render::film::TileMeans| {
        bound |= tile.bound;
        Share::of(&tile.pixels, tile.freedom, tile.bound, epsilon)
    };
    let shares = means().map(share).collect();
    Some(Judgement { epsilon, shares, bound })
}

/// ε of a picture with these pixels.
pub(super) fn epsilon(pixels: impl Iterator<Item = MeanPixel>) -> f64 {
    let luminance = |[r, g, b]: [f64; 3]| 0.2126 * r + 0.7152 * g + 0.0722 * b;
    noise::epsilon(pixels.map(|pixel| luminance(pixel.mean)))
}
