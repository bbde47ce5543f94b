//! What surrounds the scene, infinitely far away: seen where a ray meets nothing.

use std::f32::consts::{FRAC_1_PI, PI};
use std::sync::Arc;

use glam::{Vec2, Vec3};

use super::choice::Gives;
use super::{Arrival, Disc, Site, Sky};
use crate::math::{Rgb, random, warp};

/// Light from around the scene.
#[derive(Clone, Debug)]
pub struct Surroundings {
    /// What is seen of it.
    pub sight: Sight,
    /// Its number among the lights that are asked, if it is.
    pub asked: Option<u32>,
}

/// What is seen.
#[derive(Clone, Debug)]
pub enum Sight {
    /// The same radiance in every direction, in light units.
    Constant(Rgb),
    /// A sun.
    Disc(Disc),
    /// A sky.
    Sky(Arc<Sky>),
}

impl Sight {
    /// Whether it is small and bright: no matter for rays that look around at random.
    pub fn is_sun(&self) -> bool {
        matches!(self, Self::Disc(_))
    }
}

impl Surroundings {
    /// About the irradiance that it gives.
    pub(super) fn gives(&self) -> Gives {
        match &self.sight {
            Sight::Constant(radiance) => Gives::evenly(f64::from(PI * radiance.luminance())),
            Sight::Disc(disc) => disc.gives(),
            Sight::Sky(sky) => sky.gives(),
        }
    }

    /// Radiance along a ray that goes there, in light units.
    pub fn radiance(&self, direction: Vec3) -> Rgb {
        match &self.sight {
            Sight::Constant(radiance) => *radiance,
            Sight::Disc(disc) => disc.radiance(direction),
            Sight::Sky(sky) => sky.radiance(direction),
        }
    }

    /// The same along a ray from a site, and the density with which `sample` gives its direction.
    pub fn met(&self, site: &Site, direction: Vec3) -> (Rgb, f32) {
        match &self.sight {
            Sight::Sky(sky) => sky.met(site.normal, direction),
            _ => (self.radiance(direction), self.pdf_w(site, direction)),
        }
    }

    /// Light from one direction. Of light that is the same everywhere: for a surface by the cosine
    /// to its normal, else uniform; of a sky by its luminance and that cosine; of a disc from
    /// within it.
    pub(super) fn sample(&self, site: &Site, u: [f64; 2]) -> Option<Arrival> {
        let (wi, radiance, pdf_w) = match &self.sight {
            Sight::Constant(radiance) => {
                let u = Vec2::from_array(u.map(random::unit_f32));
                let wi = match site.normal {
                    Vec3::ZERO => warp::square_to_sphere(u),
                    normal => warp::about(normal, warp::square_to_cosine(u)),
                };
                (wi, *radiance, self.pdf_w(site, wi))
            }
            Sight::Disc(disc) => disc.sample(u),
            Sight::Sky(sky) => sky.sample(site.normal, u)?,
        };
        if pdf_w <= 0.0 {
            return None;
        }
        let shadow = site.point.ray(wi);
        Some(Arrival { wi, irradiance: radiance / pdf_w, pdf_w, shadow })
    }

    /// Density with which `sample` gives a direction.
    pub fn pdf_w(&self, site: &Site, wi: Vec3) -> f32 {
        match &self.sight {
            Sight::Constant(_) => match site.normal {
                Vec3::ZERO => 0.25 * FRAC_1_PI,
                normal => normal.dot(wi).max(0.0) / PI,
            },
            Sight::Disc(disc) => disc.pdf_w(wi),
            Sight::Sky(sky) => sky.pdf_w(site.normal, wi),
        }
    }
}
