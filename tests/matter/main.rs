//! Bodies of clear matter, end to end: what is around what, without its being said.

mod meeting;
mod thin;
#[path = "../shots/mod.rs"]
mod shots;

use std::path::Path;

use scn::math::Picture;
use scn::prepare::Prepared;
use scn::render::materials::Surface;
use shots::Shot;

const HEAD: &str = "scn 1 in m
film: { size: (24, 16), filter: box {} }
sampler: independent
stop: { samples: 4 }
integrator: path
camera: perspective { eye: (0, 0.3, 6), look_at: (0, 0, 0), fov_y: 30 deg }
light sky: preetham { turbidity: 3, latitude: 40 deg, day: 172, time: 10:00, sun: none }
medium air: homogeneous { ior: 1.0003 }
medium water: homogeneous { ior: 1.33 }
medium glass: homogeneous { ior: 1.5 }
medium oil: homogeneous { ior: 1.47 }
";

fn open(folder: &Path, text: &str) -> Result<Shot, String> {
    let text = format!("{HEAD}{text}");
    shots::open_text(&folder.join("it.scn"), &text, &[]).map(|mut all| all.remove(0))
}

/// The world of a text, or the report of its faults.
fn world(text: &str) -> Result<Prepared, String> {
    world_in(Path::new("."), text)
}

fn world_in(folder: &Path, text: &str) -> Result<Prepared, String> {
    open(folder, text).map(|shot| shot.prepare(1.0))
}

/// For each piece of glass in the world, the index before it and behind it; sorted.
fn sides(prepared: &Prepared) -> Vec<(f64, f64)> {
    let sides = prepared.world.materials.iter().filter_map(|material| match &material.surface {
        Surface::Dielectric(glass) => Some((glass.outside, glass.inside)),
        _ => None,
    });
    let mut all: Vec<_> = sides.collect();
    all.sort_by(|a, b| a.partial_cmp(b).unwrap());
    all.dedup();
    all
}

fn picture(text: &str) -> Picture {
    let shot = open(Path::new("."), text).unwrap_or_else(|report| panic!("{report}"));
    shot.picture(&shot.prepare(1.0), 7)
}

/// The faults of a text by their codes, which must be of matter.
fn refused(text: &str, code: &str) -> String {
    let report = world(text).err().unwrap_or_else(|| panic!("accepted:\n{text}"));
    assert!(report.contains(&format!("matter/{code}")), "{code}: {report}");
    report
}

fn ball(name: &str, at: &str, radius: f64, material: &str) -> String {
    format!(
        "object {name}: sphere {{ center: {at}, radius: {radius} m, material: dielectric {{ {material} }} }}\n"
    )
}

#[test]
fn what_is_around_a_body_is_as_if_it_was_written_to_the_bit() {
    let unsaid = ball("a", "(0, 0, 0)", 1.0, "inside: glass")
        + &ball("b", "(0.1, 0, 0)", 0.7, "inside: water")
        + &ball("c", "(0.2, 0, 0)", 0.3, "inside: air");
    let said = ball("a", "(0, 0, 0)", 1.0, "inside: glass")
        + &ball("b", "(0.1, 0, 0)", 0.7, "inside: water, outside: glass")
        + &ball("c", "(0.2, 0, 0)", 0.3, "inside: air, outside: water");
    let expected = [(1.0, 1.5), (1.33, 1.0003), (1.5, 1.33)];
    for text in [&unsaid, &said] {
        assert_eq!(sides(&world(text).unwrap_or_else(|report| panic!("{report}"))), expected);
    }
    assert_eq!(picture(&unsaid), picture(&said));
    let surrounded = format!("{unsaid}surroundings: oil\n");
    let expected = [(1.33, 1.0003), (1.47, 1.5), (1.5, 1.33)];
    assert_eq!(sides(&world(&surrounded).unwrap()), expected);
}

#[test]
fn bodies_nest_to_any_depth_in_any_order() {
    let media = ["glass", "water", "oil"];
    let index = |n: usize| [1.5, 1.33, 1.47][n % 3];
    let mut text = String::new();
    for n in (0..20).rev() {
        // Names in another order than the bodies.
        let name = format!("body{}", (7 * n) % 20);
        text +=
            &ball(&name, "(0, 0, 0)", 1.0 - 0.04 * n as f64, &format!("inside: {}", media[n % 3]));
    }
    let world = world(&text).unwrap_or_else(|report| panic!("{report}"));
    let mut expected: Vec<_> =
        (0..20).map(|n| (if n == 0 { 1.0 } else { index(n - 1) }, index(n))).collect();
    expected.sort_by(|a, b| a.partial_cmp(b).unwrap());
    expected.dedup();
    assert_eq!(sides(&world), expected);
}

