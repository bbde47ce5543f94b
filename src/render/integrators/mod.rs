//! Integrators: how the light that reaches the camera is computed. Each tells its algorithm in
//! order, in one function.

mod carrier;
mod direct;
mod lighting;
mod path;
mod preview;
mod roulette;

pub use carrier::Carrier;
pub use direct::{Ambient, Direct};
pub use lighting::{AreaLights, Lighting};
pub use path::{Path, Splits};
pub use preview::Preview;
pub use roulette::Roulette;

use super::World;
use super::film::Begun;
use super::geometry::Ray;
use super::samplers::Stream;
use super::tiles::{self, Counts, Job};

/// How light is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Integrator {
    /// From a light to a surface to the camera, and no further.
    Direct(Direct),
    /// All of it.
    Path(Path),
    /// What is where.
    Preview(Preview),
}

impl Integrator {
    /// One pass over the picture; see [`tiles::pass`]. The choice is made here, once a pass, so
    /// that each integrator has a tile loop compiled for it.
    pub fn pass(&self, world: &World, job: &Job) -> Vec<Option<Begun>> {
        match self {
            Self::Direct(direct) => tiles::pass(world, job, |ray, stream, carrier| {
                direct.radiance(world, ray, stream, carrier)
            }),
            Self::Path(path) => tiles::pass(world, job, |ray, stream, carrier| {
                path.radiance(world, ray, stream, carrier)
            }),
            Self::Preview(preview) => tiles::pass(world, job, |ray, _: &mut Stream, carrier| {
                preview.radiance(world, ray, carrier)
            }),
        }
    }
}
