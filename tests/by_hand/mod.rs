//! Scenes made by hand, for tests that ask what the light does and not what the text says.

#![allow(dead_code, unused_imports, reason = "each test file uses a part of it")]

mod objects;
pub mod vocabulary;
mod watches;

use std::f64::consts::FRAC_PI_4;
use std::sync::Arc;

use glam::{DVec3, dvec3};
use scn::diag::{Diagnostic, FileId, Span};
use scn::load::{SceneHash, Stage, StagedMesh};
use scn::math::{NoProgress, Picture, Rgb, Spectrum};
use scn::measure::statistics::Moments;
use scn::prepare::{self, Prepared};
use scn::run::{self, Begin, Outcome, Watch};
use scn::scene::{self, At, Named};

pub use objects::bumpy_ball;
pub use watches::{Patient, Ticking};

/// The place of what has no text.
pub const NOWHERE: Span = Span { file: FileId(0), start: 0, end: 0 };

/// `value`, said nowhere.
pub fn at<T>(value: T) -> At<T> {
    At::new(value, NOWHERE)
}

/// A stage in the making.
#[derive(Clone)]
pub struct Hand {
    pub scene: scene::Scene,
    pub meshes: Vec<Option<StagedMesh>>,
    pub settings: prepare::Settings,
}

/// Direct light, lamps at random points, with shadows.
pub fn direct() -> scene::Integrator {
    integrator(true, scene::AreaLights::Random)
}

/// Direct light.
pub fn integrator(shadows: bool, area_lights: scene::AreaLights) -> scene::Integrator {
    scene::Integrator::Direct(scene::Direct {
        shadows: at(scene::Switch(shadows)),
        area_lights: at(area_lights),
        environment: at(scene::Switch(false)),
        lights: at(scene::LightCount::All),
        light_samples: at(scene::Count(1)),
        specular_depth: at(scene::Depth::Most(10)),
        splits: at(splits(0, 0, 1)),
        roulette: at(scene::Roulette::Throughput),
        paths: at(None),
    })
}

/// All light, with the defaults of the language.
pub fn path() -> scene::Path {
    scene::Path {
        next_event: at(scene::Switch(true)),
        mis: at(scene::Switch(true)),
        lights: at(None),
        light_samples: at(scene::Count(1)),
        splits: at(splits(0, 0, 1)),
        roulette: at(scene::Roulette::Throughput),
        roulette_after: at(scene::Count(3)),
        reuse: at(scene::Count(1)),
        guide: at(scene::Guide::Off),
        depth: at(scene::Depth::Unlimited),
        paths: at(None),
    }
}

/// Where a path goes on as several.
pub fn splits(specular: u64, diffuse: u64, rays: u64) -> scene::Splits {
    scene::Splits {
        specular: at(scene::Count(specular)),
        diffuse: at(scene::Count(diffuse)),
        rays: at(scene::Count(rays)),
    }
}

/// So many samples, and no other limit.
pub fn stop(samples: u64) -> scene::Stop {
    scene::Stop {
        samples: at(Some(scene::Count(samples))),
        time: at(None),
        error: at(None),
        adaptive: at(scene::Switch(false)),
    }
}

/// The box filter of one pixel.
pub fn pixel_box() -> scene::Filter {
    scene::Filter::BoxFilter(scene::BoxFilter { radius: at(scene::Number(0.5)) })
}

impl Hand {
    /// An empty scene of 1 × 1 pixel, one sample, seen from +z.
    pub fn new(integrator: scene::Integrator) -> Self {
        let camera = scene::Camera::Overview(scene::Overview {
            look: at(scene::Direction(DVec3::NEG_Z)),
            up: at(scene::Direction(DVec3::Y)),
            distance: at(scene::Number(1.75)),
            fov_y: at(scene::Angle(FRAC_PI_4)),
        });
        let film = scene::Film {
            size: at(scene::Size([1, 1])),
            filter: at(pixel_box()),
            exposure: at(scene::Exposure(0.0)),
        };
        let sampler = scene::Stratified { grid: at(scene::Count(4)) };
        Self {
            scene: scene::Scene {
                surroundings: at(None),
                camera: at(camera),
                caption: at(scene::Text(String::new())),
                film: at(film),
                integrator: at(integrator),
                sampler: at(scene::Sampler::Stratified(sampler)),
                stop: at(stop(1)),
                layers: Vec::new(),
                lights: Vec::new(),
                materials: Vec::new(),
                media: Vec::new(),
                objects: Vec::new(),
                textures: Vec::new(),
            },
            meshes: Vec::new(),
            settings: prepare::Settings::default(),
        }
    }

    pub fn size(mut self, width: u64, height: u64) -> Self {
        self.scene.film.value.size = at(scene::Size([width, height]));
        self
    }

    pub fn filter(mut self, filter: scene::Filter) -> Self {
        self.scene.film.value.filter = at(filter);
        self
    }

