//! The render log: what was done, in the order it happened, for people or for machines.
//!
//! docs/log.md describes the events for machines; a test holds it to them.

use std::path::Path;

use serde::Serialize;

use super::bias::Told;
use super::limits::{self, percent};
use super::options::Form;
use super::shard::Slice;
use super::terminal;
use super::words::{duration, rate, size};
use crate::diag::words::{counted, grouped};
use crate::diag::{harmless_line, harmless_text};
use crate::measure::noise::Noise;
use crate::run::Rule;

/// Something that happened. Times are in seconds, sizes in bytes.
#[derive(Debug, Serialize)]
#[serde(tag = "event", rename_all = "snake_case")]
pub enum Event {
    /// The scene and every file it names are read and checked.
    Loaded { scene: String, renders: Vec<String>, files: Vec<Loaded>, seconds: f64 },
    /// One render is ready to begin.
    Built {
        render: String,
        hash: String,
        triangles: u64,
        other_shapes: u64,
        materials: u64,
        lights: u64,
        slivers: u64,
        bytes: u64,
        seconds: f64,
    },
    /// Rays are about to be followed.
    Rendering {
        render: String,
        width: u64,
        height: u64,
        film: [u64; 2],
        crop: Option<[u64; 4]>,
        limits: Rule,
        seed: u64,
        shard: Option<Slice>,
    },
    /// It goes on from a checkpoint; from the first sample if there is none.
    Resumed { render: String, file: String, samples: u64, seconds: f64 },
    /// What is done is kept; `ended` if the render ends with it.
    Checkpoint { render: String, file: String, samples: u64, seconds: f64, ended: bool },
    /// Rays are being followed: `done` of `total` samples, of all pixels together, are taken. Told
    /// when the first are, then once a second at most.
    Progress { render: String, done: u64, total: u64 },
    /// All parts of a render are read, and become its picture.
    Merged { render: String, parts: usize, samples: u64 },
    /// The picture is there.
    Rendered {
        render: String,
        samples: u64,
        mean_samples: f64,
        rays: u64,
        shadow_rays: u64,
        seconds: f64,
        rays_per_second: f64,
        peak_memory: Option<u64>,
        error: Option<Error>,
        limits: Rule,
        stopped_by: &'static str,
    },
    /// Something makes the picture systematically wrong, whatever the number of samples.
    Bias {
        render: String,
        #[serde(flatten)]
        told: Told,
    },
    /// Something about the picture that is no fault of the scene.
    Remark { render: String, text: String },
    /// It was asked to stop. `samples` of each pixel are in the picture, or in part of it. No render
    /// while the scene and its files are read.
    Interrupted { render: Option<String>, samples: u64, of: Option<u64>, tiles: Option<[usize; 2]> },
    /// A file is complete.
    Written { render: String, file: String },
    /// Warnings and errors, as `scn lint --format json` writes them.
    Diagnostics {
        #[serde(flatten)]
        report: serde_json::Value,
    },
    /// All is done.
    Done { pictures: usize, seconds: f64 },
}

/// How wrong a picture is by its noise: √relMSE, and the ends of its 95 % interval. `bound` if it is
/// only known to be no more.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Error {
    pub error: f64,
    pub low: f64,
    pub high: f64,
    pub bound: bool,
}

impl Error {
    /// In words of the field: a root mean square.
    pub fn new(noise: &Noise, bound: bool) -> Self {
        let [error, low, high] = [noise.relmse, noise.low, noise.high].map(f64::sqrt);
        Self { error, low, high, bound }
    }

    fn told(&self) -> String {
        let [error, low, high] = [self.error, self.low, self.high].map(percent);
        if self.high == 0.0 {
            format!("{error}: no two samples of a pixel differ")
        } else if self.bound {
            format!("at most about {high}, by the spread of single samples")
        } else {
            format!("{error}, with 95 % confidence {low} to {high}")
        }
    }
}

/// A file that was read.
#[derive(Debug, Serialize)]
pub struct Loaded {
    pub name: String,
    pub bytes: u64,
    pub triangles: Option<u64>,
}

/// Where events go.
#[derive(Clone, Copy, Debug)]
pub struct Log {
    pub form: Form,
    pub quiet: bool,
}

impl Log {
    /// Whether anybody reads of progress here.
    pub fn tells_progress(&self) -> bool {
        self.form == Form::Json && !self.quiet
    }

    /// Writes an event to stdout.
    pub fn tell(&self, event: &Event) {
        if self.quiet {
            return;
        }
        let text = match self.form {
            Form::Human => harmless_text(&human(event)),
            Form::Json => {
                let line = serde_json::to_string(event).expect("words and numbers are JSON");
                format!("{line}\n")
            }
        };
        terminal::say(&text);
    }
}

