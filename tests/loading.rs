//! Scenes staged from files made for each test.

mod common;

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
    Homogeneous, Independent, Index, Integrator, KaMeans, Length, Material, Medium, Mesh, Named,
    Number, Object, Overview, Place, Preview, Radiance, Ref, Reflectance, Sampler, Scene, Size,
    Stop, Text, Textured,
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

#[test]
fn materials_come_from_the_mtl_file_with_their_places() {
    let mtl = "newmtl red\nKd 1 0 0\nnewmtl white\nKd 0.9 0.8 0.7\nKe 3 2 1\n";
    let folder = Folder::with(&[("a.obj", PAINTED), ("a.mtl", mtl)]);
    let (stage, found, sources) = stage(folder.mesh("a.obj"));
    assert_eq!(found, []);
    let stage = stage.unwrap();
    assert_eq!(paints(&stage), [([0.9, 0.8, 0.7], [3.0, 2.0, 1.0])]);
    let white = &stage.meshes[0].as_ref().unwrap().materials[0];
    let Material::Diffuse(diffuse) = &white.value.value else { panic!("diffuse") };
    assert_eq!(sources.text(diffuse.albedo.span), "Kd 0.9 0.8 0.7");
    assert_eq!(sources.line_column(white.name.span), (3, 1));
    let names: Vec<_> = stage.files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["a.obj", "a.mtl"]);
    assert_eq!((stage.files[0].bytes, stage.files[0].triangles), (PAINTED.len() as u64, Some(1)));
}

#[test]
fn the_scene_replaces_materials_and_what_it_replaces_may_be_missing() {
    let folder = Folder::with(&[("a.obj", PAINTED), ("bare.obj", FACE)]);
    for file in ["a.obj", "bare.obj"] {
        let mut all = folder.mesh(file);
        all.material = at(Some(Ref::new("grey")));
        assert_eq!(paints(&stage(all).0.unwrap())[0].0, [0.5; 3]);
    }
    let mut named = folder.mesh("a.obj");
    named.materials = at(vec![(at("white".into()), at(Ref::new("pink")))]);
    assert_eq!(paints(&stage(named).0.unwrap())[0].0, [0.75; 3]);
}

#[test]
fn another_mtl_file_may_be_named() {
    let folder = Folder::with(&[("a.obj", PAINTED), ("other.mtl", "newmtl white\nKd 0.1\n")]);
    let mut mesh = folder.mesh("a.obj");
    mesh.mtl = at(Some(folder.name("other.mtl")));
    assert_eq!(paints(&stage(mesh).0.unwrap())[0].0, [0.1; 3]);
}

#[test]
fn files_that_cannot_be_read_are_told_on_the_field() {
    let folder = Folder::with(&[("bunny.obj", FACE)]);
    let (_, found, _) = stage(folder.mesh("buny.obj"));
    assert_eq!(found[0].code, Code::FILE_UNREADABLE);
    assert_eq!(found[0].headline, "the file `buny.obj` does not exist");
    assert!(found[0].help.as_ref().unwrap().contains("`bunny.obj`"));
    assert_eq!(one(folder.mesh(".")).0, Code::FILE_UNREADABLE);
    #[cfg(unix)]
    for device in ["/dev/zero", "/dev/null"] {
        let mut mesh = folder.mesh("x");
        mesh.file.value.path = device.into();
        assert_eq!(one(mesh), said(Code::FILE_UNREADABLE, "a.scn", 1, "mesh"));
    }
}

#[test]
fn mtllib_stays_in_its_folder() {
    for name in ["../a.mtl", "/etc/passwd", "C:\\a.mtl", "x\\..\\..\\a.mtl"] {
        let folder = Folder::with(&[("a.obj", &PAINTED.replace("a.mtl", name))]);
        let words = format!("mtllib {name}");
        assert_eq!(one(folder.mesh("a.obj")), said(Code::FILE_OUTSIDE_FOLDER, "a.obj", 1, &words));
    }
    let folder = Folder::with(&[("a.obj", PAINTED)]);
    let wanted = said(Code::FILE_UNREADABLE, "a.obj", 1, "mtllib a.mtl");
    assert_eq!(one(folder.mesh("a.obj")), wanted);
    let folder = Folder::with(&[("a.obj", &PAINTED.replace("a.mtl", "."))]);
    assert_eq!(one(folder.mesh("a.obj")).0, Code::FILE_UNREADABLE);
}

