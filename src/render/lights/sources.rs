//! Light as it leaves: rays from lamps and suns, all with the same flux.

use std::f64::consts::PI;

use glam::{Vec2, Vec3};

use super::{Disc, Light, Lights, Sight};
use crate::math::{random, warp};
use crate::render::geometry::{Geometry, Point, Primitive, Ray};

/// Lamps and suns, of which one is chosen by its flux. Skies, and lights without extent, are none of
/// them: those are found by rays that look around, these by none.
pub struct Sources<'w> {
    geometry: &'w Geometry,
    /// Each with the flux of all before it and its own, of luminance, in light units.
    all: Vec<(f64, Source)>,
    /// The middle of what is bounded, and the radius of a sphere around it.
    centre: Vec3,
    radius: f32,
}

#[derive(Clone, Copy)]
enum Source {
    /// A surface that shines: from its front, or from both sides.
    Surface(Primitive, bool),
    Sun(Disc),
}

impl<'w> Sources<'w> {
    /// Those of a world.
    pub fn new(lights: &Lights, geometry: &'w Geometry) -> Self {
        let bounds = geometry.bounds();
        let (centre, radius) = match bounds.is_empty() {
            true => (Vec3::ZERO, 0.0),
            false => {
                let (min, max) = (bounds.min, bounds.max);
                (0.5 * min + 0.5 * max, 0.5 * (max - min).length())
            }
        };
        let mut sources = Self { geometry, all: Vec::new(), centre, radius };
        for light in &lights.all {
            match light {
                Light::Lamp(lamp) => {
                    let sides = if lamp.both() { 2.0 } else { 1.0 };
                    let exitance = sides * PI * f64::from(lamp.radiance().luminance());
                    for surface in lamp.surfaces() {
                        let flux = exitance * geometry.area(surface);
                        sources.push(flux, Source::Surface(surface, lamp.both()));
                    }
                }
                Light::Surroundings(around) => {
                    if let Sight::Disc(disc) = &around.sight {
                        let flux = disc.irradiance() * PI * f64::from(radius).powi(2);
                        sources.push(flux, Source::Sun(*disc));
                    }
                }
                Light::Directional(_) | Light::Point(_) | Light::Spot(_) => {}
            }
        }
        sources
    }

    fn push(&mut self, flux: f64, source: Source) {
        if flux > 0.0 && flux.is_finite() {
            self.all.push((self.flux() + flux, source));
        }
    }

    /// Of all of them together.
    fn flux(&self) -> f64 {
        self.all.last().map_or(0.0, |(flux, _)| *flux)
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// A ray of light: of a place by `u`, in a direction by `v`, both in [0, 1)⁴ with `choice`, which
    /// says of what it comes. None if there is nothing.
    pub fn ray(&self, choice: f64, u: [f64; 2], v: [f64; 2]) -> Option<Ray> {
        let sought = choice * self.flux();
        let number = self.all.partition_point(|(flux, _)| *flux <= sought);
        let before = number.checked_sub(1).map_or(0.0, |last| self.all[last].0);
        let (flux, source) = self.all.get(number)?;
        // What is left of the choice, within the source.
        let rest = (sought - before) / (flux - before);
        let (place, way) = (u.map(random::unit_f32), v.map(random::unit_f32));
        match *source {
            Source::Surface(surface, both) => {
                let point = self.geometry.sample(surface, Vec2::from_array(place))?;
                let is_back = both && rest < 0.5;
                let normal = if is_back { -point.ng } else { point.ng };
                let local = warp::square_to_cosine(Vec2::from_array(way));
                Some(point.ray(warp::about(normal, local)))
            }
            Source::Sun(disc) => {
                let (towards, ..) = disc.sample(v);
                let on = self.radius * warp::square_to_disk(Vec2::from_array(place));
                let (x, y) = towards.any_orthonormal_pair();
                let from = self.centre + self.radius * towards + on.x * x + on.y * y;
                Some(Point::free(from).ray(-towards))
            }
        }
    }
}
