//! The pages of the language's errors: each example is told its own fault and no other, and what
//! the page writes in its place is right. (Pages of other rooms need more than the language.)

mod common;

use std::path::Path;

use common::show;
use scn::diag::{CODES, Sources};
use scn::lang::{self, Library};

/// Files that a page brings along.
struct Files(Vec<(String, String)>);

impl Library for Files {
    fn read(&self, path: &Path) -> Result<String, String> {
        let found = self.0.iter().find(|(name, _)| Path::new(name) == path);
        found.map(|(_, text)| text.clone()).ok_or("does not exist".to_string())
    }
}

/// Fenced blocks: info string and text.
fn blocks(page: &str) -> Vec<(String, String)> {
    let mut found: Vec<(String, String)> = Vec::new();
    let mut open = false;
    for line in page.lines() {
        match line.strip_prefix("```") {
            Some(info) => {
                open = !open;
                if open {
                    found.push((info.to_string(), String::new()));
                }
            }
            None if open => {
                let text = &mut found.last_mut().unwrap().1;
                text.push_str(line);
                text.push('\n');
            }
            None => {}
        }
    }
    found
}

#[test]
fn every_page_shows_its_own_fault_and_a_right_text() {
    let ours = ["syntax/", "name/", "type/", "render/", "import/"];
    let mut report = String::new();
    let mut pages = 0;
    for code in CODES.iter().filter(|code| ours.iter().any(|family| code.name.starts_with(family)))
    {
        pages += 1;
        let blocks = blocks(code.page);
        let files = Files(
            blocks
                .iter()
                .filter_map(|(info, text)| Some((info.strip_prefix("file ")?.into(), text.clone())))
                .collect(),
        );
        for (info, text) in &blocks {
            if info.starts_with("file ") {
                continue;
            }
            let mut sources = Sources::new();
            let compiled = lang::compile(Path::new("scene.scn"), text, &[], &files, &mut sources);
            let told: Vec<_> = compiled.diagnostics.iter().map(|told| told.code.name).collect();
            let right = match info.as_str() {
                "scn" => !told.is_empty() && told.iter().all(|name| *name == code.name),
                _ => told.is_empty(),
            };
            if !right {
                let shown: Vec<_> =
                    compiled.diagnostics.iter().map(|told| show(told, &sources)).collect();
                report.push_str(&format!(
                    "{} ```{info}: {told:?}\n{}\n",
                    code.name,
                    shown.join("\n")
                ));
            }
        }
        assert!(blocks.iter().filter(|(info, _)| info == "scn").count() > 0, "{}", code.name);
        assert!(blocks.iter().filter(|(info, _)| info == "scn-ok").count() > 0, "{}", code.name);
    }
    assert!(pages > 50);
    assert!(report.is_empty(), "\n{report}");
}
