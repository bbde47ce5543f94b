//! Textures, end to end: each place of a surface has the colour that its texture has there.

mod shots;

use std::path::Path;

use scn::math::{NoProgress, Picture};
use scn::plan::{Feature, Plan};
use scn::prepare::{self, Settings};
use shots::Shot;

/// The one render of a text that stands in a folder, or the report of its faults.
fn open(folder: &Path, text: &str) -> Result<Shot, String> {
    let text = format!("scn 1 in m\nsampler: independent\nstop: {{ samples: 2 }}\n{text}");
    shots::open_text(&folder.join("it.scn"), &text, &[]).map(|mut all| all.remove(0))
}

/// Words about a light that is the same everywhere, by which a lone flat surface shows its albedo.
fn lit(size: (u32, u32), body: &str) -> String {
    let (width, height) = size;
    format!(
        "film: {{ size: ({width}, {height}), filter: box {{}} }}\n\
         light around: constant {{ radiance: 1 W/m^2/sr }}\n\
         integrator: direct {{ environment: on }}\n{body}"
    )
}

/// The albedos that a picture of so many columns and rows shows.
fn albedos(folder: &Path, size: (u32, u32), body: &str) -> Picture {
    let shot = open(folder, &lit(size, body)).unwrap_or_else(|report| panic!("{report}"));
    shot.picture(&shot.prepare(1.0), 0)
}

/// A camera far away that sees 2 × 2 metres about the origin, x to the right and y upward.
const FRONT: &str =
    "camera: perspective { eye: (0, 0, 2000), look_at: (0, 0, 0), fov_y: 0.0572957767 deg }\n";
/// A quad that fills its view.
const QUAD: &str =
    "object card: quad { corner: (-1, -1, 0), u: (2, 0, 0), v: (0, 2, 0), material: it }\n";

/// Holds a picture to the values of its pixels: green, times 1000, rows from the top.
fn holds<R: AsRef<[i32]>>(seen: &Picture, expected: &[R]) {
    let rows = seen.pixels.chunks(seen.width);
    let rows: Vec<Vec<i32>> =
        rows.map(|row| row.iter().map(|p| (1000.0 * p.g).round() as i32).collect()).collect();
    let expected: Vec<&[i32]> = expected.iter().map(AsRef::as_ref).collect();
    assert_eq!(rows, expected);
}

/// A folder with pictures: `six.pgm` is of three columns and two rows of linear grey.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("six.pgm"), "P2 3 2 255\n51 102 153\n204 255 0\n").unwrap();
    std::fs::write(folder.path().join("flat.pgm"), "P2 2 2 255\n51 51 51 51\n").unwrap();
    folder
}

/// A material that reads a texture.
fn reads(texture: &str) -> String {
    format!("material it: diffuse {{ albedo: {texture} }}\n")
}

const SIX: &str = "file: \"six.pgm\", encoding: linear, filter: nearest";

#[test]
fn a_checker_has_its_squares_where_it_says() {
    let checker = reads("checker { a: 0.75, b: 0.25, squares: (4, 2) }");
    let seen = albedos(Path::new("."), (4, 4), &format!("{FRONT}{QUAD}{checker}"));
    let (a, b) = (750, 250);
    holds(&seen, &[&[b, a, b, a], &[b, a, b, a], &[a, b, a, b], &[a, b, a, b]]);
}

#[test]
fn a_picture_stands_upright_on_a_quad_texel_by_texel() {
    let folder = folder();
    let six = reads(&format!("image {{ {SIX} }}"));
    let seen = albedos(folder.path(), (6, 6), &format!("{FRONT}{QUAD}{six}"));
    let (above, below) = ([200, 200, 400, 400, 600, 600], [800, 800, 1000, 1000, 0, 0]);
    holds(&seen, &[&above, &above, &above, &below, &below, &below]);
    // From behind it is mirrored.
    let behind = FRONT.replace("2000)", "-2000)");
    let seen = albedos(folder.path(), (6, 6), &format!("{behind}{QUAD}{six}"));
    let (above, below) = ([600, 600, 400, 400, 200, 200], [0, 0, 1000, 1000, 800, 800]);
    holds(&seen, &[&above, &above, &above, &below, &below, &below]);
}

