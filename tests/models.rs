//! The models that are committed are those that the program in examples/models writes, and they
//! are closed.

use std::collections::HashSet;
use std::fs;
use std::path::PathBuf;

use glam::DVec3;

#[path = "../examples/models/cornell.rs"]
mod cornell;
#[path = "../examples/models/elephant.rs"]
mod elephant;
#[path = "../examples/models/field.rs"]
mod field;
#[path = "../examples/models/mesh.rs"]
mod mesh;
#[path = "../examples/models/nets.rs"]
mod nets;
#[path = "../examples/models/obj.rs"]
mod obj;
#[path = "../examples/models/sculpt.rs"]
mod sculpt;
#[path = "../examples/models/simplify.rs"]
mod simplify;
#[path = "../examples/models/sphere.rs"]
mod sphere;
#[path = "../examples/models/wood.rs"]
mod wood;

fn model(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("models").join(name)
}

fn hold(files: &[(&str, String)]) {
    for (name, text) in files {
        let committed = fs::read_to_string(model(name)).unwrap();
        assert!(committed == *text, "{name} differs: cargo run --example models -- models");
    }
}

#[test]
fn the_cornell_files_are_what_their_program_writes() {
    let files = cornell::files();
    assert_eq!(files.len(), 4);
    hold(&files);
}

#[test]
fn the_elephant_is_what_its_program_writes() {
    hold(&elephant::files());
}

#[test]
fn the_ball_is_what_its_program_writes() {
    hold(&sphere::files());
}

#[test]
fn the_wood_is_what_its_program_paints() {
    let file = fs::File::open(model("wood.png")).unwrap();
    assert!(file.metadata().unwrap().len() < 300_000);
    let mut reader = png::Decoder::new(std::io::BufReader::new(file)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    // Encoders differ from version to version: the pixels count.
    assert!(pixels == wood::pixels(), "wood.png differs: cargo run --example models -- models");
    assert!(!wood::png().unwrap().is_empty());
}

#[test]
fn the_wood_tiles() {
    let pixels = wood::pixels();
    let row = |y: usize| &pixels[y * 512 * 3..][..512 * 3];
    let column = |x: usize| (0..512).flat_map(move |y| [0, 1, 2].map(|i| (y * 512 + x) * 3 + i));
    let difference = |a: &[u8], b: &[u8]| -> u32 {
        a.iter().zip(b).map(|(&a, &b)| u32::from(a.abs_diff(b))).sum()
    };
    let columns = |x: usize| column(x).map(|i| pixels[i]).collect::<Vec<u8>>();
    // Across the seam pixels differ no more than elsewhere; half a picture apart they do.
    let seam = difference(&columns(511), &columns(0));
    assert!(seam < 2 * difference(&columns(300), &columns(301)), "{seam}");
    assert!(seam < difference(&columns(255), &columns(0)) / 4, "{seam}");
    // Above and below is the gap between two rows of boards.
    let light = |row: &[u8]| row.iter().map(|&v| u32::from(v)).sum::<u32>();
    assert!([0, 511].iter().all(|&gap| light(row(gap)) * 3 < light(row(64)) * 2));
}

/// Positions, normals, and triangles by material of a model as it is committed.
struct Read {
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
    groups: Vec<(String, Vec<[usize; 3]>)>,
}

fn read(name: &str) -> Read {
    let mut found = Read { positions: Vec::new(), normals: Vec::new(), groups: Vec::new() };
    for line in fs::read_to_string(model(name)).unwrap().lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let vector = || DVec3::from([1, 2, 3].map(|i| words[i].parse::<f64>().unwrap()));
        match words[0] {
            "v" => found.positions.push(vector()),
            "vn" => found.normals.push(vector()),
            "usemtl" => found.groups.push((words[1].to_string(), Vec::new())),
            "f" => {
                let corner = |i: usize| {
                    let (position, normal) = words[i].split_once("//").unwrap();
                    assert_eq!(position, normal);
                    position.parse::<usize>().unwrap() - 1
                };
                found.groups.last_mut().unwrap().1.push([1, 2, 3].map(corner));
            }
            _ => {}
        }
    }
    found
}