/// A line of the log: what it is about, and what is to be said.
fn line(about: &str, text: &str) -> String {
    format!("  {about:<9} {text}\n")
}

fn human(event: &Event) -> String {
    match event {
        Event::Loaded { scene, renders, files, seconds } => loaded(scene, renders, files, *seconds),
        Event::Built {
            render,
            triangles,
            other_shapes,
            materials,
            lights,
            slivers,
            bytes,
            seconds,
            ..
        } => {
            let shape = if *triangles > 0 { "other shape" } else { "shape" };
            let counts = [
                (*triangles, "triangle"),
                (*other_shapes, shape),
                (*materials, "material"),
                (*lights, "light"),
            ];
            let mut scene: Vec<String> = counts
                .into_iter()
                .filter(|(count, word)| *count > 0 || *word == "light")
                .map(|(count, word)| match count {
                    0 => format!("no {word}s"),
                    _ => counted(count, word),
                })
                .collect();
            if *slivers > 0 {
                scene.push(format!("{} dropped for want of area", counted(*slivers, "triangle")));
            }
            let built = format!("in {}, {}", duration(*seconds), size(*bytes));
            format!("\n{render}\n") + &line("scene", &scene.join(", ")) + &line("built", &built)
        }
        Event::Rendering { width, height, crop, limits, seed, shard, .. } => {
            let mut text = format!("{width} × {height}, {}", limits::told(limits));
            if let Some([x0, y0, x1, y1]) = crop {
                text.push_str(&format!(", columns {x0} to {x1} and rows {y0} to {y1} alone"));
            }
            if *seed != 0 {
                text.push_str(&format!(", seed {seed}"));
            }
            if let Some(slice) = shard {
                text.push_str(&format!(", {}", slice.told()));
            }
            line("picture", &text)
        }
        Event::Rendered {
            rays,
            shadow_rays,
            seconds,
            peak_memory,
            error,
            limits,
            stopped_by,
            samples,
            mean_samples,
            ..
        } => {
            let mut all = counted(*rays, "camera ray");
            if *shadow_rays > 0 {
                all.push_str(&format!(" and {}", counted(*shadow_rays, "shadow ray")));
            }
            let rate = rate(rays + shadow_rays, *seconds);
            let mut text = line("rendered", &format!("in {}: {all}, {rate}", duration(*seconds)));
            if let Some(bytes) = peak_memory {
                text.push_str(&line("memory", &format!("{} at most", size(*bytes))));
            }
            if limits::several(limits) && *stopped_by != "interruption"
                || ["time", "error"].contains(stopped_by)
            {
                let mut reached = counted(*samples, "sample");
                if *mean_samples < 0.999 * *samples as f64 {
                    reached = format!("{mean_samples:.0} on average and at most {reached}");
                }
                text.push_str(&line(
                    "stopped",
                    &format!("by {stopped_by}, after {reached} a pixel"),
                ));
            }
            if let Some(error) = error {
                text.push_str(&line("error", &error.told()));
            }
            text
        }
        Event::Resumed { file, samples, seconds, .. } => line(
            "resumed",
            &match samples {
                0 => format!("nothing: there is no {}, so it begins anew", harmless_line(file)),
                _ => {
                    let done = counted(*samples, "sample");
                    format!("{}, {done} a pixel in {}", harmless_line(file), duration(*seconds))
                }
            },
        ),
        Event::Checkpoint { file, ended: true, .. } => line("kept", &harmless_line(file)),
        Event::Checkpoint { .. } => String::new(),
        Event::Merged { render, parts, samples } => {
            let (parts, samples) = (counted(*parts as u64, "part"), counted(*samples, "sample"));
            format!("{render}\n") + &line("merged", &format!("{parts}, {samples} a pixel"))
        }
        Event::Bias { told, .. } => line("bias", &told.line()),
        // Told on stderr.
        Event::Progress { .. } | Event::Remark { .. } | Event::Diagnostics { .. } => String::new(),
        Event::Interrupted { render: None, .. } => {
            "stopped while the scene was read; nothing was rendered\n".to_string()
        }
        Event::Interrupted { samples, of, tiles, .. } => line(
            "stopped",
            &match tiles {
                None if *samples == 0 => "before the first ray; nothing was rendered".to_string(),
                Some([0, _]) => "in the first sample; nothing is written".to_string(),
                None => match of {
                    Some(of) => {
                        format!("after {} of {} samples a pixel", grouped(*samples), grouped(*of))
                    }
                    None => format!("after {} a pixel", counted(*samples, "sample")),
                },
                Some([done, of]) => {
                    format!(
                        "in the first sample: {done} of {of} tiles have it, the others are black"
                    )
                }
            },
        ),
        Event::Written { file, .. } => line("wrote", &harmless_line(file)),
        Event::Done { pictures, seconds } => {
            format!("\n{} in {}\n", counted(*pictures as u64, "picture"), duration(*seconds))
        }
    }
}

