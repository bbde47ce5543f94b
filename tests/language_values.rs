//! What scenes are worth: values in base units, differences, and what a scene is the same under.

mod common;

use std::path::Path;

use common::{Nothing, compile, show};
use scn::diag::{Code, Sources};
use scn::lang;
use scn::math::Spectrum;
use scn::scene::{Camera, Integrator, Light, Material, Medium, Object, Phase, Scene};

/// The scenes of a text without fault, by the names of their renders.
fn scenes(text: &str) -> Vec<(String, std::sync::Arc<Scene>)> {
    let (compiled, sources) = compile(text);
    let told: Vec<_> = compiled.diagnostics.iter().map(|told| show(told, &sources)).collect();
    assert!(told.is_empty(), "{}", told.join("\n"));
    compiled.renders.into_iter().map(|r| (r.name.value, r.scene)).collect()
}

fn scene(text: &str) -> std::sync::Arc<Scene> {
    scenes(&format!("scn 1 in mm\nintegrator: direct\n{text}")).remove(0).1
}

/// The radiance that `value` is worth.
fn radiance(value: &str) -> Spectrum {
    let scene = scene(&format!("light l: constant {{ radiance: {value} }}"));
    let Light::Constant(light) = &scene.lights[0].value.value else { panic!("a constant light") };
    light.radiance.0.clone()
}

/// The exposure that `value` is worth.
fn exposure(value: &str) -> f64 {
    scene(&format!("film.exposure: {value}")).film.exposure.0
}

#[test]
fn units_are_values_and_bind_tightest() {
    assert_eq!(radiance("9 W/m^2/sr"), Spectrum::Constant(9.0));
    assert_eq!(radiance("pi * W/m^2/sr"), Spectrum::Constant(std::f64::consts::PI));
    assert_eq!(radiance("2 kW / 4 m^2 / sr"), Spectrum::Constant(500.0));
    assert_eq!(radiance("rgb(1, 2, 3) * W/m^2/sr"), Spectrum::Rgb([1.0, 2.0, 3.0]));
    assert_eq!(radiance("W / (10 cm)^2 / sr"), Spectrum::Constant(100.0 - 1.4210854715202004e-14));
    assert_eq!(exposure("1 / 2 m * 4 m * ev"), 2.0);
    assert_eq!(exposure("50 % * 1 ev"), 0.5);
    assert_eq!(exposure("(12:30 / h) * 1 ev"), 12.5);
    assert_eq!(exposure("-1 ev - -2 ev + +3 ev"), 4.0);
    assert_eq!(exposure("2^3 * 2^-1 * 1 ev"), 4.0);
    assert_eq!(exposure("1_0.5e1 ev - 100 ev"), 5.0);
}

#[test]
fn colours_are_linear_or_decoded() {
    let Spectrum::Rgb([r, g, b]) = radiance("srgb(0, 0.5, 1) * W/m^2/sr") else { panic!() };
    assert_eq!((r, b), (0.0, 1.0));
    assert!((g - 0.214_041_140_482_232_6).abs() < 1e-12);
    assert_eq!(radiance("rgb(1, 2, 3) * rgb(2, 0, 1) * W/m^2/sr"), Spectrum::Rgb([2.0, 0.0, 3.0]));
}

#[test]
fn bare_coordinates_count_in_the_unit_of_their_file() {
    let scene = scene(
        "camera: perspective { eye: (1000, 2 m, 0), look_at: (0, 0, 0) + 2 * (1, 2, 3), fov_y: 90 deg }",
    );
    let Camera::Perspective(camera) = &scene.camera.value else { panic!("a pinhole") };
    assert_eq!(camera.eye.0.to_array(), [1.0, 2.0, 0.0]);
    assert_eq!(camera.look_at.0.to_array(), [0.002, 0.004, 0.006]);
    assert_eq!(camera.fov_y.0, std::f64::consts::FRAC_PI_2);
}

#[test]
fn directions_are_normalised_whatever_their_length() {
    for (text, expected) in [
        ("-y", [0.0, -1.0, 0.0]),
        ("(0, 3, 4)", [0.0, 0.6, 0.8]),
        ("(0, 3e200, 4e200)", [0.0, 0.6, 0.8]),
        ("(0 m, 3 m, 4 m)", [0.0, 0.6, 0.8]),
        ("-(0, 0, 1e-300)", [0.0, 0.0, -1.0]),
    ] {
        let scene =
            scene(&format!("light l: directional {{ direction: {text}, irradiance: 1 W/m^2 }}"));
        let Light::Directional(light) = &scene.lights[0].value.value else { panic!("a sun") };
        let off = light.direction.0 - glam::DVec3::from_array(expected);
        assert!(off.length() < 1e-15, "{text}: {:?}", light.direction);
    }
}

