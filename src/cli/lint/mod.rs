//! `scn lint`: everything that can be found wrong, or doubtful, without rendering.

mod fix;
mod options;

use crate::diag::near;
use crate::diag::words::did_you_mean;
use std::path::Path;

use super::log::shown;
use super::{End, check, diff, scene_file, terminal};
use crate::diag::words::grouped;
use crate::diag::{self, CODES, Diagnostic, Sources};
use crate::files;
use crate::lint::{Selection, fixed};

use options::Form;
pub use options::Lint;

pub fn run(options: &Lint) -> End {
    if options.list {
        terminal::say(&list());
        return End::Well;
    }
    let selection = Selection {
        select: options.select.clone(),
        ignore: options.ignore.clone(),
        deny: options.deny.clone(),
    };
    if let [unknown, ..] = selection.unknown()[..] {
        terminal::fail(&no_such_code(unknown));
        return End::NotDone;
    }
    let stdin = options.files.iter().filter(|file| file.as_os_str() == scene_file::STREAMS).count();
    if stdin > 1 || stdin == 1 && options.fix && !options.diff {
        terminal::fail(match stdin {
            1 => "stdin is read, not written: `--diff` shows what `--fix` would change",
            _ => "`-` stands for stdin, and can be read once only",
        });
        return End::NotDone;
    }
    let mut sources = Sources::new();
    let mut all = Vec::new();
    let mut done = true;
    for file in &options.files {
        match one(file, options, &selection, &mut sources) {
            Some(found) => all.extend(found),
            None => done = false,
        }
    }
    let counts = all.iter().any(|diagnostic| selection.denies(diagnostic));
    tell(all, options, &sources);
    match (done, counts) {
        (false, _) => End::NotDone,
        (true, false) => End::Well,
        (true, true) => End::SceneErrors,
    }
}

/// What is told of a file. None if the tool could not do what it was asked to.
fn one(
    file: &Path,
    options: &Lint,
    selection: &Selection,
    sources: &mut Sources,
) -> Option<Vec<Diagnostic>> {
    let stdin = file.as_os_str() == scene_file::STREAMS;
    let file = if stdin { Path::new("stdin") } else { file };
    let mut text = match stdin {
        true => scene_file::from_stdin()
            .map(|text| files::text::without_mark(&text).to_string())
            .map_err(|failure| terminal::fail(&scene_file::unread(file, &failure)))
            .ok()?,
        false => scene_file::read(file)?,
    };
    if options.fix || options.diff {
        let mended = fix::mended(file, &text, selection)?;
        if options.diff {
            terminal::say(&diff::unified(file, &text, &mended.text));
        } else if mended.mends.is_empty() {
            terminal::tell(&format!("{}: nothing that --fix mends\n", shown(file)));
        } else {
            fix::write(file, &text, &mended)?;
            text = mended.text;
        }
    }
    let checked = check::check(file, &text, &options.set, sources);
    let found: Vec<Diagnostic> =
        checked.found.into_iter().filter(|diagnostic| selection.tells(diagnostic)).collect();
    if options.format == Form::Human && !options.diff {
        let look = terminal::stdout_look();
        terminal::say(&diag::print::report(&found, sources, &shown(file), look));
        if let Some(fixed) = fixed(&text, checked.main, &found) {
            let count = grouped(fixed.mends.len() as u64);
            terminal::say(&format!("{count} of these can be mended by --fix\n"));
        }
    }
    Some(found)
}

/// What machines read is one report of all files.
fn tell(all: Vec<Diagnostic>, options: &Lint, sources: &Sources) {
    if options.format == Form::Human {
        return;
    }
    let all = diag::in_order(all, sources);
    let tool = (env!("CARGO_PKG_NAME"), env!("CARGO_PKG_VERSION"));
    terminal::say(&match options.format {
        Form::Human => return,
        Form::Short => diag::short::lines(&all, sources),
        Form::Github => diag::short::github(&all, sources),
        Form::Json => format!("{:#}\n", diag::json::report(&all, sources)),
        Form::Sarif => format!("{:#}\n", diag::sarif::report(&all, sources, tool)),
    });
}

/// All rules, each with what it finds.
pub fn list() -> String {
    let lints: Vec<_> = CODES.iter().filter(|code| code.name.starts_with("lint/")).collect();
    let width = lints.iter().map(|code| code.name.len()).max().unwrap_or(0);
    let mut text = String::from("Rules of the linter. `scn explain CODE` tells more of one.\n\n");
    for code in lints {
        text.push_str(&format!("  {:width$}  {}\n", code.name, code.title()));
    }
    text
}

fn no_such_code(name: &str) -> String {
    let rules = CODES.iter().filter_map(|code| code.name.strip_prefix("lint/"));
    let hint = match near(name, CODES.iter().map(|code| code.name).chain(rules)).as_slice() {
        [] => "`scn lint --list` shows the rules, `scn explain` all codes".to_string(),
        words => did_you_mean(words.iter().copied()),
    };
    format!("no code is `{name}`, or begins so; {hint}")
}
