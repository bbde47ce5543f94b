//! The World: everything a ray can meet, and how pictures are taken of it.

use super::cameras::Camera;
use super::film::Film;
use super::geometry::Geometry;
use super::guide::Guide;
use super::lights::Lights;
use super::materials::{Makeup, Material};
use super::media::Medium;
use super::overlaps::Overlaps;
use super::samplers::Sampler;
use crate::math::paths::Automaton;

/// Lengths are in world units: the scene moved to the middle of its bounding box and scaled by a
/// power of two to fit about [-1, 1]. Radiance does not change by that; it is in `light_unit`s.
pub struct World {
    /// What a ray can meet.
    pub geometry: Geometry,
    /// What surfaces do with light; hits name them by number.
    pub materials: Vec<Material>,
    /// Which of them there are.
    pub makeup: Makeup,
    /// What fills space; the sides of materials name them by number. The first surrounds everything.
    pub media: Vec<Medium>,
    /// Bodies of which one ends where another begins, if there are any.
    pub overlaps: Option<Overlaps>,
    /// Number of the medium around the camera.
    pub camera_medium: u32,
    /// What shines.
    pub lights: Lights,
    /// Directions in which paths look for light beside those of the surfaces themselves, if any.
    pub guide: Option<Guide>,
    /// Where the picture is taken from.
    pub camera: Camera,
    /// What the light becomes.
    pub film: Film,
    /// Which paths of light go to which layer of the film; None: all go to the picture alone.
    pub paths: Option<Automaton>,
    /// Where the random numbers come from.
    pub sampler: Sampler,
    /// W/m²/sr of one unit of radiance within: a power of two near the brightest light, so that
    /// products of very bright or very faint light neither overflow nor vanish.
    pub light_unit: f64,
}
