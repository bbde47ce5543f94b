//! What a plan looks at: the surfaces of a stage with their materials, and what shines on them.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::DVec3;

use super::daylight::Daylight;
use super::textures::largest;
use crate::load::Stage;
use crate::math::Spectrum;
use crate::optics::colour;
use crate::scene::{self, At, Light, Material, Named, Object, SunForm};

/// The surfaces and lights of a stage.
pub(super) struct Survey<'a> {
    /// One for each object and each of its materials that is in use; of a mixture its parts, as if
    /// each were all of the surface.
    pub surfaces: Vec<Surface<'a>>,
    /// Lights without extent that shine: directional ones, points, spots, and suns of skies that are
    /// a direction.
    pub sharp: Vec<&'a Named<Light>>,
    /// Suns that are discs.
    pub discs: Vec<&'a Named<Light>>,
    /// What surrounds the scene and shines: `constant` lights and skies.
    pub surroundings: Vec<&'a Named<Light>>,
    pub stage: &'a Stage,
    camera: &'a scene::Camera,
    objects: &'a [Named<Object>],
}

/// The surfaces of one object that share a material.
pub(super) struct Surface<'a> {
    pub object: &'a Named<Object>,
    pub material: &'a Named<Material>,
    /// The largest channel of the part of light it scatters, as rendered; 0 for mirrors, glass
    /// and metal.
    pub albedo: f64,
    /// Whether its front shines.
    pub shines: bool,
    /// Whether it is a part of a mixture.
    mixed: bool,
}

impl<'a> Survey<'a> {
    pub fn of(stage: &'a Stage) -> Self {
        let scene = &*stage.scene;
        let mut surfaces = Vec::new();
        let mut slots_in_use = BTreeMap::new();
        for (object, mesh) in scene.objects.iter().zip(&stage.meshes) {
            let material = match &object.value.value {
                Object::Disk(disk) => &disk.material,
                Object::Plane(plane) => &plane.material,
                Object::Quad(quad) => &quad.material,
                Object::Sphere(sphere) => &sphere.material,
                Object::Triangle(triangle) => &triangle.material,
                Object::Mesh(_) => {
                    let Some(mesh) = mesh else { continue };
                    let used = slots_in_use
                        .entry(Arc::as_ptr(&mesh.mesh))
                        .or_insert_with(|| in_use(&mesh.mesh.slots, mesh.materials.len()));
                    let used = mesh.materials.iter().zip(&*used).filter(|(_, used)| **used);
                    for (material, _) in used {
                        surfaces.extend(Surface::all(stage, object, material));
                    }
                    continue;
                }
            };
            surfaces.extend(Surface::all(stage, object, scene.material(material)));
        }
        let lights = |wanted: fn(&Light) -> bool| {
            scene.lights.iter().filter(|light| wanted(&light.value)).collect()
        };
        Self {
            surfaces,
            sharp: lights(|light| match light {
                Light::Preetham(sky) => matches!(*sky.sun, SunForm::SunDirection(_)) && is_day(sky),
                other => !other.has_extent() && shines(other),
            }),
            discs: lights(|light| match light {
                Light::Preetham(sky) => matches!(*sky.sun, SunForm::SunDisc(_)) && is_day(sky),
                _ => false,
            }),
            surroundings: lights(|light| match light {
                Light::Preetham(sky) => is_day(sky),
                other => other.has_extent() && shines(other),
            }),
            stage,
            camera: &scene.camera,
            objects: &scene.objects,
        }
    }

