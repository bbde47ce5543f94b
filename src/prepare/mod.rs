//! Stage + Plan → World: the last place that can fail. The only room that knows scene and render.
//!
//! In order: every object is placed in f64 (objects), the box around the bounded ones gives the
//! map to world space (space), shapes go there in f32 (shapes), and camera, lights, materials and
//! film become what render knows. Faults are collected all the way.

mod camera;
mod daylight;
mod errors;
mod film;
mod instances;
mod integrator;
mod lights;
mod materials;
mod media;
mod paths;
mod shapes;
mod space;
mod textures;

use glam::DVec3;

use crate::bodies::{self, Matter};
use crate::diag::{Diagnostic, Level, Span};
use crate::load::Stage;
use crate::math::paths::Automaton;
use crate::math::{NoProgress, Progress};
use crate::plan::{Feature, Plan};
use crate::render::geometry::Geometry;
use crate::render::guide::Guide;
use crate::render::integrators::Integrator;
use crate::render::materials::Makeup;
use crate::render::media::Medium;
use crate::render::samplers::Rhythm;
use crate::render::{World, film::Film};
use crate::scene;

pub use film::Unfit;

/// What a render is asked beside its scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Factor of columns and rows.
    pub scale: f64,
    /// The part of the film that is wanted, in pixels of the scaled film: x0, y0, x1, y1, ends
    /// not included.
    pub crop: Option<[u64; 4]>,
    /// Whether rays are met by plain instructions, though the processor may have better ones. The
    /// picture is the same.
    pub portable: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self { scale: 1.0, crop: None, portable: false }
    }
}

impl Settings {
    /// What about these settings does not suit the film of a stage. To be asked first: it is no
    /// fault of the scene's, so [`prepare`] has no words for it.
    pub fn unfit(&self, stage: &Stage) -> Option<Unfit> {
        film::window(&stage.scene.film, self).err()
    }
}

/// A scene, ready to be rendered.
pub struct Prepared {
    /// What a ray can meet.
    pub world: World,
    /// How light is followed.
    pub integrator: Integrator,
    /// World units a metre.
    pub scale: f64,
    /// The point, in metres, that is the origin of the world.
    pub centre: DVec3,
    /// The scene's objects: number n of a hit is the n-th here.
    pub objects: Vec<ObjectNote>,
    /// What was made of the scene.
    pub summary: Summary,
}

/// An object, for reports.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ObjectNote {
    /// As the author named it.
    pub name: String,
    /// Where.
    pub span: Span,
    /// Triangles in the world.
    pub triangles: u64,
    /// Its part of the geometry's memory, in bytes.
    pub bytes: u64,
}

/// What was made of a scene, in numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// Triangles in the world; a quad is two.
    pub triangles: u64,
    /// Spheres, disks and planes in the world.
    pub other_shapes: u64,
    /// Materials in use.
    pub materials: u64,
    /// Lights and lamps that shine, asked or only met.
    pub lights: u64,
    /// Triangles dropped, since they have no area in single precision.
    pub slivers: u64,
    /// Memory of the geometry, in bytes.
    pub bytes: u64,
    /// Objects that are instances.
    pub instances: u64,
    /// About what the geometry would take if they were copies, in bytes.
    pub bytes_of_copies: u64,
    /// Memory of the pictures of textures, in bytes.
    pub texture_bytes: u64,
}

/// How the samples of a stage belong together.
pub fn rhythm(stage: &Stage) -> Rhythm {
    integrator::sampler(&stage.scene.sampler).rhythm()
}

/// Everything that [`prepare`] can find wrong, without building the tree.
pub fn check(stage: &Stage, settings: &Settings) -> Vec<Diagnostic> {
    assemble(stage, settings, &Plan::of(stage), &NoProgress).1
}

/// The world of a stage. None if there is an error among the diagnostics, or if the settings are
/// [unfit](Settings::unfit).
pub fn prepare(
    stage: &Stage,
    settings: &Settings,
    progress: &dyn Progress,
) -> (Option<Prepared>, Vec<Diagnostic>) {
    prepare_by(&Plan::of(stage), stage, settings, progress)
}

/// The same by a plan of the stage: [`Plan::of`] it, or that one [forced](Plan::forced).
pub fn prepare_by(
    plan: &Plan,
    stage: &Stage,
    settings: &Settings,
    progress: &dyn Progress,
) -> (Option<Prepared>, Vec<Diagnostic>) {
    let (parts, diagnostics) = assemble(stage, settings, plan, progress);
    (parts.map(|parts| build(stage, settings, plan, parts)), diagnostics)
}

/// How light is followed by another integrator than the stage's own, in the same world: one that needs
/// no other lights to be asked.
pub fn other_integrator(
    stage: &Stage,
    prepared: &Prepared,
    integrator: &scene::Integrator,
) -> Integrator {
    integrator::prepare(integrator, &Plan::with(stage, integrator), prepared.scale)
}

/// A world but for the tree over its shapes.
struct Parts {
    shapes: shapes::Assembled,
    materials: materials::Table,
    media: Vec<Medium>,
    camera_medium: u32,
    lights: lights::Plain,
    camera: crate::render::cameras::Camera,
    film: Film,
    paths: Option<Automaton>,
    integrator: Integrator,
    light_unit: f64,
    space: space::Space,
}

