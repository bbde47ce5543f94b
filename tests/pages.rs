//! The page of every fault: its example shows that fault and no other error, its mend none.
//!
//! A page has a title, a ```scn block with the fault, blocks "```file NAME" for further files,
//! and a ```scn-ok block with the mend. The page of a lint has a ```scn-near block as well: a scene
//! that looks much like the example, in which nothing is found. Blocks "```scn --unbiased" are looked
//! at as if that option was given.

use std::collections::BTreeSet;
use std::path::Path;

use scn::cli;
use scn::diag::{self, CODES, Diagnostic, Level, Sources};
use scn::lang;
use scn::load::Loader;
use scn::math::NoProgress;
use scn::plan;

/// Ends what stands after the backticks of an example for that option.
const UNBIASED: &str = " --unbiased";

/// A fenced block: what stands after the backticks, and its text.
struct Block {
    info: String,
    text: String,
}

fn blocks(page: &str) -> Vec<Block> {
    let mut all = Vec::new();
    let mut open: Option<Block> = None;
    for line in page.lines() {
        match (line.strip_prefix("```"), open.take()) {
            (Some(info), None) => {
                open = Some(Block { info: info.trim().to_string(), text: String::new() });
            }
            (Some(_), Some(block)) => all.push(block),
            (None, Some(mut block)) => {
                block.text.push_str(line);
                block.text.push('\n');
                open = Some(block);
            }
            (None, None) => {}
        }
    }
    assert!(open.is_none(), "a block is not closed");
    all
}

/// Everything that is found wrong with a scene in a folder, as `scn lint` does.
fn faults(folder: &Path, text: &str, unbiased: bool) -> (Vec<Diagnostic>, Sources) {
    let path = folder.join("example.scn");
    std::fs::write(&path, text).unwrap();
    let mut sources = Sources::new();
    let mut found = cli::check(&path, text, &[], &mut sources).found;
    if unbiased {
        let compiled = lang::compile(&path, text, &[], &[], &cli::Disk, &mut sources);
        for render in &compiled.renders {
            let (stage, _) = Loader::new(&NoProgress).stage(&render.scene, &mut sources);
            found.extend(plan::biases(&stage.unwrap()).iter().map(plan::errors::biased));
        }
    }
    (found, sources)
}

/// What is wrong with the page of `code`, in words.
fn wrong_with(code: diag::Code) -> Vec<String> {
    let mut wrong = Vec::new();
    let title = code.page.strip_prefix("# ").and_then(|rest| rest.lines().next()).unwrap_or("");
    if title.len() < 4 {
        wrong.push("has no title".to_string());
    }
    let folder = tempfile::tempdir().unwrap();
    let blocks = blocks(code.page);
    for block in &blocks {
        if let Some(name) = block.info.strip_prefix("file ") {
            let path = folder.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, &block.text).unwrap();
        }
    }
    let is_lint = code.name.starts_with("lint/");
    for (info, what) in [("scn", "example"), ("scn-ok", "mend"), ("scn-near", "near-miss")] {
        if info == "scn-near" && !is_lint {
            continue;
        }
        if blocks.iter().all(|block| block.info.trim_end_matches(UNBIASED) != info) {
            wrong.push(format!("has no {what}"));
        }
    }
    for block in &blocks {
        let unbiased = block.info.ends_with(UNBIASED);
        let info = block.info.trim_end_matches(UNBIASED);
        let (found, sources) = match info {
            "scn" | "scn-ok" | "scn-near" => faults(folder.path(), &block.text, unbiased),
            _ => continue,
        };
        let report = || diag::print::report(&found, &sources, "it", diag::print::Look::PLAIN);
        let errors = || found.iter().filter(|fault| fault.level == Level::Error);
        if info != "scn" {
            if !found.is_empty() {
                let what = if info == "scn-ok" { "mend" } else { "near-miss" };
                wrong.push(format!("has a {what} with faults:\n{}\n{}", block.text, report()));
            }
            continue;
        }
        // The page of a warning shows that warning, and no error.
        let mut shown: BTreeSet<&str> = errors().map(|fault| fault.code.name).collect();
        if shown.is_empty() {
            shown = found.iter().map(|fault| fault.code.name).collect();
        }
        if shown != BTreeSet::from([code.name]) {
            let report = report();
            wrong.push(format!("shows {shown:?} in its example:\n{}\n{report}", block.text));
        }
    }
    wrong
}

#[test]
fn every_page_shows_its_fault_and_how_it_is_mended() {
    let mut all = Vec::new();
    for code in CODES {
        all.extend(wrong_with(*code).into_iter().map(|what| format!("{code}.md {what}")));
    }
    assert!(all.is_empty(), "\n{}\n\n{} faults in pages", all.join("\n"), all.len());
}

#[test]
fn every_page_belongs_to_a_code() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/errors");
    let mut strays = Vec::new();
    for family in std::fs::read_dir(&root).unwrap() {
        let family = family.unwrap().path();
        if !family.is_dir() {
            continue;
        }
        for page in std::fs::read_dir(&family).unwrap() {
            let page = page.unwrap().path().with_extension("");
            let name = page.strip_prefix(&root).unwrap().to_str().unwrap().replace('\\', "/");
            if diag::find(&name).is_none() {
                strays.push(name);
            }
        }
    }
    assert!(strays.is_empty(), "pages without a code: {strays:?}");
    let names: Vec<_> = CODES.iter().map(|code| code.name).collect();
    assert!(names.is_sorted(), "codes are not in the order of their names");
}
