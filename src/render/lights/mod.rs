//! Lights: what shines on a point, and from where.
//!
//! A light is asked for one of its points or directions ([`Light::sample`]), and tells with which
//! density it would have given one that was found in another way ([`Light::pdf_w`],
//! [`Surroundings::pdf_w`]): the two must agree, for paths weigh them against each other.

mod choice;
mod crowd;
mod directional;
mod disc;
mod flat;
mod lamp;
mod loops;
mod patch;
mod point;
mod rectangle;
mod round;
mod sky;
mod sources;
mod spot;
mod surroundings;
mod together;
mod triangle;
mod views;

#[cfg(test)]
mod tests;

pub use directional::Directional;
pub use disc::Disc;
pub use lamp::{Centre, Lamp};
pub use point::PointLight;
pub use sky::Sky;
pub use sources::Sources;
pub use spot::SpotLight;
pub use surroundings::{Sight, Surroundings};
pub use together::{Arrivals, Sites};

use glam::Vec3;

use choice::Choice;
use crowd::Emitter;

use super::geometry::{Geometry, Hit, Point, Ray, between};
use super::materials::Scatter;
use crate::math::Rgb;

/// Everything that shines.
#[derive(Clone, Debug, Default)]
pub struct Lights {
    /// What is asked, in a fixed order.
    pub all: Vec<Light>,
    /// What a ray sees that meets nothing.
    pub surroundings: Vec<Surroundings>,
    /// By number of the material: the light of the surfaces that have it, [`Lights::NONE`] for
    /// none. A material that shines belongs to one object.
    of_materials: Vec<u32>,
    /// How one is chosen.
    choice: Choice,
}

/// A light that can be asked.
#[derive(Clone, Debug)]
pub enum Light {
    /// Parallel light from infinitely far away.
    Directional(Directional),
    /// A surface that shines.
    Lamp(Box<Lamp>),
    /// A point that shines alike in every direction.
    Point(PointLight),
    /// A point that shines within a cone.
    Spot(SpotLight),
    /// What surrounds the scene.
    Surroundings(Surroundings),
}

/// A point that asks for light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// Where.
    pub point: Point,
    /// Shading normal on the side from which light counts; zero if it counts from both.
    pub normal: Vec3,
}

/// Light that arrives at a point if nothing is in its way.
#[derive(Clone, Copy, Debug)]
pub struct Arrival {
    /// Where it comes from: unit length, away from the point.
    pub wi: Vec3,
    /// Irradiance on a surface square to `wi`, in light units; of a sampled light, the estimate:
    /// radiance over the sample's density in solid angle.
    pub irradiance: Rgb,
    /// That density; 0 of a light that nothing else can find, since it has no extent.
    pub pdf_w: f32,
    /// Meets what is in the way.
    pub shadow: Ray,
}

impl Site {
    /// Where a surface is met.
    #[inline]
    pub fn new(hit: &Hit, bsdf: &impl Scatter) -> Self {
        Self { point: hit.point(), normal: bsdf.side() }
    }

    /// On no surface.
    #[inline]
    pub const fn free(position: Vec3) -> Self {
        Self { point: Point::free(position), normal: Vec3::ZERO }
    }
}

impl Light {
    /// Light from one point of it, chosen by `u` in [0, 1)².
    #[inline(always)]
    pub fn sample(&self, geometry: &Geometry, site: &Site, u: [f64; 2]) -> Option<Arrival> {
        match self {
            Self::Directional(directional) => Some(directional.arrive(&site.point)),
            Self::Lamp(lamp) => lamp.sample(geometry, site, u),
            Self::Point(point) => point.arrive(&site.point),
            Self::Spot(spot) => spot.arrive(&site.point),
            Self::Surroundings(surroundings) => surroundings.sample(site, u),
        }
    }

    /// What bounds it; None of what is infinitely far away.
    fn emitter(&self) -> Option<Emitter> {
        match self {
            Self::Directional(_) | Self::Surroundings(_) => None,
            Self::Lamp(lamp) => Some(lamp.emitter()),
            Self::Point(point) => Some(point.emitter()),
            Self::Spot(spot) => Some(spot.emitter()),
        }
    }

    /// All its light as if it came from its centre, of those that have one; of what shines from
    /// everywhere around, from a direction chosen by `u`.
    pub fn at_centre(&self, geometry: &Geometry, site: &Site, u: [f64; 2]) -> Option<Arrival> {
        match self {
            Self::Lamp(lamp) => lamp.at_centre(&site.point),
            Self::Surroundings(it) if it.sight.is_sun() => it.sample(site, [0.5; 2]),
            other => other.sample(geometry, site, u),
        }
    }

    /// Density with which `sample` gives the direction in which a ray from `site` met this light.
    pub fn pdf_w(&self, site: &Site, hit: &Hit) -> f32 {
        match self {
            Self::Lamp(lamp) => lamp.pdf_w(site, hit),
            // They are no surface.
            Self::Directional(_) | Self::Point(_) | Self::Spot(_) | Self::Surroundings(_) => 0.0,
        }
    }
}

impl Lights {
    /// Stands for no light.
    pub const NONE: u32 = u32::MAX;

    /// With what is asked, what is seen, and by number of the material which of `all` the surfaces
    /// that have it are.
    pub fn new(all: Vec<Light>, surroundings: Vec<Surroundings>, of_materials: Vec<u32>) -> Self {
        let choice = Choice::new(&all);
        Self { all, surroundings, of_materials, choice }
    }

    /// A light chosen by importance for a site, and the probability of that. `u` in [0, 1). None:
    /// no light gives the site any.
    #[inline]
    pub fn choose(&self, site: &Site, u: f64) -> Option<(usize, f32)> {
        let (number, pmf) = match self.all.len() {
            0 | 1 => (self.all.len().checked_sub(1)?, 1.0),
            _ => self.choice.choose(site, u)?,
        };
        let pmf = pmf as f32;
        (pmf > 0.0).then_some((number, pmf))
    }

    /// The probability with which [`Lights::choose`] gives this light.
    #[inline]
    pub fn pmf(&self, site: &Site, light: usize) -> f32 {
        if self.all.len() == 1 { 1.0 } else { self.choice.pmf(site, light) as f32 }
    }

    /// The light that surfaces of a material are.
    #[inline]
    pub fn of_material(&self, material: u32) -> Option<usize> {
        let number = *self.of_materials.get(material as usize)?;
        (number != Self::NONE).then_some(number as usize)
    }

    /// Radiance along a ray that meets nothing, in light units.
    pub fn seen(&self, direction: Vec3) -> Rgb {
        self.sum(direction, |_| true)
    }

    /// The part of it that is not asked for, as surfaces are lit by it: without suns, which count
    /// among the lights.
    pub fn ambient(&self, direction: Vec3) -> Rgb {
        self.sum(direction, |light| light.asked.is_none() && !light.sight.is_sun())
    }

    fn sum(&self, direction: Vec3, counts: impl Fn(&Surroundings) -> bool) -> Rgb {
        let mut sum = Rgb::BLACK;
        for light in self.surroundings.iter().filter(|light| counts(light)) {
            sum += light.radiance(direction);
        }
        sum
    }
}
