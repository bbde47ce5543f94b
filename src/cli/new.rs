//! `scn new`: a small scene to begin with.

use std::path::PathBuf;

use super::options::New;
use super::{End, terminal};
use crate::diag::harmless_text;
use crate::files;

/// The scene.
const SCENE: &str = include_str!("new.scn");

pub fn run(options: &New) -> End {
    let mut path = options.name.clone().unwrap_or_else(|| PathBuf::from("scene"));
    if path.extension().is_none_or(|ending| ending != "scn") {
        let mut longer = path.into_os_string();
        longer.push(".scn");
        path = PathBuf::from(longer);
    }
    let shown = path.display();
    match files::whole::create(&path, SCENE.as_bytes()) {
        Ok(()) => {
            let text = format!("wrote {shown}; its pictures: scn render {shown}\n");
            terminal::say(&harmless_text(&text));
            End::Well
        }
        Err(failure) => {
            terminal::fail(&format!("the scene file `{shown}` {failure}"));
            End::NotDone
        }
    }
}
