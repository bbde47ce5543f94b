//! What can be asked of `scn plan`, by clap.

use std::path::PathBuf;

use clap::Args;

use crate::cli::options::{self, Force, Form};

/// Tell what a render requires, takes and reaches, without rendering it
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  scn plan my.scn                     every render of the file
  scn plan my.scn --only fig02        one of them
  scn plan my.scn --error 1%          with another limit than the scene's
  scn plan my.scn --format json       for programs; docs/plan.md tells what is in it

A pilot run of about 0.3 s takes the same samples every time; what it tells of time depends on the
machine and on what else it does.")]
pub struct Plan {
    /// The scene file
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Plan this render alone; may be given more than once
    #[arg(long, value_name = "NAME")]
    pub only: Vec<String>,
    /// How the plan is written to stdout: for people, or as one JSON object
    #[arg(long, value_name = "FORM", default_value = "human")]
    pub format: Form,
    /// Stop after so many samples of each pixel; in place of the scene's limits, as are --time and
    /// --error
    #[arg(long, value_name = "N", value_parser = options::samples, allow_negative_numbers = true)]
    pub samples: Option<u64>,
    /// Stop after so much time of rendering, such as `90s` or `5 min`
    #[arg(long, value_name = "TIME", value_parser = options::time, allow_negative_numbers = true)]
    pub time: Option<f64>,
    /// Stop when the relative error is, with 95 % confidence, at most so much, such as `1%`
    #[arg(long, value_name = "PART", value_parser = options::error, allow_negative_numbers = true)]
    pub error: Option<f64>,
    /// Chooses all random numbers
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = options::seed, allow_negative_numbers = true)]
    pub seed: u64,
    /// Threads to compute with; one for each processor without it
    #[arg(long, value_name = "N", value_parser = options::threads, allow_negative_numbers = true)]
    pub threads: Option<u64>,
    /// Factor on the picture's width and height
    #[arg(long, value_name = "F", default_value_t = 1.0, value_parser = options::scale, allow_negative_numbers = true)]
    pub scale: f64,
    /// Plan for these pixels alone
    #[arg(long, value_name = "x0,y0,x1,y1", value_parser = options::crop)]
    pub crop: Option<[u64; 4]>,
    /// Change the scene, as if written last in every render asked for; may be given more than once
    #[arg(long, value_name = "path=value")]
    pub set: Vec<String>,
    /// Plan with what the scene does not require put in, too
    #[arg(long, value_name = "WHAT")]
    pub force: Option<Force>,
}
