//! What begins on each line of a text: an item, a field, or the line alone. Found in one pass, so
//! that many comments take no longer than one each.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

use crate::diag::Code;

/// The lines of a text.
pub(super) struct Lines {
    /// Where each begins.
    starts: Vec<usize>,
    /// The end of what begins on each: of the line where all its brackets are closed.
    ends: Vec<usize>,
    /// The length of the text.
    length: usize,
}

impl Lines {
    pub fn of(text: &str, comments: &[Range<usize>]) -> Self {
        let depths = depths(text, comments);
        let mut starts: Vec<usize> = vec![0];
        starts.extend(depths.iter().map(|(newline, _)| newline + 1));
        let mut ends = vec![text.len(); starts.len()];
        // Newlines from here on that are less deep than all between, the nearest last. The nearest
        // that is no deeper than a line's beginning ends what begins there.
        let mut nearest: Vec<(usize, isize)> = Vec::new();
        for (line, ended) in depths.iter().enumerate().rev() {
            while nearest.pop_if(|(_, depth)| *depth >= ended.1).is_some() {}
            nearest.push(*ended);
            let before = line.checked_sub(1).map_or(0, |line| depths[line].1);
            let end = nearest.partition_point(|(_, depth)| *depth <= before);
            ends[line] = end.checked_sub(1).map_or(text.len(), |at| nearest[at].0);
        }
        Self { starts, ends, length: text.len() }
    }

    /// Where the line begins that holds a byte.
    pub fn start(&self, at: usize) -> usize {
        self.starts[self.starts.partition_point(|start| *start <= at) - 1]
    }

    /// What begins on the line at `start`.
    pub fn block(&self, start: usize) -> Range<usize> {
        let line = self.starts.partition_point(|it| *it < start);
        start..self.ends.get(line).copied().unwrap_or(self.length)
    }
}

/// Each newline, and how many brackets are open there.
fn depths(text: &str, comments: &[Range<usize>]) -> Vec<(usize, isize)> {
    let mut next = comments.iter().peekable();
    let mut depth = 0_isize;
    let mut quoted = false;
    let mut found = Vec::new();
    let bytes = text.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        if next.peek().is_some_and(|comment| comment.start == at) {
            at = next.next().map_or(at, |comment| comment.end);
            continue;
        }
        match bytes[at] {
            b'\n' => {
                found.push((at, depth));
                quoted = false;
            }
            b'\\' if quoted => at += usize::from(bytes.get(at + 1) != Some(&b'\n')),
            b'"' => quoted = !quoted,
            b'{' | b'(' | b'[' if !quoted => depth += 1,
            b'}' | b')' | b']' if !quoted => depth -= 1,
            _ => {}
        }
        at += 1;
    }
    found
}

/// What comments of a text speak of, and what they allow there. Blocks lie within each other, or
/// apart.
#[derive(Default)]
pub(super) struct Blocks(BTreeMap<usize, Block>);

struct Block {
    end: usize,
    /// Where the block begins that this one lies in.
    within: Option<usize>,
    /// The codes that are allowed here, and whether they were found here.
    codes: HashMap<&'static str, bool>,
}

impl Blocks {
    /// Those of comments that allow these codes in these bytes.
    pub fn of<'a>(allows: impl Iterator<Item = (&'a Range<usize>, Code)>) -> Self {
        let mut all: BTreeMap<usize, Block> = BTreeMap::new();
        for (bytes, code) in allows {
            let new = || Block { end: bytes.end, within: None, codes: HashMap::new() };
            let block = all.entry(bytes.start).or_insert_with(new);
            block.codes.insert(code.name, false);
        }
        let mut open: Vec<(usize, usize)> = Vec::new();
        for (start, block) in &mut all {
            while open.pop_if(|(_, end)| *end <= *start).is_some() {}
            block.within = open.last().map(|(start, _)| *start);
            open.push((*start, block.end));
        }
        Self(all)
    }

    /// Whether a code is allowed where something begins; it was found there then.
    pub fn allow(&mut self, code: Code, at: usize) -> bool {
        let mut is_allowed = false;
        let mut next = self.0.range(..=at).next_back().map(|(start, _)| *start);
        while let Some(start) = next
            && let Some(block) = self.0.get_mut(&start)
        {
            next = block.within;
            if at < block.end
                && let Some(used) = block.codes.get_mut(code.name)
            {
                *used = true;
                is_allowed = true;
            }
        }
        is_allowed
    }

    /// Whether a code was found in what begins there.
    pub fn used(&self, code: Code, start: usize) -> bool {
        self.0.get(&start).is_some_and(|block| block.codes.get(code.name) == Some(&true))
    }
}