#[test]
fn faults_of_the_mesh_are_told_in_it() {
    let folder = Folder::with(&[("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n")]);
    assert_eq!(one(folder.mesh("a.obj")), said(Code::MESH_BAD_INDEX, "a.obj", 5, "9"));
    let (_, found, _) = stage(folder.mesh("a.obj"));
    assert_eq!(found[0].headline, "the face in line 5 of `a.obj` uses vertex 9; the file has 3");
    assert_eq!(found[0].labels[1].span, at(()).span);

    let many = Folder::with(&[("a.obj", &"v 1 2\n".repeat(100))]);
    let (_, found, _) = stage(many.mesh("a.obj"));
    assert_eq!(found.len(), 20);
    let why = found[19].why.as_ref().unwrap();
    assert_eq!(why, "`a.obj` has 80 further faults, often of the same kinds.");
}

#[test]
fn meshes_without_a_surface_are_told() {
    let folder = Folder::with(&[
        ("empty.obj", ""),
        ("points.obj", "v 0 0 0\np 1\n"),
        ("flat.obj", "v 0 0 0\nv 1 1 1\nf 1 2 2\n"),
        ("ply.obj", "ply\n"),
    ]);
    assert_eq!(one(folder.mesh("empty.obj")), said(Code::MESH_NO_FACES, "a.scn", 1, "mesh"));
    let codes = |file| told(folder.mesh(file)).iter().map(|t| t.0).collect::<Vec<_>>();
    assert_eq!(codes("points.obj"), [Code::MESH_NOT_RENDERED, Code::MESH_NO_FACES]);
    assert_eq!(codes("flat.obj"), [Code::MESH_DEGENERATE_TRIANGLES, Code::MESH_NO_FACES]);
    assert_eq!(codes("ply.obj"), [Code::MESH_NOT_WAVEFRONT]);
}

#[test]
fn triangles_left_out_are_counted_and_shown() {
    let text = format!("{FACE}f 1 1 2\nf 2 2 3\nf 3 2 1\n");
    let folder = Folder::with(&[("a.obj", &text)]);
    let mut mesh = folder.mesh("a.obj");
    mesh.material = at(Some(Ref::new("grey")));
    let wanted = [
        said(Code::MESH_DEGENERATE_TRIANGLES, "a.obj", 5, "f 1 1 2"),
        said(Code::MESH_REPEATED_TRIANGLES, "a.obj", 7, "f 3 2 1"),
    ];
    assert_eq!(told(mesh.clone()), wanted);
    let (stage, found, _) = stage(mesh);
    assert_eq!(found[0].headline, "2 triangles of `a.obj` have no area and are left out");
    assert_eq!(stage.unwrap().files[0].triangles, Some(1));
}

#[test]
fn materials_that_are_missing_are_told() {
    let folder = Folder::with(&[
        ("a.obj", PAINTED),
        ("a.mtl", "newmtl wite\nKd 1\n"),
        ("bare.obj", FACE),
        ("orphan.obj", &PAINTED.replace("mtllib a.mtl", "")),
    ]);
    let missing = said(Code::MESH_MISSING_MATERIAL, "a.obj", 5, "usemtl white");
    assert_eq!(one(folder.mesh("a.obj")), missing);
    let (_, found, _) = stage(folder.mesh("a.obj"));
    assert!(found[0].help.as_ref().unwrap().starts_with("write `usemtl wite`"));
    let none = said(Code::MESH_NO_MATERIAL, "bare.obj", 4, "f 1 2 3");
    assert_eq!(one(folder.mesh("bare.obj")), none);
    assert_eq!(one(folder.mesh("orphan.obj")).0, Code::MESH_MISSING_MATERIAL);

    let mut unknown = folder.mesh("a.obj");
    unknown.materials = at(vec![
        (at("white".into()), at(Ref::new("pink"))),
        (at("whit".into()), at(Ref::new("pink"))),
    ]);
    assert_eq!(one(unknown.clone()), said(Code::MESH_UNKNOWN_MATERIAL, "a.scn", 1, "mesh"));
    unknown.material = at(Some(Ref::new("grey")));
    assert_eq!(told(unknown)[0].0, Code::MESH_TWO_REPLACEMENTS);
}

