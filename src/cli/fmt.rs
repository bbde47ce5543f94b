//! `scn fmt`: scene files in the one style there is.

use std::path::Path;

use super::log::shown;
use super::options::Fmt;
use super::{End, diff, scene_file, terminal};
use crate::diag::{self, Sources};
use crate::{files, lang};

pub fn run(options: &Fmt) -> End {
    let streams = |path: &Path| path.as_os_str() == scene_file::STREAMS;
    if options.files.len() > 1 && options.files.iter().any(|path| streams(path)) {
        terminal::fail("`-` stands for stdin and stdout, and takes no files beside it");
        return End::NotDone;
    }
    let mut worst = End::Well;
    for path in &options.files {
        let end = match streams(path) {
            true => stream(options),
            false => file(path, options),
        };
        worst = worse(worst, end);
    }
    worst
}

/// What is not done counts most, then what is wrong with a file.
fn worse(a: End, b: End) -> End {
    let rank = |end: &End| match end {
        End::Well => 0,
        End::Held => 1,
        End::SceneErrors => 2,
        End::NotDone | End::Interrupted => 3,
    };
    if rank(&b) > rank(&a) { b } else { a }
}

fn file(path: &Path, options: &Fmt) -> End {
    let raw = match files::text::read_raw(path) {
        Ok(raw) => raw,
        Err(failure) => {
            terminal::fail(&scene_file::unread(path, &failure));
            return End::NotDone;
        }
    };
    let Some(text) = formatted(path, files::text::without_mark(&raw)) else {
        return End::SceneErrors;
    };
    if text == raw {
        return End::Well;
    }
    if options.check || options.diff {
        return compared(path, &raw, &text, options);
    }
    match files::whole::replace(path, text.as_bytes()) {
        Ok(()) => {
            terminal::say(&format!("formatted {}\n", shown(path)));
            End::Well
        }
        Err(failure) => {
            terminal::fail(&format!("the scene file `{}` {failure}", shown(path)));
            End::NotDone
        }
    }
}

/// From stdin to stdout.
fn stream(options: &Fmt) -> End {
    let path = Path::new("stdin");
    let raw = match scene_file::from_stdin() {
        Ok(raw) => raw,
        Err(failure) => {
            terminal::fail(&format!("the text on stdin {failure}"));
            return End::NotDone;
        }
    };
    let Some(text) = formatted(path, files::text::without_mark(&raw)) else {
        return End::SceneErrors;
    };
    if !options.check && !options.diff {
        terminal::say(&text);
        return End::Well;
    }
    if text == raw { End::Well } else { compared(path, &raw, &text, options) }
}

/// The text in the style; None if it has faults, which have been told.
fn formatted(path: &Path, text: &str) -> Option<String> {
    let mut sources = Sources::new();
    let id = sources.add_file(path, text);
    match lang::format::format(text, id) {
        Ok(text) => Some(text),
        Err(faults) => {
            let faults = diag::in_order(faults, &sources);
            let look = terminal::stderr_look();
            let subject = format!("{}, which stays as it is", shown(path));
            terminal::tell(&diag::print::report(&faults, &sources, &subject, look));
            None
        }
    }
}

/// Shows what would change, or only where.
fn compared(path: &Path, old: &str, new: &str, options: &Fmt) -> End {
    terminal::say(&match options.diff {
        true => diff::unified(path, old, new),
        false => format!("{}\n", shown(path)),
    });
    if options.check { End::Held } else { End::Well }
}
