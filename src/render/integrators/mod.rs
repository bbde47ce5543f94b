//! Integrators: how the light that reaches the camera is computed. Each tells its algorithm in
//! order, in one function.

mod direct;
mod preview;

pub use direct::{AreaLights, Direct};
pub use preview::Preview;

use super::World;
use super::film::Begun;
use super::geometry::Ray;
use super::samplers::Stream;
use super::tiles::{self, Counts, Job, Sample};

/// How light is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Integrator {
    /// From a lamp to a surface to the camera, and no further.
    Direct(Direct),
    /// What is where.
    Preview(Preview),
}

impl Integrator {
    /// One pass over the picture; see [`tiles::pass`]. The choice is made here, once a pass, so
    /// that each integrator has a tile loop compiled for it.
    pub fn pass(&self, world: &World, job: &Job) -> Vec<Option<Begun>> {
        match self {
            Self::Direct(direct) => tiles::pass(world, job, |ray, stream, counts| {
                direct.radiance(world, ray, stream, counts)
            }),
            Self::Preview(preview) => {
                tiles::pass(world, job, |ray, _: &mut Stream, _| preview.radiance(world, ray))
            }
        }
    }
}