/// A surface of revolution about the y axis, as an .obj file: profiles of (radius, height) from the
/// bottom of the outer surface on, each with a material.
fn lathe(parts: &[(&str, &[(f64, f64)])], around: usize) -> String {
    let mut text = String::new();
    let mut count = 0;
    for (material, profile) in parts {
        text += &format!("usemtl {material}\n");
        for (radius, height) in *profile {
            for i in 0..around {
                let (sin, cos) = (std::f64::consts::TAU * i as f64 / around as f64).sin_cos();
                text += &format!("v {:.6} {height:.6} {:.6}\n", radius * cos, radius * sin);
            }
        }
        for row in 0..profile.len() - 1 {
            for i in 0..around {
                let at = |row: usize, i: usize| count + row * around + i % around + 1;
                let [a, b, c, d] = [at(row, i), at(row, i + 1), at(row + 1, i + 1), at(row + 1, i)];
                // At the axis one of the two has no area.
                if profile[row + 1].0 > 0.0 {
                    text += &format!("f {a} {d} {c}\n");
                }
                if profile[row].0 > 0.0 {
                    text += &format!("f {a} {c} {b}\n");
                }
            }
        }
        count += around * profile.len();
    }
    text
}

/// A tumbler of radius 1, half full: walls of glass, wine that touches them, its top.
const TUMBLER: &[(&str, &[(f64, f64)])] = &[
    ("glass", &[(0.0, -1.0), (1.0, -1.0), (1.0, 1.0), (0.9, 1.0), (0.9, 0.2)]),
    ("bowl", &[(0.0, -0.8), (0.9, -0.8), (0.9, 0.2)]),
    ("top", &[(0.9, 0.2), (0.0, 0.2)]),
];

const POURED: &str = "medium wine: homogeneous { ior: 1.36 }
object goblet: mesh {
    file: \"goblet.obj\"
    unit: m
    materials: {
        glass: dielectric { inside: glass }
        bowl: dielectric { inside: wine, outside: glass }
        top: dielectric { inside: wine }
    }
}
";

fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

#[test]
fn a_glass_of_wine_is_three_lines() {
    let folder = folder(&[("goblet.obj", &lathe(TUMBLER, 24))]);
    let world = world_in(folder.path(), POURED).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(sides(&world), [(1.0, 1.36), (1.0, 1.5), (1.5, 1.36)]);
    // In the wine, above it, in the wall, and beside it.
    for (eye, index) in
        [("(0, 0, 0)", 1.36), ("(0, 0.6, 0)", 1.0), ("(0.95, 0.6, 0)", 1.5), ("(2, 0, 0)", 1.0)]
    {
        let text =
            format!("{POURED}render it {{ camera.eye: {eye}, camera.look_at: (0.1, 5, 9) }}\n");
        let world = world_in(folder.path(), &text).unwrap_or_else(|report| panic!("{report}"));
        let around = world.world.camera_medium;
        let behind = |material: &scn::render::materials::Material| match &material.surface {
            Surface::Dielectric(glass) if material.behind == Some(around) => Some(glass.inside),
            _ => None,
        };
        let found = world.world.materials.iter().find_map(behind).unwrap_or(1.0);
        assert_eq!(found, index, "{eye}");
    }
}

#[test]
fn a_hole_is_told_and_a_crack_is_told_with_its_width_and_mended() {
    let whole = lathe(TUMBLER, 24);
    let mut lines: Vec<&str> = whole.lines().collect();
    let face = lines.iter().position(|line| line.starts_with("f ")).unwrap() + 31;
    lines.remove(face);
    let holed = lines.join("\n");
    // The top of the wine is a tenth of a millimetre too narrow.
    let mut narrow = TUMBLER.to_vec();
    narrow[2] = ("top", &[(0.8999, 0.2), (0.0, 0.2)]);
    let cracked = lathe(&narrow, 24);
    let folder = folder(&[("goblet.obj", &holed), ("cracked.obj", &cracked)]);
    let report = world_in(folder.path(), POURED).err().expect("it is open");
    assert!(report.contains("matter/open") && report.contains("3 edges"), "{report}");
    assert!(report.contains("scanned models are often open below"), "{report}");

    let cracked = POURED.replace("goblet.obj", "cracked.obj");
    let report = world_in(folder.path(), &cracked).err().expect("it is cracked");
    assert!(report.contains("matter/gap") && report.contains("gap 100 um wide"), "{report}");
    assert!(report.contains("mend: 110 um"), "{report}");
    let mended = cracked.replace("unit: m", "unit: m, mend: 110 um");
    let mended = world_in(folder.path(), &mended).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(sides(&mended), [(1.0, 1.36), (1.0, 1.5), (1.5, 1.36)]);
    let little = cracked.replace("unit: m", "unit: m, mend: 90 um");
    assert!(world_in(folder.path(), &little).is_err());
}

