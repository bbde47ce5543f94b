//! The scenes of the project against the linter: what fires on good practice is a faulty rule.

use std::path::{Path, PathBuf};

use scn::cli;
use scn::diag::{self, Sources};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The report of what is found in a text; empty if nothing is.
fn told(path: &Path, text: &str) -> String {
    let mut sources = Sources::new();
    let found = cli::check(path, text, &[], &mut sources).found;
    diag::print::report(&found, &sources, &path.to_string_lossy(), diag::print::Look::PLAIN)
}

fn scenes(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            scenes(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "scn") {
            found.push(path);
        }
    }
}

#[test]
fn shipped_scenes_are_beyond_doubt() {
    let mut all = Vec::new();
    scenes(&root().join("scenes"), &mut all);
    assert!(all.len() >= 3);
    for path in all {
        let report = told(&path, &std::fs::read_to_string(&path).unwrap());
        assert!(report.is_empty(), "{report}");
    }
}

#[test]
fn scenes_of_the_readme_are_beyond_doubt() {
    let text = std::fs::read_to_string(root().join("README.md")).unwrap();
    let scenes: Vec<_> = text.split("```scn\n").skip(1).collect();
    assert!(scenes.len() >= 3);
    for scene in scenes {
        let scene = scene.split("```").next().unwrap();
        let report = told(&root().join("example.scn"), scene);
        assert!(report.is_empty(), "{scene}\n{report}");
    }
}

/// A world of media and bodies; light goes through `hollow` as through a vacuum.
fn clear(bodies: &str) -> String {
    format!(
        "scn 1 in m\n\nintegrator: path\nlight sky: constant {{ radiance: 1 W/m^2/sr }}\n\
         medium hollow: homogeneous {{ ior: 1 }}\nmedium water: homogeneous {{ ior: 1.333 }}\n\
         medium glass: homogeneous {{ ior: 1.5 }}\n{bodies}"
    )
}

fn ball(name: &str, radius: f64, media: &str) -> String {
    format!(
        "object {name}: sphere {{ center: (0, 0, 0), radius: {radius} m, material: dielectric \
         {{ {media} }} }}\n"
    )
}

#[test]
fn what_a_surface_says_is_around_it_is_doubted_where_it_is_not() {
    let report = |bodies: &[String]| told(&root().join("example.scn"), &clear(&bodies.concat()));
    let bubble = ball("bubble", 0.5, "inside: hollow, outside: glass");
    let glass = ball("marble", 1.0, "inside: glass");
    let pond = ball("pond", 2.0, "inside: water");
    let all = [glass.clone(), pond.clone(), bubble.clone()];
    assert_eq!(report(&all).matches("lint/outside-contradicted").count(), 0);
    let empty = ball("marble", 1.0, "inside: glass, outside: hollow");
    assert!(!report(&[empty.clone(), bubble.clone()]).contains("outside-contradicted"));
    let wrong = report(&[empty, pond, bubble.clone()]);
    assert!(wrong.contains("`marble` says that `hollow` is around it"));
    let alone = report(&[bubble]);
    assert!(alone.contains("write `surroundings: glass` if it is everywhere"), "{alone}");
}

#[test]
fn stones_of_glass_that_touch_in_a_line_are_doubted_and_stones_apart_are_not() {
    let folder = tempfile::tempdir().unwrap();
    let scene = clear(
        "object stones: mesh { file: \"two.obj\", unit: m, material: dielectric { inside: glass } }\n",
    );
    let report = |away: f64| {
        let mut text = String::new();
        for (sign, from) in [(1.0, 0.0), (-1.0, away)] {
            for [x, y, z] in [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
                text += &format!("v {} {} {z}\n", sign * x - from, sign * y - from);
            }
        }
        for at in [0, 4] {
            for [a, b, c] in [[1, 3, 2], [1, 2, 4], [1, 4, 3], [2, 3, 4]] {
                text += &format!("f {} {} {}\n", a + at, b + at, c + at);
            }
        }
        std::fs::write(folder.path().join("two.obj"), text).unwrap();
        told(&folder.path().join("example.scn"), &scene)
    };
    let touching = report(0.0);
    assert!(touching.contains("more than two faces of `stones` meet at an edge"), "{touching}");
    assert!(touching.contains("at an edge near (0, 0, 50) cm"), "{touching}");
    assert!(!report(0.1).contains("lint/non-manifold"));
}

#[test]
fn parts_of_very_different_size_are_told_with_their_number_factor_and_place() {
    let folder = tempfile::tempdir().unwrap();
    let scene = clear(
        "object stones: mesh { file: \"two.obj\", unit: m, material: dielectric { inside: glass } }\n",
    );
    let report = |size: f64| {
        let mut text = String::new();
        for (size, from) in [(1.0, 0.0), (size, 5.0)] {
            for [x, y, z] in [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
                text += &format!("v {} {} {}\n", from + size * x, size * y, size * z);
            }
        }
        for at in [0, 4] {
            for [a, b, c] in [[1, 3, 2], [1, 2, 4], [1, 4, 3], [2, 3, 4]] {
                text += &format!("f {} {} {}\n", a + at, b + at, c + at);
            }
        }
        std::fs::write(folder.path().join("two.obj"), text).unwrap();
        told(&folder.path().join("example.scn"), &scene)
    };
    let mixed = report(5e-5);
    assert!(mixed.contains("`stones` has parts of which one is 20000 times as large"), "{mixed}");
    assert!(mixed.contains("the smallest of its 2 parts is near (5, 0, 0) m"), "{mixed}");
    assert!(!report(2e-4).contains("lint/mixed-scale"));
}