#[test]
fn mirrored_quads_and_single_triangles_keep_their_coordinates() {
    let folder = folder();
    let six = reads(&format!("image {{ {SIX} }}"));
    let mirrored = QUAD.replace("material: it", "material: it, place: [scale(-1, 1, 1)]");
    let seen = albedos(folder.path(), (6, 6), &format!("{FRONT}{mirrored}{six}"));
    let row = [600, 600, 400, 400, 200, 200];
    let below = [0, 0, 1000, 1000, 800, 800];
    holds(&seen, &[&row, &row, &row, &below, &below, &below]);
    // Half of a quad of twice the size about its middle.
    let triangle =
        "object card: triangle { a: (-1, -1, 0), b: (3, -1, 0), c: (-1, 3, 0), material: it }\n";
    let seen = albedos(folder.path(), (6, 6), &format!("{FRONT}{triangle}{six}"));
    // It shows the lower left quarter.
    holds(&seen, &[&[800, 800, 800, 800, 1000, 1000]; 6]);
}

#[test]
fn a_picture_is_turned_repeated_and_moved() {
    let folder = folder();
    let image =
        |more: &str| format!("{FRONT}{QUAD}{}", reads(&format!("image {{ {SIX}, {more} }}")));
    // A quarter turn from u to v about the lower left corner, back into view by repetition.
    let seen = albedos(folder.path(), (6, 6), &image("turn: 90 deg, tint: 0.5"));
    let row = |left: i32, right: i32| [left, left, left, right, right, right];
    let rows =
        [row(300, 0), row(300, 0), row(200, 500), row(200, 500), row(100, 400), row(100, 400)];
    holds(&seen, &rows);
    let seen = albedos(folder.path(), (6, 6), &image("repeats: (2, 1), offset: (0, 0.5)"));
    let (above, below) = ([800, 1000, 0, 800, 1000, 0], [200, 400, 600, 200, 400, 600]);
    holds(&seen, &[&above, &above, &above, &below, &below, &below]);
}

#[test]
fn planes_have_tiles_of_a_length_from_their_point() {
    let folder = folder();
    let six = reads(&format!("image {{ {SIX} }}"));
    let plane = "object wall: plane { point: (-1, -1, 0), normal: z, material: it, tile: 1 m }\n\
         object behind: quad { corner: (-1, -1, -1), u: (2, 0, 0), v: (0, 2, 0), material: it }\n";
    let (above, below) = ([200, 400, 600, 200, 400, 600], [800, 1000, 0, 800, 1000, 0]);
    let seen = albedos(folder.path(), (12, 12), &format!("{FRONT}{plane}{six}"));
    for (y, row) in seen.pixels.chunks(12).enumerate() {
        let expected = if (y / 3) % 2 == 0 { above } else { below };
        for (x, pixel) in row.iter().enumerate() {
            assert!((pixel.g - expected[x / 2] as f32 / 1000.0).abs() < 1e-4, "{x} {y}");
        }
    }
    // The same tiles from a point a million tiles away.
    let far = plane.replace("point: (-1, -1, 0)", "point: (-1000001, 999999, 0)");
    let there = albedos(folder.path(), (12, 12), &format!("{FRONT}{far}{six}"));
    assert_eq!(there, seen);
}

#[test]
fn disks_show_the_square_around_them() {
    let folder = folder();
    let six = reads(&format!("image {{ {SIX} }}"));
    let disk = "object card: disk { center: (0, 0, 0), normal: z, radius: 1.5 m, material: it }\n";
    let seen = albedos(folder.path(), (4, 4), &format!("{FRONT}{disk}{six}"));
    let (above, below) = ([200, 400, 400, 600], [800, 1000, 1000, 0]);
    holds(&seen, &[&above, &above, &below, &below]);
}

#[test]
fn spheres_are_globes_and_turn_with_their_place() {
    let folder = folder();
    let six = reads(&format!("image {{ {SIX} }}"));
    // From so near that the pixel shows the middle of the sphere.
    let seen_from = |eye: &str, place: &str| {
        let text = format!(
            "camera: perspective {{ eye: {eye}, look_at: (0, 0, 0), fov_y: 1e-3 deg }}\n\
             object ball: sphere {{ center: (0, 0, 0), radius: 1 m, material: it, place: [{place}] }}\n{six}"
        );
        let seen = albedos(folder.path(), (1, 1), &text);
        (1000.0 * seen.pixels[0].g).round()
    };
    // The middle third is about +z; 200, 400, 600 are in the north.
    assert_eq!(seen_from("(0, 2, 4)", ""), 400.0);
    assert_eq!(seen_from("(0, -2, 4)", ""), 1000.0);
    assert_eq!(seen_from("(4, 2, -1)", ""), 600.0);
    assert_eq!(seen_from("(-4, 2, -1)", ""), 200.0);
    assert_eq!(seen_from("(0, 2, 4)", "rotate(y, 120 deg)"), 200.0);
    assert_eq!(seen_from("(0, 2, 4)", "scale(2), rotate(z, 180 deg), move(0, 0.001, 0)"), 1000.0);
    assert_eq!(seen_from("(4, 2, -1)", "scale(-1, 1, 1)"), 200.0);
}