#[test]
fn a_mend_that_is_wider_than_the_body_or_its_triangles_is_refused() {
    let whole = lathe(TUMBLER, 24);
    // Most of the top of the wine is left out.
    let holed: Vec<&str> = whole.lines().take(whole.lines().count() - 20).collect();
    let folder = folder(&[("goblet.obj", &holed.join("\n")), ("closed.obj", &whole)]);
    let mended = |file: &str, mend: &str| {
        let unit = format!("unit: m, mend: {mend}");
        let text = POURED.replace("unit: m", &unit).replace("goblet.obj", file);
        world_in(folder.path(), &text)
    };
    let report = mended("goblet.obj", "3 m").err().expect("nothing would be left");
    assert!(report.contains("`mend: 3 m` is wider than a gap of `goblet`"), "{report}");
    assert!(report.contains("which is 3.5 m across"), "{report}");
    // A fiftieth of it is 7 cm: too little to join neighbours on its rim.
    let report = mended("goblet.obj", "6 cm").err().expect("it is open");
    assert!(report.contains("matter/open"), "{report}");
    // What is closed is left alone, whatever is said.
    assert!(mended("closed.obj", "3 m").is_ok());
    // Neighbours on a rim of many sides are near to each other.
    let fine = lathe(TUMBLER, 240);
    let fine: Vec<&str> = fine.lines().take(fine.lines().count() - 230).collect();
    std::fs::write(folder.path().join("fine.obj"), fine.join("\n")).unwrap();
    let report = mended("fine.obj", "6 cm").err().expect("its rim would be drawn together");
    assert!(report.contains("is wider than triangles of `goblet`: it would lose"), "{report}");
}

#[test]
fn clear_matter_too_small_for_single_precision_is_told_and_refused() {
    let found = |far: f64, material: &str| {
        let text = format!(
            "object it: sphere {{ center: (0, 0, 0), radius: 1 m, material: {material} }}
            object far: sphere {{ center: ({far}, 0, 0), radius: 1 m, material: diffuse {{ albedo: 0.5 }} }}\n"
        );
        match world(&text) {
            Err(report) => report,
            Ok(_) => String::new(),
        }
    };
    let glass = "dielectric { inside: glass }";
    assert!(found(1e6, glass).contains("matter/too-small"));
    let report = found(1e5, glass);
    assert!(report.contains("scene/too-small") && report.contains("336 steps"), "{report}");
    assert!(report.contains("Some of the light that goes through it is lost."), "{report}");
    assert_eq!(found(1e4, glass), "");
    assert_eq!(found(1e6, "diffuse { albedo: 0.5 }"), "");
}

#[test]
fn quads_of_six_objects_bound_one_body_and_five_do_not() {
    let mut quads = String::new();
    let sides_of_box = [
        ("front", "(0.1, 0.1, 0.3)", "(0.2, 0, 0)", "(0, 0.2, 0)"),
        ("back", "(0.3, 0.1, 0.1)", "(-0.2, 0, 0)", "(0, 0.2, 0)"),
        ("left", "(0.1, 0.1, 0.1)", "(0, 0, 0.2)", "(0, 0.2, 0)"),
        ("right", "(0.3, 0.1, 0.3)", "(0, 0, -0.2)", "(0, 0.2, 0)"),
        ("above", "(0.1, 0.3, 0.3)", "(0.2, 0, 0)", "(0, 0, -0.2)"),
        ("below", "(0.1, 0.1, 0.1)", "(0.2, 0, 0)", "(0, 0, 0.2)"),
    ];
    for (name, corner, u, v) in sides_of_box {
        quads += &format!(
            "object {name}: quad {{ corner: {corner}, u: {u}, v: {v}, material: dielectric {{ inside: glass }} }}\n"
        );
    }
    assert_eq!(sides(&world(&quads).unwrap_or_else(|report| panic!("{report}"))), [(1.0, 1.5)]);
    let five: String = quads.lines().take(5).map(|line| format!("{line}\n")).collect();
    assert!(refused(&five, "open").contains("4 edges"));
    let turned =
        quads.replace("u: (0.2, 0, 0), v: (0, 0, -0.2)", "u: (0, 0, -0.2), v: (0.2, 0, 0)");
    let report = refused(&turned, "turned");
    assert!(report.contains("turn its faces outward, all of them"), "{report}");
    assert!(!report.contains("swap"), "{report}");
    refused(
        "object d: disk { center: (0, 0, 0), normal: y, radius: 1 m, material: dielectric { inside: glass } }\n",
        "open",
    );
}

