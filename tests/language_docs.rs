//! The pages in docs/: every example of a scene compiles.

mod common;

use std::fs;
use std::path::Path;

use common::{compile, show};

#[test]
fn every_example_of_the_pages_compiles() {
    let mut examples = 0;
    for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "md") {
            continue;
        }
        let page = fs::read_to_string(&path).unwrap();
        for block in page.split("```scn\n").skip(1) {
            let text = block.split("```").next().unwrap();
            let (compiled, sources) = compile(text);
            let told: Vec<_> =
                compiled.diagnostics.iter().map(|told| show(told, &sources)).collect();
            assert!(told.is_empty(), "{}:\n{text}\n{}", path.display(), told.join("\n"));
            assert!(!compiled.renders.is_empty(), "{}:\n{text}", path.display());
            examples += 1;
        }
    }
    assert!(examples >= 6);
}
