//! The figures for a program: one JSON object, described in docs/compare.md.

use std::collections::BTreeMap;

use serde::Serialize;

use super::input::Input;
use super::{Comparison, remarks};
use crate::measure::{MAPE_EPSILON, METRICS};

#[derive(Serialize)]
struct Whole<'a> {
    version: &'static str,
    reference: File<'a>,
    settings: Settings<'a>,
    pictures: Vec<Judged<'a>>,
    conditions: Vec<Condition>,
    differing: BTreeMap<&'a str, Vec<Option<&'a str>>>,
    notes: Vec<String>,
    difference: Option<Difference<'a>>,
}

#[derive(Serialize)]
struct File<'a> {
    file: String,
    width: usize,
    height: usize,
    words: BTreeMap<&'a str, &'a str>,
}

#[derive(Serialize)]
struct Settings<'a> {
    layer: Option<&'a str>,
    relmse_epsilon: f64,
    mape_epsilon: f64,
    pixels_per_degree: f64,
}

#[derive(Serialize)]
struct Judged<'a> {
    #[serde(flatten)]
    file: File<'a>,
    metrics: BTreeMap<&'static str, Option<f64>>,
    trimmed_pixels: usize,
    exposures: Option<Exposures>,
}

#[derive(Serialize)]
struct Exposures {
    start: f64,
    stop: f64,
    count: u32,
}

#[derive(Serialize)]
struct Condition {
    condition: String,
    file: String,
    value: Option<f64>,
    /// `None` where the metric is undefined.
    holds: Option<bool>,
}

#[derive(Serialize)]
struct Difference<'a> {
    file: String,
    shows: &'a str,
}

/// The object, ready to print.
pub fn json(comparison: &Comparison) -> String {
    let tests = comparison.tests.iter().map(|judged| judged.input);
    let inputs: Vec<_> = tests.chain([comparison.reference]).collect();
    let whole = Whole {
        version: env!("CARGO_PKG_VERSION"),
        reference: file(comparison.reference),
        settings: Settings {
            layer: comparison.layer,
            relmse_epsilon: comparison.settings.epsilon,
            mape_epsilon: MAPE_EPSILON,
            pixels_per_degree: comparison.settings.pixels_per_degree,
        },
        pictures: comparison.tests.iter().map(judged).collect(),
        conditions: comparison.conditions.iter().map(condition).collect(),
        differing: remarks::differences(&inputs)
            .into_iter()
            .map(|difference| (difference.key, difference.values))
            .collect(),
        notes: remarks::notes(comparison),
        difference: comparison.difference.as_ref().map(|difference| Difference {
            file: difference.path.to_string_lossy().into_owned(),
            shows: difference.shows,
        }),
    };
    // Keys are texts and numbers finite: there is nothing serde_json could refuse.
    let mut text = serde_json::to_string_pretty(&whole).unwrap_or_default();
    text.push('\n');
    text
}

fn file(input: &Input) -> File<'_> {
    File {
        file: input.path.to_string_lossy().into_owned(),
        width: input.picture.width,
        height: input.picture.height,
        words: input.words.iter().map(|(key, value)| (key.as_str(), value.as_str())).collect(),
    }
}

fn judged<'a>(judged: &super::Judged<'a>) -> Judged<'a> {
    let metrics = &judged.metrics;
    Judged {
        file: file(judged.input),
        metrics: METRICS.iter().map(|metric| (metric.name, (metric.value)(metrics))).collect(),
        trimmed_pixels: metrics.errors.trimmed_pixels,
        exposures: metrics.exposures().map(|exposures| Exposures {
            start: exposures.start,
            stop: exposures.stop,
            count: exposures.count,
        }),
    }
}

fn condition(tried: &super::Tried) -> Condition {
    Condition {
        condition: tried.condition.to_string(),
        file: tried.input.path.to_string_lossy().into_owned(),
        value: tried.value,
        holds: tried.value.map(|_| tried.holds()),
    }
}