fn loaded(scene: &str, renders: &[String], files: &[Loaded], seconds: f64) -> String {
    let renders = counted(renders.len() as u64, "render");
    let scene = harmless_line(scene);
    let mut text = format!("{scene}: {renders}, loaded in {}\n", duration(seconds));
    let width = files.iter().map(|file| file.name.chars().count()).max().unwrap_or(0);
    let short = |file: &Loaded| size(file.bytes);
    let widest = files.iter().map(|file| short(file).len()).max().unwrap_or(0);
    for file in files {
        let Loaded { name, triangles, .. } = file;
        let name = harmless_line(name);
        let mut row = format!("{name:<width$}  {:>widest$}", short(file));
        if let Some(triangles) = triangles {
            row.push_str(&format!("  {}", counted(*triangles, "triangle")));
        }
        text.push_str(&line("file", &row));
    }
    text
}

/// A name for machines; bytes that are no text become marks.
pub fn name(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

/// A name for people, on one line.
pub fn shown(path: &Path) -> String {
    harmless_line(&name(path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_log_reads_well() {
        let file = |name: &str, bytes, triangles| Loaded { name: name.into(), bytes, triangles };
        let events = [
            Event::Loaded {
                scene: "w01.scn".into(),
                renders: vec!["a".into(), "b".into()],
                files: vec![file("bunny.obj", 7_340_000, Some(99_785)), file("a.mtl", 80, None)],
                seconds: 0.21,
            },
            Event::Built {
                render: "a".into(),
                hash: String::new(),
                triangles: 99_785,
                other_shapes: 0,
                materials: 1,
                lights: 0,
                slivers: 0,
                bytes: 12_000_000,
                seconds: 0.1,
            },
            Event::Rendering {
                render: "a".into(),
                width: 512,
                height: 512,
                film: [512, 512],
                crop: None,
                limits: Rule { samples: Some(16), ..Rule::default() },
                seed: 0,
                shard: None,
            },
            Event::Rendered {
                render: "a".into(),
                samples: 16,
                mean_samples: 16.0,
                rays: 4_194_304,
                shadow_rays: 1000,
                seconds: 2.0,
                rays_per_second: 2.1e6,
                peak_memory: Some(40_000_000),
                error: Some(Error { error: 0.0234, low: 0.02, high: 0.031, bound: false }),
                limits: Rule { samples: Some(16), ..Rule::default() },
                stopped_by: "samples",
            },
            Event::Written { render: "a".into(), file: "out/w01/a.exr".into() },
            Event::Done { pictures: 1, seconds: 2.5 },
        ];
        let text: String = events.iter().map(human).collect();
        assert_eq!(
            text,
            "w01.scn: 2 renders, loaded in 0.21 s\n  \
               file      bunny.obj    7.3 MB  99,785 triangles\n  \
               file      a.mtl      80 bytes\n\
             \na\n  \
               scene     99,785 triangles, 1 material, no lights\n  \
               built     in 0.10 s, 12.0 MB\n  \
               picture   512 × 512, 16 samples a pixel\n  \
               rendered  in 2 s: 4,194,304 camera rays and 1,000 shadow rays, 2.1 million rays a second\n  \
               memory    40.0 MB at most\n  \
               error     2.34 %, with 95 % confidence 2 % to 3.1 %\n  \
               wrote     out/w01/a.exr\n\
             \n1 picture in 2.50 s\n"
        );
    }

    #[test]
    fn a_stop_tells_what_there_is() {
        let told = |render: Option<&str>, samples, tiles| {
            let render = render.map(str::to_string);
            human(&Event::Interrupted { render, samples, of: Some(16), tiles })
        };
        assert_eq!(told(None, 0, None), "stopped while the scene was read; nothing was rendered\n");
        assert_eq!(
            told(Some("a"), 0, None),
            line("stopped", "before the first ray; nothing was rendered")
        );
        assert_eq!(
            told(Some("a"), 0, Some([0, 9])),
            line("stopped", "in the first sample; nothing is written")
        );
        assert_eq!(told(Some("a"), 3, None), line("stopped", "after 3 of 16 samples a pixel"));
    }
}