#[test]
fn a_ka_must_be_explained() {
    let mtl = "newmtl white\nKa 4 5 6\nKd 0.5\nnewmtl unused\nKa 1 1 1\n";
    let folder = Folder::with(&[("a.obj", PAINTED), ("a.mtl", mtl)]);
    let mut mesh = folder.mesh("a.obj");
    assert_eq!(one(mesh.clone()), said(Code::MTL_AMBIENT, "a.mtl", 2, "Ka 4 5 6"));
    let (_, found, _) = stage(mesh.clone());
    assert_eq!(
        found[0].headline,
        "the scene must say what Ka means in the material `white` of `a.obj`"
    );
    assert_eq!(found[0].mends.len(), 2);
    mesh.ambient = at(Some(KaMeans::Emission));
    assert_eq!(paints(&stage(mesh.clone()).0.unwrap()), [([0.5; 3], [4.0, 5.0, 6.0])]);
    mesh.ambient = at(Some(KaMeans::Ignored));
    assert_eq!(paints(&stage(mesh.clone()).0.unwrap()), [([0.5; 3], [0.0; 3])]);
    mesh.ambient = at(None);
    mesh.material = at(Some(Ref::new("grey")));
    assert!(stage(mesh).0.is_some());
}

#[test]
fn what_is_not_rendered_warns_and_what_has_no_effect_does_not() {
    let warned = |values: &str| {
        let mtl = format!("newmtl white\n{values}\n");
        let folder = Folder::with(&[("a.obj", PAINTED), ("a.mtl", &mtl)]);
        let (stage, found, _) = stage(folder.mesh("a.obj"));
        assert!(stage.is_some(), "{found:?}");
        found.into_iter().map(|d| d.headline).collect::<Vec<_>>()
    };
    let none: [&str; 0] = [];
    assert_eq!(warned("Kd 1\nKs 1 1 1\nNs 90\nNi 1.5\nillum 0"), none);
    assert_eq!(warned("Kd 1\nKs 1 1 1\nillum 1\nd 1\nTf 1 1 1"), none);
    assert_eq!(warned("Kd 1\nKs 0 0 0\nillum 2"), none);
    let without =
        |what: &str| [format!("the material `white` is rendered as diffuse, without {what}")];
    assert_eq!(warned("Kd 1\nKs 1 1 1\nillum 2"), without("highlights"));
    assert_eq!(
        warned("Kd 1\nillum 10\nd 0.5\nmap_Ks a.png"),
        without("a catcher of shadows, transparency and a texture")
    );
    assert_eq!(
        warned("illum 4\nNi 1.5\nd 0.1\nTf 1 0 0\nKe 1 1 1"),
        ["the material `white` is rendered without light of its own and coloured glass"]
    );
    assert_eq!(
        warned("illum 3\nKs 1 1 2"),
        ["the material `white` gives back more light than it gets"]
    );
    assert_eq!(warned("Kd 1.5"), ["the material `white` gives back more light than it gets"]);
    assert_eq!(warned("illum 1"), ["the material `white` has no Kd and is rendered black"]);
    assert_eq!(warned("Ke 1 1 1"), none);
}

/// The one material of a mesh whose file says this of the material `name`.
fn made_of(name: &str, values: &str) -> Result<(Material, Stage), String> {
    let obj = FACE.replace("f 1", &format!("usemtl {name}\nf 1"));
    let mtl = format!("newmtl {name}\n{values}\n");
    let folder = Folder::with(&[("a.obj", &format!("mtllib a.mtl\n{obj}")), ("a.mtl", &mtl)]);
    let mut scene = scene(vec![("a", folder.mesh("a.obj"))]);
    let medium = |name: &str, n| Named {
        name: at(name.to_string()),
        value: at(Medium::Homogeneous(Homogeneous {
            ior: at(Index { n: Spectrum::Constant(n), k: Spectrum::Constant(0.0) }),
        })),
    };
    Arc::make_mut(&mut scene).media = vec![medium("glass", 1.5), medium("wine", 1.34)];
    let (stage, found) = Loader::new(&NoProgress).stage(&scene, &mut sources());
    let Some(stage) = stage else {
        assert_eq!(found.len(), 1, "{found:?}");
        return Err(format!("{}; {}", found[0].headline, found[0].help.as_deref().unwrap_or("")));
    };
    let material = stage.meshes[0].as_ref().unwrap().materials[0].value.value.clone();
    Ok((material, stage))
}

