//! The Cornell models that are committed are those that the program in examples/models writes.

use std::path::Path;

#[path = "../examples/models/cornell.rs"]
mod cornell;
#[path = "../examples/models/obj.rs"]
mod obj;

#[test]
fn the_cornell_files_are_what_their_program_writes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("models");
    let files = cornell::files();
    assert_eq!(files.len(), 4);
    for (name, text) in files {
        let committed = std::fs::read_to_string(folder.join(name)).unwrap();
        assert!(committed == text, "{name} differs: cargo run --example models -- models");
    }
}

#[test]
fn every_model_has_its_source_and_terms_in_the_readme() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("models");
    let readme = std::fs::read_to_string(folder.join("README.md")).unwrap();
    for entry in std::fs::read_dir(folder).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(name == "README.md" || readme.contains(&format!("`{name}`")), "{name}");
    }
}