#[test]
fn bodies_that_cross_or_coincide_are_refused_by_name() {
    let near = ball("one", "(0, 0, 0)", 1.0, "inside: glass");
    for (at, radius, code) in [
        ("(1.5, 0, 0)", 0.6, Some("cross")),
        ("(1.7, 0, 0)", 0.6, None),
        ("(0.3, 0, 0)", 0.6, None),
        ("(0.5, 0, 0)", 0.6, Some("cross")),
        ("(0, 0, 0)", 1.0, Some("coincide")),
    ] {
        let text = near.clone() + &ball("two", at, radius, "inside: water");
        match code {
            None => drop(world(&text).unwrap_or_else(|report| panic!("{report}"))),
            Some(code) => {
                let report = refused(&text, code);
                assert!(report.contains("`one`") && report.contains("`two`"), "{report}");
            }
        }
    }
    let plane = |height: &str| {
        format!(
            "object sea: plane {{ point: (0, {height}, 0), normal: y, material: dielectric {{ inside: water }} }}\n"
        )
    };
    refused(&(near.clone() + &plane("0.5")), "cross");
    let world = world(&(near + &plane("1.5"))).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(sides(&world), [(1.0, 1.33), (1.33, 1.5)]);
}

#[test]
fn meshes_nest_cross_and_hollow_like_anything_else() {
    // A hollow ball as one mesh: its inner surface looks inward, and air is on both sides.
    let sphere = |radius: f64, outward: bool, x: f64, first: usize| {
        let (rows, around) = (8, 12);
        let mut text = String::new();
        for row in 0..=rows {
            let (sin, cos) = (std::f64::consts::PI * row as f64 / rows as f64).sin_cos();
            for i in 0..around {
                let (s, c) = (std::f64::consts::TAU * i as f64 / around as f64).sin_cos();
                let at = [x + radius * sin * c, -radius * cos, radius * sin * s];
                text += &format!("v {:.6} {:.6} {:.6}\n", at[0], at[1], at[2]);
            }
        }
        for row in 0..rows {
            for i in 0..around {
                let at = |row: usize, i: usize| first + row * around + i % around + 1;
                let [a, b, c, d] = [at(row, i), at(row, i + 1), at(row + 1, i + 1), at(row + 1, i)];
                let mut face = |[a, b, c]: [usize; 3]| {
                    let [b, c] = if outward { [b, c] } else { [c, b] };
                    text += &format!("f {a} {b} {c}\n");
                };
                if row + 1 < rows {
                    face([a, d, c]);
                }
                if row > 0 {
                    face([a, c, b]);
                }
            }
        }
        text
    };
    let hollow = sphere(1.0, true, 0.0, 0) + &sphere(0.8, false, 0.0, 9 * 12);
    let files = [
        ("hollow.obj", hollow.as_str()),
        ("small.obj", &sphere(0.5, true, 0.0, 0)),
        ("inward.obj", &sphere(0.5, false, 0.0, 0)),
    ];
    let folder = folder(&files);
    let mesh = |name: &str, file: &str, inside: &str, more: &str| {
        format!(
            "object {name}: mesh {{ file: \"{file}.obj\", unit: m, material: dielectric {{ inside: {inside} }}{more} }}\n"
        )
    };
    let opened = |text: &str| world_in(folder.path(), text);
    let ring = mesh("ring", "hollow", "glass", "");
    let world = opened(&ring).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(sides(&world), [(1.0, 1.5)]);
    // What is in the hollow is in air; in a lake both are in water.
    let filled = ring.clone() + &mesh("drop", "small", "oil", "");
    let world = opened(&filled).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(sides(&world), [(1.0, 1.47), (1.0, 1.5)]);
    let lake = filled + &ball("lake", "(0, 0, 0)", 3.0, "inside: water");
    let world = opened(&lake).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(sides(&world), [(1.0, 1.33), (1.33, 1.47), (1.33, 1.5)]);

    let crossing = ring.clone() + &mesh("drop", "small", "oil", ", place: [move(0.5, 0, 0)]");
    let report = opened(&crossing).err().expect("they cross");
    assert!(report.contains("matter/cross"), "{report}");
    let report = opened(&mesh("drop", "inward", "oil", "")).err().expect("it is inside out");
    assert!(report.contains("matter/inside-out"), "{report}");
    let mirrored = mesh("drop", "small", "oil", ", place: [scale(-1, 1, 1)]");
    assert_eq!(
        sides(&opened(&mirrored).unwrap_or_else(|report| panic!("{report}"))),
        [(1.0, 1.47)]
    );
    // One mesh of two bodies, one of which is in water and one is not.
    let two = sphere(0.5, true, 0.0, 0) + &sphere(0.5, true, 4.0, 9 * 12);
    std::fs::write(folder.path().join("two.obj"), two).unwrap();
    let text = mesh("pair", "two", "oil", "") + &ball("lake", "(0, 0, 0)", 1.0, "inside: water");
    let world = opened(&text).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(sides(&world), [(1.0, 1.33), (1.0, 1.47), (1.33, 1.47)]);
}