    pub fn grid(mut self, grid: u64) -> Self {
        let sampler = scene::Stratified { grid: at(scene::Count(grid)) };
        self.scene.sampler = at(scene::Sampler::Stratified(sampler));
        self
    }

    pub fn samples(mut self, samples: u64) -> Self {
        self.scene.stop.value = stop(samples);
        self
    }

    pub fn integrator(mut self, integrator: scene::Integrator) -> Self {
        self.scene.integrator = at(integrator);
        self
    }

    /// A camera at `eye` that looks at a point, so many degrees from edge to edge.
    pub fn camera(mut self, eye: DVec3, look_at: DVec3, fov_deg: f64) -> Self {
        let across = if (look_at - eye).normalize().y.abs() > 0.9 { DVec3::Z } else { DVec3::Y };
        self.scene.camera = at(scene::Camera::Perspective(scene::Perspective {
            eye: at(scene::Point(eye)),
            look_at: at(scene::Point(look_at)),
            up: at(scene::Direction(across)),
            fov_y: at(scene::Angle(fov_deg.to_radians())),
        }));
        self
    }

    /// What is up in the picture of the camera that was placed.
    pub fn up(mut self, up: DVec3) -> Self {
        let scene::Camera::Perspective(camera) = &mut self.scene.camera.value else {
            panic!("a camera that was placed")
        };
        camera.up = at(scene::Direction(up.normalize()));
        self
    }

    pub fn material(mut self, name: &str, albedo: f64, emission: f64) -> Self {
        self.scene.materials.push(diffuse(name, Spectrum::Constant(albedo), emission));
        self.scene.materials.sort_by(|a, b| a.name.value.cmp(&b.name.value));
        self
    }

    /// A material other than diffuse.
    pub fn made_of(mut self, name: &str, material: scene::Material) -> Self {
        self.scene.materials.push(Named { name: at(name.to_string()), value: at(material) });
        self.scene.materials.sort_by(|a, b| a.name.value.cmp(&b.name.value));
        self
    }

    /// Clear matter of an index, and a material of that name whose inside it is.
    pub fn glass(mut self, name: &str, index: f64) -> Self {
        let ior = scene::Index { n: Spectrum::Constant(index), k: Spectrum::Constant(0.0) };
        let medium = scene::Medium::Homogeneous(scene::Homogeneous::clear(at(ior)));
        self.scene.media.push(Named { name: at(name.to_string()), value: at(medium) });
        self.scene.media.sort_by(|a, b| a.name.value.cmp(&b.name.value));
        let inside = at(scene::Ref::new(name));
        let dielectric = scene::Dielectric { inside, outside: at(None) };
        self.made_of(name, scene::Material::Dielectric(dielectric))
    }

    /// Metal of an index n + ik.
    pub fn metal(self, name: &str, n: Spectrum, k: Spectrum) -> Self {
        let conductor = scene::Conductor {
            ior: at(scene::Index { n, k }),
            emission: at(scene::Radiance(Spectrum::Constant(0.0))),
            emits: at(scene::Sides::Front),
        };
        self.made_of(name, scene::Material::Conductor(conductor))
    }

    /// A mirror.
    pub fn mirror(self, name: &str, reflectance: f64) -> Self {
        let mirror = scene::Mirror {
            reflectance: at(scene::Textured::Plain(scene::Reflectance(Spectrum::Constant(
                reflectance,
            )))),
            emission: at(scene::Radiance(Spectrum::Constant(0.0))),
            emits: at(scene::Sides::Front),
        };
        self.made_of(name, scene::Material::Mirror(mirror))
    }

    /// A mixture of two materials, of which `amount` is the second.
    pub fn mix(self, name: &str, [first, second]: [&str; 2], amount: f64) -> Self {
        let mix = scene::Mix {
            first: at(scene::Ref::new(first)),
            second: at(scene::Ref::new(second)),
            amount: at(scene::Number(amount)),
        };
        self.made_of(name, scene::Material::Mix(mix))
    }

    pub fn directional(mut self, direction: DVec3, irradiance: f64) -> Self {
        let light = scene::Light::Directional(scene::Directional {
            direction: at(scene::Direction(direction.normalize())),
            irradiance: at(scene::Irradiance(Spectrum::Constant(irradiance))),
        });
        let name = at(format!("light{}", self.scene.lights.len()));
        self.scene.lights.push(Named { name, value: at(light) });
        self
    }

    pub fn point(self, position: DVec3, intensity: f64) -> Self {
        self.light(scene::Light::PointLight(scene::PointLight {
            position: at(scene::Point(position)),
            intensity: at(scene::Intensity(Spectrum::Constant(intensity))),
        }))
    }

