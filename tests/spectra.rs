//! Spectra in scenes: what a file says, what its picture is made of, and what files of data do.

mod common;

use std::path::Path;
use std::sync::Arc;

use common::show;
use glam::Vec3;
use scn::cli::Disk;
use scn::diag::Sources;
use scn::lang::{self, Compiled};
use scn::load::Loader;
use scn::math::{NoProgress, Spectrum};
use scn::optics::{colour, tabulated};
use scn::prepare;
use scn::scene::{Light, Scene};

fn compile(folder: &Path, text: &str) -> (Compiled, Sources) {
    let mut sources = Sources::new();
    let path = folder.join("scene.scn");
    let compiled = lang::compile(&path, text, &[], &[], &Disk, &mut sources);
    (compiled, sources)
}

/// The scene of a file whose sky has this radiance.
fn sky(folder: &Path, value: &str) -> Arc<Scene> {
    let text = format!(
        "scn 1 in m\nintegrator: preview\n{value}\nobject ball: sphere {{ center: (0, 0, 0), radius: 1 m, material: diffuse {{ albedo: 0.5 }} }}\n"
    );
    let (compiled, sources) = compile(folder, &text);
    let told: Vec<_> = compiled.diagnostics.iter().map(|told| show(told, &sources)).collect();
    assert!(told.is_empty(), "{text}\n{}", told.join("\n"));
    compiled.renders[0].scene.clone()
}

fn radiance_of(scene: &Scene) -> Spectrum {
    let Light::Constant(sky) = &scene.lights[0].value.value else { panic!("a constant light") };
    sky.radiance.0.clone()
}

fn radiance(value: &str) -> Spectrum {
    let item = format!("light sky: constant {{ radiance: {value} }}");
    radiance_of(&sky(Path::new(""), &item))
}

fn nodes(value: &str) -> Vec<(f64, f64)> {
    match radiance(&format!("({value}) * W/m^2/sr")) {
        Spectrum::Table(table) => table.nodes().to_vec(),
        other => panic!("{other:?}"),
    }
}

fn near(found: [f64; 3], expected: [f64; 3], most: f64) {
    let off = (0..3).map(|i| (found[i] - expected[i]).abs()).fold(0.0, f64::max);
    assert!(off < most, "{found:?}, not {expected:?}");
}

#[test]
fn tables_have_their_nodes_in_order_and_in_nanometres() {
    assert_eq!(nodes("spectrum { 0.7 um: 3, 400 nm: 1 }"), [(400.0, 1.0), (700.0, 3.0)]);
    assert_eq!(nodes("2 * spectrum { 400 nm: 1 } / 4"), [(400.0, 0.5)]);
    assert_eq!(nodes("1 - spectrum { 400 nm: 1, 500 nm: 0.25 }"), [(400.0, 0.0), (500.0, 0.75)]);
    let sum = nodes("spectrum { 400 nm: 1, 600 nm: 3 } + spectrum { 500 nm: 1 }");
    assert_eq!(sum, [(400.0, 2.0), (500.0, 3.0), (600.0, 4.0)]);
    let product = nodes("spectrum { 400 nm: 1, 600 nm: 3 } * spectrum { 500 nm: 5, 600 nm: 2 }");
    assert_eq!(product, [(400.0, 5.0), (500.0, 10.0), (600.0, 6.0)]);
    assert_eq!(nodes("spectrum { 400 nm: 3 }^2"), [(400.0, 9.0)]);
}

#[test]
fn illuminants_are_as_bright_as_what_they_are_multiplied_with() {
    near(colour::emitted(&radiance("illuminant.d65 * 5 W/m^2/sr")), [5.0; 3], 1e-9);
    let lamp = colour::emitted(&radiance("5 W/m^2/sr * illuminant.a"));
    assert!((colour::luminance(lamp) - 5.0).abs() < 1e-9 && lamp[0] > lamp[2], "{lamp:?}");
    // The values of its page, divided by their luminance, which leave out what is beyond 700 nm.
    let cornell = colour::emitted(&radiance("illuminant.cornell * W/m^2/sr"));
    let published = [20.7321, 10.8534, 2.7699];
    let luminance = colour::luminance(published);
    near(cornell, published.map(|channel| channel / luminance), 5e-3);
}

