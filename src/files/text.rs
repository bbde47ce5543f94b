//! Scene files as text.

use std::path::Path;

use super::{Failure, regular, whole};

/// The longest scene file, in bytes.
pub const LIMIT: u64 = 8_000_000;

/// The text of a scene file: a regular file of at most 8 MB, in UTF-8. A byte order mark is left
/// out.
pub fn read(path: &Path) -> Result<String, Failure> {
    let text = read_raw(path)?;
    Ok(match text.strip_prefix(MARK) {
        Some(rest) => rest.to_string(),
        None => text,
    })
}

/// The same with its byte order mark.
pub fn read_raw(path: &Path) -> Result<String, Failure> {
    decode(regular::read(path, LIMIT)?)
}

/// A text without its byte order mark.
pub fn without_mark(text: &str) -> &str {
    text.strip_prefix(MARK).unwrap_or(text)
}

/// Some programs begin every text with it.
const MARK: char = '\u{feff}';

/// Bytes as UTF-8.
pub fn decode(bytes: Vec<u8>) -> Result<String, Failure> {
    String::from_utf8(bytes).map_err(|error| {
        let good = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + good.iter().filter(|byte| **byte == b'\n').count();
        Failure::new(format!("is not UTF-8 text: line {line} holds other bytes"))
    })
}

/// Writes a scene file anew, whole or not at all, if it still is what was read: `before`, as
/// [`read`] gave it. A byte order mark stays.
pub fn replace(path: &Path, before: &str, after: &str) -> Result<(), Failure> {
    let raw = read_raw(path)?;
    let rest = without_mark(&raw);
    if rest != before {
        return Err(Failure::new("was changed meanwhile, and is left as it is"));
    }
    let mark = &raw[..raw.len() - rest.len()];
    whole::replace(path, format!("{mark}{after}").as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_bytes_are_named_by_their_line() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.scn");
        std::fs::write(&path, "\u{feff}scn 1 in m\n").unwrap();
        assert_eq!(read(&path).unwrap(), "scn 1 in m\n");
        std::fs::write(&path, b"scn 1\n// caf\xe9\n").unwrap();
        let failure = read(&path).unwrap_err().to_string();
        assert_eq!(failure, "is not UTF-8 text: line 2 holds other bytes");
    }

    #[test]
    fn a_text_is_replaced_unless_it_changed_meanwhile() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.scn");
        std::fs::write(&path, "\u{feff}one\r\n").unwrap();
        replace(&path, "one\r\n", "two\r\n").unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "\u{feff}two\r\n");
        let told = replace(&path, "one\r\n", "three").unwrap_err().to_string();
        assert_eq!(told, "was changed meanwhile, and is left as it is");
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "\u{feff}two\r\n");
    }
}
