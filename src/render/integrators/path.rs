//! All light, however often it was scattered: paths from the camera [Kajiya86], with next-event
//! estimation and multiple importance sampling [Veach95].

use super::carrier::{Branch, Carrier};
use super::lighting::Lighting;
use super::roulette::{self, Roulette};
use super::{Source, Stream, World};
use crate::render::geometry::Hit;
use crate::render::lights::Site;
use crate::render::materials::{Part, Scatter, Seen};

/// The path tracer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// How lights are asked, if they are; else paths find lamps by chance alone.
    pub lighting: Option<Lighting>,
    /// Whether the two ways to find a lamp are weighed against each other. If not, a light that
    /// is asked counts by that alone.
    pub mis: bool,
    /// Where a path goes on as several.
    pub splits: Splits,
    /// By what chance a path goes on.
    pub roulette: Roulette,
    /// Surfaces before paths may be ended.
    pub roulette_after: u32,
    /// How often light is scattered at most, mirrors, glass and metal included.
    pub depth: u32,
    /// How many pixels share the light that comes to their first diffuse surfaces from others; 1: none
    /// do.
    pub reuse: u32,
}

/// Where a path goes on as several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Splits {
    /// The first so many mirrors, panes of glass and metals: by all ways on.
    pub specular: u32,
    /// The first so many surfaces that scatter: by `rays`.
    pub diffuse: u32,
    /// How many, 1 or more.
    pub rays: u32,
}

/// The power heuristic, with the square [Veach95]: the part of one way to find light that is
/// found with density `a`, and by another way with density `b`.
#[inline(always)]
pub(super) fn power(a: f32, b: f32) -> f32 {
    // By the ratio: squares of large densities have no place in f32.
    let (greater, lesser) = if a > b { (a, b) } else { (b, a) };
    let ratio = lesser / greater;
    let square = ratio * ratio;
    (if a > b { 1.0 } else { square }) / (1.0 + square)
}

impl Path {
    /// What a ray brings that meets nothing.
    pub(super) fn escaped(&self, world: &World, branch: &Branch, carrier: &mut Carrier) {
        let direction = branch.ray.direction;
        for light in &world.lights.surroundings {
            let asked = light.asked.map(|number| number as usize);
            let (radiance, pdf_w) = match branch.pdf_w == 0.0 || asked.is_none() {
                true => (light.radiance(direction), 0.0),
                false => light.met(&branch.site, direction),
            };
            if radiance.is_black() {
                continue;
            }
            let weight = self.weight(world, branch, asked, |_| pdf_w);
            let light = branch.throughput * radiance * weight;
            carrier.add(branch.trail, light, || Source::Direction(direction));
        }
    }

    /// The part that counts of the emission of a surface that was met.
    pub(super) fn weight_of_met(&self, world: &World, branch: &Branch, hit: &Hit) -> f32 {
        let number = world.lights.of_material(hit.material);
        self.weight(world, branch, number, |site| {
            number.map_or(0.0, |number| world.lights.all[number].pdf_w(site, hit))
        })
    }

    /// The part that counts of light that the path itself has found, where asking lights finds it
    /// with density `pdf_w`.
    fn weight(
        &self,
        world: &World,
        branch: &Branch,
        light: Option<usize>,
        pdf_w: impl Fn(&Site) -> f32,
    ) -> f32 {
        let (Some(lighting), Some(light)) = (&self.lighting, light) else { return 1.0 };
        if branch.pdf_w == 0.0 {
            return 1.0;
        }
        if !self.mis {
            return 0.0;
        }
        let density = lighting.density(world, &branch.site, light, pdf_w(&branch.site));
        power(branch.pdf_w, density)
    }

    /// The largest chance to go on of a path that has met so many surfaces before this one.
    #[inline]
    pub(super) fn limit(&self, surfaces: u32) -> f32 {
        if surfaces >= self.roulette_after { roulette::most(surfaces) } else { roulette::SAFE }
    }

    /// How many rays go on from a surface, and by which part of what it does.
    #[inline]
    pub(super) fn split(&self, branch: &Branch, seen: &Seen) -> Split {
        let specular = seen.is_specular && branch.specular_splits < self.splits.specular;
        let part = if specular { Part::Scattering } else { Part::All };
        let diffuse = seen.lambert.is_some() && branch.diffuse_splits < self.splits.diffuse;
        let rays = if diffuse { self.splits.rays } else { 1 };
        Split { specular, diffuse, part, rays }
    }

    /// Sends several rays on, none of which is ended by chance.
    #[inline(never)]
    pub(super) fn split_on(
        &self,
        branch: &Branch,
        hit: &Hit,
        (site, bsdf, split): (&Site, &impl Scatter, Split),
        stream: &mut Stream,
        carrier: &mut Carrier,
    ) {
        // Every ray that goes on has used them up, whatever way it takes: at a mixture, too.
        let branch = &Branch {
            specular_splits: branch.specular_splits + u32::from(split.specular),
            diffuse_splits: branch.diffuse_splits + u32::from(split.diffuse),
            ..*branch
        };
        if split.specular {
            for way in bsdf.specular().into_iter().flatten() {
                carrier.follow(branch.turned(site, &way, 1), way.event, hit);
            }
            if bsdf.scatters().is_none() {
                return;
            }
        }
        let fan = stream.fan(split.rays);
        for nth in 0..split.rays {
            let Some(mut way) = bsdf.sample(split.part, fan.four(nth)) else { continue };
            way.weight = way.weight / split.rays as f32;
            carrier.follow(branch.turned(site, &way, split.rays), way.event, hit);
        }
    }
}

/// How a path goes on from a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Split {
    /// By all its specular ways.
    pub specular: bool,
    /// By several rays.
    pub diffuse: bool,
    /// What a ray is sampled of.
    pub part: Part,
    /// How many rays.
    pub rays: u32,
}

impl Split {
    /// Whether not one ray goes on, but all that there are.
    #[inline]
    pub fn is_any(self) -> bool {
        self.specular || self.diffuse
    }
}
