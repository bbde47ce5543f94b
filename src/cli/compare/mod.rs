//! `scn compare`: pictures measured against a reference.

mod condition;
mod input;
mod json;
mod options;
mod remarks;
mod report;

use std::path::{Path, PathBuf};

use super::options::Form;
use super::{End, terminal};
use crate::files;
use crate::math::Picture;
use crate::measure::{self, Metric, Metrics};
use condition::Condition;
use input::{Input, shown};

pub use options::Compare;
use options::Epsilon;

/// Why nothing could be done, as a line for a person.
type Refusal = String;

/// Everything there is to tell.
struct Comparison<'a> {
    /// What is judged: one picture, or two side by side.
    tests: Vec<Judged<'a>>,
    /// What they are judged against.
    reference: &'a Input,
    settings: measure::Settings,
    /// The layer that is compared, in place of all light.
    layer: Option<&'a str>,
    /// Each condition with each picture it was tried on, and its figure there.
    conditions: Vec<Tried<'a>>,
    /// The difference picture, where one was asked for.
    difference: Option<Difference<'a>>,
}

/// A picture with its figures.
struct Judged<'a> {
    input: &'a Input,
    metrics: Metrics,
}

/// A condition on one picture.
struct Tried<'a> {
    condition: &'a Condition,
    input: &'a Input,
    /// `None` where the metric is undefined.
    value: Option<f64>,
}

impl Tried<'_> {
    fn holds(&self) -> bool {
        self.value.is_some_and(|value| self.condition.holds(value))
    }
}

/// Where the difference picture went, and what it shows.
struct Difference<'a> {
    path: &'a Path,
    shows: &'static str,
}

pub fn run(options: &Compare) -> End {
    match compare(options) {
        Ok(end) => end,
        Err(refusals) => {
            refusals.iter().for_each(|refusal| terminal::fail(refusal));
            End::NotDone
        }
    }
}

fn compare(options: &Compare) -> Result<End, Vec<Refusal>> {
    if let Some(path) = &options.output {
        check_output(path, &options.files()).map_err(|refusal| vec![refusal])?;
    }
    let layer = options.layer.as_deref();
    let inputs = read(&options.files(), layer)?;
    let (reference, tests) = inputs.split_last().ok_or_else(Vec::new)?;
    let settings = measure::Settings {
        epsilon: epsilon(options.epsilon, tests).map_err(|refusal| vec![refusal])?,
        radiance: inputs.iter().all(|input| input.radiance),
        ..measure::Settings::default()
    };
    let mut pairs = Vec::new();
    let mut refusals = Vec::new();
    for input in tests {
        match input.pair(reference) {
            Ok(pair) => pairs.push((input, pair)),
            Err(refusal) => refusals.push(refusal),
        }
    }
    if !refusals.is_empty() {
        return Err(refusals);
    }
    let tests: Vec<Judged> = pairs
        .into_iter()
        .map(|(input, pair)| Judged { input, metrics: Metrics::of(&pair, &settings) })
        .collect();
    let difference = match &options.output {
        None => None,
        Some(path) => Some(write_difference(path, &tests, reference).map_err(|r| vec![r])?),
    };
    let conditions = options.fail_if.iter().flat_map(|condition| {
        tests.iter().map(move |judged| {
            let value = (condition.metric.value)(&judged.metrics);
            Tried { condition, input: judged.input, value }
        })
    });
    let conditions = conditions.collect();
    let comparison = Comparison { tests, reference, settings, layer, conditions, difference };
    match options.format {
        Form::Human => terminal::say(&report::human(&comparison, terminal::stdout_look().width)),
        Form::Json => terminal::say(&json::json(&comparison)),
    }
    Ok(judge(&comparison))
}

/// The ε of relmse that is asked for.
fn epsilon(asked: Epsilon, tests: &[Input]) -> Result<f64, Refusal> {
    match (asked, tests.first()) {
        (Epsilon::Number(epsilon), _) => Ok(epsilon),
        (Epsilon::Own, Some(first)) => first.epsilon().ok_or_else(|| {
            format!("`{}` states no ε (scn:error_epsilon) for --epsilon own", first.name)
        }),
        (Epsilon::Own, None) => Err("there is no picture whose ε could be taken".to_string()),
    }
}

