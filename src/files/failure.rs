//! Why a file could not be read or written, in one clause.

use std::fmt;
use std::io::{self, ErrorKind};

/// A clause that continues "the file …": "does not exist", "is a folder".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure(String);

impl Failure {
    /// From the clause itself.
    pub fn new(clause: impl Into<String>) -> Self {
        Self(clause.into())
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Failure {}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        let clause = match error.kind() {
            ErrorKind::NotFound => "does not exist",
            ErrorKind::PermissionDenied => "may not be opened: permission denied",
            ErrorKind::IsADirectory => "is a folder",
            ErrorKind::NotADirectory => "has a file where a folder should be in its path",
            ErrorKind::StorageFull => "finds no space left on the disk",
            ErrorKind::QuotaExceeded => "is beyond the quota of its owner",
            ErrorKind::FileTooLarge => "is larger than the system allows",
            ErrorKind::ReadOnlyFilesystem => "is on a disk that can only be read",
            ErrorKind::InvalidFilename => "has a name the system does not accept",
            ErrorKind::OutOfMemory => "does not fit into memory",
            ErrorKind::UnexpectedEof => "ends too early",
            _ => return Self(format!("cannot be used: {}", system_words(&error))),
        };
        Self(clause.into())
    }
}

/// What the system says, without the error's number.
fn system_words(error: &io::Error) -> String {
    let text = error.to_string();
    let words = text.split(" (os error").next().unwrap_or(&text);
    let mut letters = words.chars();
    letters.next().map(|c| c.to_lowercase().chain(letters).collect()).unwrap_or_default()
}
