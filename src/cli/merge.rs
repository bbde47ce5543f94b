//! `scn merge`: the parts of a render, joined to the pictures of one run.

use std::path::{Path, PathBuf};

use clap::Args;

use super::bar::Bar;
use super::finish::Finish;
use super::kept::{Kept, Kind, contradicting};
use super::log::{Event, Log, shown};
use super::options::Form;
use super::output::Output;
use super::shard::Slice;
use super::{End, terminal};
use crate::files::{self, Failure};
use crate::render::film::Taken;
use crate::run::{self, Stopped};

/// Join the parts of a render, made with --shard, into its pictures
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  scn render my.scn --only fig02 --shard 1/3     on one machine
  scn render my.scn --only fig02 --shard 2/3     on another one
  scn render my.scn --only fig02 --shard 3/3     on a third one
  scn merge out/my/fig02.*.part -o fig02.exr     the picture of one run

The parts may come in any order. They are to be of one scene, one seed and the same settings.")]
pub struct Merge {
    /// The parts, all of one render
    #[arg(value_name = "PART", required = true)]
    pub parts: Vec<PathBuf>,
    /// Where the pictures go: a folder, or a file ending in .exr or .png
    #[arg(short, long, value_name = "DIR | FILE.exr | FILE.png", required = true)]
    pub output: PathBuf,
    /// Say nothing but errors
    #[arg(long, short)]
    pub quiet: bool,
    /// How the log on stdout is written: for people, or one JSON object a line
    #[arg(long, value_name = "FORM", default_value = "human")]
    pub log: Form,
}

pub fn run(options: &Merge) -> End {
    match merge(options) {
        Ok(()) => End::Well,
        Err(told) => {
            told.iter().for_each(|text| terminal::fail(text));
            End::NotDone
        }
    }
}

/// A part, without its samples.
struct Part {
    path: PathBuf,
    kept: Kept,
    slice: Slice,
}

/// What is wrong, if anything is.
fn merge(options: &Merge) -> Result<(), Vec<String>> {
    let clock = Bar::new(false);
    let one = |text: String| vec![text];
    let output = Output::new(Some(&options.output), Path::new("")).map_err(one)?;
    let mut parts = read_all(&options.parts)?;
    together(&parts)?;
    parts.sort_by_key(|part| part.slice.first);
    let first = &parts[0];
    let paths = output.paths(&first.kept.about.render);
    for path in [&paths.exr, &paths.png].into_iter().flatten() {
        let picture = |why: String| vec![format!("the picture `{}` {why}", shown(path))];
        let identity = files::regular::identity(path);
        if parts.iter().any(|part| files::regular::identity(&part.path) == identity) {
            return Err(picture("would replace a part that it is made of".to_string()));
        }
        files::whole::ready(path).map_err(|failure| picture(failure.to_string()))?;
    }

    let taken = join(&parts).map_err(one)?;
    let log = Log { form: options.log, quiet: options.quiet };
    let Kept { about, frame, limits, .. } = &first.kept;
    log.tell(&Event::Merged {
        render: about.render.clone(),
        parts: parts.len(),
        samples: first.slice.samples,
    });
    let seconds = parts.iter().map(|part| part.kept.seconds).sum();
    let outcome = run::outcome(&frame.window, frame.light_unit, taken, Stopped::Samples, seconds);
    // The lowest place of all is the lowest one of its part.
    let of_part = outcome.invalid.and_then(|invalid| {
        let sample = invalid.first.sample;
        parts.iter().find(|part| (part.slice.first..part.slice.end).contains(&sample))
    });
    let object = of_part.and_then(|part| part.kept.first.as_deref());
    let finish = Finish { log, about, frame, rule: *limits };
    finish.tell(&outcome, object);
    // Why it could not be written has been told.
    finish.write(outcome, paths).map_err(|_| Vec::new())?;
    log.tell(&Event::Done { pictures: 1, seconds: clock.seconds() });
    Ok(())
}

/// Looks into every part; what is wrong with any is told of all.
fn read_all(paths: &[PathBuf]) -> Result<Vec<Part>, Vec<String>> {
    let (mut parts, mut faults) = (Vec::new(), Vec::new());
    for path in paths {
        match read(path) {
            Ok((kept, slice, _)) => parts.push(Part { path: path.clone(), kept, slice }),
            Err(failure) => faults.push(format!("the part `{}` {failure}", shown(path))),
        }
    }
    if faults.is_empty() { Ok(parts) } else { Err(faults) }
}

