//! The pages in docs/: every example of a scene compiles, and is in the style; every link leads
//! somewhere.

mod common;

use std::fs;
use std::path::{Path, PathBuf};

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

/// The links of a page to files of the project, outside of blocks of text: file and anchor.
fn links(page: &str) -> Vec<(String, Option<String>)> {
    let prose: String = page.split("\n```").step_by(2).collect();
    let targets = prose.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let ours = targets.filter(|target| !target.contains("://"));
    let parts = ours.map(|target| match target.split_once('#') {
        Some((file, anchor)) => (file.to_string(), Some(anchor.to_string())),
        None => (target.to_string(), None),
    });
    parts.collect()
}

/// What a heading is called in a link.
fn anchor(heading: &str) -> String {
    let text = heading.trim_start_matches('#').trim().to_lowercase();
    let kept = text.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[test]
fn every_link_of_the_pages_leads_somewhere() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut pages: Vec<PathBuf> =
        fs::read_dir(root.join("docs")).unwrap().map(|entry| entry.unwrap().path()).collect();
    pages.retain(|path| path.extension().is_some_and(|ending| ending == "md"));
    pages.extend([root.join("README.md"), root.join("models/README.md")]);
    let mut followed = 0;
    for page in &pages {
        for (file, wanted) in links(&fs::read_to_string(page).unwrap()) {
            let target = match &*file {
                "" => page.clone(),
                file => page.parent().unwrap().join(file),
            };
            assert!(target.exists(), "{}: there is no {file}", page.display());
            if let Some(wanted) = wanted {
                let text = fs::read_to_string(&target).unwrap();
                let mut headings = text.lines().filter(|line| line.starts_with('#'));
                let found = headings.any(|heading| anchor(heading) == wanted);
                assert!(found, "{}: no heading #{wanted} in {file}", page.display());
            }
            followed += 1;
        }
    }
    assert!(followed > 100, "{followed}");
}
