//! Lamps with an area: the surfaces of one object that share one emitting material.

use glam::{DVec3, Vec3};

use super::crowd::{Chosen, Crowd};
use super::flat::Sampled;
use super::patch::Patch;
use super::rectangle::Rectangle;
use super::{Arrival, Emitter, Geometry, Hit, Point, Site, between};
use crate::math::Rgb;
use crate::render::geometry::{Primitive, Sheet};

/// Surfaces that shine with the same radiance everywhere.
#[derive(Clone, Debug)]
pub struct Lamp {
    radiance: Rgb,
    /// Whether the backs shine as well.
    both: bool,
    patches: Vec<Patch>,
    /// From which one is chosen, if there are several.
    crowd: Option<Crowd>,
    /// Each primitive with the number of its patch; ascending.
    numbers: Vec<(Primitive, u32)>,
    /// What bounds it.
    emitter: Emitter,
    /// Of all surfaces, in square world units.
    area: f64,
    centre: Centre,
}

/// A lamp as one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Centre {
    /// Centroid of its surfaces by area, and the mean of their normals by area, of unit length:
    /// the direction it faces. Zero for a lamp that faces every way, which shines nothing then.
    pub point: Point,
}

impl Lamp {
    /// A lamp over `surfaces` of positive, finite area. Its radiance in light units, and whether
    /// both sides have it.
    pub fn new(
        (radiance, both): (Rgb, bool),
        surfaces: Vec<Primitive>,
        geometry: &Geometry,
        centre: Centre,
    ) -> Self {
        let area = surfaces.iter().map(|surface| geometry.area(*surface)).sum();
        let patches = Patch::of(&surfaces, geometry);
        let mut numbers: Vec<_> = (0..)
            .zip(&patches)
            .flat_map(|(number, patch)| patch.primitives().map(move |it| (it, number)))
            .collect();
        numbers.sort_unstable();
        let emitters: Vec<_> = patches.iter().map(|it| it.emitter(geometry, both)).collect();
        let crowd = Crowd::new(&emitters);
        let bounds = crowd.as_ref().map(|crowd| *crowd.emitter());
        let bounds = bounds.unwrap_or(Emitter::everywhere([DVec3::ZERO; 2], 0.0));
        let emitter = bounds.times(f64::from(radiance.luminance()));
        let crowd = crowd.filter(|_| patches.len() > 1);
        Self { radiance, both, patches, crowd, numbers, emitter, area, centre }
    }

    /// Area of all surfaces, in square world units.
    pub fn area(&self) -> f64 {
        self.area
    }

    /// Its radiance, in light units.
    pub(super) fn radiance(&self) -> Rgb {
        self.radiance
    }

    /// All its surfaces.
    pub(super) fn surfaces(&self) -> impl Iterator<Item = Primitive> {
        self.numbers.iter().map(|(primitive, _)| *primitive)
    }

    /// What bounds it.
    pub(super) fn emitter(&self) -> Emitter {
        self.emitter
    }

    /// Light from a point of one of its surfaces.
    #[inline(always)]
    pub(super) fn sample(&self, geometry: &Geometry, site: &Site, u: [f64; 2]) -> Option<Arrival> {
        let chosen = match &self.crowd {
            None => Chosen { number: 0, pmf: 1.0, u: u[0] },
            Some(crowd) => crowd.choose(site, u[0])?,
        };
        let patch = self.patches.get(chosen.number)?;
        let found = patch.sample(geometry, (site, self.both), [chosen.u, u[1]])?;
        Some(self.arrival(&site.point, &found, chosen.pmf))
    }

    /// Light from a point of one of its surfaces, of which that was chosen with this probability.
    #[inline(always)]
    pub(super) fn arrival(&self, from: &Point, found: &Sampled, pmf: f64) -> Arrival {
        let Sampled { point, wi, pdf_w } = found;
        let pdf_w = pmf * pdf_w;
        let irradiance = self.radiance * (1.0 / pdf_w) as f32;
        let shadow = between(from, point);
        // Of what is tiny and far, no more than f32 holds.
        let pdf_w = pdf_w.min(f64::from(f32::MAX)) as f32;
        Arrival { wi: wi.as_vec3(), irradiance, pdf_w, shadow }
    }

    /// Its only surface, if that is a rectangle.
    pub(super) fn rectangle(&self) -> Option<&Rectangle> {
        match self.patches.as_slice() {
            [Patch::Rectangle(rectangle)] => Some(rectangle),
            _ => None,
        }
    }

    /// Whether the backs shine as well.
    #[inline]
    pub(super) fn both(&self) -> bool {
        self.both
    }

    /// Larsen's simplification: all flux from the centre, L = Lₑ A cos θ / r², θ at the lamp.
    pub(super) fn at_centre(&self, at: &Point) -> Option<Arrival> {
        self.arrive(at, &self.centre.point)
    }

    /// The lamp's radiance times the solid angle its area would fill around `to`: Lₑ A cos θ / r².
    fn arrive(&self, at: &Point, to: &Point) -> Option<Arrival> {
        let way = to.position.as_dvec3() - at.position.as_dvec3();
        let distance_2 = way.length_squared();
        let wi = way.try_normalize()?;
        let cos = -wi.dot(to.ng.as_dvec3());
        let cos = if self.both { cos.abs() } else { cos };
        if cos <= 0.0 {
            return None;
        }
        let solid_angle = self.area() * cos / distance_2;
        let irradiance = self.radiance * solid_angle as f32;
        let pdf_w = (1.0 / solid_angle) as f32;
        Some(Arrival { wi: wi.as_vec3(), irradiance, pdf_w, shadow: between(at, to) })
    }

    /// Density with which `sample` gives the direction in which a ray from `site` met the lamp.
    pub(super) fn pdf_w(&self, site: &Site, hit: &Hit) -> f32 {
        let found = self.numbers.binary_search_by_key(&hit.primitive, |(primitive, _)| *primitive);
        let Some((_, number)) = found.ok().and_then(|index| self.numbers.get(index)) else {
            return 0.0;
        };
        let number = *number as usize;
        let pmf = self.crowd.as_ref().map_or(1.0, |crowd| crowd.pmf(site, number));
        let point = hit.position.as_dvec3();
        let pdf_w = self.patches[number].pdf_w((site, self.both), point);
        (pmf * pdf_w).min(f64::from(f32::MAX)) as f32
    }
}

impl Centre {
    /// The centre of a lamp: `centroid` by area; `facing`, the sum of its normals times their
    /// areas; `reach`, the greatest magnitude of its coordinates, which bounds how far rounding
    /// moved its surfaces. All in world units.
    pub fn new(centroid: DVec3, facing: DVec3, reach: DVec3) -> Self {
        let error = (reach.as_vec3() * f32::EPSILON).map(f32::next_up);
        let ng = facing.normalize_or_zero().as_vec3();
        Self { point: Point { position: centroid.as_vec3(), error, ng, sheet: Sheet::NONE } }
    }

    /// The direction the lamp faces.
    pub fn facing(&self) -> Vec3 {
        self.point.ng
    }
}