/// A part of which all words and samples fit together.
fn read(path: &Path) -> Result<(Kept, Slice, Taken), Failure> {
    let (kept, taken) = Kept::read(path, Kind::Part)?;
    let slice = kept.slice.ok_or_else(contradicting)?;
    let whole = kept.limits.samples == Some(slice.samples)
        && taken.is_sound(&kept.frame.window, kept.about.layers.len())
        && taken.first() == slice.first
        && taken.ends().all(|end| end == slice.end);
    if whole { Ok((kept, slice, taken)) } else { Err(contradicting()) }
}

/// Whether the parts are all of one render, and make it whole.
fn together(parts: &[Part]) -> Result<(), Vec<String>> {
    let first = &parts[0];
    let name = |part: &Part| format!("`{}`", shown(&part.path));
    let stranger = |part: &Part| {
        let differences = part.kept.differences(&first.kept);
        (!differences.is_empty()).then(|| {
            let differences = differences.join("\n    ");
            format!("{} is not of one picture with {}:\n    {differences}", name(part), name(first))
        })
    };
    let strangers: Vec<String> = parts[1..].iter().filter_map(stranger).collect();
    if !strangers.is_empty() {
        return Err(strangers);
    }

    let mut sorted: Vec<&Part> = parts.iter().collect();
    sorted.sort_by_key(|part| (part.slice.first, part.slice.end));
    let mut faults = Vec::new();
    let mut missing = Vec::new();
    let (mut next, mut last): (u64, Option<&Part>) = (0, None);
    for part in sorted {
        let slice = &part.slice;
        match last {
            Some(last) if slice.first < next => faults.push(if last.slice == *slice {
                format!("{} and {} are the same: {}", name(last), name(part), slice.told())
            } else {
                format!(
                    "{} ({}) and {} ({}) overlap",
                    name(last),
                    last.slice.told(),
                    name(part),
                    slice.told()
                )
            }),
            _ if slice.first > next => missing.push((next, slice.first)),
            _ => {}
        }
        if slice.end > next {
            (next, last) = (slice.end, Some(part));
        }
    }
    if next < first.slice.samples {
        missing.push((next, first.slice.samples));
    }
    if !missing.is_empty() {
        faults.push(absent(parts, &missing));
    }
    if faults.is_empty() { Ok(()) } else { Err(faults) }
}

/// Names what is missing: shards, if all parts are of one cut; else samples.
fn absent(parts: &[Part], missing: &[(u64, u64)]) -> String {
    /// More names help nobody.
    const MOST: usize = 20;
    let of = parts[0].slice.of;
    let all: Vec<String> = if parts.iter().all(|part| part.slice.of == of) {
        let there = |index: &u64| parts.iter().any(|part| part.slice.index == *index);
        (1..=of).filter(|index| !there(index)).map(|index| format!("{index}/{of}")).collect()
    } else {
        missing.iter().map(|(from, to)| format!("samples {from} to {}", to - 1)).collect()
    };
    let mut text = all[..all.len().min(MOST)].join(", ");
    if all.len() > MOST {
        text.push_str(&format!(" and {} more", all.len() - MOST));
    }
    match all.first() {
        Some(shard) if shard.contains('/') => {
            let word = if all.len() == 1 { "shard is" } else { "shards are" };
            format!("{} {word} missing: {text}\n  render with --shard {shard}", all.len())
        }
        _ => format!("missing: {text}"),
    }
}

/// All samples, of parts which follow each other. Each is read once more, so that one at a time is
/// in the memory.
fn join(parts: &[Part]) -> Result<Taken, String> {
    let mut joined: Option<Taken> = None;
    for part in parts {
        let told = |why: &str| format!("the part `{}` {why}", shown(&part.path));
        let (_, slice, taken) = read(&part.path).map_err(|failure| told(&failure.to_string()))?;
        joined = match joined {
            _ if slice != part.slice => None,
            None => Some(taken),
            Some(before) => before.join(taken),
        };
        if joined.is_none() {
            return Err(told("has changed while it was read"));
        }
    }
    joined.ok_or_else(|| "there are no parts".to_string())
}
