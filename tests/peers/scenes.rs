//! What the harness in Python renders and traces, so far as it is scn's: its scenes are beyond doubt
//! and are those it asks for, its rays are those it says.

use std::path::{Path, PathBuf};

use scn::cli;
use scn::diag::{self, Sources};
use scn::lang;

#[path = "rays/src/sets.rs"]
mod sets;

fn here(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/peers").join(name)
}

fn read(name: &str) -> String {
    std::fs::read_to_string(here(name)).unwrap()
}

#[test]
fn scenes_are_beyond_doubt() {
    let (path, mut sources) = (here("scenes.scn"), Sources::new());
    let found = cli::check(&path, &read("scenes.scn"), &[], &mut sources).found;
    let report = diag::print::report(&found, &sources, "scenes.scn", diag::print::Look::PLAIN);
    assert!(report.is_empty(), "{report}");
}

#[test]
fn the_harness_asks_for_the_renders_there_are() {
    let (path, mut sources) = (here("scenes.scn"), Sources::new());
    let compiled = lang::compile(&path, &read("scenes.scn"), &[], &[], &cli::Disk, &mut sources);
    let mut there: Vec<&str> = compiled.renders.iter().map(|r| r.name.value.as_str()).collect();
    // The keys of SCENES and of SIDES, each on a line of its own.
    let text = read("harness/scenes.py") + &read("harness/sky.py");
    let keys = text.lines().filter_map(|line| line.strip_prefix("    \"")?.split_once("\": "));
    let mut asked: Vec<&str> = keys.map(|(key, _)| key).collect();
    there.sort_unstable();
    asked.sort_unstable();
    assert_eq!(there, asked);
}

/// Two triangles that fill the view of the rays' camera, as the harness writes them.
fn wall() -> Vec<u8> {
    let points = [[-2.0, -2.0, 0.0], [2.0, -2.0, 0.0], [2.0, 2.0, 0.0], [-2.0, 2.0, 0.0_f32]];
    let faces = [[0, 1, 2], [0, 2, 3_u32]];
    let counts = [points.len() as u32, faces.len() as u32];
    let words = counts.map(u32::to_le_bytes).into_iter();
    let words = words.chain(points.into_iter().flatten().map(f32::to_le_bytes));
    words.chain(faces.into_iter().flatten().map(u32::to_le_bytes)).flatten().collect()
}

#[test]
fn rays_go_from_hit_to_hit() {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), wall()).unwrap();
    let geometry = sets::Triangles::read(file.path()).unwrap().geometry();
    let sets = sets::sets(&geometry, 8);
    let counts: Vec<_> = sets.iter().map(|set| (set.name, set.any, set.rays.len())).collect();
    // All rays of the camera meet the wall; none that leaves it does.
    let expected = [
        ("primary", false, 64),
        ("diffuse", false, 64),
        ("second", false, 0),
        ("shadow", true, 64),
    ];
    assert_eq!(counts, expected);
    assert!(sets[0].rays.iter().all(|ray| geometry.closest(ray).is_some()));
    assert!(sets[1].rays.iter().all(|ray| ray.direction.z > 0.0));
    assert!(sets[1].rays.iter().all(|ray| geometry.closest(ray).is_none()));
}

#[test]
fn triangles_of_another_length_are_refused() {
    let file = tempfile::NamedTempFile::new().unwrap();
    for bytes in [wall().split_at(76).0, &[], &[1, 2, 3]] {
        std::fs::write(file.path(), bytes).unwrap();
        assert!(sets::Triangles::read(file.path()).is_err(), "{bytes:?}");
    }
}