#[test]
fn black_bodies_have_the_luminance_that_physics_gives_them() {
    // By Planck's law and sums over 5 nm: 683.002 lm/W times this, in cd/m².
    let body = colour::emitted(&radiance("blackbody(2856 K)"));
    let luminance = 683.002 * colour::luminance(body);
    assert!((luminance / 19749722.129674517 - 1.0).abs() < 1e-4, "{luminance}");
    let half = colour::emitted(&radiance("0.5 * blackbody(2856 K)"));
    near(half, body.map(|channel| channel / 2.0), 1e-9 * body[0]);
    // The same power in each nanometre: a watt over the width of the eye.
    let even = colour::emitted(&radiance("1 W/m^2/sr/nm"));
    assert!((colour::luminance(even) - 106.8566).abs() < 1e-3, "{even:?}");
}

#[test]
fn a_colour_comes_back_from_its_spectrum() {
    for rgb in ["rgb(0.8, 0.4, 0.2)", "rgb(0.02, 0.3, 0.9)", "rgb(40, 30, 20)"] {
        let light = colour::emitted(&radiance(&format!("upsample({rgb} * W/m^2/sr)")));
        let Spectrum::Rgb(wanted) = radiance(&format!("{rgb} * W/m^2/sr")) else { panic!() };
        near(light, wanted, 1e-3 * wanted[0].max(wanted[2]));
        // Without a unit it is a reflectance, as white light shows it.
        let paint = colour::reflected(&radiance(&format!("upsample({rgb}) * W/m^2/sr")));
        near(paint, wanted, 1e-8 * wanted[0].max(wanted[2]));
    }
}

#[test]
fn a_picture_has_the_colour_of_the_spectrum() {
    let world = |value: &str| {
        let scene = sky(Path::new(""), &format!("light sky: constant {{ radiance: {value} }}"));
        let (stage, _) = Loader::new(&NoProgress).stage(&scene, &mut Sources::new());
        let stage = stage.unwrap();
        let (prepared, _) = prepare::prepare(&stage, &prepare::Settings::default(), &NoProgress);
        (prepared.unwrap().world, stage.hash)
    };
    let (table, hash) = world("paint.cornell_green * illuminant.a * W/m^2/sr");
    let [r, g, b] = colour::emitted(&radiance("paint.cornell_green * illuminant.a * W/m^2/sr"));
    let (rgb, other) = world(&format!("rgb({r}, {g}, {b}) * W/m^2/sr"));
    assert_eq!(table.lights.seen(Vec3::X), rgb.lights.seen(Vec3::X));
    assert!(hash != other, "another scene");
    assert_eq!(hash, world("illuminant.a * paint.cornell_green * W/m^2/sr").1);
}

#[test]
fn files_of_data_are_read_where_they_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("lamp.csv", "# nm\nwl,power\n400,1\n700,3\n");
    write("lamp_um.txt", "0.4 1\n0.7 3\n");
    std::fs::create_dir(folder.path().join("lib")).unwrap();
    write("lib/lamps.scn", "scn 1\nlet lamp = data(\"lamp.csv\") * W/m^2/sr\n");
    write("lib/lamp.csv", "400;1\r\n700;3\r\n");
    let light = |value: &str| format!("light sky: constant {{ radiance: {value} }}");
    for item in [
        light("data(\"lamp.csv\") * W/m^2/sr"),
        light("data(\"lamp_um.txt\", um) * W/m^2/sr"),
        light("lamp") + "\nuse \"lib/lamps.scn\"",
    ] {
        let table = tabulated(&radiance_of(&sky(folder.path(), &item))).unwrap();
        assert_eq!(table.nodes(), [(400.0, 1.0), (700.0, 3.0)], "{item}");
    }
}

