//! Next-event estimation: lights are asked at a point, each for one or several of its points.

use glam::Vec3;

use super::{Stream, World};
use crate::math::Rgb;
use crate::render::lights::{Arrival, Light, Site};
use crate::render::materials::Scatter;

/// How lights are asked at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lighting {
    /// How many lights: None for all, or so many that are chosen by importance.
    pub chosen: Option<u32>,
    /// Points of each of them, 1 or more.
    pub points: u32,
    /// Whether surfaces hide lights.
    pub shadows: bool,
    /// Whether lights take random numbers. Where none needs them the picture is the same without.
    pub numbers: bool,
    /// Which points of a lamp with an area shine.
    pub area_lights: AreaLights,
}

/// Which points of a lamp with an area shine on a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AreaLights {
    /// Its centre alone.
    Center,
    /// A random point for every sample.
    Random,
}

impl Lighting {
    /// Whether one point of one light is asked for: the common case, by one draw of four numbers.
    fn is_single(&self) -> bool {
        (self.chosen, self.points) == (Some(1), 1)
    }

    /// Whether that is any point of it, so that many sites can ask together.
    pub fn is_plain(&self) -> bool {
        self.is_single() && self.area_lights == AreaLights::Random
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
        if self.is_single() {
            let u = stream.four();
            if let Some((number, pmf)) = world.lights.choose(site, u[2]) {
                ask(&world.lights.all[number], pmf, u);
            }
            return;
        }
        self.each(world, site, stream, &mut ask);
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
        site: &Site,
        stream: &mut Stream,
        ask: &mut impl FnMut(&Light, f32, [f64; 4]),
    ) {
        let lights = &world.lights.all;
        let Some(chosen) = self.chosen else {
            for light in lights {
                let fan = stream.fan(self.points);
                for nth in 0..self.points {
                    let u = if self.numbers { fan.four(nth) } else { [0.0; 4] };
                    ask(light, self.points as f32, u);
                }
            }
            return;
        };
        let fan = stream.fan(chosen * self.points);
        for choice in 0..chosen {
            let first = fan.four(choice * self.points);
            let u = (f64::from(choice) + first[2]) / f64::from(chosen);
            let Some((number, pmf)) = world.lights.choose(site, u) else { continue };
            for nth in 0..self.points {
                let u = if nth == 0 { first } else { fan.four(choice * self.points + nth) };
                ask(&lights[number], self.taken(pmf), u);
            }
        }
    }

    /// The density with which a light's direction is chosen, times the samples that are taken by
    /// it: of the light of that number, with that density of its own.
    pub fn density(&self, world: &World, site: &Site, light: usize, pdf_w: f32) -> f32 {
        let pmf = if self.chosen.is_some() { world.lights.pmf(site, light) } else { 1.0 };
        self.taken(pmf) * pdf_w
    }

    /// How many samples a light gets on average.
    #[inline]
    fn taken(&self, pmf: f32) -> f32 {
        match self.chosen {
            None => self.points as f32,
            Some(chosen) => (chosen * self.points) as f32 * pmf,
        }
    }
}
