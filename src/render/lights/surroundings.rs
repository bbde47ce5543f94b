//! What surrounds the scene, infinitely far away: seen where a ray meets nothing.

use std::f32::consts::{FRAC_1_PI, PI};

use glam::{Vec2, Vec3};

use super::{Arrival, Ray, Site};
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
}

impl Surroundings {
    /// Radiance along a ray that goes there, in light units.
    pub fn radiance(&self, _direction: Vec3) -> Rgb {
        match &self.sight {
            Sight::Constant(radiance) => *radiance,
        }
    }

    /// Light from one direction: for a surface by the cosine to its normal, else uniform.
    pub(super) fn sample(&self, site: &Site, u: [f64; 2]) -> Option<Arrival> {
        let u = Vec2::from_array(u.map(random::unit_f32));
        let wi = match site.normal {
            Vec3::ZERO => warp::square_to_sphere(u),
            normal => warp::about(normal, warp::square_to_cosine(u)),
        };
        let pdf_w = self.pdf_w(site, wi);
        if pdf_w <= 0.0 {
            return None;
        }
        let irradiance = self.radiance(wi) / pdf_w;
        let shadow = Ray::new(site.point.leave(wi), wi);
        Some(Arrival { wi, irradiance, pdf_w, shadow })
    }

    /// Density with which `sample` gives a direction.
    pub fn pdf_w(&self, site: &Site, wi: Vec3) -> f32 {
        match site.normal {
            Vec3::ZERO => 0.25 * FRAC_1_PI,
            normal => normal.dot(wi).max(0.0) / PI,
        }
    }
}
