//! Files that keep work in between: checkpoints of renders, and parts of them. What is kept is
//! whoever writes it to say; here it is wrapped so that nothing broken, foreign or of another
//! version is ever taken for it.
//!
//! A header (eight bytes of name, the form of the file, the lengths of what follows), words as
//! JSON, the payload as postcard, and the SHA-256 of words, payload and header, in this order.
//! Numbers are little-endian. Both are read into memory as a whole.

use std::io::{Seek, SeekFrom, Write};
use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::{Failure, regular, whole};

/// How such a file begins.
const NAME: [u8; 8] = *b"scn kept";
/// The form described above.
const FORM: u32 = 1;
/// Bytes before the words: name, form, length of the words, length of the payload.
const HEADER: usize = 8 + 4 + 8 + 8;
/// Bytes of the checksum.
const CHECKSUM: usize = 32;
/// The longest file that is read, in bytes.
const LIMIT: u64 = 64_000_000_000;

/// The words, and the version of the program that wrote them.
#[derive(Serialize, Deserialize)]
struct Words<W> {
    version: String,
    words: W,
}

/// The version alone: the first thing to be read, for the rest depends on it.
#[derive(Deserialize)]
struct Version {
    version: String,
}

/// Writes a file of `version` of the program: words about what is kept, and what is kept.
pub fn write(
    path: &Path,
    version: &str,
    words: &impl Serialize,
    payload: &impl Serialize,
) -> Result<(), Failure> {
    let words = serde_json::to_vec(&Words { version: version.to_string(), words })
        .map_err(|error| Failure::new(format!("cannot hold these words: {error}")))?;
    whole::write(path, |file| {
        file.write_all(&[0; HEADER])?;
        let mut body = Hashed { inner: &mut *file, hasher: Sha256::new(), length: 0, failed: None };
        body.write_all(&words)?;
        if postcard::to_io(payload, &mut body).is_err() {
            let failed = body.failed.take().map(Failure::from);
            return Err(failed.unwrap_or_else(|| Failure::new("cannot hold what is to be kept")));
        }
        let (mut hasher, length) = (body.hasher, body.length);
        let words = words.len() as u64;
        let header = header(words, length - words);
        hasher.update(header);
        file.write_all(&hasher.finalize())?;
        file.seek(SeekFrom::Start(0))?;
        Ok(file.write_all(&header)?)
    })
}

/// Reads what [`write`] wrote. What the payload says is as whoever made it wanted it: only that it
/// came here whole is known.
pub fn read<W: DeserializeOwned, P: DeserializeOwned>(
    path: &Path,
    version: &str,
) -> Result<(W, P), Failure> {
    parsed(&regular::read(path, LIMIT)?, version)
}

fn header(words: u64, payload: u64) -> [u8; HEADER] {
    let mut header = [0; HEADER];
    header[..8].copy_from_slice(&NAME);
    header[8..12].copy_from_slice(&FORM.to_le_bytes());
    header[12..20].copy_from_slice(&words.to_le_bytes());
    header[20..].copy_from_slice(&payload.to_le_bytes());
    header
}

fn parsed<W: DeserializeOwned, P: DeserializeOwned>(
    bytes: &[u8],
    version: &str,
) -> Result<(W, P), Failure> {
    let short = || Failure::new("is not whole: it ends too early");
    let known = bytes.len().min(NAME.len());
    if bytes[..known] != NAME[..known] {
        return Err(Failure::new("is neither a checkpoint nor a part of a render"));
    }
    let (header, rest) = bytes.split_at_checked(HEADER).ok_or_else(short)?;
    let form = u32::from_le_bytes(header[8..12].try_into().expect("four bytes"));
    if form != FORM {
        let clause = format!("is of form {form}, and this scn reads form {FORM} alone");
        return Err(Failure::new(clause));
    }
    let long = |at: usize| u64::from_le_bytes(header[at..at + 8].try_into().expect("eight bytes"));
    let (words, payload) = (long(12), long(20));
    let length = words.checked_add(payload).and_then(|sum| sum.checked_add(CHECKSUM as u64));
    match length.map(|length| length.cmp(&(rest.len() as u64))) {
        Some(std::cmp::Ordering::Equal) => {}
        Some(std::cmp::Ordering::Less) => {
            return Err(Failure::new("is damaged: it is longer than it says"));
        }
        _ => return Err(short()),
    }
    let (body, checksum) = rest.split_at(rest.len() - CHECKSUM);
    let mut hasher = Sha256::new();
    hasher.update(body);
    hasher.update(header);
    if hasher.finalize()[..] != *checksum {
        return Err(Failure::new("is damaged: its bytes do not fit its checksum"));
    }
    // From here on it is what somebody wrote on purpose, which may still be anything.
    let strange = || Failure::new("is whole, but not written by this scn");
    let (words, payload) = body.split_at(words as usize);
    let said: Version = serde_json::from_slice(words).map_err(|_| strange())?;
    if said.version != version {
        let clause = format!("was written by scn {}, and this is scn {version}", said.version);
        return Err(Failure::new(clause));
    }
    let words: Words<W> = serde_json::from_slice(words).map_err(|_| strange())?;
    let (payload, left) = postcard::take_from_bytes(payload).map_err(|_| strange())?;
    if left.is_empty() { Ok((words.words, payload)) } else { Err(strange()) }
}