/// A square of two triangles and a triangle above it, with coordinates counted either way.
const OBJ: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 3 0\n\
     vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

#[test]
fn meshes_have_the_coordinates_of_their_files() {
    let folder = folder();
    let six = reads(&format!("image {{ {SIX} }}"));
    let mesh = "object card: mesh { file: \"card.obj\", unit: m, material: it }\n";
    let (above, below) = ([200, 200, 400, 400, 600, 600], [800, 800, 1000, 1000, 0, 0]);
    let upright = [&above[..], &above, &above, &below, &below, &below];
    for face in ["f 1/1 2/2 3/3 4/4", "f -5/-4 -4/-3 -3/-2 -2/-1", "f 1/1/ 2/2 3/3\nf 1/1 3/3 4/4"]
    {
        std::fs::write(folder.path().join("card.obj"), format!("{OBJ}{face}\n")).unwrap();
        let seen = albedos(folder.path(), (6, 6), &format!("{FRONT}{mesh}{six}"));
        holds(&seen, &upright);
    }
    // Mirrored with its place.
    let mirrored = mesh.replace("material: it", "material: it, place: [scale(1, -1, 1)]");
    let seen = albedos(folder.path(), (6, 6), &format!("{FRONT}{mirrored}{six}"));
    holds(&seen, &[&below[..], &below, &below, &above, &above, &above]);
}

#[test]
fn faces_without_coordinates_are_told_where_a_texture_needs_them() {
    let folder = folder();
    let six = reads(&format!("image {{ {SIX} }}")) + "material plain: diffuse { albedo: 0.5 }\n";
    let obj = format!("{OBJ}usemtl a\nf 1/1 2/2 3/3 4/4\nusemtl b\nf 4 3 5\n");
    std::fs::write(folder.path().join("card.obj"), obj).unwrap();
    let mesh = |materials: &str| {
        let text = format!(
            "object card: mesh {{ file: \"card.obj\", unit: m, {materials} }}\n{FRONT}{six}"
        );
        open(folder.path(), &lit((6, 6), &text))
    };
    assert!(mesh("materials: { a: it, b: plain }").is_ok());
    let report = mesh("materials: { a: plain, b: it }").err().unwrap();
    assert!(report.contains("parts of the mesh `card` have no coordinates"), "{report}");
    let report = mesh("material: it").err().unwrap();
    assert!(report.contains("1 of its 3 triangles"), "{report}");
}

#[test]
fn encodings_are_as_said_or_by_the_file() {
    let folder = folder();
    std::fs::write(folder.path().join("grey.pgm"), "P2 1 1 255\n188\n").unwrap();
    let seen = |encoding: &str| {
        let image = reads(&format!("image {{ file: \"grey.pgm\"{encoding} }}"));
        albedos(folder.path(), (1, 1), &format!("{FRONT}{QUAD}{image}")).pixels[0].g
    };
    assert!((seen("") - 0.502_886).abs() < 1e-5);
    assert_eq!(seen(", encoding: srgb"), seen(""));
    assert!((seen(", encoding: linear") - 188.0 / 255.0).abs() < 1e-5);
}

/// A box open to one side with a ball of this material, where light goes many ways.
fn furnace(albedo: &str) -> String {
    format!(
        "integrator: path {{ depth: 4 }}\nfilm: {{ size: (16, 16) }}\n\
         light around: constant {{ radiance: 1 W/m^2/sr }}\n{FRONT}{QUAD}\n\
         object ball: sphere {{ center: (0, 0, 0.5), radius: 0.5 m, material: it }}\n\
         object disk: disk {{ center: (1, 0, 0.5), normal: -x, radius: 1 m, material: it }}\n\
         object floor: plane {{ point: (0, -1, 0), normal: y, material: it }}\n{}",
        reads(albedo)
    )
}

