//! Lights and lamps of the scene → lights of the world, in light units.

use glam::DVec3;

use super::daylight::{self, Day, Sun};
use super::errors::scene as errors;
use super::materials::{self, in_units};
use super::shapes::Assembled;
use super::space::Space;
use crate::bodies::Placed;
use crate::diag::{Diagnostic, Span};
use crate::load::Stage;
use crate::optics::colour;
use crate::plan;
use crate::render::geometry::{Geometry, Owner, Primitive};
use crate::render::lights::{
    Centre, Directional, Lamp, Light, Lights, PointLight, Sight, SpotLight, Surroundings,
};
use crate::scene::{self, At, Integrator, Scene};

/// Everything that shines without being a surface.
#[derive(Default)]
pub(super) struct Plain {
    pub surroundings: Vec<Sight>,
    /// Lights without extent.
    pub sharp: Vec<Light>,
    /// Whether one was refused, and so may be missed everywhere.
    pub refused: bool,
    pub days: Vec<Day>,
}

/// Brightest component of a light, of a surface's colour likewise: far enough below the largest
/// f32 that what a picture holds stays below it.
const MOST: f64 = 1e37;

/// Distance of a point that shines from the middle of the scene, in world units: so far away its
/// light is parallel, and a `directional` light does the same.
const FARTHEST_POINT: f64 = 1e15;

/// The unit of light: the power of two at or below the brightest light of the scene.
pub(super) fn unit(
    stage: &Stage,
    bodies: &[Placed],
    space: &Space,
    found: &mut Vec<Diagnostic>,
) -> f64 {
    let scene = &*stage.scene;
    let mut brightest = 0.0_f64;
    let mut refused: Vec<Span> = Vec::new();
    let mut largest = |channels: [f64; 3], span: Span, what: &str, name: &At<String>| {
        let most = channels.into_iter().fold(0.0, f64::max);
        let fits = channels.into_iter().all(|channel| channel <= MOST);
        if !fits && !refused.contains(&span) {
            refused.push(span);
            found.push(errors::too_bright(name, span, what, MOST));
        }
        most
    };
    for light in &scene.lights {
        let scale = match &light.value.value {
            scene::Light::Constant(_) | scene::Light::Directional(_) => 1.0,
            // What it gives to a surface one world unit away.
            scene::Light::PointLight(_) | scene::Light::SpotLight(_) => space.length(1.0).powi(2),
            scene::Light::Preetham(sky) => {
                brightest = brightest.max(daylight::brightest(sky));
                continue;
            }
        };
        let Some(shine) = light.value.shine() else { continue };
        let channels = colour::emitted(shine.spectrum).map(|channel| scale * channel);
        brightest = brightest.max(largest(channels, shine.at, "light", &light.name));
    }
    for (_, material) in bodies.iter().flat_map(|body| body.parts.iter().flatten()) {
        if let Some(albedo) = material.value.reflectance() {
            largest(plan::largest(stage, albedo), albedo.span, "albedo of", &material.name);
        }
        if let Some(emission) = material.value.emission() {
            let (shines, at) = (colour::emitted(&emission.0), emission.span);
            brightest = brightest.max(largest(shines, at, "emission of", &material.name));
        }
    }
    // Kept where a reciprocal in f32 is a normal number.
    let exponent =
        if brightest > 0.0 { brightest.log2().floor().clamp(-120.0, 120.0) } else { 0.0 };
    2.0_f64.powi(exponent as i32)
}

/// The lights that are declared as such.
pub(super) fn plain(
    scene: &Scene,
    space: &Space,
    light_unit: f64,
    found: &mut Vec<Diagnostic>,
) -> Plain {
    let mut plain = Plain { days: daylight::days(scene), ..Plain::default() };
    for light in &scene.lights {
        let name = &light.name;
        match &light.value.value {
            scene::Light::Constant(constant) => {
                let radiance = in_units(&constant.radiance.0, light_unit);
                if !radiance.is_black() {
                    plain.surroundings.push(Sight::Constant(radiance));
                }
            }
            scene::Light::Directional(sun) => {
                let irradiance = in_units(&sun.irradiance.0, light_unit);
                let to_light = -sun.direction.0.as_vec3();
                if !irradiance.is_black() {
                    plain.sharp.push(Light::Directional(Directional { to_light, irradiance }));
                }
            }
            // Among the days.
            scene::Light::Preetham(_) => {}
            scene::Light::PointLight(point) => {
                let bulb = (&point.position, &point.intensity);
                plain.bulb(name, bulb, space, light_unit, found, Light::Point);
            }
            scene::Light::SpotLight(spot) => {
                let (cone, falloff) = (spot.cone.0, spot.falloff.0);
                if falloff > cone {
                    plain.refused = true;
                    found.push(errors::wide_falloff(name, spot.falloff.span, spot.cone.span));
                    continue;
                }
                let axis = spot.direction.0.as_vec3();
                let bulb = (&spot.position, &spot.intensity);
                plain.bulb(name, bulb, space, light_unit, found, |bulb| {
                    Light::Spot(SpotLight::new(bulb, axis, [cone - falloff, cone]))
                });
            }
        }
    }
    plain
}

impl Plain {
    /// How many of them shine.
    pub(super) fn shining(&self) -> usize {
        let days = self.days.iter().filter(|day| day.shines(true)).count();
        self.sharp.len() + self.surroundings.len() + days
    }