#[test]
fn what_is_seen_from_under_water_is_what_is_seen_through_its_surface() {
    // Straight up through a calm sea: n² of the radiance above, less what is reflected, and of
    // that below what is reflected.
    let text = "light around: constant { radiance: 1 W/m^2/sr }
        object sea: plane { point: (0, 0, 0), normal: y, material: dielectric { inside: water } }
        render it {
            camera: perspective { eye: (0, -2, 0), look_at: (0, 0, 0), up: z, fov_y: 1 deg }
            without light sky
            stop.samples: 64
        }";
    let shot = open(Path::new("."), text).unwrap_or_else(|report| panic!("{report}"));
    let prepared = shot.prepare(1.0);
    assert_eq!(prepared.world.media.len(), 2);
    assert_eq!(prepared.world.camera_medium, 1);
    let picture = shot.picture(&prepared, 3);
    let mean: f64 =
        picture.pixels.iter().map(|p| f64::from(p.g)).sum::<f64>() / picture.pixels.len() as f64;
    let reflected = (0.33_f64 / 2.33).powi(2);
    assert!((mean - 1.33 * 1.33 * (1.0 - reflected) - reflected).abs() < 0.02, "{mean}");
    // The same sea, said: to the bit.
    let said = text.replace("inside: water }", "inside: water, outside: air }");
    let world =
        open(Path::new("."), &said).unwrap_or_else(|report| panic!("{report}")).prepare(1.0);
    assert_eq!(sides(&world), [(1.0003, 1.33)]);
}

#[test]
fn metal_in_water_reflects_less_of_an_index_near_its_own() {
    let mirror = |more: &str| {
        let text = format!("light around: constant {{ radiance: 1 W/m^2/sr }}
            object coin: sphere {{ center: (0, 0, 0), radius: 0.2 m, material: conductor {{ ior: complex(1.33, 2) }} }}
            render it {{ without light sky, camera: perspective {{ eye: (0, 0, 0.5), look_at: (0, 0, 0), fov_y: 1 deg }}{more} }}");
        let shot = open(Path::new("."), &text).unwrap_or_else(|report| panic!("{report}"));
        let picture = shot.picture(&shot.prepare(1.0), 3);
        f64::from(picture.pixels[picture.pixels.len() / 2 + 12].g)
    };
    let fresnel = |n: f64, k: f64| ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k);
    let air = mirror("");
    assert!((air - fresnel(1.33, 2.0)).abs() < 1e-3, "{air}");
    // The ray is in the water all the way: the camera and the light are there as well.
    let water = mirror(", surroundings: water");
    assert!((water - fresnel(1.0, 2.0 / 1.33)).abs() < 1e-3, "{water}");
}

