//! The texts that spans point into.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{FileId, Span};

/// One text: a scene file, or the lines of a mesh file around a fault.
#[derive(Clone, Debug)]
pub struct Source {
    /// The name a person knows it by: the path as given, or `--set` for an argument.
    pub name: Arc<str>,
    /// Where it lies, whose bytes the name may have lost; None if it is no file.
    pub path: Option<PathBuf>,
    /// The text, or the part of it that is kept.
    pub text: Arc<str>,
    /// Line number of the first line of `text`, counted from 1; above 1 for an excerpt.
    pub first_line: usize,
}

/// All texts of a run, by [`FileId`].
#[derive(Clone, Debug, Default)]
pub struct Sources {
    all: Vec<Source>,
}

impl Sources {
    /// No text yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a whole text.
    pub fn add(&mut self, name: impl Into<Arc<str>>, text: impl Into<Arc<str>>) -> FileId {
        self.add_excerpt(name, text, 1)
    }

    /// Adds part of a text too large to keep whole, beginning at line `first_line` of it.
    pub fn add_excerpt(
        &mut self,
        name: impl Into<Arc<str>>,
        text: impl Into<Arc<str>>,
        first_line: usize,
    ) -> FileId {
        let id = FileId(self.all.len() as u32);
        let name = name.into();
        let path = Some(PathBuf::from(&*name));
        self.all.push(Source { name, path, text: text.into(), first_line });
        id
    }

    /// Adds the text of a file.
    pub fn add_file(&mut self, path: &Path, text: impl Into<Arc<str>>) -> FileId {
        let id = self.add(path.to_string_lossy(), text);
        self.all[id.0 as usize].path = Some(path.to_path_buf());
        id
    }

    /// Adds a text that is no file, such as an argument.
    pub fn add_argument(&mut self, name: impl Into<Arc<str>>, text: impl Into<Arc<str>>) -> FileId {
        let id = self.add(name, text);
        self.all[id.0 as usize].path = None;
        id
    }

    /// The text of that number.
    pub fn get(&self, file: FileId) -> &Source {
        &self.all[file.0 as usize]
    }

    /// All texts, in the order they were added.
    pub fn iter(&self) -> impl Iterator<Item = &Source> {
        self.all.iter()
    }

    /// The words a span covers.
    pub fn text(&self, span: Span) -> &str {
        &self.get(span.file).text[span.range()]
    }

    /// Line and column of a span's beginning, both counted from 1, the column in characters.
    pub fn line_column(&self, span: Span) -> (usize, usize) {
        let source = self.get(span.file);
        let mut at = (span.start as usize).min(source.text.len());
        while !source.text.is_char_boundary(at) {
            at -= 1;
        }
        let before = &source.text[..at];
        let line = before.bytes().filter(|&b| b == b'\n').count();
        let column = before.rsplit('\n').next().unwrap_or("").chars().count();
        (source.first_line + line, column + 1)
    }
}
