//! A value and the place in the text that gave it.

use std::ops::Deref;

use serde::{Serialize, Serializer};

use crate::diag::Span;

/// A value with its place. Equality, hashes and serialisation are those of the value: a scene is
/// what it says, wherever it says it. A default's place is that of the record that left it out.
#[derive(Clone, Copy, Debug)]
pub struct At<T> {
    /// The value.
    pub value: T,
    /// The place.
    pub span: Span,
    /// Whether it is what a field is when it is left out. Serialised records have no such fields:
    /// words that come to the language change nothing in scenes that do not use them.
    pub usual: bool,
}

impl<T> At<T> {
    /// `value`, said at `span`.
    pub fn new(value: T, span: Span) -> Self {
        Self { value, span, usual: false }
    }

    /// The same place with another value.
    pub fn map<U>(self, f: impl FnOnce(T) -> U) -> At<U> {
        At { value: f(self.value), span: self.span, usual: self.usual }
    }

    /// Whether serialised records do without it.
    pub(super) fn is_usual(&self) -> bool {
        self.usual
    }
}

impl<T> Deref for At<T> {
    type Target = T;
    fn deref(&self) -> &T {
        &self.value
    }
}

impl<T: PartialEq> PartialEq for At<T> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<T: Serialize> Serialize for At<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.value.serialize(serializer)
    }
}
