//! docs/language.md: every example in it compiles.

mod common;

use common::{compile, show};

#[test]
fn every_example_of_the_language_compiles() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/language.md");
    let page = std::fs::read_to_string(path).unwrap();
    let mut examples = 0;
    for block in page.split("```scn\n").skip(1) {
        let text = block.split("```").next().unwrap();
        let (compiled, sources) = compile(text);
        let told: Vec<_> = compiled.diagnostics.iter().map(|told| show(told, &sources)).collect();
        assert!(told.is_empty(), "{text}\n{}", told.join("\n"));
        assert!(!compiled.renders.is_empty(), "{text}");
        examples += 1;
    }
    assert!(examples >= 5);
}
