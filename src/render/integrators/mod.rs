//! Integrators: how the light that reaches the camera is computed. Each tells its algorithm in
//! order, in one function.

mod carrier;
mod direct;
mod flight;
mod guided;
mod lighting;
mod lit;
mod path;
mod preview;
mod reuse;
mod roulette;
mod stages;
mod traced;
mod turns;
mod wave;

pub use carrier::{Carrier, GiveUp};
pub use direct::{Ambient, Direct};
pub use lighting::{AreaLights, Asked, Lighting};
pub use path::{Path, Splits};
pub use preview::Preview;
pub use roulette::Roulette;
pub use traced::{Source, Traced};
pub use wave::Wave;

use flight::Flight;
use traced::Tracing;

use super::World;
use super::film::Begun;
use super::geometry::Ray;
use super::materials::{Any, Makeup, Matter, OnlyDiffuse};
use super::samplers::Stream;
use super::tiles::{self, Job};

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
    /// that each integrator has a tile loop compiled for it, and for what surfaces there are.
    pub fn pass(&self, world: &World, job: &Job) -> Vec<Option<Begun>> {
        match world.makeup {
            Makeup::Any => self.pass_among::<Any>(world, job),
            Makeup::Diffuse => self.pass_among::<OnlyDiffuse>(world, job),
        }
    }

    fn pass_among<M: Matter>(&self, world: &World, job: &Job) -> Vec<Option<Begun>> {
        match self {
            Self::Direct(direct) => tiles::pass(world, job, 1, || {
                |wave: &mut Wave| {
                    wave.each(|ray, stream, carrier| {
                        direct.radiance::<M>(world, ray, stream, carrier);
                    })
                }
            }),
            Self::Path(path) => tiles::pass(world, job, path.reuse as usize, || {
                let mut flight = Flight::<M>::new();
                move |wave: &mut Wave| path.follow(wave, &mut flight)
            }),
            Self::Preview(preview) => tiles::pass(world, job, 1, || {
                |wave: &mut Wave| wave.each(|ray, _, carrier| preview.radiance(world, ray, carrier))
            }),
        }
    }

    /// Tells `visit` all paths that bring light to one sample of a pixel, with the factor that the
    /// film's filter gives to it. Together they are what the sample brings to the picture; of one
    /// that is not finite there are none. The preview follows no light, and so has no paths.
    pub fn trace(
        &self,
        world: &World,
        seed: u64,
        pixel: [u64; 2],
        sample: u64,
        mut visit: impl FnMut(f64, Traced),
    ) {
        let mut wave = Wave::new(world, None);
        wave.begin(seed, std::iter::once((pixel, sample)), &[1]);
        wave.trace();
        match self {
            Self::Direct(direct) => wave.each(|ray, stream, carrier| {
                direct.radiance::<Any>(world, ray, stream, carrier);
            }),
            Self::Path(path) => path.follow(&mut wave, &mut Flight::<Any>::new()),
            Self::Preview(preview) => {
                wave.each(|ray, _, carrier| preview.radiance(world, ray, carrier))
            }
        }
        for (carrier, weight) in wave.brought().filter(|(carrier, _)| carrier.radiance.is_finite())
        {
            if let Some(tracing) = &carrier.traced {
                tracing.paths().for_each(|path| visit(weight, path));
            }
        }
    }
}
