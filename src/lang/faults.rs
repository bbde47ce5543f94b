//! The faults of one text: so many are kept, the others are counted, so that no text however bad
//! costs more than a moment.

use super::errors::more;
use super::limits;
use crate::diag::Diagnostic;

/// Faults, in the order they were found.
#[derive(Debug, Default)]
pub struct Faults {
    /// Those that are told.
    pub kept: Vec<Diagnostic>,
    /// How many were found beside them.
    more: usize,
    /// Reading stopped: there may be others that nobody counted.
    stopped: bool,
}

impl Faults {
    /// One more.
    pub fn push(&mut self, fault: Diagnostic) {
        if self.is_full() {
            self.more += 1;
        } else {
            self.kept.push(fault);
        }
    }

    /// One more, which is built only if it is told.
    pub fn push_with(&mut self, fault: impl FnOnce() -> Diagnostic) {
        if self.is_full() {
            self.more += 1;
        } else {
            self.kept.push(fault());
        }
    }

    /// All of another text, or of another part of this one.
    pub fn append(&mut self, other: Faults) {
        self.more += other.more;
        self.stopped |= other.stopped;
        other.kept.into_iter().for_each(|fault| self.push(fault));
    }

    /// Whether further faults are only counted.
    pub fn is_full(&self) -> bool {
        self.kept.len() >= limits::FAULTS
    }

    /// There may be others, but nobody looks for them.
    pub fn stop(&mut self) {
        self.stopped = true;
    }

    /// How many there were.
    pub fn len(&self) -> usize {
        self.kept.len() + self.more
    }

    /// Whether there was none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Those that are told; the last one says how many are not.
    pub fn finish(mut self) -> Vec<Diagnostic> {
        let counted = Some(self.more).filter(|_| !self.stopped);
        if self.stopped || self.more > 0 {
            self.kept.extend(self.kept.last().map(|last| more::more_faults(counted, last)));
        }
        self.kept
    }
}