    /// Adds what is made of a point that shines, if it does, and is not too far away.
    fn bulb(
        &mut self,
        name: &At<String>,
        (position, intensity): (&At<scene::Point>, &At<scene::Intensity>),
        space: &Space,
        light_unit: f64,
        found: &mut Vec<Diagnostic>,
        make: impl Fn(PointLight) -> Light,
    ) {
        let place = space.point(position.0);
        if place.length() > FARTHEST_POINT {
            self.refused = true;
            found.push(errors::light_beyond_scene(name, position.span, FARTHEST_POINT));
            return;
        }
        let area = space.length(1.0).powi(2);
        let intensity = in_units(&intensity.0, light_unit / area);
        if !intensity.is_black() {
            self.sharp.push(make(PointLight { position: place.as_vec3(), intensity }));
        }
    }
}

/// Surfaces of one object and one emitting material, summed up in world space.
pub(super) struct LampParts {
    owner: Owner,
    surfaces: Vec<Primitive>,
    area: f64,
    /// Σ area × centroid.
    centroid: DVec3,
    /// Σ area × normal.
    facing: DVec3,
    /// Greatest magnitude of each coordinate.
    reach: DVec3,
}

/// A lamp whose normals cancel to less than this part of its area faces every way: what is left
/// of the sum is rounding of its corners.
const FACES_NOWHERE: f64 = 1e-4;

impl LampParts {
    pub fn new(owner: Owner) -> Self {
        Self {
            owner,
            surfaces: Vec::new(),
            area: 0.0,
            centroid: DVec3::ZERO,
            facing: DVec3::ZERO,
            reach: DVec3::ZERO,
        }
    }

    /// Adds a surface: its area and centroid, the sum of its normals by area, and the greatest
    /// magnitude of its coordinates.
    pub fn add(
        &mut self,
        surface: Primitive,
        area: f64,
        centroid: DVec3,
        facing: DVec3,
        reach: DVec3,
    ) {
        self.surfaces.push(surface);
        self.area += area;
        self.centroid += area * centroid;
        self.facing += facing;
        self.reach = self.reach.max(reach);
    }

    /// The number of its material, which is of no other lamp.
    pub fn material(&self) -> u32 {
        self.owner.material
    }

    /// As render knows it.
    pub fn light(self, geometry: &Geometry, materials: &materials::Table) -> Light {
        let radiance = materials.emission(self.owner.material).unwrap_or_default();
        let centre = Centre::new(self.centroid / self.area, self.facing, self.reach);
        Light::Lamp(Box::new(Lamp::new(radiance, self.surfaces, geometry, centre)))
    }
}

/// All lights as render knows them. Where nothing `asks`, neither surfaces for light nor photons for
/// where they begin, they are only seen.
pub(super) fn gather(
    plain: Plain,
    lamps: Vec<LampParts>,
    (geometry, materials): (&Geometry, &materials::Table),
    (integrator, asks): (&Integrator, bool),
    light_unit: f64,
) -> Lights {
    let mut all = Vec::new();
    let mut of_materials = vec![Lights::NONE; materials.all.len()];
    // What is seen, and whether it is asked for: a sun as every light.
    let asks_around = asks && integrator.asks_surroundings();
    let mut sights: Vec<_> = plain.surroundings.into_iter().map(|it| (it, asks_around)).collect();
    let mut suns = Vec::new();
    for day in &plain.days {
        match day.sun(light_unit) {
            Some(Sun::Disc(disc)) => sights.push((disc, asks)),
            Some(Sun::Direction(sun)) => suns.push(Light::Directional(sun)),
            None => {}
        }
        sights.extend(day.sky(light_unit).map(|sky| (sky, asks_around)));
    }
    if asks {
        all.extend(plain.sharp);
        all.extend(suns);
        for lamp in lamps {
            of_materials[lamp.material() as usize] = all.len() as u32;
            all.push(lamp.light(geometry, materials));
        }
    }
    let mut surroundings = Vec::new();
    for (sight, asked) in sights {
        let asked = asked.then_some(all.len() as u32);
        let light = Surroundings { sight, asked };
        if asked.is_some() {
            all.push(Light::Surroundings(light.clone()));
        }
        surroundings.push(light);
    }
    Lights::new(all, surroundings, of_materials)
}

/// What an integrator asks of lights and does not find.
pub(super) fn check(
    scene: &Scene,
    (bodies, shapes): (&[Placed], &Assembled),
    plain: &Plain,
    found: &mut Vec<Diagnostic>,
) {
    let integrator = &scene.integrator.value;
    if !integrator.follows_light() {
        return;
    }
    let points = integrator.lamp_points();
    for lamp in &shapes.lamps {
        let name = &scene.objects[lamp.owner.object as usize].name;
        if !lamp.area.is_finite() {
            found.push(errors::endless_lamp(name));
        } else if let Err(at) = points
            && lamp.facing.length() <= FACES_NOWHERE * lamp.area
        {
            found.push(errors::closed_lamp(name, at));
        }
    }
    let by_sky = integrator.lit_by_surroundings();
    let surrounded =
        by_sky && !plain.surroundings.is_empty() || plain.days.iter().any(|day| day.shines(by_sky));
    let sharp = plain.refused || !plain.sharp.is_empty();
    // Mirrors, glass and metal show what surrounds them.
    let lit = bodies.iter().flat_map(|body| &body.materials).any(|it| it.value.scatters());
    if lit && shapes.lamps.is_empty() && !sharp && !surrounded {
        found.push(errors::nothing_shines(scene.integrator.span));
    }
}