/// Tells which conditions hold, and which cannot be judged.
fn judge(comparison: &Comparison) -> End {
    let mut end = End::Well;
    for tried in &comparison.conditions {
        let (condition, name) = (tried.condition, &tried.input.name);
        let metric = condition.metric.name;
        match tried.value {
            Some(value) if tried.holds() => {
                let figure = report::figure(value);
                terminal::tell(&format!("failed: {condition} holds for {name}: {figure}\n"));
                if end == End::Well {
                    end = End::Held;
                }
            }
            Some(_) => {}
            None => {
                let why = undefined(condition.metric, comparison);
                terminal::fail(&format!(
                    "`{condition}` cannot be judged: {metric} of {name} is undefined, since {why}"
                ));
                end = End::NotDone;
            }
        }
    }
    end
}

/// Why a metric has no value, as a clause.
fn undefined(metric: &Metric, comparison: &Comparison) -> &'static str {
    match metric.name {
        "ssim" => "the pictures are smaller than its window of 11 × 11 pixels",
        _ if !comparison.settings.radiance => "a PNG holds no radiance to expose",
        _ => "the reference is black under every exposure",
    }
}

/// Reads all files; tells of every one that cannot be read.
fn read(paths: &[&PathBuf], layer: Option<&str>) -> Result<Vec<Input>, Vec<Refusal>> {
    let mut inputs = Vec::new();
    let mut refusals: Vec<Refusal> = Vec::new();
    for path in paths {
        match Input::read(path, layer) {
            Ok(input) => inputs.push(input),
            Err(refusal) if refusals.contains(&refusal) => {}
            Err(refusal) => refusals.push(refusal),
        }
    }
    if !refusals.is_empty() {
        return Err(refusals);
    }
    input::name(&mut inputs);
    Ok(inputs)
}

/// Finds out before the work whether the difference picture can be written.
fn check_output(path: &Path, inputs: &[&PathBuf]) -> Result<(), Refusal> {
    let shown = shown(path);
    if !input::has_ending(path, "png") {
        return Err(format!("the difference picture is a PNG, but `{shown}` does not end in .png"));
    }
    let identity = files::regular::identity(path);
    if inputs.iter().any(|input| files::regular::identity(input) == identity) {
        return Err(format!("`{shown}` is one of the pictures compared, and is not overwritten"));
    }
    files::whole::ready(path).map(drop).map_err(|failure| format!("`{shown}` {failure}"))
}

/// FLIP of each picture against the reference in magma, side by side.
fn write_difference<'a>(
    path: &'a Path,
    tests: &[Judged],
    reference: &Input,
) -> Result<Difference<'a>, Refusal> {
    let radiance = tests.iter().all(|judged| judged.metrics.flip_hdr.is_some());
    let maps: Vec<Picture> = tests
        .iter()
        .map(|judged| match &judged.metrics.flip_hdr {
            Some(hdr) if radiance => measure::in_magma(&hdr.map),
            _ => measure::in_magma(&judged.metrics.flip_ldr),
        })
        .collect();
    let shows = if radiance { "flip_hdr" } else { "flip_ldr" };
    let names: Vec<&str> = tests.iter().map(|judged| judged.input.name.as_str()).collect();
    let caption = format!(
        "{shows} of {} against {}: black 0, purple, orange, pale yellow 1",
        names.join(" (left) and "),
        reference.name
    );
    let words = vec![
        ("scn:caption".to_string(), caption),
        ("scn:version".to_string(), env!("CARGO_PKG_VERSION").to_string()),
    ];
    files::png::write(path, &beside(&maps), 1.0, &words)
        .map_err(|failure| format!("`{}` {failure}", shown(path)))?;
    Ok(Difference { path, shows })
}

/// Pictures of one height side by side.
fn beside(pictures: &[Picture]) -> Picture {
    let height = pictures.first().map_or(0, |picture| picture.height);
    let width = pictures.iter().map(|picture| picture.width).sum();
    let rows = (0..height).flat_map(|y| {
        pictures.iter().flat_map(move |it| &it.pixels[y * it.width..(y + 1) * it.width])
    });
    Picture { width, height, pixels: rows.copied().collect() }
}