/// The line a fault is told of in a file of data, and its headline.
fn fault(text: &str) -> (String, usize, String) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.csv"), text).unwrap();
    let scene = "scn 1 in m\nintegrator: preview\nlet a = data(\"a.csv\")\nmaterial m1: diffuse { albedo: a }\nmaterial m2: diffuse { albedo: a }\n";
    let (compiled, sources) = compile(folder.path(), scene);
    let [told] = &compiled.diagnostics[..] else { panic!("{:?}", compiled.diagnostics) };
    let place = told.place().unwrap();
    let file = Path::new(&*sources.get(place.file).name).file_name().unwrap().to_string_lossy();
    (file.into_owned(), sources.line_column(place).0, told.headline.clone())
}

#[test]
fn faults_of_data_are_told_once_with_their_line() {
    let (file, line, headline) = fault("# a\nwl,n\n400,1\n500,x\n600,2\n");
    assert_eq!((file.as_str(), line), ("a.csv", 4));
    assert_eq!(headline, "the file `a.csv` has `x` where a number belongs");
    let (file, line, headline) = fault("# nothing\n");
    assert_eq!((file.as_str(), line), ("scene.scn", 3));
    assert_eq!(headline, "the file `a.csv` has no row of numbers");
    assert!(fault("0.4,1\n0.7,2\n").2.contains("which no eye sees"));
    // Three columns are an index, not a reflectance.
    assert!(fault("400,1.5,0.1\n").2.contains("found a complex index of refraction"));
}

#[test]
fn spectra_cost_no_more_than_the_limit_allows() {
    // Each product has the nodes of both, and the list of products grows: stopped, not endured.
    let folder = tempfile::tempdir().unwrap();
    let table: Vec<_> =
        (0..20_000).map(|i| format!("{} nm: 0.5", 380.0 + 0.02 * f64::from(i))).collect();
    let text = format!(
        "scn 1 in m\nintegrator: preview\nlet a = spectrum {{ {} }}\nfor i in 1 to 100_000 {{ material \"m{{i}}\": diffuse {{ albedo: a * a }} }}\n",
        table.join(", ")
    );
    let (compiled, _) = compile(folder.path(), &text);
    assert!(compiled.diagnostics.iter().any(|told| told.code.name == "render/too-much"));
}

/// What docs/language.md says of the price of three channels.
#[test]
fn three_channels_are_off_by_what_the_page_says() {
    let light = |value: &str| colour::emitted(&radiance(&format!("({value}) * W/m^2/sr")));
    let paint = |value: &str| colour::reflected(&radiance(&format!("({value}) * W/m^2/sr")));
    let red = paint("paint.cornell_red");
    let green = paint("paint.cornell_green");
    let sodium = "spectrum { 589.29 nm: 0, 589.3 nm: 100, 589.31 nm: 0 }";
    for (lamp, walls, names, expected) in [
        ("illuminant.d65", vec![red], "paint.cornell_red", 0.0),
        ("illuminant.d65", vec![red, red], "paint.cornell_red^2", 0.16),
        ("illuminant.a", vec![red], "paint.cornell_red", 0.14),
        ("illuminant.a", vec![red, red], "paint.cornell_red^2", 0.29),
        ("illuminant.a", vec![red, green], "paint.cornell_red * paint.cornell_green", -0.30),
        (sodium, vec![red], "paint.cornell_red", 0.86),
    ] {
        let exact = light(&format!("{lamp} * {names}"));
        let mut product = light(lamp);
        for wall in walls {
            (0..3).for_each(|i| product[i] *= wall[i]);
        }
        let off = colour::luminance(product) / colour::luminance(exact) - 1.0;
        assert!((off - expected).abs() < 0.006, "{lamp} on {names}: {off}");
    }
}
