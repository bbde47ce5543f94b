//! What can be asked of `scn paths`, by clap.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::cli::options::{self, Form};

/// Draw the paths of light through a pixel over the picture, and list what they bring
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  scn paths my.scn --pixel 120,80                    into out/my/NAME.paths.png and .svg
  scn paths my.scn fig24 --pixel 120,80 -o paths.svg of one of several renders, into one file
  scn paths my.scn --pixel 9,9 --samples 16384       more paths: rare ones are found
  scn paths my.scn --pixel 9,9 --by class            a colour for each kind of path
  scn paths my.scn --pixel 9,9 --format json         for programs; docs/paths.md tells what is in it

Caustics straight from the light are pink, those of light that was scattered before blue, all other
paths grey. What is listed adds up to the pixel as these samples make it.")]
pub struct Paths {
    /// The scene file
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Which of its renders, if it has several
    #[arg(value_name = "RENDER")]
    pub render: Option<String>,
    /// Column and row of the pixel, counted from 0 at the top left; of the scaled picture
    #[arg(long, value_name = "x,y", value_parser = pixel, allow_hyphen_values = true)]
    pub pixel: [u64; 2],
    /// Samples of the pixel that are followed
    #[arg(long, value_name = "N", default_value_t = 1024, value_parser = samples, allow_negative_numbers = true)]
    pub samples: u64,
    /// Chooses all random numbers
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = options::seed, allow_negative_numbers = true)]
    pub seed: u64,
    /// Factor on the picture's width and height
    #[arg(long, value_name = "F", default_value_t = 1.0, value_parser = options::scale, allow_negative_numbers = true)]
    pub scale: f64,
    /// Change the scene, as if written last in the render; may be given more than once
    #[arg(long, value_name = "path=value")]
    pub set: Vec<String>,
    /// Files NAME.png and NAME.svg, or only one of them
    #[arg(short, long, value_name = "NAME | NAME.png | NAME.svg")]
    pub output: Option<PathBuf>,
    /// Draw over this picture of the scene, EXR or PNG, in place of a rough one
    #[arg(long, value_name = "PICTURE")]
    pub over: Option<PathBuf>,
    /// What colours tell apart
    #[arg(long, value_name = "WHAT", default_value = "caustic")]
    pub by: By,
    /// Draw so many paths: of each kind the one that brings most, then of each the next
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = drawn, allow_negative_numbers = true)]
    pub lines: u64,
    /// List the surfaces of so many paths, those that bring most
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = drawn, allow_negative_numbers = true)]
    pub top: u64,
    /// How the list is written to stdout: for people, or as one JSON object
    #[arg(long, value_name = "FORM", default_value = "human")]
    pub format: Form,
}

/// What colours tell apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum By {
    /// Caustics straight from the light, those of light that was scattered before, and the rest
    Caustic,
    /// The kinds of paths that bring most
    Class,
}

/// More samples of one pixel take longer than a picture.
const MOST_SAMPLES: u64 = 1 << 24;
/// More lines hide each other.
const MOST_LINES: u64 = 100_000;

fn pixel(text: &str) -> Result<[u64; 2], String> {
    let parts: Result<Vec<u64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    match parts.as_deref() {
        Ok([x, y]) => Ok([*x, *y]),
        _ => Err("write two whole numbers, column and row, such as 120,80".to_string()),
    }
}

fn samples(text: &str) -> Result<u64, String> {
    options::whole(text, 1, MOST_SAMPLES)
}

fn drawn(text: &str) -> Result<u64, String> {
    options::whole(text, 0, MOST_LINES)
}
