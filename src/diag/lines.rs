//! Lines and columns of places, for a report of many faults: each text is cut into lines once.

use std::collections::HashMap;

use super::{FileId, Sources, Span};

/// Line beginnings of the texts asked for so far.
pub(super) struct Lines<'a> {
    sources: &'a Sources,
    starts: HashMap<FileId, Vec<usize>>,
}

/// A place as people count: lines and columns from 1, columns in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Position {
    /// The line, in the whole file even if only an excerpt is kept.
    pub line: usize,
    /// The column, in characters.
    pub column: usize,
}

impl<'a> Lines<'a> {
    pub fn new(sources: &'a Sources) -> Self {
        Self { sources, starts: HashMap::new() }
    }

    pub fn sources(&self) -> &'a Sources {
        self.sources
    }

    /// The byte at which each line of `file` begins; an empty last line counts.
    pub fn starts(&mut self, file: FileId) -> &[usize] {
        self.starts.entry(file).or_insert_with(|| {
            let text = &self.sources.get(file).text;
            std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect()
        })
    }

    /// The bytes a span covers, brought within its text and onto character boundaries.
    pub fn range(&self, span: Span) -> (usize, usize) {
        let text = &self.sources.get(span.file).text;
        let inside = |at: u32| {
            let mut at = (at as usize).min(text.len());
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let start = inside(span.start);
        (start, inside(span.end).max(start))
    }

    /// The line, counted from 0 in the kept text, that holds byte `at`.
    pub fn index(&mut self, file: FileId, at: usize) -> usize {
        self.starts(file).partition_point(|start| *start <= at).saturating_sub(1)
    }

    /// Where byte `at` of `file` is.
    pub fn position(&mut self, file: FileId, at: usize) -> Position {
        let index = self.index(file, at);
        let start = self.starts(file)[index];
        let source = self.sources.get(file);
        let column = source.text[start..at.max(start)].chars().count() + 1;
        Position { line: source.first_line + index, column }
    }

    /// Where a span begins and ends.
    pub fn positions(&mut self, span: Span) -> (Position, Position) {
        let (start, end) = self.range(span);
        (self.position(span.file, start), self.position(span.file, end))
    }
}