#[test]
fn functions_loops_and_copies_build_objects() {
    let text = "scn 1 in mm\nintegrator: direct\n\
         let ball(at, r) = sphere { center: at, radius: r, material: grey }\n\
         material grey: diffuse { albedo: 0.5 }\n\
         for i in 1 to 3 { let r = i * cm\nobject \"b{i}\": ball((i, 0, 0), r) }\n\
         object last: ball((9, 0, 0), 1 m) with { radius: 2 m }\n";
    let scene = scenes(text).remove(0).1;
    let names: Vec<_> = scene.objects.iter().map(|o| o.name.value.as_str()).collect();
    assert_eq!(names, ["b1", "b2", "b3", "last"]);
    let radius = |i: usize| match &scene.objects[i].value.value {
        Object::Sphere(sphere) => sphere.radius.0,
        _ => panic!("a sphere"),
    };
    assert_eq!([radius(0), radius(1), radius(2), radius(3)], [0.01, 0.02, 0.03, 2.0]);
}

#[test]
fn an_inline_material_is_a_declaration_named_by_its_path() {
    let scene = scene(
        "object floor: plane { point: (0, 0, 0), normal: y, material: diffuse { albedo: 0.3 } }\n\
         object box: mesh { file: \"a.obj\", unit: m, materials: { wall: diffuse { albedo: 0.4 } } }",
    );
    let names: Vec<_> = scene.materials.iter().map(|m| m.name.value.as_str()).collect();
    assert_eq!(names, ["object box.materials.wall", "object floor.material"]);
    let Object::Plane(floor) = &scene.objects[1].value.value else { panic!("a plane") };
    let Material::Diffuse(found) = &scene.material(&floor.material).value.value else {
        panic!("diffuse")
    };
    assert_eq!(found.albedo.plain().unwrap().0, Spectrum::Constant(0.3));
}

#[test]
fn what_nothing_refers_to_is_not_part_of_a_scene() {
    let with = "material used: diffuse { albedo: 0.5 }\nmaterial unused: diffuse { albedo: 0.1 }\n\
        object floor: plane { point: (0, 0, 0), normal: y, material: used }";
    let without = with.replace("material unused: diffuse { albedo: 0.1 }\n", "// nothing here\n\n");
    let (with, without) = (scene(with), scene(&without));
    assert_eq!(with.materials.len(), 1);
    assert_eq!(with, without);
    let json = |scene: &Scene| serde_json::to_string(scene).unwrap();
    assert_eq!(json(&with), json(&without));
}

#[test]
fn order_means_nothing() {
    let items = [
        "setup a { stop.samples: 2 }",
        "setup b: c { film.size: (8, 8) }",
        "setup c { film: { size: (9, 9), exposure: 1 ev } }",
        "render r: a + b { light sun.irradiance: 2 W/m^2 }",
        "light sun: directional { direction: -y, irradiance: 1 W/m^2 }",
        "integrator: direct",
    ];
    let forward = scenes(&format!("scn 1 in m\n{}", items.join("\n"))).remove(0).1;
    let mut backward = items.to_vec();
    backward.reverse();
    let backward = backward.join("\n").replace("a + b", "b + a");
    let backward = scenes(&format!("scn 1 in m\n{backward}")).remove(0).1;
    assert_eq!(forward, backward);
    assert_eq!((forward.film.size.0, forward.film.exposure.0), ([8, 8], 1.0));
    assert_eq!(forward.stop.most_samples(), Some(2));
}

#[test]
fn a_statement_leaves_nothing_of_an_earlier_one() {
    let text = "scn 1 in m\nintegrator: direct { shadows: off }\n\
        render changed { integrator.area_lights: center }\n\
        render stated { integrator: direct { area_lights: center } }";
    let all = scenes(text);
    let shadows = |i: usize| match &all[i].1.integrator.value {
        Integrator::Direct(direct) => direct.shadows.0,
        _ => panic!("direct"),
    };
    assert_eq!((shadows(0), shadows(1)), (false, true));
}

#[test]
fn set_says_it_last_in_every_render() {
    let text = "scn 1 in cm\nintegrator: direct\nrender a { stop.samples: 5 }\nrender b {}";
    let sets = [
        "stop.samples=3".to_string(),
        "camera=perspective { eye: (0, 0, 100), look_at: (0, 0, 0), fov_y: 1 rad }".to_string(),
    ];
    let mut sources = Sources::new();
    let compiled =
        lang::compile(Path::new("x/scene.scn"), text, &sets, &[], &Nothing, &mut sources);
    assert!(compiled.diagnostics.is_empty(), "{:?}", compiled.diagnostics);
    for render in &compiled.renders {
        assert_eq!(render.scene.stop.most_samples(), Some(3));
        let Camera::Perspective(camera) = &render.scene.camera.value else { panic!("a pinhole") };
        assert_eq!(camera.eye.0.z, 1.0);
    }
    assert_eq!(compiled.renders.len(), 2);
}

