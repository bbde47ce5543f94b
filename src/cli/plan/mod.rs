//! `scn plan`: what each render requires, what it takes, how wrong it will be.

mod options;
mod forecast;
mod report;

use std::time::Instant;

use serde::Serialize;

pub use options::Plan;

use super::bias::{self, Told};
use super::clock::Clock;
use super::log::shown;
use super::options::Form;
use super::{End, failed, limits, scene_file, terminal, whose};
use crate::diag::words::counted;
use crate::diag::{Sources, harmless_text};
use crate::files;
use crate::load::{Loader, Stage};
use crate::math::{NoProgress, Rgb};
use crate::plan::{Feature, Need};
use crate::prepare::{self, Prepared};
use crate::render::film::Taken;
use crate::render::tiles::Threads;
use crate::run::{self, Pilot, Watch};
use forecast::Forecast;

/// Bytes that a thread takes while it renders: what is known of a wave of samples, measured 0.8 MB,
/// and of a cell of pixels that share light, up to 1.8 MB.
const OF_A_THREAD: u64 = 3 << 20;

/// Bytes that a render takes beside all that: what is written, and the allocator's rest.
const BESIDE: u64 = 2 << 20;

/// How error and time hang together.
const RULE: &str = "twice the time, 0.71 times the error";

/// All about one render.
#[derive(Debug, Serialize)]
struct Planned {
    render: String,
    features: Vec<OfFeature>,
    memory: Memory,
    pilot: OfPilot,
    /// Whether samples are spread evenly, so that their error falls faster than is told.
    cautious: bool,
    #[serde(flatten)]
    forecast: Forecast,
    biases: Vec<Told>,
}

/// A feature of the renderer.
#[derive(Debug, Serialize)]
struct OfFeature {
    #[serde(serialize_with = "word")]
    feature: Feature,
    #[serde(serialize_with = "need")]
    need: Need,
    /// Whether it is put in.
    built: bool,
    why: String,
    file: Option<String>,
    line: Option<usize>,
}

fn word<S: serde::Serializer>(feature: &Feature, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(feature.word())
}

fn need<S: serde::Serializer>(need: &Need, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(match need {
        Need::Required => "required",
        Need::Unneeded => "unneeded",
        Need::SwitchedOff => "switched_off",
    })
}

/// Bytes.
#[derive(Debug, Serialize)]
struct Memory {
    objects: Vec<OfObject>,
    geometry: u64,
    /// About what it would take if instances were copies; the same where there are none.
    copied: u64,
    /// Objects that are instances.
    instances: u64,
    /// Pictures of textures.
    textures: u64,
    /// Sums of the film, the picture and its standard error.
    film: u64,
    /// Of the process, at most; None where the system does not tell.
    peak: Option<u64>,
}

/// An object's part of the geometry.
#[derive(Debug, Serialize)]
struct OfObject {
    name: String,
    triangles: u64,
    bytes: u64,
}

/// The pilot run.
#[derive(Debug, Serialize)]
struct OfPilot {
    /// Of each of its pixels.
    samples: u64,
    pixels: u64,
    seconds: f64,
    samples_per_second: f64,
    shadow_rays_per_sample: f64,
    /// √relMSE of its pixels, and the ends of its 95 % interval.
    error: Option<f64>,
    low: Option<f64>,
    high: Option<f64>,
    /// Whether the error is only a bound from above.
    bound: bool,
}

pub fn run(options: &Plan) -> End {
    let all = || plan(options);
    let ended = match options.threads {
        None => all(),
        Some(count) => match Threads::new(count as usize) {
            Some(threads) => threads.run(all),
            None => Err(failed(&format!("the system does not give {count} threads"))),
        },
    };
    ended.err().unwrap_or(End::Well)
}

