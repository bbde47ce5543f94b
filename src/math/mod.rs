//! Numbers that every room shares: colours, units, meshes, transforms, random numbers.
//!
//! Names nothing else of ours. f64 wherever a scene is described, f32 where it is rendered.

pub mod angles;
mod bounds;
#[cfg(test)]
pub(crate) mod chi_squared;
mod lines;
mod mean;
mod mesh;
pub mod paths;
mod picture;
mod progress;
pub mod random;
mod reach;
mod rgb;
pub mod spectrum;
pub mod srgb;
mod texels;
mod transform;
pub mod units;
pub mod warp;

pub use bounds::Bounds;
pub use lines::{Lines, clipped};
pub use mean::MeanPixel;
pub use mesh::Mesh;
pub use picture::Picture;
pub use progress::{NoProgress, Progress};
pub use reach::Reach;
pub use rgb::Rgb;
pub use spectrum::{Formula, Spectrum, Table};
pub use texels::{Texels, Values};
pub use transform::Transform;
