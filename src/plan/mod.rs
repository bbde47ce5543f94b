//! Stage → Plan: what a scene requires of the renderer, with the reason for each answer; and what
//! about it makes its pictures systematically wrong.
//!
//! A feature is something the renderer has code for that is skipped where no scene part asks for
//! it. `prepare` builds the World and the integrator by the plan. What is left out changes no bit
//! of a picture: `--force all` puts everything in, and a test compares the two.

pub mod daylight;
mod textures;
mod survey;
mod features;
mod instances;
mod spectra;
mod dispersion;
mod rare;
mod paths;
mod bias;
pub mod errors;

pub use bias::{Bias, Kind, biases};
pub use features::{Answer, Feature, Need, Plan};
pub use instances::Copies;
pub use paths::{Chosen, Unmet};
pub use textures::{largest, largest_of};
