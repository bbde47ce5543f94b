//! What tests of the language share: files for it, and its reports as plain text.
#![allow(dead_code)]

use std::fmt::Write;
use std::path::{Path, PathBuf};

use scn::diag::{Diagnostic, Sources};
use scn::lang::{self, Compiled, Library};

/// No files but the one given.
pub struct Nothing;

impl Library for Nothing {
    fn read(&self, _: &Path) -> Result<String, String> {
        Err("does not exist".to_string())
    }

    fn identity(&self, path: &Path) -> PathBuf {
        path.to_path_buf()
    }
}

/// A text alone, as if in the file `scene.scn`.
pub fn compile(text: &str) -> (Compiled, Sources) {
    let mut sources = Sources::new();
    let compiled = lang::compile(Path::new("scene.scn"), text, &[], &[], &Nothing, &mut sources);
    (compiled, sources)
}

/// A report without ornaments.
pub fn show(told: &Diagnostic, sources: &Sources) -> String {
    let mut text = format!("{} [{}]\n", told.headline, told.code);
    for label in &told.labels {
        let (line, column) = sources.line_column(label.span);
        let source = sources.get(label.span.file);
        let content = source.text.lines().nth(line - source.first_line).unwrap_or("");
        writeln!(text, "  {}:{line}:{column}: {content}", source.name).unwrap();
        let width = sources.text(label.span).lines().next().unwrap_or("").chars().count().max(1);
        let indent = format!("  {}:{line}:{column}: ", source.name).len() + column - 1;
        writeln!(text, "{}{} {}", " ".repeat(indent), "^".repeat(width), label.text).unwrap();
    }
    if let Some(why) = &told.why {
        writeln!(text, "  why: {why}").unwrap();
    }
    if let Some(help) = &told.help {
        writeln!(text, "  help: {help}").unwrap();
    }
    for mend in &told.mends {
        writeln!(text, "  mend: {}", mend.title).unwrap();
    }
    text
}
