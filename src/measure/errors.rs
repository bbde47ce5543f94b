//! How far pixels are off: squared, relative, signed and extreme errors, all summed in f64 over
//! the components red, green and blue alike.

use super::pair::Pair;

/// The ε of relMSE unless another is asked for.
pub const RELMSE_EPSILON: f64 = 0.01;

/// The ε of MAPE: components of the reference far below it count as this much.
pub const MAPE_EPSILON: f64 = 0.01;

/// The part of all pixels that the trimmed relMSE leaves out, those with the largest errors.
pub const TRIMMED: f64 = 0.001;

/// The part of all components whose absolute errors lie at or below the percentile.
const PERCENTILE: f64 = 0.999;

/// The errors of a picture against its reference, in the unit of their pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Mean of (x − ref)².
    pub mse: f64,
    /// Mean of (x − ref)² / (ref² + ε).
    pub relmse: f64,
    /// The same without the [`trimmed_pixels`](Self::trimmed_pixels) worst pixels.
    pub relmse_trimmed: f64,
    /// How many pixels the trimmed relMSE leaves out; none below 1000 pixels.
    pub trimmed_pixels: usize,
    /// Mean of |x − ref| / (|ref| + [`MAPE_EPSILON`]): 0.01 is one per cent.
    pub mape: f64,
    /// Mean of x − ref of red, green and blue: what does not average out.
    pub bias: [f64; 3],
    /// The value that 99.9 % of all |x − ref| reach or stay below.
    pub percentile: f64,
    /// The largest |x − ref|.
    pub max: f64,
}

impl Errors {
    /// Measures with this ε (> 0) in relMSE.
    pub fn of(pair: &Pair, epsilon: f64) -> Self {
        let pixels = pair.test().pixels.len();
        let (mut squares, mut ratios, mut bias) = (0.0, 0.0, [0.0; 3]);
        let mut relative = Vec::with_capacity(pixels);
        let mut absolute = Vec::with_capacity(3 * pixels);
        for [test, reference] in pair.components() {
            let mut relative_here = 0.0;
            for channel in 0..3 {
                let (x, r) = (test[channel], reference[channel]);
                let off = x - r;
                squares += off * off;
                relative_here += off * off / (r * r + epsilon) / 3.0;
                ratios += off.abs() / (r.abs() + MAPE_EPSILON);
                bias[channel] += off;
                absolute.push(off.abs());
            }
            relative.push(relative_here);
        }
        let trimmed_pixels = (TRIMMED * pixels as f64) as usize;
        let kept = pixels - trimmed_pixels;
        let relmse = mean(&relative);
        if trimmed_pixels > 0 {
            relative.select_nth_unstable_by(kept, f64::total_cmp);
        }
        let components = absolute.len();
        let rank = (PERCENTILE * components as f64).ceil() as usize;
        let max = absolute.iter().copied().fold(0.0, f64::max);
        let (_, percentile, _) =
            absolute.select_nth_unstable_by(rank.clamp(1, components) - 1, f64::total_cmp);
        Self {
            mse: squares / components as f64,
            relmse,
            relmse_trimmed: mean(&relative[..kept]),
            trimmed_pixels,
            mape: ratios / components as f64,
            bias: bias.map(|sum| sum / pixels as f64),
            percentile: *percentile,
            max,
        }
    }

    /// The signed error over all components.
    pub fn mean_bias(&self) -> f64 {
        mean(&self.bias)
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Picture, Rgb};

    fn row(pixels: &[Rgb]) -> Picture {
        Picture { width: pixels.len(), height: 1, pixels: pixels.to_vec() }
    }

    #[track_caller]
    fn near(found: f64, wanted: f64) {
        assert!((found - wanted).abs() <= 1e-7 * wanted.abs().max(1e-9), "{found}, not {wanted}");
    }

    #[test]
    fn two_pixels_by_hand() {
        let test = row(&[Rgb::new(1.5, 2.0, 0.0), Rgb::new(0.5, 0.0, 1.0)]);
        let reference = row(&[Rgb::new(1.0, 4.0, 0.0), Rgb::new(0.0, 0.0, -1.0)]);
        let errors = Errors::of(&Pair::new(&test, &reference).unwrap(), 0.25);
        // Off by .5, −2, 0 and .5, 0, 2.
        near(errors.mse, (0.25 + 4.0 + 0.25 + 4.0) / 6.0);
        near(errors.relmse, (0.25 / 1.25 + 4.0 / 16.25 + 0.25 / 0.25 + 4.0 / 1.25) / 6.0);
        near(errors.mape, (0.5 / 1.01 + 2.0 / 4.01 + 0.5 / 0.01 + 2.0 / 1.01) / 6.0);
        assert_eq!(errors.bias, [0.5, -1.0, 1.0]);
        near(errors.mean_bias(), 0.5 / 3.0);
        assert_eq!((errors.max, errors.percentile), (2.0, 2.0));
        assert_eq!((errors.trimmed_pixels, errors.relmse_trimmed), (0, errors.relmse));
    }

    #[test]
    fn one_firefly_in_a_thousand_is_trimmed_and_reported() {
        let reference = row(&vec![Rgb::grey(1.0); 2000]);
        let mut pixels = vec![Rgb::grey(1.1); 2000];
        pixels[77] = Rgb::grey(1e4);
        pixels[900] = Rgb::grey(5.0);
        let test = row(&pixels);
        let errors = Errors::of(&Pair::new(&test, &reference).unwrap(), RELMSE_EPSILON);
        assert_eq!(errors.trimmed_pixels, 2);
        let even = (f64::from(1.1_f32) - 1.0).powi(2) / 1.01;
        near(errors.relmse_trimmed, even);
        assert!(errors.relmse > 4e4, "{}", errors.relmse);
        near(errors.max, 9999.0);
        // 6 of 6000 components are the two fireflies': the percentile lies just below them.
        near(errors.percentile, f64::from(1.1_f32) - 1.0);
        let mut worse = test.clone();
        worse.pixels[0].r = 7.0;
        let errors = Errors::of(&Pair::new(&worse, &reference).unwrap(), RELMSE_EPSILON);
        near(errors.percentile, 4.0);
    }

    #[test]
    fn the_largest_floats_do_not_overflow() {
        let test = row(&[Rgb::grey(f32::MAX), Rgb::grey(-f32::MAX)]);
        let reference = row(&[Rgb::grey(-f32::MAX), Rgb::BLACK]);
        let errors = Errors::of(&Pair::new(&test, &reference).unwrap(), RELMSE_EPSILON);
        for value in [errors.mse, errors.relmse, errors.mape, errors.mean_bias(), errors.max] {
            assert!(value.is_finite(), "{errors:?}");
        }
    }

    #[test]
    fn a_small_bias_under_large_noise_is_not_lost() {
        let pixels: Vec<Rgb> =
            (0..100_000).map(|i| Rgb::grey(if i % 2 == 0 { 1000.0 } else { -998.0 })).collect();
        let (test, reference) = (row(&pixels), row(&vec![Rgb::BLACK; 100_000]));
        near(Errors::of(&Pair::new(&test, &reference).unwrap(), 0.01).mean_bias(), 1.0);
    }
}