fn plan(options: &Plan) -> Result<(), End> {
    let mut sources = Sources::new();
    let scene = shown(&options.file);
    let compiled = scene_file::compile(&options.file, &options.set, &options.only, &mut sources)
        .ok_or(End::NotDone)?;
    scene_file::no_errors(compiled.diagnostics, &sources, &scene)?;
    let renders =
        scene_file::chosen(compiled.renders, &compiled.setups, &options.only, &options.file)
            .map_err(|text| failed(&text))?;
    let settings = prepare::Settings {
        scale: options.scale,
        crop: options.crop,
        portable: terminal::portable(),
    };
    let mut loader = Loader::new(&NoProgress);
    let (mut stages, mut found, mut faults) = (Vec::new(), Vec::new(), Vec::new());
    for render in renders {
        let (stage, told) = loader.stage(&render.scene, &mut sources);
        found.extend(told);
        if let Some(stage) = stage {
            faults.push((render.name.value.clone(), prepare::check(&stage, &settings)));
            stages.push((render.name.value, stage));
        }
    }
    found.extend(whose::told(faults));
    scene_file::no_errors(found, &sources, &scene)?;
    if let Some((name, unfit)) =
        stages.iter().find_map(|(name, stage)| Some((name, settings.unfit(stage)?)))
    {
        return Err(failed(&format!("render `{name}`: {unfit}")));
    }
    if options.format == Form::Human {
        let renders = counted(stages.len() as u64, "render");
        terminal::say(&harmless_text(&format!("{scene}: {renders}\n")));
    }
    let mut all = Vec::new();
    for (name, stage) in &stages {
        let planned = one(name, stage, options, &settings, &sources)?;
        match options.format {
            Form::Human => terminal::say(&harmless_text(&report::report(&planned))),
            Form::Json => all.push(planned),
        }
    }
    if options.format == Form::Json {
        let whole = serde_json::json!({ "scene": scene, "renders": all });
        terminal::say(&format!("{whole:#}\n"));
    }
    Ok(())
}

fn one(
    name: &str,
    stage: &Stage,
    options: &Plan,
    settings: &prepare::Settings,
    sources: &Sources,
) -> Result<Planned, End> {
    let plan = bias::plan(stage, options.force);
    let (prepared, found) = prepare::prepare_by(&plan, stage, settings, &NoProgress);
    let Some(mut prepared) = prepared else {
        scene_file::no_errors(found, sources, &shown(&options.file))?;
        return Err(End::SceneErrors);
    };
    // The pilot run takes sums of its own, which are no part of the render.
    let loaded = files::memory::peak();
    let watch = Clock(Instant::now());
    let Prepared { world, integrator, .. } = &prepared;
    let pilot = run::pilot(world, integrator, options.seed, &|| watch.now());
    let rule = limits::of(options.samples, options.time, options.error, &stage.scene.stop);
    let pixels = world.film.window.pixels();
    let rhythm = world.sampler.rhythm();
    let cautious = rhythm.round > 1;
    let forecast = Forecast::new(&pilot, pixels, &rule, rhythm);
    let end = forecast.end().map_or(pilot.samples, |end| end.samples);
    let layers = world.film.layers;
    let colours = (2 + layers) * size_of::<Rgb>();
    let film = pixels.saturating_mul(Taken::bytes_a_pixel(end, layers, rhythm) + colours as u64);
    let working = BESIDE + OF_A_THREAD * Threads::here() as u64;
    let samples = end.saturating_mul(pixels);
    let biases = bias::measured(stage, &mut prepared, samples, sources, &watch);
    let features = plan.answers.iter().map(|answer| {
        let at = answer.at.map(|span| bias::place(sources, span));
        OfFeature {
            feature: answer.feature,
            need: answer.need,
            built: plan.builds(answer.feature),
            why: answer.why.clone(),
            file: at.as_ref().map(|(file, _)| file.clone()),
            line: at.map(|(_, line)| line),
        }
    });
    let objects = prepared.objects.iter().map(|object| OfObject {
        name: object.name.clone(),
        triangles: object.triangles,
        bytes: object.bytes,
    });
    Ok(Planned {
        render: name.to_string(),
        features: features.collect(),
        memory: Memory {
            objects: objects.collect(),
            geometry: prepared.summary.bytes,
            copied: prepared.summary.bytes_of_copies,
            instances: prepared.summary.instances,
            textures: prepared.summary.texture_bytes,
            film,
            peak: loaded.map(|peak| peak.saturating_add(film).saturating_add(working)),
        },
        pilot: OfPilot::new(&pilot),
        cautious,
        forecast,
        biases,
    })
}

impl OfPilot {
    fn new(pilot: &Pilot) -> Self {
        Self {
            samples: pilot.samples,
            pixels: pilot.pixels,
            seconds: pilot.seconds,
            samples_per_second: pilot.rate(),
            shadow_rays_per_sample: pilot.shadow_rays,
            error: pilot.noise.map(|noise| noise.relmse.sqrt()),
            low: pilot.noise.map(|noise| noise.low.sqrt()),
            high: pilot.noise.map(|noise| noise.high.sqrt()),
            bound: pilot.bound,
        }
    }
}
