//! A picture read from a file, with what the file says of it.

use std::path::{Path, PathBuf};

use super::Refusal;
use crate::cli::words::NAMES;
use crate::diag::words::few;
use crate::files::{self, Metadata};
use crate::math::Picture;
use crate::measure::{Pair, Unpaired};

/// Names longer than this, in characters, lose their beginning in tables.
const LONGEST_NAME: usize = 32;

/// One of the pictures compared.
pub struct Input {
    pub path: PathBuf,
    /// What it is called in reports.
    pub name: String,
    pub picture: Picture,
    /// Whether its pixels are radiance of any range (EXR), not what a display shows (PNG).
    pub radiance: bool,
    pub words: Metadata,
    /// What layers its file has.
    pub layers: Vec<String>,
    /// Where the picture lies in its film, if it is a part of one.
    part: Option<Part>,
}

/// A crop: the film's size, and the column and row where the picture begins.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Part {
    film: [usize; 2],
    origin: [usize; 2],
}

impl Input {
    /// Reads an EXR or a PNG; of an EXR the layer of this name, or all light.
    pub fn read(path: &Path, layer: Option<&str>) -> Result<Self, Refusal> {
        let shown = shown(path);
        let refuse = |failure: files::Failure| format!("`{shown}` {failure}");
        let of = |picture, radiance, words| Self {
            path: path.to_path_buf(),
            name: String::new(),
            picture,
            radiance,
            words,
            layers: Vec::new(),
            part: None,
        };
        if has_ending(path, "exr") {
            let (all, words) = files::exr::read(path).map_err(refuse)?;
            let part = Part { film: all.film, origin: all.origin };
            let whole = part.film == [all.main.width, all.main.height];
            let layers: Vec<String> = all.named.iter().map(|(name, _)| name.clone()).collect();
            let picture = match layer {
                None => all.main,
                Some(layer) => {
                    let found = all.named.into_iter().find(|(name, _)| name == layer);
                    found
                        .map(|(_, picture)| picture)
                        .ok_or_else(|| no_layer(&shown, layer, &layers))?
                }
            };
            let part = (!whole).then_some(part);
            Ok(Self { layers, part, ..of(picture, true, words) })
        } else if has_ending(path, "png") {
            if layer.is_some() {
                return Err(format!("`{shown}` is a PNG, which has no layers: --layer takes EXR"));
            }
            let (picture, words) = files::png::read(path).map_err(refuse)?;
            Ok(of(picture, false, words))
        } else {
            Err(format!("`{shown}` ends neither in .exr nor in .png, the pictures that are read"))
        }
    }

    /// What its file says under a key.
    pub fn word(&self, key: &str) -> Option<&str> {
        self.words.iter().find(|(k, _)| k == key).map(|(_, value)| value.as_str())
    }

    /// The ε of the error that its file states: above 0, in squared units of the picture.
    pub fn epsilon(&self) -> Option<f64> {
        let stated = self.word("scn:error_epsilon")?.parse().ok();
        stated.filter(|epsilon: &f64| epsilon.is_finite() && *epsilon > 0.0)
    }

    /// This picture and its reference, if they can be compared.
    pub fn pair<'a>(&'a self, reference: &'a Self) -> Result<Pair<'a>, Refusal> {
        let (a, b) = (self.described(), reference.described());
        let pair = Pair::new(&self.picture, &reference.picture).map_err(|why| match why {
            Unpaired::Sizes(..) => {
                format!("pictures of different sizes cannot be compared: {a}, and {b}")
            }
            Unpaired::Empty => format!("{a}: there is nothing to compare"),
            Unpaired::NotFinite { reference: of_reference, count, first: [x, y] } => {
                let name = if of_reference { &reference.name } else { &self.name };
                let pixels = if count == 1 { "1 pixel".into() } else { format!("{count} pixels") };
                format!(
                    "`{name}` has {pixels} with a component that is infinite or not a number, the \
                     first in column {x}, row {y}; leaving them out would hide an error"
                )
            }
        })?;
        match (self.part, reference.part) {
            (Some(one), Some(other)) if one != other => {
                Err(format!("these are different parts of the film: {a}, and {b}"))
            }
            _ => Ok(pair),
        }
    }

    /// Its name with its size, and its place if it is a part.
    fn described(&self) -> String {
        let size =
            format!("`{}` has {} × {} pixels", self.name, self.picture.width, self.picture.height);
        match self.part {
            None => size,
            Some(Part { film: [width, height], origin: [x, y] }) => {
                format!("{size} from ({x}, {y}) of a film of {width} × {height}")
            }
        }
    }
}

/// A layer that a file does not have.
fn no_layer(shown: &str, layer: &str, layers: &[String]) -> Refusal {
    let names: Vec<&str> = layers.iter().map(String::as_str).collect();
    let has = match names.as_slice() {
        [] => "it has none".to_string(),
        names => format!("it has {}", few(names.iter().copied(), NAMES)),
    };
    let layer = super::remarks::harmless(layer);
    format!("`{shown}` has no layer `{layer}`\n  {}", super::remarks::harmless(&has))
}

/// Names each by its file, or by its whole path where files of several folders are called alike.
pub fn name(inputs: &mut [Input]) {
    let file = |input: &Input| {
        input.path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
    };
    let files: Vec<String> = inputs.iter().map(file).collect();
    for (i, input) in inputs.iter_mut().enumerate() {
        let alike = files.iter().filter(|name| **name == files[i]).count() > 1;
        let name = if alike { input.path.to_string_lossy() } else { files[i].as_str().into() };
        input.name = shortened(&super::remarks::harmless(&name));
    }
}

/// A path as it is told.
pub fn shown(path: &Path) -> String {
    super::remarks::harmless(&path.to_string_lossy())
}

/// The end of a long name.
fn shortened(name: &str) -> String {
    let length = name.chars().count();
    if length <= LONGEST_NAME {
        return name.to_string();
    }
    let end: String = name.chars().skip(length - LONGEST_NAME + 1).collect();
    format!("…{end}")
}

/// Whether a path ends in this extension, in letters of either case.
pub fn has_ending(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(ending))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_names_keep_their_end() {
        assert_eq!(shortened("a.exr"), "a.exr");
        let long = format!("{}/fig05.exr", "deep".repeat(20));
        assert_eq!(shortened(&long).chars().count(), LONGEST_NAME);
        assert!(shortened(&long).starts_with('…') && shortened(&long).ends_with("/fig05.exr"));
    }

    #[test]
    fn endings_of_either_case() {
        assert!(has_ending(Path::new("a/B.EXR"), "exr"));
        assert!(!has_ending(Path::new("exr"), "exr"));
        assert!(!has_ending(Path::new("a.exr.png"), "exr"));
    }
}