    /// A spot that looks at a point, with its two angles in degrees.
    pub fn spot(
        self,
        position: DVec3,
        look_at: DVec3,
        intensity: f64,
        [cone, falloff]: [f64; 2],
    ) -> Self {
        self.light(scene::Light::SpotLight(scene::SpotLight {
            position: at(scene::Point(position)),
            direction: at(scene::Direction((look_at - position).normalize())),
            intensity: at(scene::Intensity(Spectrum::Constant(intensity))),
            cone: at(scene::Angle(cone.to_radians())),
            falloff: at(scene::Angle(falloff.to_radians())),
        }))
    }

    pub fn light(mut self, light: scene::Light) -> Self {
        let name = at(format!("light{}", self.scene.lights.len()));
        self.scene.lights.push(Named { name, value: at(light) });
        self
    }

    pub fn background(mut self, radiance: f64) -> Self {
        let light = scene::Light::Constant(scene::Constant {
            radiance: at(scene::Radiance(Spectrum::Constant(radiance))),
        });
        let name = at(format!("light{}", self.scene.lights.len()));
        self.scene.lights.push(Named { name, value: at(light) });
        self
    }

    pub fn stage(&self) -> Stage {
        Stage {
            scene: Arc::new(self.scene.clone()),
            meshes: self.meshes.clone(),
            textures: Vec::new(),
            media: Vec::new(),
            files: Vec::new(),
            hash: SceneHash([0; 32]),
            light_hash: SceneHash([0; 32]),
        }
    }

    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        prepare::check(&self.stage(), &self.settings)
    }

    /// Names of the codes of all faults.
    pub fn codes(&self) -> Vec<&'static str> {
        self.diagnostics().iter().map(|diagnostic| diagnostic.code.name).collect()
    }

    pub fn prepared(&self) -> Prepared {
        let (prepared, found) = prepare::prepare(&self.stage(), &self.settings, &NoProgress);
        prepared.unwrap_or_else(|| panic!("{found:?}"))
    }

    pub fn render(&self, seed: u64) -> Outcome {
        render(&self.prepared(), seed, self.scene.stop.most_samples().unwrap(), &Patient)
    }

    pub fn picture(&self) -> Picture {
        self.render(0).picture
    }

    /// Mean and standard error of the first pixel's green, over 16 seeds.
    pub fn estimate(&self) -> Moments {
        let prepared = self.prepared();
        let mut moments = Moments::default();
        for seed in 0..16 {
            let outcome =
                render(&prepared, seed, self.scene.stop.most_samples().unwrap(), &Patient);
            moments.add(f64::from(outcome.picture.pixels[0].g));
        }
        moments
    }
}

pub fn render(prepared: &Prepared, seed: u64, samples: u64, watch: &dyn Watch) -> Outcome {
    let settings = run::Settings::samples(seed, samples);
    let Prepared { world, integrator, .. } = prepared;
    let outcome = run::render(world, integrator, &settings, Begin::new(world), watch);
    assert_eq!(outcome.invalid, None);
    outcome
}

fn diffuse(name: &str, albedo: Spectrum, emission: f64) -> Named<scene::Material> {
    let material = scene::Material::Diffuse(scene::Diffuse {
        albedo: at(scene::Textured::Plain(scene::Reflectance(albedo))),
        emission: at(scene::Radiance(Spectrum::Constant(emission))),
        emits: at(scene::Sides::Front),
    });
    Named { name: at(name.to_string()), value: at(material) }
}

/// A scene with something of everything: a smooth mesh, round things, a lamp, a sun, a sky.
pub fn still_life() -> Hand {
    Hand::new(direct())
        .size(48, 40)
        .samples(20)
        .material("white", 0.8, 0.0)
        .material("shining", 0.5, 7.0)
        .mesh(bumpy_ball(16), 1.0, 0.7)
        .sphere(dvec3(1.5, -0.3, 0.8), 0.7, "white")
        .quad(dvec3(0.0, -1.0, 0.0), DVec3::Z * 3.0, DVec3::X * 3.0, "white")
        .quad(dvec3(0.5, 3.0, 0.0), DVec3::X * 0.5, DVec3::Z * 0.5, "shining")
        .disk(dvec3(-2.0, 1.0, 0.0), DVec3::X, 0.4, "shining")
        .directional(dvec3(-1.0, -1.0, -0.5), 2.0)
        .background(0.25)
        .camera(dvec3(1.0, 2.0, 6.0), dvec3(0.0, 0.0, 0.0), 45.0)
}

/// The largest component-wise difference of two pictures.
pub fn difference(a: &Picture, b: &Picture) -> f32 {
    assert_eq!((a.width, a.height), (b.width, b.height));
    let apart = |(a, b): (&Rgb, &Rgb)| {
        let [r, g, b] = (*a - *b).to_array().map(f32::abs);
        r.max(g).max(b)
    };
    a.pixels.iter().zip(&b.pixels).map(apart).fold(0.0, f32::max)
}
