//! `scn lint --fix` and `--diff`: safe mends in the files given.

use std::path::Path;

use crate::cli::log::shown;
use crate::cli::{check, terminal};
use crate::diag::words::counted;
use crate::diag::{Level, Sources};
use crate::files;
use crate::lint::{Mended, Selection, fixed};

/// A mend may bring to light what can be mended then; more rounds than this do not help.
const ROUNDS: usize = 10;

/// What is mended in a file.
pub struct All {
    /// Its text then.
    pub text: String,
    /// What was mended, in the order it was.
    pub mends: Vec<Mended>,
    /// How many of them are of what could not be told before others were made.
    pub late: usize,
}

/// The text with all safe mends of what is told in it. None if mending would bring errors, which
/// was told then.
pub fn mended(file: &Path, text: &str, selection: &Selection) -> Option<All> {
    let mut all = All { text: text.to_string(), mends: Vec::new(), late: 0 };
    let mut errors: Option<usize> = None;
    for _ in 0..=ROUNDS {
        let checked = check::check(file, &all.text, &[], &mut Sources::new());
        let count = checked.found.iter().filter(|it| it.level == Level::Error).count();
        if errors.is_some_and(|before| count > before) {
            let name = shown(file);
            terminal::fail(&format!("mending `{name}` would bring errors; it was left as it is"));
            return None;
        }
        errors = Some(count);
        let told: Vec<_> = checked.found.into_iter().filter(|it| selection.tells(it)).collect();
        let Some(round) = fixed(&all.text, checked.main, &told) else { break };
        all.text = round.text;
        if !all.mends.is_empty() {
            all.late += round.mends.len();
        }
        all.mends.extend(round.mends);
    }
    Some(all)
}

/// Writes a mended text in the place of the one that was read. None if that could not be done,
/// which was told then.
pub fn write(file: &Path, before: &str, mended: &All) -> Option<()> {
    if let Err(failure) = files::text::replace(file, before, &mended.text) {
        terminal::fail(&format!("the scene file `{}` {failure}", shown(file)));
        return None;
    }
    let name = shown(file);
    let mut text = format!("{name}: {}", counted(mended.mends.len() as u64, "mend"));
    if mended.late > 0 {
        text.push_str(&format!(", {} of what the others brought to light", mended.late));
    }
    text.push('\n');
    for Mended { line, title } in &mended.mends {
        text.push_str(&format!("  {name}:{line}: {}\n", crate::diag::harmless_line(title)));
    }
    terminal::tell(&text);
    Some(())
}