#[test]
fn set_speaks_of_the_renders_that_are_asked_for() {
    let text = "scn 1 in cm\nrender a { integrator: preview }\nrender b { integrator: direct }";
    let sets = ["integrator.shadows=off".to_string()];
    let told = |only: &[String]| {
        let path = Path::new("scene.scn");
        let compiled = lang::compile(path, text, &sets, only, &Nothing, &mut Sources::new());
        compiled.diagnostics.into_iter().map(|told| told.code).collect::<Vec<_>>()
    };
    assert_eq!(told(&["b".to_string()]), []);
    assert_eq!(told(&[]), [Code::NAME_UNKNOWN_FIELD]);
}

#[test]
fn names_of_files_are_relative_to_the_file_whose_text_holds_them() {
    let text = "scn 1 in m\nintegrator: direct\nobject a: mesh { file: \"models/a.obj\", unit: m }";
    let mut sources = Sources::new();
    let compiled =
        lang::compile(Path::new("some/scene.scn"), text, &[], &[], &Nothing, &mut sources);
    let Object::Mesh(mesh) = &compiled.renders[0].scene.objects[0].value.value else { panic!() };
    assert_eq!(mesh.file.path, Path::new("some/models/a.obj"));
    assert_eq!(compiled.renders[0].name.value, "scene");
}

#[test]
fn every_default_is_right_and_every_place_is_in_a_text() {
    // Of every kind and variant, with nothing said but what must be.
    let scene = scene(
        "object a: mesh { file: \"a.obj\", unit: m }\n\
         light b: directional { direction: -y, irradiance: 1 W/m^2 }\n",
    );
    assert_eq!(scene.film.size.0, [512, 512]);
    let sources = 1;
    assert!(scene.camera.span.file.0 < sources && scene.film.filter.span.file.0 < sources);
    let Camera::Overview(overview) = &scene.camera.value else { panic!("the default") };
    assert!(overview.up.span.file.0 < sources);
    assert_eq!(overview.look.0.to_array(), [0.0, 0.0, -1.0]);
}

#[test]
fn work_ends_where_its_limit_is_reached() {
    // Ten thousand renders of two thousand objects: told after the first renders, not the last.
    let text = "scn 1 in m\nintegrator: preview\nmaterial clay: diffuse { albedo: 1 }\n\
        for i in 1 to 2000 { object \"o{i}\": sphere { center: (i, 0, 0), radius: 1 m, material: clay } }\n\
        for i in 1 to 10000 { render \"a{i}\" {} }\n";
    let (compiled, _) = compile(text);
    let codes: Vec<_> = compiled.diagnostics.iter().map(|told| told.code).collect();
    assert_eq!(codes, [Code::RENDER_TOO_MUCH]);
    assert!(compiled.renders.len() < 1000, "{}", compiled.renders.len());
}

#[test]
fn media_of_the_shelf_are_media_in_base_units() {
    let scene = scene(
        "medium juice: matter.merlot\nmedium marble: matter.marble\n\
         medium other: matter.marble with { ior: 1.486 }\nmedium water: matter.water",
    );
    let medium = |name: &str| {
        let found = scene.media.iter().find(|it| it.name.value == name).expect(name);
        let Medium::Homogeneous(medium) = &found.value.value;
        medium
    };
    let (juice, marble, water) = (medium("juice"), medium("marble"), medium("water"));
    // 0.11632, 0.25191 and 0.29434 for each millimetre.
    let Spectrum::Rgb(absorption) = &juice.absorption.0 else { panic!("three bands") };
    assert!((absorption[0] - 116.32).abs() < 1e-9 && (absorption[2] - 294.34).abs() < 1e-9);
    // Measured in the red alone; in the others it scatters too little.
    let Phase::HenyeyGreenstein(phase) = &juice.phase.value else { panic!("{:?}", juice.phase) };
    assert!((phase.g.0 - 0.974).abs() < 1e-9);
    // The scattering of marble is the reduced one, which goes with a phase function of no side.
    assert!(matches!(marble.phase.value, Phase::Isotropic(_)));
    assert_eq!(marble.scattering.0, Spectrum::Rgb([2190.0, 2620.0, 3000.0]));
    assert_eq!(marble.ior.n, Spectrum::Constant(1.5));
    assert_eq!(medium("other").ior.n, Spectrum::Constant(1.486));
    assert_eq!(medium("other").scattering.0, marble.scattering.0);
    let Spectrum::Table(index) = &water.ior.n else { panic!("{:?}", water.ior) };
    assert!((index.at(589.26) - 1.33301).abs() < 2e-5, "{}", index.at(589.26));
    assert!(water.absorbs() && !water.scatters());
}