/// A writer that knows the checksum and the length of what went through it, and why it failed.
struct Hashed<W> {
    inner: W,
    hasher: Sha256,
    length: u64,
    failed: Option<std::io::Error>,
}

impl<W: Write> Write for Hashed<W> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        match self.inner.write(bytes) {
            Ok(written) => {
                self.hasher.update(&bytes[..written]);
                self.length += written as u64;
                Ok(written)
            }
            Err(error) => {
                let told = std::io::Error::from(error.kind());
                self.failed = Some(error);
                Err(told)
            }
        }
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.inner.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Kept = (Vec<[f64; 3]>, Option<u64>);

    fn kept() -> (String, Kept) {
        ("left: 3 of 7\nlys, 光".to_string(), (vec![[0.1, -0.0, 1e300]; 5], Some(u64::MAX)))
    }

    fn written() -> (tempfile::TempDir, std::path::PathBuf, Vec<u8>) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.checkpoint");
        let (about, payload) = kept();
        write(&path, "1.2", &about, &payload).unwrap();
        let bytes = std::fs::read(&path).unwrap();
        (folder, path, bytes)
    }

    fn failure(bytes: &[u8]) -> String {
        parsed::<String, Kept>(bytes, "1.2").unwrap_err().to_string()
    }

    /// The same file with other bytes in it, and a checksum which fits them.
    fn forged(bytes: &[u8], change: impl FnOnce(&mut Vec<u8>)) -> Vec<u8> {
        let mut body = bytes[..bytes.len() - CHECKSUM].to_vec();
        change(&mut body);
        let mut hasher = Sha256::new();
        hasher.update(&body[HEADER..]);
        hasher.update(&body[..HEADER]);
        body.extend(hasher.finalize());
        body
    }

    #[test]
    fn it_comes_back_as_it_went() {
        let (_folder, path, _) = written();
        assert_eq!(read::<String, Kept>(&path, "1.2").unwrap(), kept());
        let other = read::<String, Kept>(&path, "1.3").unwrap_err().to_string();
        assert_eq!(other, "was written by scn 1.2, and this is scn 1.3");
    }

    #[test]
    fn no_beginning_of_it_is_taken_for_the_whole() {
        let (_folder, _, bytes) = written();
        for end in 0..bytes.len() {
            assert_eq!(failure(&bytes[..end]), "is not whole: it ends too early", "{end}");
        }
        let mut longer = bytes.clone();
        longer.push(0);
        assert_eq!(failure(&longer), "is damaged: it is longer than it says");
    }

    #[test]
    fn no_byte_of_it_can_change() {
        let (_folder, _, bytes) = written();
        for at in 0..bytes.len() {
            for bit in 0..8 {
                let mut damaged = bytes.clone();
                damaged[at] ^= 1 << bit;
                failure(&damaged);
            }
        }
        assert_eq!(failure(b"a picture"), "is neither a checkpoint nor a part of a render");
        let at = HEADER + 3;
        let mut damaged = bytes.clone();
        damaged[at] ^= 1;
        assert_eq!(failure(&damaged), "is damaged: its bytes do not fit its checksum");
    }

    #[test]
    fn forged_ones_are_told_not_trusted() {
        let (_folder, _, bytes) = written();
        let strange = "is whole, but not written by this scn";
        let form = forged(&bytes, |bytes| bytes[8] = 2);
        assert_eq!(failure(&form), "is of form 2, and this scn reads form 1 alone");
        for lengths in [12..20, 20..28, 12..28] {
            let huge = forged(&bytes, |bytes| bytes[lengths].fill(0xff));
            assert_eq!(failure(&huge), "is not whole: it ends too early");
        }
        // Five vectors are said to be as many as a varint can say.
        let words = u64::from_le_bytes(bytes[12..20].try_into().unwrap()) as usize;
        let many = forged(&bytes, |bytes| bytes[HEADER + words] = 0x7f);
        assert_eq!(failure(&many), strange);
        assert_eq!(failure(&forged(&bytes, |bytes| bytes[HEADER] = b'[')), strange);
        // Whatever stands there: an answer, and no panic.
        for at in HEADER..bytes.len() - CHECKSUM {
            let changed = forged(&bytes, |bytes| bytes[at] ^= 0x55);
            let _ = parsed::<String, Kept>(&changed, "1.2");
        }
    }

    #[test]
    fn why_the_disk_took_no_more_is_told() {
        let mut full = Hashed { inner: Full(1000), hasher: Sha256::new(), length: 0, failed: None };
        assert!(postcard::to_io(&vec![[1.0_f64; 3]; 100], &mut full).is_err());
        let told = Failure::from(full.failed.unwrap()).to_string();
        assert_eq!(told, "finds no space left on the disk");
    }

    /// A disk with so many bytes left.
    struct Full(usize);

    impl Write for Full {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            let full = || std::io::Error::from(std::io::ErrorKind::StorageFull);
            self.0 = self.0.checked_sub(bytes.len()).ok_or_else(full)?;
            Ok(bytes.len())
        }

        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
}
