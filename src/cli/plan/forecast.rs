//! What a render will take and reach, told from a pilot run.
//!
//! Time grows with the samples; the error, √relMSE, falls with the square root of their number. For
//! samples spread evenly that is cautious: their error falls faster, at edges and in smooth parts.

use serde::Serialize;

use crate::cli::options::MAX_SAMPLES;
use crate::render::samplers::Rhythm;
use crate::run::{Pilot, Rule, first_check};

/// Samples a pixel that can be asked for.
pub const MOST_SAMPLES: u64 = MAX_SAMPLES;

/// The errors that are always told of.
const TARGETS: [f64; 2] = [0.01, 0.001];

/// A number of samples, and what comes of it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Reached {
    /// Samples a pixel.
    pub samples: u64,
    /// Seconds of rendering.
    pub seconds: f64,
    /// √relMSE; None where the pilot run told nothing of it.
    pub error: Option<f64>,
}

/// A limit of the render, and what it leads to by itself.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Limit {
    /// samples, time or error.
    pub limit: &'static str,
    /// A number of samples, seconds, or a part.
    pub value: f64,
    /// None where the pilot run told nothing of the error.
    pub reached: Option<Reached>,
}

/// What a render will take and reach.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Forecast {
    /// The limits that are set.
    pub limits: Vec<Limit>,
    /// Which of them will be the first to be reached.
    pub first: Option<&'static str>,
    /// What errors of 1 % and 0.1 % take.
    pub targets: Vec<Limit>,
}

impl Forecast {
    /// Of a picture of so many pixels.
    pub fn new(pilot: &Pilot, pixels: u64, rule: &Rule, rhythm: Rhythm) -> Self {
        let told = Told { pilot, pixels: pixels as f64 };
        let limit = |limit, value, samples: Option<f64>| Limit {
            limit,
            value,
            reached: samples
                .filter(|samples| *samples <= MOST_SAMPLES as f64)
                .map(|samples| told.reached(samples)),
        };
        let samples = rule.samples.map(|n| limit("samples", n as f64, Some(n as f64)));
        let time = rule.time.map(|time| {
            // Each pixel has one sample at least.
            let samples = (time * pilot.rate() / told.pixels).floor();
            limit("time", time, Some(samples))
        });
        let error = rule.error.map(|error| {
            let samples = told.samples(error).map(|samples| checked(samples, rhythm));
            limit("error", error, samples)
        });
        let limits: Vec<Limit> = [samples, time, error].into_iter().flatten().collect();
        let known = limits.iter().filter_map(|limit| Some((limit.limit, limit.reached?.seconds)));
        let first = known.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(limit, _)| limit);
        let targets = TARGETS.map(|error| limit("error", error, told.samples(error)));
        Self { limits, first, targets: targets.to_vec() }
    }

    /// What the render will come to.
    pub fn end(&self) -> Option<Reached> {
        self.limits.iter().find(|limit| Some(limit.limit) == self.first)?.reached
    }
}

/// The error is looked at when the samples have doubled.
fn checked(samples: f64, rhythm: Rhythm) -> f64 {
    let first = first_check(rhythm) as f64;
    first * (samples / first).max(1.0).log2().ceil().exp2()
}

/// What a pilot run told of a picture of so many pixels.
struct Told<'a> {
    pilot: &'a Pilot,
    pixels: f64,
}

impl Told<'_> {
    fn reached(&self, samples: f64) -> Reached {
        let samples = samples.max(1.0);
        let relmse = self.pilot.noise.map(|noise| noise.relmse);
        Reached {
            samples: samples as u64,
            seconds: samples * self.pixels / self.pilot.rate(),
            error: relmse.map(|relmse| (relmse * self.pilot.samples as f64 / samples).sqrt()),
        }
    }

    /// How many samples an error takes.
    fn samples(&self, error: f64) -> Option<f64> {
        let relmse = self.pilot.noise?.relmse;
        Some((relmse * self.pilot.samples as f64 / (error * error)).ceil())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::noise::Noise;

    /// 1000 samples a second; an error of 10 % after 16.
    fn pilot() -> Pilot {
        let noise = Noise {
            relmse: 0.01,
            low: 0.009,
            high: 0.011,
            epsilon: 1.0,
            doubtful: 0,
            doubtful_part: 0.0,
        };
        Pilot {
            samples: 16,
            pixels: 100,
            timed: 1500,
            seconds: 1.5,
            shadow_rays: 0.5,
            noise: Some(noise),
            bound: false,
        }
    }

    const RHYTHM: Rhythm = Rhythm { round: 1, block: 64 };

    #[test]
    fn time_grows_with_the_samples_and_the_error_falls_with_their_root() {
        let rule = Rule { samples: Some(64), time: Some(10.0), error: Some(0.01), adaptive: false };
        let forecast = Forecast::new(&pilot(), 200, &rule, RHYTHM);
        let reached: Vec<Reached> = forecast.limits.iter().map(|it| it.reached.unwrap()).collect();
        assert_eq!(reached[0].samples, 64);
        assert!((reached[0].seconds - 12.8).abs() < 1e-9);
        assert!((reached[0].error.unwrap() - 0.05).abs() < 1e-12);
        // 10 s are 10,000 samples of 200 pixels.
        assert_eq!(reached[1].samples, 50);
        // 1 % takes 1600, and is looked at after 2048.
        assert_eq!(reached[2].samples, 2048);
        assert_eq!(forecast.first, Some("time"));
        assert_eq!(forecast.end(), Some(reached[1]));
        let targets: Vec<u64> =
            forecast.targets.iter().map(|it| it.reached.unwrap().samples).collect();
        assert_eq!(targets, [1600, 160_000]);
    }

    #[test]
    fn nothing_is_told_of_an_unknown_error() {
        let pilot = Pilot { noise: None, seconds: 0.0, ..pilot() };
        let rule = Rule { error: Some(0.01), ..Rule::default() };
        let forecast = Forecast::new(&pilot, 200, &rule, RHYTHM);
        assert_eq!((forecast.limits[0].reached, forecast.first), (None, None));
        assert_eq!(forecast.end(), None);
        let rule = Rule { samples: Some(4), ..Rule::default() };
        let end = Forecast::new(&pilot, 200, &rule, RHYTHM).end().unwrap();
        assert!(end.seconds.is_finite() && end.error.is_none());
    }

    #[test]
    fn a_picture_without_noise_is_done_at_the_first_look() {
        let mut pilot = pilot();
        pilot.noise.as_mut().unwrap().relmse = 0.0;
        let rule = Rule { error: Some(0.01), ..Rule::default() };
        let forecast = Forecast::new(&pilot, 200, &rule, RHYTHM);
        assert_eq!(forecast.end().unwrap().samples, 256);
        assert_eq!(forecast.targets[1].reached.unwrap().samples, 1);
    }
}