#[test]
fn a_texture_of_one_colour_is_that_colour_to_the_bit() {
    let folder = folder();
    let picture = |albedo: &str| {
        let shot =
            open(folder.path(), &furnace(albedo)).unwrap_or_else(|report| panic!("{report}"));
        shot.picture(&shot.prepare(1.0), 7)
    };
    let plain = picture("0.2");
    assert!(plain.pixels.iter().any(|pixel| pixel.g > 0.0));
    assert_eq!(picture("checker { a: 0.2, b: 0.2, squares: (7, 3), turn: 20 deg }"), plain);
    let flat = "image { file: \"flat.pgm\", encoding: linear, repeats: (5, 5), turn: 33 deg";
    for filter in ["nearest", "linear"] {
        for wrap in ["repeat", "clamp", "mirror"] {
            assert_eq!(picture(&format!("{flat}, filter: {filter}, wrap: {wrap} }}")), plain);
        }
    }
}

#[test]
fn coordinates_are_built_where_a_texture_is_read_and_change_nothing_elsewhere() {
    let folder = folder();
    for (albedo, needed) in [("checker { a: 0.9, b: 0.1, squares: (9, 9) }", true), ("0.5", false)]
    {
        let shot =
            open(folder.path(), &furnace(albedo)).unwrap_or_else(|report| panic!("{report}"));
        let plan = Plan::of(&shot.stage);
        assert_eq!(plan.builds(Feature::Coordinates), needed);
        let pictures = [plan.clone(), plan.forced()].map(|plan| {
            let settings = Settings::default();
            let (prepared, _) = prepare::prepare_by(&plan, &shot.stage, &settings, &NoProgress);
            shot.picture(&prepared.unwrap(), 3)
        });
        assert_eq!(pictures[0], pictures[1], "{albedo}");
    }
}

#[test]
fn a_scene_is_another_when_its_picture_is() {
    let folder = folder();
    let text = lit((1, 1), &format!("{FRONT}{QUAD}{}", reads("image { file: \"flat.pgm\" }")));
    let first = open(folder.path(), &text).ok().unwrap().stage;
    assert_eq!(first.files.len(), 1);
    std::fs::write(folder.path().join("flat.pgm"), "P2 2 2 255\n51 51 51 52\n").unwrap();
    let second = open(folder.path(), &text).ok().unwrap().stage;
    assert!(first.hash != second.hash && first.light_hash != second.light_hash);
}

#[test]
fn a_mtl_file_names_pictures_beside_it_and_multiplies_them() {
    let folder = folder();
    std::fs::create_dir(folder.path().join("old")).unwrap();
    std::fs::copy(folder.path().join("six.pgm"), folder.path().join("old/my six.pgm")).unwrap();
    let obj = format!("mtllib old/card.mtl\n{OBJ}usemtl a\nf 1/1 2/2 3/3 4/4\n");
    std::fs::write(folder.path().join("card.obj"), obj).unwrap();
    let mesh = format!("{FRONT}object card: mesh {{ file: \"card.obj\", unit: m }}\n");
    let seen = |mtl: &str| {
        std::fs::write(folder.path().join("old/card.mtl"), format!("newmtl a\n{mtl}\n")).unwrap();
        open(folder.path(), &lit((2, 2), &mesh)).map(|shot| {
            let picture = shot.picture(&shot.prepare(1.0), 0);
            (picture, shot.stage.files.len())
        })
    };
    let (plain, files) = seen("map_Kd my six.pgm").unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(files, 3);
    let (half, _) = seen("Kd 0.5 0.5 0.5\nmap_Kd -blendu on my six.pgm").ok().unwrap();
    assert!(plain.pixels[0].g > 0.03);
    for (plain, half) in plain.pixels.iter().zip(&half.pixels) {
        assert!((0.5 * plain.g - half.g).abs() < 1e-6);
    }
    let report = |mtl: &str| {
        let report = seen(mtl).err().unwrap();
        let words = report.split_whitespace().filter(|word| *word != "│");
        words.collect::<Vec<_>>().join(" ")
    };
    let outside = report("map_Kd ../six.pgm");
    assert!(
        outside.contains("names the file `../six.pgm`, which is not in its folder"),
        "{outside}"
    );
    let missing = report("map_Kd my_six.pgm");
    assert!(missing.contains("does not exist") && missing.contains("my six.pgm"), "{missing}");
    let options = report("map_Kd -o 1 1 my six.pgm");
    assert!(options.contains("without the options of its texture"), "{options}");
}
