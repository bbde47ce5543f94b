//! What can be asked of `scn compare`, by clap.

use std::fmt;
use std::path::PathBuf;

use clap::Args;

use super::condition::Condition;
use crate::cli::options::Form;
use crate::measure::RELMSE_EPSILON;

/// Measure how far a picture is from a reference: A against B
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  scn compare fast.exr slow.exr                       fast.exr against slow.exr
  scn compare new.exr old.exr --reference truth.exr   each of the two against truth.exr
  scn compare a.exr b.exr -o diff.png                 where they differ, as an eye sees it
  scn compare a.exr b.exr --layer caustics            one of their layers
  scn compare a.exr truth.exr --epsilon own           as the error that a.exr states is defined
  scn compare a.exr b.exr --fail-if 'relmse > 0.01' --fail-if 'flip_hdr > 0.05'

Metrics: mse, relmse, relmse_trimmed, mape, bias, bias_red, bias_green, bias_blue, error_p999,
error_max, flip_ldr, flip_hdr, ssim. docs/compare.md says what each means and when to trust it.

Pictures are EXR (linear radiance) or PNG (decoded from sRGB to linear light, clipped to 0 to 1 and
rounded to eight bits by its nature). All must be of one size.

Exit status: 0 well; 1 a --fail-if condition holds; 2 the comparison could not be made.")]
pub struct Compare {
    /// The picture that is judged
    #[arg(value_name = "A")]
    pub a: PathBuf,
    /// What it is judged against; with --reference a second picture, judged beside the first
    #[arg(value_name = "B")]
    pub b: PathBuf,
    /// Judge both A and B against this one
    #[arg(long, short, value_name = "R")]
    pub reference: Option<PathBuf>,
    /// Compare this layer of the pictures, which are EXR, in place of the whole light
    #[arg(long, value_name = "NAME")]
    pub layer: Option<String>,
    /// The ε of relmse, which keeps dark pixels from counting without bound: a number, or `own`
    /// for the one that A's file states with its error
    #[arg(long, value_name = "E", default_value_t = Epsilon::Number(RELMSE_EPSILON))]
    #[arg(value_parser = Epsilon::parse)]
    pub epsilon: Epsilon,
    /// How the figures are written to stdout: for people, or as one JSON object
    #[arg(long, value_name = "FORM", default_value = "human")]
    pub format: Form,
    /// Write where they differ: the map of flip_hdr, or of flip_ldr where there is a PNG, in the
    /// colours of magma, black 0 to pale yellow 1. With --reference A's on the left, B's on the
    /// right
    #[arg(long, short, value_name = "DIFF.png")]
    pub output: Option<PathBuf>,
    /// End with status 1 if this holds: a metric, one of > >= < <=, a number. With --reference
    /// if it holds for A or for B. May be given more than once
    #[arg(long, value_name = "CONDITION", value_parser = Condition::parse)]
    pub fail_if: Vec<Condition>,
}

impl Compare {
    /// The pictures judged, and last the one they are judged against.
    pub fn files(&self) -> Vec<&PathBuf> {
        [&self.a, &self.b].into_iter().chain(&self.reference).collect()
    }
}

/// Which ε relmse has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Epsilon {
    /// This one, above 0.
    Number(f64),
    /// That of the error which A's file states.
    Own,
}

impl Epsilon {
    fn parse(text: &str) -> Result<Self, String> {
        if text == OWN {
            return Ok(Self::Own);
        }
        let why = || format!("write a number, such as 0.01, or {OWN}");
        let value: f64 = text.parse().map_err(|_| why())?;
        if value > 0.0 && value.is_finite() {
            Ok(Self::Number(value))
        } else {
            Err("it must be above 0, and finite".to_string())
        }
    }
}

/// The word for the ε of the file.
const OWN: &str = "own";

impl fmt::Display for Epsilon {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value) => write!(f, "{value}"),
            Self::Own => f.write_str(OWN),
        }
    }
}
