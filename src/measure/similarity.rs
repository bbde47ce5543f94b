//! SSIM: how alike the structure of two pictures is, 1 where they are equal [Wang04].
//!
//! Taken of the luma of sRGB-encoded values clipped to [0, 1], in a Gaussian window of 11 × 11
//! pixels, over the windows that lie wholly in the picture. The mean over the three colours, and
//! several scales, were left out: neither is what others report as SSIM.

use super::planes::Plane;
use crate::math::{Picture, srgb};

/// Width of the window in pixels, and its standard deviation.
const WINDOW: usize = 11;
const DEVIATION: f64 = 1.5;

/// (K₁ L)² and (K₂ L)² for a range L of 1: what keeps the ratios tame where both are flat.
const C1: f64 = 0.01 * 0.01;
const C2: f64 = 0.03 * 0.03;

/// The mean SSIM in [−1, 1]; `None` if the pictures are smaller than the window.
///
/// # Panics
/// If the pictures differ in size.
pub fn ssim(reference: &Picture, test: &Picture) -> Option<f64> {
    let (width, height) = (reference.width, reference.height);
    assert_eq!((width, height), (test.width, test.height), "one size");
    if width < WINDOW || height < WINDOW {
        return None;
    }
    let weights = window();
    let blurred = |plane: &Plane| plane.filtered(&weights, &weights);
    let (x, y) = (luma(reference), luma(test));
    let (mean_x, mean_y) = (blurred(&x), blurred(&y));
    let (xx, yy, xy) =
        (blurred(&product(&x, &x)), blurred(&product(&y, &y)), blurred(&product(&x, &y)));

    let reach = WINDOW / 2;
    let mut sum = 0.0;
    for row in reach..height - reach {
        for column in reach..width - reach {
            let at = |plane: &Plane| f64::from(plane.values[row * width + column]);
            let (mx, my) = (at(&mean_x), at(&mean_y));
            let (vx, vy, both) = (at(&xx) - mx * mx, at(&yy) - my * my, at(&xy) - mx * my);
            sum += (2.0 * mx * my + C1) * (2.0 * both + C2)
                / ((mx * mx + my * my + C1) * (vx + vy + C2));
        }
    }
    Some(sum / ((width - 2 * reach) * (height - 2 * reach)) as f64)
}

/// 0.2126 R′ + 0.7152 G′ + 0.0722 B′ of what a display is sent.
fn luma(picture: &Picture) -> Plane {
    let values = picture.pixels.iter().map(|pixel| {
        let [r, g, b] = pixel.to_array().map(|c| srgb::encode(f64::from(c)));
        (0.2126 * r + 0.7152 * g + 0.0722 * b) as f32
    });
    Plane { width: picture.width, height: picture.height, values: values.collect() }
}

fn product(a: &Plane, b: &Plane) -> Plane {
    let values = a.values.iter().zip(&b.values).map(|(a, b)| a * b).collect();
    Plane { width: a.width, height: a.height, values }
}

/// A Gaussian across the window, of sum one.
fn window() -> Vec<f32> {
    let centre = (WINDOW / 2) as f64;
    let bell = (0..WINDOW).map(|i| (-0.5 * ((i as f64 - centre) / DEVIATION).powi(2)).exp());
    let bell: Vec<f64> = bell.collect();
    let sum: f64 = bell.iter().sum();
    bell.into_iter().map(|w| (w / sum) as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Rgb, random};

    fn random_picture(seed: u64) -> Picture {
        let pixel = |i| Rgb::grey((random::mix(seed + i) >> 40) as f32 / 16_777_216.0);
        Picture { width: 30, height: 20, pixels: (0..600).map(pixel).collect() }
    }

    #[test]
    fn equal_is_one_and_unrelated_is_near_zero() {
        let (a, b) = (random_picture(0), random_picture(1000));
        assert!((ssim(&a, &a).unwrap() - 1.0).abs() < 1e-6);
        assert!(ssim(&a, &b).unwrap().abs() < 0.15, "{:?}", ssim(&a, &b));
    }

    #[test]
    fn two_flat_greys_by_the_formula() {
        let flat = |encoded: f64| {
            let pixel = Rgb::grey(srgb::decode(encoded) as f32);
            Picture { width: 11, height: 11, pixels: vec![pixel; 121] }
        };
        let wanted = (2.0 * 0.4 * 0.6 + C1) / (0.16 + 0.36 + C1);
        assert!((ssim(&flat(0.4), &flat(0.6)).unwrap() - wanted).abs() < 1e-4);
    }

    #[test]
    fn smaller_than_the_window_it_is_undefined() {
        let small = Picture::black(10, 40);
        assert_eq!(ssim(&small, &small), None);
    }
}
