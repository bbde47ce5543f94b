//! Reading regular files of bounded size, and nothing that may block or never end.

use std::fs::{self, File, Metadata};
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};

use super::Failure;

/// Bytes read between two looks at the size.
const CHUNK: usize = 1 << 20;

/// The bytes of a regular file of at most `limit` bytes. Folders, devices, pipes and sockets are
/// refused before they are opened, and again once open: what a name stands for may change.
pub fn read(path: &Path, limit: u64) -> Result<Vec<u8>, Failure> {
    let (mut file, length) = open(path, limit)?;
    let mut bytes = Vec::new();
    let capacity = usize::try_from(length).map_err(|_| too_long(limit))?;
    bytes.try_reserve_exact(capacity + 1).map_err(|_| Failure::new("does not fit into memory"))?;
    // The file may grow while it is read, so the limit is held here too.
    loop {
        let read = (&mut file).take(CHUNK as u64).read_to_end(&mut bytes)?;
        if bytes.len() as u64 > limit {
            return Err(too_long(limit));
        }
        if read == 0 {
            return Ok(bytes);
        }
    }
}

/// Opens a regular file of at most `limit` bytes; with it comes its length.
pub fn open(path: &Path, limit: u64) -> Result<(File, u64), Failure> {
    check(&fs::metadata(path)?, limit)?;
    let file = open_unblocked(path)?;
    let metadata = file.metadata()?;
    check(&metadata, limit)?;
    Ok((file, metadata.len()))
}

/// Whether there is anything of that name.
pub fn is_there(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}

/// One name for each file, however it is reached; the whole path if there is no such file.
pub fn identity(path: &Path) -> PathBuf {
    let whole = || std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    fs::canonicalize(path).unwrap_or_else(|_| whole())
}

/// The names of the files beside `path`, for guessing which one was meant; at most a thousand.
pub fn neighbours(path: &Path) -> Vec<String> {
    const MOST: usize = 1000;
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let mut names: Vec<String> = entries
        .take(MOST)
        .flatten()
        .filter(|entry| entry.file_type().is_ok_and(|kind| kind.is_file()))
        .filter_map(|entry| entry.file_name().into_string().ok())
        .collect();
    names.sort();
    names
}

/// Opens for reading without waiting for the other end of a pipe.
fn open_unblocked(path: &Path) -> Result<File, Failure> {
    let mut options = File::options();
    options.read(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags(rustix::fs::OFlags::NONBLOCK.bits() as i32);
    }
    options.open(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => Failure::new("does not exist"),
        ErrorKind::PermissionDenied => Failure::new("may not be read: permission denied"),
        _ => error.into(),
    })
}

fn check(metadata: &Metadata, limit: u64) -> Result<(), Failure> {
    let kind = metadata.file_type();
    if kind.is_dir() {
        return Err(Failure::new("is a folder"));
    }
    if !kind.is_file() {
        return Err(Failure::new(special(kind)));
    }
    if metadata.len() > limit { Err(too_long(limit)) } else { Ok(()) }
}

/// What it is in place of a regular file.
#[cfg(unix)]
pub(super) fn special(kind: fs::FileType) -> &'static str {
    use std::os::unix::fs::FileTypeExt;
    if kind.is_fifo() {
        "is a pipe, not a file"
    } else if kind.is_socket() {
        "is a socket, not a file"
    } else {
        "is a device, not a file"
    }
}

/// What it is in place of a regular file.
#[cfg(not(unix))]
pub(super) fn special(_kind: fs::FileType) -> &'static str {
    "is no regular file"
}

fn too_long(limit: u64) -> Failure {
    Failure::new(format!("is larger than {}, the most that is read", size(limit)))
}

/// A size in the largest unit that fits: "8 MB".
pub(super) fn size(bytes: u64) -> String {
    let units = [(1_000_000_000, "GB"), (1_000_000, "MB"), (1_000, "kB")];
    match units.iter().find(|(scale, _)| bytes >= *scale) {
        Some((scale, unit)) => format!("{} {unit}", bytes / scale),
        None => format!("{bytes} bytes"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn failure(path: &Path) -> String {
        read(path, 100).unwrap_err().to_string()
    }

    #[test]
    fn only_regular_files_within_the_limit_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a");
        fs::write(&file, [7; 100]).unwrap();
        assert_eq!(read(&file, 100).unwrap(), [7; 100]);
        fs::write(&file, [7; 101]).unwrap();
        assert_eq!(failure(&file), "is larger than 100 bytes, the most that is read");
        assert_eq!(failure(folder.path()), "is a folder");
        assert_eq!(failure(&folder.path().join("b")), "does not exist");
        assert_eq!(failure(&file.join("b")), "has a file where a folder should be in its path");
    }

    #[cfg(unix)]
    #[test]
    fn neither_devices_nor_pipes_are_waited_for() {
        assert_eq!(failure(Path::new("/dev/zero")), "is a device, not a file");
        assert_eq!(failure(Path::new("/dev/null")), "is a device, not a file");
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        rustix::fs::mknodat(
            rustix::fs::CWD,
            &pipe,
            rustix::fs::FileType::Fifo,
            rustix::fs::Mode::RUSR,
            0,
        )
        .unwrap();
        assert_eq!(failure(&pipe), "is a pipe, not a file");
        // Even if the pipe took a file's place after the first look, opening does not wait.
        assert!(open_unblocked(&pipe).is_ok());
    }
}
