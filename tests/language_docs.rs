//! The pages in docs/: every example of a scene compiles, and is in the style.

mod common;

use std::fs;
use std::path::Path;

use common::{compile, show};

#[test]
fn every_example_of_the_pages_compiles_and_is_in_the_style() {
    let mut examples = 0;
    for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "md") {
            continue;
        }
        let page = fs::read_to_string(&path).unwrap();
        for block in page.split("```scn\n").skip(1) {
            let text = block.split("```").next().unwrap();
            let (compiled, mut sources) = compile(text);
            let told: Vec<_> =
                compiled.diagnostics.iter().map(|told| show(told, &sources)).collect();
            assert!(told.is_empty(), "{}:\n{text}\n{}", path.display(), told.join("\n"));
            assert!(!compiled.renders.is_empty(), "{}:\n{text}", path.display());
            let id = sources.add("scene.scn", text);
            let styled = scn::lang::format::format(text, id).expect("no faults of syntax");
            assert_eq!(styled, text, "{}: `scn fmt` would change it", path.display());
            examples += 1;
        }
    }
    assert!(examples >= 6);
}
