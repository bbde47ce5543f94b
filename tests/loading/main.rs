//! Scenes staged from files made for each test.

#[path = "../common/mod.rs"]
mod common;
mod files;
mod hashes;
mod illum;
mod materials;

use std::fs;
use std::path::Path;
use std::sync::Arc;

use glam::DVec3;

use scn::diag::{Code, Diagnostic, FileId, Level, Sources, Span};
use scn::load::{Loader, Stage};
use scn::math::{NoProgress, Spectrum};
use scn::optics::colour::{emitted, reflected};
use scn::scene::{
    At, BoxFilter, Camera, Count, Diffuse, Direction, Exposure, FileName, Film, Filter,
    Independent, Integrator, Length, Material, Mesh, Named, Number, Object, Overview, Place,
    Preview, Radiance, Reflectance, Sampler, Scene, Size, Stop, Text, Textured,
};

const FACE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const PAINTED: &str = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl white\nf 1 2 3\n";

fn at<T>(value: T) -> At<T> {
    At::new(value, Span::new(FileId(0), 0, 4))
}

/// A scene of meshes, with the materials `grey` and `pink`.
fn scene(meshes: Vec<(&str, Mesh)>) -> Arc<Scene> {
    let material = |name: &str, albedo| Named {
        name: at(name.to_string()),
        value: at(Material::Diffuse(Diffuse {
            albedo: at(Textured::Plain(Reflectance(Spectrum::Constant(albedo)))),
            emission: at(Radiance(Spectrum::Constant(0.0))),
            emits: at(scn::scene::Sides::Front),
        })),
    };
    let object = |(name, mesh): (&str, Mesh)| Named {
        name: at(name.to_string()),
        value: at(Object::Mesh(mesh)),
    };
    Arc::new(Scene {
        camera: at(Camera::Overview(Overview {
            look: at(Direction(DVec3::NEG_Z)),
            up: at(Direction(DVec3::Y)),
            distance: at(Number(1.75)),
            fov_y: at(scn::scene::Angle(0.9)),
        })),
        caption: at(Text(String::new())),
        surroundings: at(None),
        film: at(Film {
            size: at(Size([4, 4])),
            filter: at(Filter::BoxFilter(BoxFilter { radius: at(Number(0.5)) })),
            exposure: at(Exposure(0.0)),
        }),
        integrator: at(Integrator::Preview(Preview {})),
        sampler: at(Sampler::Independent(Independent {})),
        stop: at(Stop {
            samples: at(Some(Count(1))),
            time: at(None),
            error: at(None),
            adaptive: at(scn::scene::Switch(false)),
        }),
        layers: Vec::new(),
        lights: Vec::new(),
        materials: vec![material("grey", 0.5), material("pink", 0.75)],
        media: Vec::new(),
        objects: meshes.into_iter().map(object).collect(),
        textures: Vec::new(),
    })
}

struct Folder(tempfile::TempDir);

impl Folder {
    fn with(files: &[(&str, &str)]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in files {
            fs::write(folder.path().join(name), text).unwrap();
        }
        Self(folder)
    }

    fn name(&self, name: &str) -> FileName {
        FileName { text: name.into(), path: self.0.path().join(name) }
    }

    fn mesh(&self, file: &str) -> Mesh {
        Mesh {
            file: at(self.name(file)),
            unit: at(Length(1.0)),
            mtl: at(None),
            material: at(None),
            materials: at(Vec::new()),
            ambient: at(None),
            place: at(Place::default()),
            mend: at(Length(0.0)),
            yields_to: at(None),
        }
    }
}

fn sources() -> Sources {
    let mut sources = Sources::new();
    sources.add("a.scn", "mesh field");
    sources
}

fn stage(mesh: Mesh) -> (Option<Stage>, Vec<Diagnostic>, Sources) {
    let mut sources = sources();
    let (stage, found) =
        Loader::new(&NoProgress).stage(&scene(vec![("thing", mesh)]), &mut sources);
    assert_eq!(stage.is_none(), found.iter().any(|d| d.level == Level::Error), "{found:?}");
    (stage, found, sources)
}

/// Each fault with the file, line and words of its first label.
fn told(mesh: Mesh) -> Vec<(Code, String, usize, String)> {
    let (_, found, sources) = stage(mesh);
    let told = |d: &Diagnostic| {
        let span = d.place().unwrap();
        let file = Path::new(&*sources.get(span.file).name);
        let file = file.file_name().unwrap().to_str().unwrap().to_string();
        (d.code, file, sources.line_column(span).0, sources.text(span).to_string())
    };
    found.iter().map(told).collect()
}

fn one(mesh: Mesh) -> (Code, String, usize, String) {
    let mut all = told(mesh);
    assert_eq!(all.len(), 1, "{all:?}");
    all.remove(0)
}

fn said(code: Code, file: &str, line: usize, words: &str) -> (Code, String, usize, String) {
    (code, file.into(), line, words.into())
}

/// The albedo and the emission of each slot.
fn paints(stage: &Stage) -> Vec<([f64; 3], [f64; 3])> {
    let paint = |material: &Named<Material>| {
        let Material::Diffuse(diffuse) = &material.value.value else { panic!("diffuse") };
        (reflected(&diffuse.albedo.plain().unwrap().0), emitted(&diffuse.emission.0))
    };
    stage.meshes[0].as_ref().unwrap().materials.iter().map(paint).collect()
}
