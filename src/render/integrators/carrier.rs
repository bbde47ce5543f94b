//! What a sample carries along: what it found, and by which paths.

use crate::math::Rgb;
use crate::math::paths::Event;
use crate::render::geometry::{Hit, Ray};
use crate::render::lights::Site;
use crate::render::materials::{Bsdf, Scattered};
use crate::render::tiles::Counts;

/// What a sample brings home.
pub struct Carrier {
    /// What is counted.
    pub counts: Counts,
    /// Radiance along the camera's ray, in light units.
    pub radiance: Rgb,
    /// Number of the object that the camera's ray met.
    pub object: Option<u32>,
    /// Rays that wait to be followed; kept from sample to sample, for its memory.
    pub(super) waiting: Vec<Branch>,
}

/// A ray that light is followed along, backwards, and what is known of the way so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Branch {
    pub ray: Ray,
    /// What one unit of radiance along the ray brings to the camera.
    pub throughput: Rgb,
    /// The part of the throughput that is due to radiance being squeezed into less solid angle in
    /// matter of a higher index; it comes back when light leaves.
    pub squeeze: f32,
    pub trail: Trail,
    /// Where the ray comes from.
    pub site: Site,
    /// Density of the ray's direction there, times the rays that were sent by it; 0 if it is
    /// the camera's, or reflected or refracted by a smooth surface.
    pub pdf_w: f32,
    /// Surfaces that scattered.
    pub scattered: u32,
    /// Surfaces that reflected or refracted in one direction alone.
    pub mirrored: u32,
}

/// Where a path stands among those that are asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Trail(u16);

impl Carrier {
    /// With these counts, and nothing found.
    pub fn new(counts: Counts) -> Self {
        Self { counts, radiance: Rgb::BLACK, object: None, waiting: Vec::new() }
    }

    /// Begins a sample.
    pub fn start(&mut self) -> Trail {
        self.radiance = Rgb::BLACK;
        self.object = None;
        self.waiting.clear();
        Trail::default()
    }

    /// A path goes on by one more event.
    pub fn after(&self, trail: Trail, _event: Event) -> Trail {
        trail
    }

    /// A path has come to a light, and brings this radiance.
    pub fn add(&mut self, _trail: Trail, radiance: Rgb) {
        self.radiance += radiance;
    }
}

impl Branch {
    /// The camera's ray.
    pub fn first(ray: &Ray, trail: Trail) -> Self {
        Self {
            ray: *ray,
            throughput: Rgb::ONE,
            squeeze: 1.0,
            trail,
            site: Site::free(ray.origin),
            pdf_w: 0.0,
            scattered: 0,
            mirrored: 0,
        }
    }

    /// The ray that goes on in one direction alone.
    pub fn mirrored(&self, hit: &Hit, way: &Scattered, trail: Trail) -> Self {
        Self {
            ray: hit.ray(way.wi),
            throughput: self.throughput * way.weight * way.squeeze,
            squeeze: self.squeeze * way.squeeze,
            trail,
            pdf_w: 0.0,
            mirrored: self.mirrored + 1,
            ..*self
        }
    }

    /// One of `rays` that go on in a direction among many.
    pub fn scattered(
        &self,
        hit: &Hit,
        (bsdf, way): (&Bsdf, &Scattered),
        rays: u32,
        trail: Trail,
    ) -> Self {
        Self {
            ray: hit.ray(way.wi),
            throughput: self.throughput * way.weight * way.squeeze,
            squeeze: self.squeeze * way.squeeze,
            trail,
            site: Site::new(hit, bsdf),
            pdf_w: rays as f32 * way.pdf_w,
            scattered: self.scattered + 1,
            ..*self
        }
    }
}