/// Asserts that a model is one closed surface without holes or handles, faces outward, and gives
/// the volume inside.
fn closed(name: &str) -> f64 {
    let Read { positions, normals, groups } = read(name);
    let triangles: Vec<[usize; 3]> = groups.into_iter().flat_map(|(_, group)| group).collect();
    let mut edges = HashSet::new();
    let mut volume = 0.0;
    for &triangle in &triangles {
        let [a, b, c] = triangle.map(|corner| positions[corner]);
        let normal = (b - a).cross(c - a);
        assert!(normal.length() > 0.0, "{name}: a triangle without area at {a}");
        for (i, &corner) in triangle.iter().enumerate() {
            let edge = (corner, triangle[(i + 1) % 3]);
            assert!(edges.insert(edge), "{name}: two triangles go along an edge at {a}");
            assert!((normals[corner].length() - 1.0).abs() < 0.01);
            assert!(normals[corner].dot(normal) > 0.0, "{name}: a normal leans inward at {a}");
        }
        volume += a.dot(b.cross(c)) / 6.0;
    }
    let back = |&(a, b): &(usize, usize)| edges.contains(&(b, a));
    assert!(edges.iter().all(back), "{name}: an edge has one triangle only");
    assert_eq!(positions.len() + triangles.len(), edges.len() / 2 + 2, "{name}: no ball");

    // One piece, and no two pieces that touch in one vertex: each is joined by its edges.
    let mut reached = vec![false; positions.len()];
    let mut next: Vec<Vec<usize>> = vec![Vec::new(); positions.len()];
    edges.iter().for_each(|&(a, b)| next[a].push(b));
    let mut found = vec![0];
    while let Some(vertex) = found.pop() {
        if !std::mem::replace(&mut reached[vertex], true) {
            found.extend(&next[vertex]);
        }
    }
    assert!(reached.iter().all(|&reached| reached), "{name}: more than one piece");
    volume
}

#[test]
fn the_elephant_is_closed_and_stands_on_the_ground() {
    let volume = closed("elephant.obj");
    assert!((3000.0..4000.0).contains(&volume), "{volume} cubic centimetres");
    let elephant = read("elephant.obj");
    let heights = elephant.positions.iter().map(|p| p.y);
    assert_eq!(heights.clone().fold(f64::INFINITY, f64::min), 0.0);
    let top = heights.fold(0.0, f64::max);
    assert!((31.0..33.0).contains(&top), "{top}");
    let names: Vec<&str> = elephant.groups.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["skin", "ivory", "dark"]);
    let count: usize = elephant.groups.iter().map(|(_, group)| group.len()).sum();
    assert!((11_000..=13_000).contains(&count), "{count} triangles");
    assert!(elephant.groups.iter().all(|(_, group)| group.len() > 100));
}

#[test]
fn the_ball_is_closed_and_round() {
    let volume = closed("sphere.obj");
    assert!((volume / (4.0 / 3.0 * std::f64::consts::PI) - 1.0).abs() < 0.002, "{volume}");
    let ball = read("sphere.obj");
    assert!(ball.positions.iter().all(|p| (p.length() - 1.0).abs() < 1e-4));
    assert!(ball.positions.iter().zip(&ball.normals).all(|(p, n)| p.distance(*n) < 2e-4));
    assert_eq!(ball.groups[0].1.len(), 8_000);
}

#[test]
fn every_model_has_its_source_and_terms_in_the_readme() {
    let readme = fs::read_to_string(model("README.md")).unwrap();
    for entry in fs::read_dir(model("")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(name == "README.md" || readme.contains(&format!("`{name}`")), "{name}");
    }
}
