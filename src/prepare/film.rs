//! Film of the scene → film of the world: its size, the part that is wanted, its filter.

use std::fmt;

use super::Settings;
use super::errors::scene as errors;
use crate::diag::Diagnostic;
use crate::render::film::{Filter, Taken, Window};
use crate::render::samplers::Rhythm;
use crate::scene::{self, Scene};

/// Settings that do not suit the film. Shown as a sentence without full stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unfit {
    /// The scale is not a positive number.
    Scale(f64),
    /// The scale leaves no pixel of the film, or more than can be counted.
    Size {
        /// Columns and rows of the scene.
        size: [u64; 2],
        /// The scale.
        scale: f64,
    },
    /// The crop has no pixel, or pixels outside the film.
    Crop {
        /// The crop.
        crop: [u64; 4],
        /// Columns and rows, scaled.
        size: [u64; 2],
    },
}

impl fmt::Display for Unfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scale(scale) => write!(f, "a film cannot be scaled by {scale}"),
            Self::Size { size: [w, h], scale } => {
                let much = if *scale < 1.0 { "no pixel" } else { "too many pixels" };
                write!(f, "scaled by {scale:?}, a film of {w} × {h} has {much}")
            }
            Self::Crop { crop: [x0, y0, x1, y1], size: [w, h] } if x0 >= x1 || y0 >= y1 => {
                write!(f, "the crop {x0},{y0},{x1},{y1} has no pixel; the film is {w} × {h}")
            }
            Self::Crop { crop: [x0, y0, x1, y1], size: [w, h] } => {
                write!(f, "the crop {x0},{y0},{x1},{y1} reaches beyond the film of {w} × {h}")
            }
        }
    }
}

/// Columns and rows beyond which pixels cannot be told apart in what follows.
const MOST_PIXELS_A_SIDE: f64 = 4_294_967_296.0;

/// Columns and rows of the whole film, and the window that is wanted.
pub(super) fn window(film: &scene::Film, settings: &Settings) -> Result<([u64; 2], Window), Unfit> {
    let scale = settings.scale;
    if !(scale > 0.0 && scale.is_finite()) {
        return Err(Unfit::Scale(scale));
    }
    let scaled = film.size.0.map(|n| (n as f64 * scale).round());
    if scaled.iter().any(|n| !(1.0..MOST_PIXELS_A_SIDE).contains(n)) {
        return Err(Unfit::Size { size: film.size.0, scale });
    }
    let size = scaled.map(|n| n as u64);
    let [x0, y0, x1, y1] = settings.crop.unwrap_or([0, 0, size[0], size[1]]);
    if x0 >= x1 || y0 >= y1 || x1 > size[0] || y1 > size[1] {
        return Err(Unfit::Crop { crop: [x0, y0, x1, y1], size });
    }
    Ok((size, Window { x0, y0, x1, y1 }))
}

/// Memory beyond which a film is refused, in bytes: 16 GiB.
const MOST_BYTES: u64 = 16 << 30;

/// Refuses a film that would fill the memory.
pub(super) fn check(scene: &Scene, settings: &Settings, found: &mut Vec<Diagnostic>) {
    let Ok((_, window)) = window(&scene.film, settings) else { return };
    let samples = scene.stop.most_samples().unwrap_or(SAMPLES_UNTOLD);
    let rhythm = super::integrator::sampler(&scene.sampler).rhythm();
    let layers = scene.layers.len();
    let bytes = window.pixels().saturating_mul(bytes_a_pixel(samples, layers, rhythm));
    if bytes > MOST_BYTES {
        let size = [window.width(), window.height()];
        found.push(errors::film_too_large(scene.film.size.span, size, bytes, MOST_BYTES));
    }
}

/// Where time or error decide, memory is counted for so many samples a pixel.
const SAMPLES_UNTOLD: u64 = 1 << 20;

/// Sums of a pixel, its colour, its standard error and its layers.
fn bytes_a_pixel(samples: u64, layers: usize, rhythm: Rhythm) -> u64 {
    let colours = (2 + layers) * size_of::<crate::math::Rgb>();
    Taken::bytes_a_pixel(samples, layers, rhythm) + colours as u64
}

/// How samples are weighed.
pub(super) fn filter(filter: &scene::Filter) -> Filter {
    match filter {
        scene::Filter::BoxFilter(filter) => Filter::Box { radius: filter.radius.0 },
        scene::Filter::Gaussian(filter) => Filter::gaussian(filter.radius.0, filter.deviation.0),
        scene::Filter::Mitchell(filter) => {
            Filter::mitchell(filter.radius.0, filter.b.0, filter.c.0)
        }
        scene::Filter::Tent(filter) => Filter::Tent { radius: filter.radius.0 },
    }
}