#[test]
fn illum_says_what_a_material_is() {
    let sides = |name: &str, values: &str| {
        let (material, stage) = made_of(name, values).unwrap();
        let Material::Dielectric(dielectric) = material else { panic!("{material:?}") };
        let index = |name: &Ref<Medium>| {
            let Medium::Homogeneous(medium) = &stage.medium(name).value.value;
            medium.ior.n.clone()
        };
        (index(&dielectric.inside), dielectric.outside.as_ref().map(index))
    };
    for illum in [4, 5, 6, 7, 9] {
        let found = sides("any", &format!("illum {illum}\nNi 1.7"));
        assert_eq!(found, (Spectrum::Constant(1.7), None));
    }
    for illum in [12, 13, 14] {
        let found = sides("wine", &format!("illum {illum}\nNi 1.7"));
        assert_eq!(found, (Spectrum::Constant(1.34), None));
        let found = sides("glass_to_wine", &format!("illum {illum}"));
        assert_eq!(found, (Spectrum::Constant(1.34), Some(Spectrum::Constant(1.5))));
    }
    let (mirror, _) = made_of("any", "illum 3\nKs 0.5 0.6 0.7\nKd 1\nKe 2 2 2").unwrap();
    let Material::Mirror(mirror) = mirror else { panic!("{mirror:?}") };
    let Textured::Plain(Reflectance(Spectrum::Rgb(ks))) = mirror.reflectance.value else {
        panic!("plain")
    };
    // tobj reads single precision.
    assert!(ks.iter().zip([0.5, 0.6, 0.7]).all(|(found, said)| (found - said).abs() < 1e-6));
    assert_eq!(mirror.emission.value, Radiance(Spectrum::Rgb([2.0; 3])));
    let (gold, _) = made_of("gold", "illum 11").unwrap();
    let Material::Conductor(gold) = gold else { panic!("{gold:?}") };
    assert!(gold.ior.absorbs() && matches!(gold.ior.n, Spectrum::Table(_)));
}

#[test]
fn what_illum_needs_and_is_missing_is_told_with_the_line_to_write() {
    for (name, values, told, line) in [
        ("a", "illum 4", "the material `a` is glass, and has no index of refraction", "`Ni 1.5`"),
        ("a", "illum 5\nNi 0", "the material `a` is glass, and has no index", "`Ni 1.5`"),
        ("a", "illum 3", "the material `a` is a mirror, and has no Ks", "`Ks 1 1 1`"),
        ("golden", "illum 11", "there is no metal `golden`", "call it `gold`"),
        ("milk", "illum 13", "the scene declares no medium `milk`", "`medium milk: homogeneous {"),
        ("wine_to_x.1", "illum 12", "the scene declares no medium `x.1`", "`medium \"x.1\": homo"),
    ] {
        let found = made_of(name, values).map(|_| ()).unwrap_err();
        assert!(found.starts_with(told) && found.contains(line), "{found}");
    }
}

#[test]
fn faults_of_the_mtl_file_are_told_in_it() {
    let folder = Folder::with(&[("a.obj", PAINTED), ("a.mtl", "newmtl white\nKd 1 -1 1\n")]);
    assert_eq!(one(folder.mesh("a.obj")), said(Code::MTL_NEGATIVE, "a.mtl", 2, "-1"));
    let folder = Folder::with(&[("a.obj", PAINTED), ("a.mtl", "<?xml?>\n")]);
    assert_eq!(one(folder.mesh("a.obj")).0, Code::MTL_NOT_WAVEFRONT);
}

#[test]
fn a_file_is_read_once_and_its_faults_are_told_once() {
    let folder = Folder::with(&[("a.obj", &format!("{FACE}f 1 1 2\n"))]);
    let mut mesh = folder.mesh("a.obj");
    mesh.material = at(Some(Ref::new("grey")));
    let scene = scene(vec![("one", mesh.clone()), ("two", mesh)]);
    let (mut loader, mut sources) = (Loader::new(&NoProgress), sources());
    let (first, found) = loader.stage(&scene, &mut sources);
    assert_eq!(found.len(), 1);
    // What is gone from the disk is still there.
    fs::remove_file(folder.0.path().join("a.obj")).unwrap();
    let known = loader.stage(&scene, &mut sources);
    assert!(known.1.is_empty());
    let (first, second) = (first.unwrap(), known.0.unwrap());
    let mesh = |stage: &Stage, i: usize| stage.meshes[i].as_ref().unwrap().mesh.clone();
    assert!(Arc::ptr_eq(&mesh(&first, 0), &mesh(&second, 1)));
    assert_eq!((first.files.len(), first.hash), (1, second.hash));
}

