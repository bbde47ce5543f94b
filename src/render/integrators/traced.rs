//! The paths of a sample, surface by surface, for those who want to see them.

use glam::Vec3;

use crate::math::Rgb;
use crate::math::paths::Event;
use crate::render::geometry::Ray;

/// Where light came from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Source {
    /// A point of a lamp, in world units.
    Point(Vec3),
    /// From far away: unit length, towards it.
    Direction(Vec3),
}

impl Source {
    /// What a ray to a light ends at.
    pub fn of(ray: &Ray) -> Self {
        match ray.t_max.is_finite() {
            true => Self::Point(ray.origin + ray.t_max * ray.direction),
            false => Self::Direction(ray.direction),
        }
    }
}

/// All paths of one sample. Those that begin alike share their first surfaces.
#[derive(Clone, Debug, Default)]
pub(super) struct Tracing {
    vertices: Vec<Vertex>,
    found: Vec<Found>,
}

/// A surface on a path.
#[derive(Clone, Copy, Debug)]
struct Vertex {
    /// Number of the one before it, nearer to the eye.
    before: u32,
    event: Event,
    place: Vec3,
}

/// A path that came to a light.
#[derive(Clone, Copy, Debug)]
struct Found {
    last: u32,
    radiance: Rgb,
    source: Source,
}

/// A path from the eye to a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Traced {
    /// What happened at each surface, from the eye on, and where, in world units.
    pub surfaces: Vec<(Event, Vec3)>,
    /// Where it ends.
    pub source: Source,
    /// What it brings to the sample, in light units.
    pub radiance: Rgb,
}

impl Tracing {
    /// In place of the number of a surface: the eye.
    pub const EYE: u32 = u32::MAX;

    /// Forgets all paths.
    pub fn clear(&mut self) {
        self.vertices.clear();
        self.found.clear();
    }

    /// The number of a surface behind another.
    pub fn after(&mut self, before: u32, event: Event, place: Vec3) -> u32 {
        self.vertices.push(Vertex { before, event, place });
        (self.vertices.len() - 1) as u32
    }

    /// A light that is met, or asked, behind a surface.
    pub fn add(&mut self, last: u32, radiance: Rgb, source: Source) {
        if !radiance.is_black() {
            self.found.push(Found { last, radiance, source });
        }
    }

    /// All paths that bring light, in the order in which they were found.
    pub fn paths(&self) -> impl Iterator<Item = Traced> {
        self.found.iter().map(|found| {
            let mut surfaces = Vec::new();
            let mut at = found.last;
            while let Some(vertex) = self.vertices.get(at as usize) {
                surfaces.push((vertex.event, vertex.place));
                at = vertex.before;
            }
            surfaces.reverse();
            Traced { surfaces, source: found.source, radiance: found.radiance }
        })
    }
}
