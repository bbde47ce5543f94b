//! All metrics of a picture against its reference, under the names a person asks for them by.

use super::errors::{Errors, RELMSE_EPSILON};
use super::flip::{self, Exposures};
use super::pair::Pair;
use super::planes::Plane;
use super::similarity::ssim;

/// How pictures are measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The ε of relMSE, in squared units of the pixels; > 0.
    pub epsilon: f64,
    /// How fine the display is seen, for FLIP; > 0.
    pub pixels_per_degree: f64,
    /// Whether the pixels are radiance of any range: then HDR-FLIP makes sense of them.
    pub radiance: bool,
}

impl Default for Settings {
    fn default() -> Self {
        let pixels_per_degree = flip::PIXELS_PER_DEGREE;
        Self { epsilon: RELMSE_EPSILON, pixels_per_degree, radiance: true }
    }
}

/// What was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Metrics {
    /// The errors of pixels.
    pub errors: Errors,
    /// FLIP of the pictures as displayed, clipped to [0, 1].
    pub flip_ldr: Plane,
    /// FLIP over all exposures; `None` for pictures that are no radiance or a black reference.
    pub flip_hdr: Option<flip::Hdr>,
    /// Mean SSIM; `None` below 11 × 11 pixels.
    pub ssim: Option<f64>,
}

impl Metrics {
    /// Measures everything.
    pub fn of(pair: &Pair, settings: &Settings) -> Self {
        let (test, reference) = (pair.test(), pair.reference());
        let density = settings.pixels_per_degree;
        Self {
            errors: Errors::of(pair, settings.epsilon),
            flip_ldr: flip::ldr(reference, test, density),
            flip_hdr: if settings.radiance { flip::hdr(reference, test, density) } else { None },
            ssim: ssim(reference, test),
        }
    }

    /// The exposures HDR-FLIP looked at.
    pub fn exposures(&self) -> Option<Exposures> {
        self.flip_hdr.as_ref().map(|hdr| hdr.exposures)
    }
}

/// One figure of [`Metrics`].
#[derive(Clone, Copy, Debug)]
pub struct Metric {
    /// What it is asked for by.
    pub name: &'static str,
    /// What it is, in a few words.
    pub about: &'static str,
    /// The figure; `None` where it is undefined.
    pub value: fn(&Metrics) -> Option<f64>,
}

/// All metrics, in the order they are told.
pub const METRICS: &[Metric] = &[
    Metric { name: "mse", about: "mean squared error", value: |it| Some(it.errors.mse) },
    Metric {
        name: "relmse",
        about: "mean squared error relative to ref² + ε",
        value: |it| Some(it.errors.relmse),
    },
    Metric {
        name: "relmse_trimmed",
        about: "relmse without the worst 0.1 % of the pixels",
        value: |it| Some(it.errors.relmse_trimmed),
    },
    Metric {
        name: "mape",
        about: "mean absolute error relative to |ref| + 0.01",
        value: |it| Some(it.errors.mape),
    },
    Metric { name: "bias", about: "mean signed error", value: |it| Some(it.errors.mean_bias()) },
    Metric {
        name: "bias_red",
        about: "mean signed error of red",
        value: |it| Some(it.errors.bias[0]),
    },
    Metric {
        name: "bias_green",
        about: "mean signed error of green",
        value: |it| Some(it.errors.bias[1]),
    },
    Metric {
        name: "bias_blue",
        about: "mean signed error of blue",
        value: |it| Some(it.errors.bias[2]),
    },
    Metric {
        name: "error_p999",
        about: "absolute error that 99.9 % stay within",
        value: |it| Some(it.errors.percentile),
    },
    Metric { name: "error_max", about: "largest absolute error", value: |it| Some(it.errors.max) },
    Metric {
        name: "flip_ldr",
        about: "mean FLIP as displayed, 0 to 1",
        value: |it| Some(it.flip_ldr.mean()),
    },
    Metric {
        name: "flip_hdr",
        about: "mean FLIP over all exposures, 0 to 1",
        value: |it| it.flip_hdr.as_ref().map(|hdr| hdr.map.mean()),
    },
    Metric { name: "ssim", about: "mean structural similarity, 1 when equal", value: |it| it.ssim },
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Picture, Rgb};

    fn value(metrics: &Metrics, name: &str) -> Option<f64> {
        let metric = METRICS.iter().find(|metric| metric.name == name).unwrap();
        (metric.value)(metrics)
    }

    #[test]
    fn each_name_gives_its_own_figure() {
        let reference = Picture { width: 40, height: 40, pixels: vec![Rgb::grey(0.5); 1600] };
        let mut test = reference.clone();
        for (i, pixel) in test.pixels.iter_mut().enumerate() {
            *pixel = Rgb::new(0.6, 0.45, 0.5 + i as f32 * 0.0005);
        }
        let pair = Pair::new(&test, &reference).unwrap();
        let metrics = Metrics::of(&pair, &Settings::default());
        let mut seen = Vec::new();
        for metric in METRICS {
            let value = (metric.value)(&metrics).unwrap();
            assert!(value.is_finite(), "{} {value}", metric.name);
            assert!(!seen.contains(&value), "{} repeats {value}", metric.name);
            seen.push(value);
        }
        assert!((value(&metrics, "bias_red").unwrap() - 0.1).abs() < 1e-6);
        assert!((value(&metrics, "bias_green").unwrap() + 0.05).abs() < 1e-6);
        assert!((value(&metrics, "error_max").unwrap() - 0.7995).abs() < 1e-6);
    }

    #[test]
    fn what_is_undefined_has_no_value() {
        let picture = Picture { width: 3, height: 3, pixels: vec![Rgb::ONE; 9] };
        let pair = Pair::new(&picture, &picture).unwrap();
        let displayed = Metrics::of(&pair, &Settings { radiance: false, ..Settings::default() });
        assert_eq!(value(&displayed, "flip_hdr"), None);
        assert_eq!(value(&displayed, "ssim"), None);
        assert_eq!(value(&displayed, "mse"), Some(0.0));
        assert_eq!(displayed.exposures(), None);
    }
}
