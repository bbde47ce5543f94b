//! The command line: the only room that prints, reads clocks, or chooses an exit code.
//!
//! What was asked for (pictures' names, the log, lists) goes to stdout; what is said beside it
//! (faults, progress) to stderr.

mod options;
mod elsewhere;
mod terminal;
mod stop;
mod words;
mod whose;
mod bar;
mod clock;
mod limits;
mod log;
mod shard;
mod about;
mod replay;
mod asked;
mod kept;
mod output;
mod bias;
mod picture;
mod finish;
mod checkpoint;
mod scene_file;
mod check;
mod render;
mod merge;
mod plan;
mod paths;
mod lint;
mod diff;
mod fmt;
mod compare;
mod explain;
mod list;
mod new;
mod manual;

use std::process::ExitCode;

use clap::Parser;

pub use check::{Checked, check};
pub use scene_file::Disk;

/// How a command ended. What went wrong has been told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    /// It did what was asked.
    Well,
    /// The scene, or a file it names, has errors.
    SceneErrors,
    /// A condition it was asked to look for holds.
    Held,
    /// It could not do its work: options, the scene file itself, the disk.
    NotDone,
    /// It was asked to stop.
    Interrupted,
}

/// Tells why a command cannot do its work.
fn failed(text: &str) -> End {
    terminal::fail(text);
    End::NotDone
}

impl From<End> for ExitCode {
    fn from(end: End) -> Self {
        Self::from(match end {
            End::Well => 0,
            End::SceneErrors | End::Held => 1,
            End::NotDone => 2,
            End::Interrupted => stop::INTERRUPTED,
        })
    }
}

/// Runs the command the arguments ask for.
pub fn main() -> ExitCode {
    let options = match options::Options::try_parse() {
        Ok(options) => options,
        Err(message) => {
            let message = elsewhere::offered(message);
            // Help and version are no faults; clap sends them to stdout.
            let printed = message.print();
            if message.use_stderr() {
                return End::NotDone.into();
            }
            terminal::note(printed);
            return said(End::Well).into();
        }
    };
    let end = match options.command {
        options::Command::Render(options) => render::run(&options),
        options::Command::Plan(options) => plan::run(&options),
        options::Command::Paths(options) => paths::run(&options),
        options::Command::Lint(options) => lint::run(&options),
        options::Command::Fmt(options) => fmt::run(&options),
        options::Command::Merge(options) => merge::run(&options),
        options::Command::Compare(options) => compare::run(&options),
        options::Command::Explain(options) => explain::run(&options),
        options::Command::List(options) => list::run(&options),
        options::Command::New(options) => new::run(&options),
        options::Command::Completions(options) => manual::completions(&options),
        options::Command::Man(options) => manual::page(&options),
    };
    said(end).into()
}

/// What was asked for goes to stdout: if it did not get there, the work is not done, whatever was
/// found.
fn said(end: End) -> End {
    match terminal::lost() {
        Some(why) if matches!(end, End::Well | End::SceneErrors | End::Held) => {
            terminal::fail(&format!("the output could not be written: {why}"));
            End::NotDone
        }
        _ => end,
    }
}