fn assemble(
    stage: &Stage,
    settings: &Settings,
    plan: &Plan,
    progress: &dyn Progress,
) -> (Option<Parts>, Vec<Diagnostic>) {
    let scene = &*stage.scene;
    let mut found = Vec::new();

    let bodies = bodies::place(stage, &mut found);
    textures::check(&bodies, &mut found);
    film::check(scene, settings, &mut found);
    let paths = paths::automaton(scene, plan, &mut found);
    if bodies.len() < scene.objects.len() {
        // What is missing would be missed everywhere: tell no consequences, only other faults.
        let space = space::Space::around(&bodies, &scene.camera);
        lights::unit(stage, &bodies, &space, &mut found);
        daylight::check(scene, &mut found);
        camera::check(scene, &mut found);
        return (None, found);
    }
    let space = space::Space::around(&bodies, &scene.camera);
    let light_unit = lights::unit(stage, &bodies, &space, &mut found);
    daylight::check(scene, &mut found);
    let matter = matter(stage, &bodies, plan, &mut found);
    let media = media::prepare(&matter, &scene.integrator, &space, &mut found);
    let materials = materials::table(stage, (&bodies, &matter), light_unit, &mut found);
    let lights = lights::plain(scene, &space, light_unit, &mut found);
    let integrator = integrator::prepare(&scene.integrator, plan, space.length(1.0));
    integrator::check(&scene.integrator, &mut found);
    let parts = (&*bodies, &matter);
    let shapes = shapes::assemble(stage, parts, &space, &materials, plan, progress, &mut found);
    lights::check(scene, (&bodies, &shapes), &lights, &mut found);
    let window = film::window(&scene.film, settings);
    let camera = camera::prepare(scene, &bodies, &space, settings, &mut found);

    let faulty = found.iter().any(|diagnostic| diagnostic.level == Level::Error);
    let (Ok((size, window)), Some(camera), false) = (window, camera, faulty) else {
        return (None, found);
    };
    let filter = film::filter(&scene.film.filter);
    let film = Film { size, window, filter, layers: scene.layers.len() };
    let parts = Parts {
        shapes,
        materials,
        media,
        camera_medium: matter.at.first().copied().unwrap_or_default(),
        lights,
        camera,
        film,
        paths,
        integrator,
        light_unit,
        space,
    };
    (Some(parts), found)
}

/// What is around what, as far as the plan asks for it.
fn matter<'a>(
    stage: &'a Stage,
    bodies: &[bodies::Placed<'a>],
    plan: &Plan,
    found: &mut Vec<Diagnostic>,
) -> Matter<'a> {
    let eye = bodies::eye(&stage.scene, bodies).map(|(eye, _)| eye);
    // Where no light is followed nothing can go wrong, whatever is built.
    match plan.builds(Feature::Bodies) && stage.scene.integrator.follows_light() {
        true => Matter::of(stage, bodies, eye.as_slice(), found),
        false => Matter::said(stage, bodies, eye.iter().len()),
    }
}

fn build(stage: &Stage, settings: &Settings, plan: &Plan, parts: Parts) -> Prepared {
    let shapes::Assembled { shapes, lamps, objects, slivers } = parts.shapes;
    let shining = parts.lights.shining() + lamps.len();
    let other_shapes: u64 = objects.iter().map(|object| object.others).sum();
    let geometry = Geometry::build(shapes)
        .with_coordinates(plan.builds(Feature::Coordinates))
        .with_portable(settings.portable);
    let guides = stage.scene.integrator.is_guided() && plan.builds(Feature::Guide);
    let lights = lights::gather(
        parts.lights,
        lamps,
        (&geometry, &parts.materials),
        (&stage.scene.integrator, plan.builds(Feature::Lights) || guides),
        parts.light_unit,
    );
    let triangles: u64 = objects.iter().map(|object| object.triangles).sum();
    let instances = || objects.iter().filter(|object| object.instance);
    let instanced: u64 = instances().map(|object| object.triangles).sum();
    let bytes = geometry.bytes() as u64;
    let [kept_once, as_copies] = geometry.bytes_of_instances().map(|bytes| bytes as u64);
    let part = |bytes: u64, count: u64, of: u64| {
        (u128::from(bytes) * u128::from(count) / u128::from(of.max(1))) as u64
    };
    let note = |(object, counted): (&crate::scene::Named<_>, &shapes::Counted)| ObjectNote {
        name: object.name.value.clone(),
        span: object.name.span,
        triangles: counted.triangles,
        bytes: match counted.instance {
            true => part(kept_once, counted.triangles, instanced),
            false => part(
                bytes - kept_once,
                counted.triangles + counted.others,
                triangles - instanced + other_shapes,
            ),
        },
    };
    let summary = Summary {
        triangles,
        other_shapes,
        materials: parts.materials.all.len() as u64,
        lights: shining as u64,
        slivers,
        bytes,
        instances: instances().count() as u64,
        bytes_of_copies: bytes - kept_once + as_copies,
        texture_bytes: textures::bytes(stage),
    };
    let guide = guides.then(|| Guide::build(&geometry, &parts.materials.all, &lights)).flatten();
    Prepared {
        objects: stage.scene.objects.iter().zip(&objects).map(note).collect(),
        summary,
        integrator: parts.integrator,
        scale: parts.space.length(1.0),
        centre: parts.space.centre(),
        world: World {
            materials: parts.materials.all,
            media: parts.media,
            overlaps: parts.materials.overlaps,
            camera_medium: parts.camera_medium,
            makeup: match plan.builds(Feature::Materials) {
                true => Makeup::Any,
                false => Makeup::Diffuse,
            },
            guide,
            geometry,
            lights,
            camera: parts.camera,
            film: parts.film,
            paths: parts.paths,
            sampler: integrator::sampler(&stage.scene.sampler),
            light_unit: parts.light_unit,
        },
    }
}
