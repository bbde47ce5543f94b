//! `scn new`: a small scene to begin with.

use std::path::{MAIN_SEPARATOR, PathBuf};

use super::log::shown;
use super::options::New;
use super::words::typed;
use super::{End, terminal};
use crate::diag::harmless_text;
use crate::files;

/// The scene.
const SCENE: &str = include_str!("new.scn");
/// The page for beginners, in the project's folder.
const TOUR: &str = "docs/tour.md";

pub fn run(options: &New) -> End {
    let mut path = options.name.clone().unwrap_or_else(|| PathBuf::from("scene"));
    let named = path.file_name().is_some_and(|name| name != ".scn");
    if !named || path.as_os_str().to_string_lossy().ends_with(['/', '.', MAIN_SEPARATOR]) {
        let why = "names no file\n  write a name such as `scene` or `figures/scene`";
        terminal::fail(&format!("`{}` {why}", shown(&path)));
        return End::NotDone;
    }
    if path.extension().is_none_or(|ending| ending != "scn") {
        let mut longer = path.into_os_string();
        longer.push(".scn");
        path = PathBuf::from(longer);
    }
    let shown = shown(&path);
    match files::whole::create(&path, SCENE.as_bytes()) {
        Ok(()) => {
            let text = format!(
                "wrote {shown}\n  its pictures    scn render {}\n  all words       scn list\n  \
                 the first hour  {TOUR}\n",
                typed(&path)
            );
            terminal::say(&harmless_text(&text));
            End::Well
        }
        Err(failure) => {
            terminal::fail(&format!("the scene file `{shown}` {failure}"));
            End::NotDone
        }
    }
}
