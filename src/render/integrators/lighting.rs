//! Next-event estimation: lights are asked at a point, each for one or several of its points.

use glam::Vec3;

use super::{Stream, World};
use crate::math::Rgb;
use crate::render::lights::{Arrival, Light, Site};
use crate::render::materials::Scatter;

/// How lights are asked at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lighting {
    /// How many lights.
    pub lights: Asked,
    /// Points of each of them, 1 or more.
    pub points: u32,
    /// Whether surfaces hide lights.
    pub shadows: bool,
    /// Whether lights take random numbers. Where none needs them the picture is the same without.
    pub numbers: bool,
    /// Which points of a lamp with an area shine.
    pub area_lights: AreaLights,
}

/// How many lights are asked at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    /// Each of them.
    All,
    /// So many, chosen by importance.
    Chosen(u32),
    /// Both of two; of more, one.
    AllOfFew,
}

/// Of so many lights each is asked, if nothing else is said. To ask a second one costs less than a
/// third of what a surface costs, and between a sun and a sky it is worth half of the samples.
const FEW: usize = 2;

/// Which points of a lamp with an area shine on a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AreaLights {
    /// Its centre alone.
    Center,
    /// A random point for every sample.
    Random,
}

impl Lighting {
    /// How many of so many lights are chosen by importance; None: each is asked.
    #[inline]
    fn chosen(&self, lights: usize) -> Option<u32> {
        match self.lights {
            Asked::All => None,
            Asked::Chosen(count) => Some(count),
            Asked::AllOfFew => (lights > FEW || lights == 1).then_some(1),
        }
    }

    /// Whether any point of one light or of all is asked for, so that many sites can ask together.
    pub fn is_plain(&self) -> bool {
        matches!(self.lights, Asked::All | Asked::Chosen(1) | Asked::AllOfFew)
            && self.points == 1
            && self.area_lights == AreaLights::Random
    }

    /// What they then ask, in turn: a light of so many by its number, or None for one that each
    /// chooses.
    pub fn rounds(&self, lights: usize) -> impl Iterator<Item = Option<usize>> + use<> {
        let chosen = self.chosen(lights).map(|_| None);
        let all = if chosen.is_none() { lights } else { 0 };
        chosen.into_iter().chain((0..all).map(Some))
    }

    /// Tells `offer` of all light that arrives at a site, and how many samples its light gets.
    #[inline]
    pub fn ask(
        &self,
        world: &World,
        site: &Site,
        stream: &mut Stream,
        mut offer: impl FnMut(&Arrival, f32),
    ) {
        let mut ask = |light: &Light, taken: f32, u: [f64; 4]| {
            if let Some(arrival) = self.arrival(world, site, light, u) {
                offer(&arrival, taken);
            }
        };
        let chosen = self.chosen(world.lights.all.len());
        // One point of one light: the common case, by one draw of four numbers.
        if (chosen, self.points) == (Some(1), 1) {
            let u = stream.four();
            if let Some((number, pmf)) = world.lights.choose(site, u[2]) {
                ask(&world.lights.all[number], pmf, u);
            }
            return;
        }
        self.each(world, chosen, (site, stream), &mut ask);
    }

    /// Light from a point of a light.
    #[inline(always)]
    fn arrival(
        &self,
        world: &World,
        site: &Site,
        light: &Light,
        [u, v, ..]: [f64; 4],
    ) -> Option<Arrival> {
        match self.area_lights {
            AreaLights::Center => light.at_centre(&world.geometry, site, [u, v]),
            AreaLights::Random => light.sample(&world.geometry, site, [u, v]),
        }
    }

    /// What the surface scatters of light that arrives, and whether that is anything if nothing is in
    /// the way.
    #[inline(always)]
    pub fn scattered(&self, bsdf: &impl Scatter, wi: Vec3, irradiance: Rgb) -> (Rgb, bool) {
        let scattered = bsdf.scattered(wi) * irradiance;
        // A surface hides first of all what is behind itself.
        (scattered, !scattered.is_black() & (!self.shadows | bsdf.faces(wi)))
    }

    /// Asks for every point of every light, or of those that are chosen.
    ///
    /// Every light takes its numbers, whether they are needed or not, so that the numbers of the
    /// next do not depend on where the ray went.
    #[inline(never)]
    fn each(
        &self,
        world: &World,
        chosen: Option<u32>,
        (site, stream): (&Site, &mut Stream),
        ask: &mut impl FnMut(&Light, f32, [f64; 4]),
    ) {
        let lights = &world.lights.all;
        let Some(count) = chosen else {
            for light in lights {
                let fan = stream.fan(self.points);
                for nth in 0..self.points {
                    let u = if self.numbers { fan.four(nth) } else { [0.0; 4] };
                    ask(light, self.points as f32, u);
                }
            }
            return;
        };
        let fan = stream.fan(count * self.points);
        for choice in 0..count {
            let first = fan.four(choice * self.points);
            let u = (f64::from(choice) + first[2]) / f64::from(count);
            let Some((number, pmf)) = world.lights.choose(site, u) else { continue };
            for nth in 0..self.points {
                let u = if nth == 0 { first } else { fan.four(choice * self.points + nth) };
                ask(&lights[number], self.taken(chosen, pmf), u);
            }
        }
    }

    /// The density with which a light's direction is chosen, times the samples that are taken by
    /// it: of the light of that number, with that density of its own.
    pub fn density(&self, world: &World, site: &Site, light: usize, pdf_w: f32) -> f32 {
        let chosen = self.chosen(world.lights.all.len());
        let pmf = if chosen.is_some() { world.lights.pmf(site, light) } else { 1.0 };
        self.taken(chosen, pmf) * pdf_w
    }

    /// How many samples a light gets on average.
    #[inline]
    fn taken(&self, chosen: Option<u32>, pmf: f32) -> f32 {
        match chosen {
            None => self.points as f32,
            Some(count) => (count * self.points) as f32 * pmf,
        }
    }
}