    /// The first lamp: a surface that shines.
    pub fn lamp(&self) -> Option<&Surface<'a>> {
        self.surfaces.iter().find(|surface| surface.shines)
    }

    /// The name of something that `direct` follows light from: a light without extent, a sun or a
    /// lamp.
    pub fn shining(&self) -> Option<&'a At<String>> {
        let mut lights = self.sharp.iter().chain(&self.discs);
        let light = lights.next().map(|light| &light.name);
        light.or_else(|| self.lamp().map(|lamp| &lamp.object.name))
    }

    /// The first mirror, glass or metal.
    pub fn specular(&self) -> Option<&Surface<'a>> {
        self.surfaces.iter().find(|surface| !surface.material.value.scatters())
    }

    /// The names of all materials that mirror or refract, each once.
    pub fn mirrors(&self) -> Vec<&'a str> {
        let mut names = Vec::new();
        for surface in self.surfaces.iter().filter(|it| !it.material.value.scatters()) {
            let name = surface.material.name.value.as_str();
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// The first surface that is not simply diffuse.
    pub fn special(&self) -> Option<&Surface<'a>> {
        self.surfaces.iter().find(|surface| {
            surface.mixed || !matches!(surface.material.value.value, Material::Diffuse(_))
        })
    }

    /// The name of something that surfaces are lit by when they ask for light.
    pub fn asked(&self, integrator: &scene::Integrator) -> Option<&'a At<String>> {
        let around = self.surroundings.first().filter(|_| integrator.asks_surroundings());
        self.shining().or_else(|| around.map(|light| &light.name))
    }

    /// The name of anything that lights surfaces.
    pub fn lit_by(&self, integrator: &scene::Integrator) -> Option<&'a At<String>> {
        let lights = self.shining().filter(|_| integrator.lit_by_lights().is_ok());
        let around = self.surroundings.first().filter(|_| integrator.lit_by_surroundings());
        lights.or_else(|| around.map(|light| &light.name))
    }

    /// The surface that scatters most light; None if none scatters any.
    pub fn brightest(&self) -> Option<&Surface<'a>> {
        let scatters = self.surfaces.iter().filter(|surface| surface.albedo > 0.0);
        // The first of equals.
        scatters.rev().max_by(|a, b| a.albedo.total_cmp(&b.albedo))
    }

    /// The only object there is, if no part of it can hide light from another part that is seen.
    pub fn only_convex(&self) -> Option<&'a Named<Object>> {
        let [only] = self.objects else { return None };
        self.is_convex(only).then_some(only)
    }

    /// The first surface whose material reads a texture, and the texture's name.
    pub fn textured(&self) -> Option<(&Surface<'a>, &'a str)> {
        self.surfaces.iter().find_map(|surface| {
            let texture = surface.material.value.value.texture()?;
            Some((surface, texture.name.as_str()))
        })
    }

    /// Whether light that surfaces scatter may meet one that scatters it again.
    pub fn scatters_twice(&self) -> bool {
        let mut scattering = self.surfaces.iter().filter(|surface| surface.albedo > 0.0);
        let Some(first) = scattering.next() else { return false };
        if self.specular().is_some() {
            return true;
        }
        !self.is_convex(first.object)
            || scattering.any(|other| !std::ptr::eq(other.object, first.object))
    }

    /// The simply diffuse surface that scatters most, if light may go straight from one such to
    /// another.
    pub fn shared(&self) -> Option<&Surface<'a>> {
        let is_diffuse = |it: &&Surface| {
            let diffuse = matches!(it.material.value.value, Material::Diffuse(_));
            diffuse && !it.mixed && it.albedo > 0.0
        };
        let diffuse = || self.surfaces.iter().filter(is_diffuse);
        let brightest = diffuse().rev().max_by(|a, b| a.albedo.total_cmp(&b.albedo))?;
        let is_another = |other: &Surface| !std::ptr::eq(other.object, brightest.object);
        let some = !self.is_convex(brightest.object) || diffuse().any(is_another);
        some.then_some(brightest)
    }

    /// Whether light from one surface of an object may meet another one of it.
    pub fn lights_itself(&self, object: &Named<Object>) -> bool {
        !self.is_convex(object)
    }

    /// Whether an object is one flat surface, or a sphere seen from outside: what leaves the side
    /// that is seen does not come back to it.
    fn is_convex(&self, object: &Named<Object>) -> bool {
        let mut surfaces = self.surfaces.iter().filter(|s| std::ptr::eq(s.object, object));
        if surfaces.any(|surface| surface.material.value.transmits()) {
            return false;
        }
        match &object.value.value {
            Object::Disk(_) | Object::Plane(_) | Object::Quad(_) | Object::Triangle(_) => true,
            Object::Mesh(_) => false,
            Object::Sphere(sphere) => {
                let place = sphere.place.transform();
                let Some(scale) = place.uniform_scale() else { return false };
                let (centre, radius) = (place.point(sphere.center.0), scale * sphere.radius.0);
                match self.camera {
                    scene::Camera::Perspective(camera) => is_outside(camera.eye.0, centre, radius),
                    // Its place depends on all objects: said only where there are no others. The
                    // radius of the box around a sphere is √3 of its own.
                    scene::Camera::Overview(camera) => {
                        let away = camera.distance.0 * 3.0_f64.sqrt() * radius;
                        self.objects.len() == 1
                            && is_outside(centre + away * DVec3::X, centre, radius)
                    }
                }
            }
        }
    }
}

/// Which of so many slots triangles have.
fn in_use(slots: &[u32], count: usize) -> Vec<bool> {
    // Without slots every triangle has the first material.
    let mut used = vec![slots.is_empty(); count];
    for slot in slots {
        if let Some(used) = used.get_mut(*slot as usize) {
            *used = true;
        }
    }
    used
}

/// Clearly outside: rounding does not matter.
fn is_outside(eye: DVec3, centre: DVec3, radius: f64) -> bool {
    const CLEARLY: f64 = 1.001;
    eye.distance(centre) > CLEARLY * radius
}

impl<'a> Surface<'a> {
    /// The parts of a material of an object.
    fn all(
        stage: &'a Stage,
        object: &'a Named<Object>,
        material: &'a Named<Material>,
    ) -> impl Iterator<Item = Self> {
        let mixed = matches!(material.value.value, Material::Mix(_));
        let parts = stage.scene.parts(material).into_iter();
        parts.map(move |(_, part)| Self { mixed, ..Self::new(stage, object, part) })
    }

    fn new(stage: &Stage, object: &'a Named<Object>, material: &'a Named<Material>) -> Self {
        let scatters = material.value.scatters();
        let albedo = material.value.reflectance().filter(|_| scatters);
        let albedo = albedo.map_or([0.0; 3], |albedo| largest(stage, albedo));
        Self {
            object,
            material,
            albedo: albedo.into_iter().fold(0.0, f64::max),
            shines: material.value.emission().is_some_and(|emission| is_lit(&emission.0)),
            mixed: false,
        }
    }
}

/// Whether the sun of a sky is up.
fn is_day(sky: &scene::Preetham) -> bool {
    Daylight::of(sky).is_some_and(|day| day.shines())
}

/// Whether a light shines, by the field that says it.
fn shines(light: &Light) -> bool {
    light.shine().is_some_and(|shine| is_lit(shine.spectrum))
}

/// Whether there is any light in it.
fn is_lit(light: &Spectrum) -> bool {
    colour::emitted(light).into_iter().any(|channel| channel > 0.0)
}