#[test]
fn what_renders_share_is_told_for_the_first() {
    let folder = Folder::with(&[("a.obj", PAINTED), ("a.mtl", "newmtl red\nKd 1\n")]);
    let scene = scene(vec![("thing", folder.mesh("a.obj"))]);
    let (mut loader, mut sources) = (Loader::new(&NoProgress), sources());
    let (first, found) = loader.stage(&scene, &mut sources);
    assert_eq!((first.is_none(), found.len()), (true, 1));
    let (second, found) = loader.stage(&scene, &mut sources);
    assert!(second.is_none() && found.is_empty());
}

#[test]
fn the_hash_is_that_of_scene_and_files_wherever_they_are() {
    let hash = |obj: &str, unit: f64, name: &str| {
        let folder = Folder::with(&[(name, obj)]);
        let mut mesh = folder.mesh(name);
        mesh.material = at(Some(Ref::new("grey")));
        mesh.unit = At::new(Length(unit), Span::new(FileId(0), 2, 3));
        stage(mesh).0.unwrap().hash
    };
    let first = hash(FACE, 1.0, "a.obj");
    assert_eq!(hash(FACE, 1.0, "a.obj"), first);
    assert_ne!(hash(FACE, 2.0, "a.obj"), first);
    assert_ne!(hash(FACE, 1.0, "b.obj"), first);
    assert_ne!(hash(&format!("{FACE}# a word\n"), 1.0, "a.obj"), first);
    assert_eq!(first.to_string().len(), 64);
}

#[test]
fn limits_caption_and_exposure_change_the_hash_but_not_that_of_the_light() {
    let hashes = |change: fn(&mut scn::scene::Scene)| {
        let mut scene = Arc::unwrap_or_clone(scene(vec![]));
        change(&mut scene);
        let (stage, _) = Loader::new(&NoProgress).stage(&Arc::new(scene), &mut sources());
        let stage = stage.unwrap();
        (stage.hash, stage.light_hash)
    };
    let plain = hashes(|_| ());
    let changes: [fn(&mut scn::scene::Scene); 6] = [
        |scene| scene.stop.value.samples = at(Some(scn::scene::Count(7))),
        |scene| scene.stop.value.time = at(Some(scn::scene::Time(7.0))),
        |scene| scene.stop.value.error = at(Some(scn::scene::Number(0.1))),
        |scene| scene.stop.value.adaptive.value.0 = true,
        |scene| scene.caption.value.0.push_str("Light."),
        |scene| scene.film.value.exposure.value.0 = 1.0,
    ];
    for (i, change) in changes.into_iter().enumerate() {
        let changed = hashes(change);
        assert!(changed.0 != plain.0 && changed.1 == plain.1, "{i}");
    }
    let film = hashes(|scene| scene.film.value.size.value.0[0] += 1);
    assert!(film.0 != plain.0 && film.1 != plain.1);
}

#[test]
fn a_default_that_is_said_leaves_the_hash_as_it_is() {
    let hashes = |items: &str| {
        let text = format!(
            "scn 1 in m\nobject ball: sphere {{ center: (0, 0, 0), radius: 1 m, material: white }}\n\
             material white: diffuse {{ albedo: 0.5 }}\n{items}\n"
        );
        let (compiled, mut sources) = common::compile(&text);
        let render =
            compiled.renders.first().unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        let (stage, _) = Loader::new(&NoProgress).stage(&render.scene, &mut sources);
        let stage = stage.unwrap();
        (stage.hash, stage.light_hash)
    };
    let usual = hashes("integrator: path {}");
    assert_eq!(hashes("integrator: path { splits: { diffuse: 0 } }"), usual);
    assert_eq!(hashes("integrator: path {}\ncamera: overview { look: -z }"), usual);
    assert_ne!(hashes("integrator: path { splits: { diffuse: 1 } }"), usual);
    // How long it takes is not what it shows.
    let longer = hashes("integrator: path {}\nstop: { samples: 1024 }");
    assert_ne!(longer.0, usual.0);
    assert_eq!(longer.1, usual.1);
    let said = hashes("integrator: path {}\nfilm: { exposure: 0 ev }");
    assert_eq!(said, usual);
    let brighter = hashes("integrator: path {}\nfilm: { exposure: 1 ev }");
    assert!(brighter.0 != usual.0 && brighter.1 == usual.1);
}
