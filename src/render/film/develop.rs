//! From samples to a picture, and to the picture of its standard error.

use super::{Taken, Window};
use crate::math::{Picture, Rgb};

/// A picture, and what its samples tell of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Developed {
    /// Radiance in the window of the film, in W/m²/sr; black where there is no sample.
    pub picture: Picture,
    /// Standard error of each pixel, likewise. None if nothing is known of it anywhere.
    pub standard_error: Option<Picture>,
    /// Pixels beyond the largest f32, which stand at the largest f32.
    pub clipped: u64,
}

/// Samples of each pixel of the window, row by row from the top left.
pub fn samples(window: &Window, taken: &Taken) -> Vec<f32> {
    let Window { x0, y0, .. } = *window;
    let width = window.width() as usize;
    let mut samples = vec![0.0; window.pixels() as usize];
    for (tile, end) in window.tiles().iter().zip(taken.ends()) {
        for (x, y) in tile.places() {
            samples[(y - y0) as usize * width + (x - x0) as usize] = (end - taken.first()) as f32;
        }
    }
    samples
}

/// What was taken of this part of a film as a picture; `light_unit` as in
/// [`crate::render::World`].
pub fn develop(window: &Window, taken: &Taken, light_unit: f64) -> Developed {
    let Window { x0, y0, .. } = *window;
    let black = || Picture::black(window.width() as usize, window.height() as usize);
    let (mut picture, mut standard_error) = (black(), None);
    let mut clipped = 0;
    let limit = f64::from(f32::MAX);
    for means in taken.means(window, light_unit) {
        for ((x, y), pixel) in means.tile.places().zip(&means.pixels) {
            clipped += u64::from(pixel.mean.iter().any(|value| value.abs() > limit));
            let place = (y - y0) as usize * picture.width + (x - x0) as usize;
            let rgb = |values: [f64; 3]| {
                let [r, g, b] = values.map(|value| value.clamp(-limit, limit) as f32);
                Rgb::new(r, g, b)
            };
            picture.pixels[place] = rgb(pixel.mean);
            if means.freedom > 0 {
                let errors: &mut Picture = standard_error.get_or_insert_with(black);
                errors.pixels[place] = rgb(pixel.variance.map(f64::sqrt));
            }
        }
    }
    Developed { picture, standard_error, clipped }
}
