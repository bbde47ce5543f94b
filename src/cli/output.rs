//! Where pictures go.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use super::log::shown;
use crate::files;

/// What -o says.
#[derive(Debug, PartialEq)]
pub enum Output {
    /// NAME.exr and NAME.png of each render, in this folder.
    Folder(PathBuf),
    /// The light of a single render.
    Exr(PathBuf),
    /// A single render as it is shown.
    Png(PathBuf),
}

/// The files of one render.
#[derive(Debug, PartialEq)]
pub struct Paths {
    /// The light.
    pub exr: Option<PathBuf>,
    /// As it is shown.
    pub png: Option<PathBuf>,
}

impl Output {
    /// From the option, or where pictures of this scene file go without it.
    pub fn new(option: Option<&Path>, scene: &Path) -> Result<Self, String> {
        let Some(path) = option else {
            let stem = scene.file_stem().unwrap_or(OsStr::new("scene"));
            return Ok(Self::Folder(Path::new("out").join(stem)));
        };
        let shown = shown(path);
        if path.as_os_str().is_empty() {
            return Err("-o needs the name of a folder or of a file".to_string());
        }
        let folder = path.as_os_str().to_string_lossy().ends_with(['/', std::path::MAIN_SEPARATOR]);
        if folder || files::whole::is_folder(path) {
            return Ok(Self::Folder(path.to_path_buf()));
        }
        let nameless = [".exr", ".png"]
            .iter()
            .find(|ending| path.file_name().is_some_and(|name| name.eq_ignore_ascii_case(ending)));
        if let Some(ending) = nameless {
            return Err(format!(
                "-o {shown}: a picture needs a name before {ending}, such as `fig01{ending}`"
            ));
        }
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            None => Ok(Self::Folder(path.to_path_buf())),
            Some("exr") => Ok(Self::Exr(path.to_path_buf())),
            Some("png") => Ok(Self::Png(path.to_path_buf())),
            Some(ending) => Err(format!(
                "-o {shown}: pictures are written as .exr or .png, not as .{ending}\n  if it is \
                 the name of a folder, write it as `{shown}/`"
            )),
        }
    }

    /// The files of the render called `name`.
    pub fn paths(&self, name: &str) -> Paths {
        match self {
            Self::Folder(folder) => Paths {
                exr: Some(folder.join(format!("{name}.exr"))),
                png: Some(folder.join(format!("{name}.png"))),
            },
            Self::Exr(path) => Paths { exr: Some(path.clone()), png: None },
            Self::Png(path) => Paths { exr: None, png: Some(path.clone()) },
        }
    }

    /// A file beside the pictures of the render called `name`: in a folder NAME.suffix, else the
    /// picture's name with the suffix in place of its ending.
    pub fn beside(&self, name: &str, suffix: &str) -> PathBuf {
        match self {
            Self::Folder(folder) => folder.join(format!("{name}.{suffix}")),
            Self::Exr(path) | Self::Png(path) => path.with_extension(suffix),
        }
    }

    /// The name of the file if it holds a single render.
    pub fn single(&self) -> Option<&Path> {
        match self {
            Self::Folder(_) => None,
            Self::Exr(path) | Self::Png(path) => Some(path),
        }
    }
}

impl IntoIterator for Paths {
    type Item = PathBuf;
    type IntoIter = std::iter::Flatten<std::array::IntoIter<Option<PathBuf>, 2>>;

    /// Those there are.
    fn into_iter(self) -> Self::IntoIter {
        [self.exr, self.png].into_iter().flatten()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn output(option: &str) -> Result<Output, String> {
        Output::new(Some(Path::new(option)), Path::new("scenes/box.scn"))
    }

    #[test]
    fn the_ending_says_what_is_written() {
        assert_eq!(output("a.EXR"), Ok(Output::Exr("a.EXR".into())));
        assert_eq!(output("x/a.png"), Ok(Output::Png("x/a.png".into())));
        assert_eq!(output("pictures"), Ok(Output::Folder("pictures".into())));
        assert_eq!(output("pictures.v2/"), Ok(Output::Folder("pictures.v2/".into())));
        assert!(output("a.jpg").unwrap_err().contains("not as .jpg"));
        assert!(output("").is_err());
        for nameless in [".exr", "x/.PNG"] {
            assert!(output(nameless).unwrap_err().contains("needs a name before ."), "{nameless}");
        }
        assert_eq!(output(".pictures"), Ok(Output::Folder(".pictures".into())));
    }

    #[test]
    fn without_it_pictures_go_to_a_folder_named_like_the_scene() {
        let output = Output::new(None, Path::new("scenes/box.scn")).unwrap();
        let paths = output.paths("fig01");
        assert_eq!(paths.exr.as_deref(), Some(Path::new("out/box/fig01.exr")));
        assert_eq!(paths.png.as_deref(), Some(Path::new("out/box/fig01.png")));
    }
}