#[test]
fn a_drink_that_ends_where_its_glass_begins_looks_as_if_it_was_made_to_fit() {
    let cup = [(
        "glass",
        &[(0.0, -1.0), (1.0, -1.0), (1.0, 1.0), (0.9, 1.0), (0.9, -0.8), (0.0, -0.8)][..],
    )];
    // It reaches half way into the glass.
    let drink = [("wine", &[(0.0, -0.9), (0.95, -0.9), (0.95, 0.2), (0.0, 0.2)][..])];
    let files = [
        ("goblet.obj", lathe(TUMBLER, 24)),
        ("cup.obj", lathe(&cup, 24)),
        ("drink.obj", lathe(&drink, 24)),
    ];
    let folder = folder(&files.each_ref().map(|(name, text)| (*name, text.as_str())));
    let overlapping = |yields: &str| {
        format!(
            "medium wine: homogeneous {{ ior: 1.36 }}
            object cup: mesh {{ file: \"cup.obj\", unit: m, material: dielectric {{ inside: glass }} }}
            object drink: mesh {{ file: \"drink.obj\", unit: m, material: dielectric {{ inside: wine }}{yields} }}\n"
        )
    };
    let report = world_in(folder.path(), &overlapping("")).err().expect("they cross");
    assert!(report.contains("matter/cross") && report.contains("yields_to: "), "{report}");
    let seen = |text: &str, eye: &str| {
        let text =
            format!("{text}render it {{ camera.eye: {eye}, integrator.splits.specular: 12 }}\n");
        let shot = open(folder.path(), &text).unwrap_or_else(|report| panic!("{report}"));
        shot.picture(&shot.prepare(1.0), 7)
    };
    let overlapping = overlapping(", yields_to: cup");
    // From outside, in the wine, in the glass, and where both are.
    for eye in ["(0, 1.2, 6)", "(0.2, -0.1, 0.3)", "(0.03, -0.97, 0.02)", "(0.03, -0.85, 0.02)"] {
        let (exact, found) = (seen(POURED, eye), seen(&overlapping, eye));
        let apart = exact.pixels.iter().zip(&found.pixels);
        let apart = apart.filter(|(a, b)| (a.g - b.g).abs() > 1e-3 * a.g.abs()).count();
        assert!(apart <= exact.pixels.len() / 50, "{eye}: {apart} pixels differ");
        let mean = |picture: &Picture| picture.pixels.iter().map(|p| f64::from(p.g)).sum::<f64>();
        assert!((mean(&exact) / mean(&found) - 1.0).abs() < 2e-3, "{eye}");
    }
    // The other way round the glass ends where the drink begins.
    let other = overlapping
        .replace(", yields_to: cup", "")
        .replace("cup.obj\", unit: m", "cup.obj\", yields_to: drink, unit: m");
    let (exact, found) = (seen(POURED, "(0, 1.2, 6)"), seen(&other, "(0, 1.2, 6)"));
    let apart = exact.pixels.iter().zip(&found.pixels);
    let apart = apart.filter(|(a, b)| (a.g - b.g).abs() > 1e-3 * a.g.abs()).count();
    assert!(apart > exact.pixels.len() / 50, "{apart}");
}

#[test]
fn what_is_open_or_turned_names_the_material_that_is_to_be_changed() {
    // The walls between glass and wine have the two the wrong way round.
    let folder = folder(&[("goblet.obj", &lathe(TUMBLER, 24))]);
    let swapped = POURED.replace("inside: wine, outside: glass", "inside: glass, outside: wine");
    let words = |report: String| report.split_whitespace().collect::<Vec<_>>().join(" ");
    let report = words(world_in(folder.path(), &swapped).err().expect("they look the other way"));
    assert!(report.contains("matter/turned"), "{report}");
    assert!(
        report.contains("or swap `inside` and `outside` of `object goblet.materials.bowl`"),
        "{report}"
    );
    // They say nothing of the glass that they touch.
    let alone = POURED.replace("inside: wine, outside: glass", "inside: wine");
    let report = words(world_in(folder.path(), &alone).err().expect("the glass is open"));
    assert!(report.contains("is the wall that holds it, let that name both"), "{report}");
    assert!(report.contains("`dielectric { inside: wine, outside: glass }`"), "{report}");
}

#[test]
fn fog_is_refused_at_what_makes_it_one() {
    let fog = "medium fog: homogeneous { ior: 1, scattering: 2 / m }
        object room: sphere { center: (0, 0, 0), radius: 1 m, material: dielectric { inside: fog } }\n";
    let report = refused(fog, "not-followed");
    assert!(
        report.contains("the medium `fog` scatters light, which is not rendered yet"),
        "{report}"
    );
    assert!(report.contains("leave this field out, or write `0 / m`"), "{report}");
}
