//! What can be asked of `scn lint`, by clap.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

/// Check scene files, and the files they name, without rendering
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  scn lint my.scn
  scn lint scenes/*.scn --deny warnings          for a gate: every warning counts
  scn lint my.scn --ignore mesh --ignore unused-let
  scn lint my.scn --diff                         what --fix would change
  scn lint - < my.scn                            what comes by stdin
  scn lint --list                                all rules

CODE is a code as a report shows it (`mesh/not-rendered`), the beginning of one (`mesh`), or a rule
without its `lint/` (`unused-let`); `warnings` are all of them. Errors are always told.

A comment `// lint: allow(unused-let) because \"…\"` at the end of a line, or above an item, keeps what
was meant. docs/lint.md tells more.

Exit status: 0 nothing that counts; 1 errors, or warnings that --deny makes count; 2 it could not do
its work.")]
pub struct Lint {
    /// The scene files; `-` for stdin, whose files are looked for in this folder
    #[arg(value_name = "FILE", required_unless_present = "list")]
    pub files: Vec<PathBuf>,
    /// How faults are written to stdout: for people, one line each, as one JSON object, as a SARIF
    /// log, or as annotations of GitHub
    #[arg(long, value_name = "FORM", default_value = "human")]
    pub format: Form,
    /// Tell these warnings alone; may be given more than once, or with commas
    #[arg(long, value_name = "CODE", value_delimiter = ',')]
    pub select: Vec<String>,
    /// Do not tell these warnings
    #[arg(long, value_name = "CODE", value_delimiter = ',')]
    pub ignore: Vec<String>,
    /// Let these warnings count as errors do
    #[arg(long, value_name = "CODE", value_delimiter = ',')]
    pub deny: Vec<String>,
    /// Apply mends that keep what was meant to the files given; tell what remains
    #[arg(long)]
    pub fix: bool,
    /// Show what --fix would change, and change nothing, with --fix or without
    #[arg(long, conflicts_with = "format")]
    pub diff: bool,
    /// Check the scene as changed so; may be given more than once
    #[arg(long, value_name = "path=value", conflicts_with_all = ["fix", "diff"])]
    pub set: Vec<String>,
    /// Show all rules, each with what it finds
    #[arg(long, conflicts_with = "files")]
    pub list: bool,
}

/// Who reads what is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Form {
    Human,
    Short,
    Json,
    Sarif,
    Github,
}
