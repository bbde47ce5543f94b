//! How long it takes to check scene text, and to lay it out: `cargo bench --bench language`.
//! The aims: 8 MB checked in under 3 s; a file of 2,000 lines checked again in under 50 ms.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use scn::diag::{FileId, Sources};
use scn::lang::{self, Library};

fn main() {
    divan::main();
}

/// No files beside the one given.
struct Nothing;

impl Library for Nothing {
    fn read(&self, _: &Path) -> Result<String, String> {
        Err("does not exist".to_string())
    }

    fn identity(&self, path: &Path) -> PathBuf {
        path.to_path_buf()
    }
}

/// A scene of at least so many bytes: materials, objects, comments.
fn scene(bytes: usize) -> String {
    let mut text = "scn 1 in cm\n\nintegrator: preview\ncamera: overview\n".to_string();
    let mut i = 0;
    while text.len() < bytes {
        let x = i % 100;
        write!(
            text,
            "\n// Number {i} of the balls, each in a grey of its own, so that one can tell them apart\n\
             // when they lie in a heap and hide each other.\n\
             material m{i}: diffuse {{ albedo: 0.{x:02} }}\n\
             object o{i}: sphere {{\n    center: ({i}, {x}.5, -3)\n    radius: 1.5 cm\n    \
             material: m{i}\n}}\n"
        )
        .expect("a text takes all that is written to it");
        i += 1;
    }
    text
}

/// The same of 2,000 lines.
fn scene_of_2000_lines() -> String {
    let text = scene(100_000);
    let lines: Vec<_> = text.split_inclusive('\n').take(4 + 9 * 222).collect();
    let text = lines.concat();
    assert!(text.ends_with("}\n") && text.lines().count() >= 2000);
    text
}

fn errors(text: &str) -> usize {
    let mut sources = Sources::new();
    let path = Path::new("scene.scn");
    let compiled = lang::compile(path, text, &[], &[], &Nothing, &mut sources);
    assert_eq!(compiled.renders.len(), 1, "{:?}", compiled.diagnostics.first());
    compiled.diagnostics.len()
}

#[divan::bench(sample_count = 3, sample_size = 1)]
fn check_8_mb(bencher: divan::Bencher) {
    let text = scene(7_900_000);
    bencher.bench(|| errors(divan::black_box(&text)));
}

#[divan::bench]
fn check_2000_lines(bencher: divan::Bencher) {
    let text = scene_of_2000_lines();
    bencher.bench(|| errors(divan::black_box(&text)));
}

#[divan::bench(sample_count = 3, sample_size = 1)]
fn format_8_mb(bencher: divan::Bencher) {
    let text = scene(7_900_000);
    bencher.bench(|| lang::format::format(divan::black_box(&text), FileId(0)).map(|t| t.len()));
}

#[divan::bench]
fn format_2000_lines(bencher: divan::Bencher) {
    let text = scene_of_2000_lines();
    bencher.bench(|| lang::format::format(divan::black_box(&text), FileId(0)).map(|t| t.len()));
}
