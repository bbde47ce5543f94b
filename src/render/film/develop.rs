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
    let mut samples = vec![0.0; window.pixels() as usize];
    for (tile, end) in window.tiles().iter().zip(taken.ends()) {
        for (x, y) in tile.places() {
            samples[place(window, x, y)] = (end - taken.first()) as f32;
        }
    }
    samples
}

/// What was taken of this part of a film as a picture; `light_unit` as in
/// [`crate::render::World`].
pub fn develop(window: &Window, taken: &Taken, light_unit: f64) -> Developed {
    let (mut picture, mut standard_error) = (black(window), None);
    let mut clipped = 0;
    for means in taken.means(window, light_unit) {
        for ((x, y), pixel) in means.tile.places().zip(&means.pixels) {
            clipped += u64::from(pixel.mean.iter().any(|value| value.abs() > LIMIT));
            let place = place(window, x, y);
            picture.pixels[place] = rgb(pixel.mean);
            if means.freedom > 0 {
                let errors: &mut Picture = standard_error.get_or_insert_with(|| black(window));
                errors.pixels[place] = rgb(pixel.variance.map(f64::sqrt));
            }
        }
    }
    Developed { picture, standard_error, clipped }
}

/// The layers of what was taken of this part of a film, as pictures like the whole one.
pub fn layers(window: &Window, taken: &Taken, light_unit: f64) -> Vec<Picture> {
    let mut pictures = vec![black(window); taken.layers()];
    for (index, tile) in window.tiles().iter().enumerate() {
        let means = taken.layer_means(index, light_unit);
        for ((x, y), of_pixel) in tile.places().zip(means.chunks(taken.layers().max(1))) {
            for (picture, mean) in pictures.iter_mut().zip(of_pixel) {
                picture.pixels[place(window, x, y)] = rgb(*mean);
            }
        }
    }
    pictures
}

/// The largest number of a picture.
const LIMIT: f64 = f32::MAX as f64;

fn black(window: &Window) -> Picture {
    Picture::black(window.width() as usize, window.height() as usize)
}

/// The number of a pixel of the film in the picture of a window.
fn place(window: &Window, x: u64, y: u64) -> usize {
    ((y - window.y0) * window.width() + (x - window.x0)) as usize
}

fn rgb(values: [f64; 3]) -> Rgb {
    let [r, g, b] = values.map(|value| value.clamp(-LIMIT, LIMIT) as f32);
    Rgb::new(r, g, b)
}
