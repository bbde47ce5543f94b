//! Files that appear whole or not at all: written beside, then renamed.
//!
//! Who writes holds a lock on the file beside. One without a lock was left by a process that was
//! killed, and goes away when the same file is written next.

use std::fs::{self, File};
use std::io::{BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::{Failure, regular};

/// Writes a file by `fill`, making its folder if there is none. When anything fails, what was
/// there before is still there, and nothing else.
pub fn write(
    path: &Path,
    fill: impl FnOnce(&mut BufWriter<&mut File>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let path = target(path)?;
    let name = path.file_name().ok_or_else(|| Failure::new("has no file name"))?;
    let folder = folder_of(&path);
    fs::create_dir_all(folder).map_err(|error| folder_failure(folder, error))?;

    let mut beside = beside(&hidden(name), folder)?;
    let mut writer = BufWriter::new(beside.as_file_mut());
    fill(&mut writer)?;
    writer.flush()?;
    drop(writer);
    // Some disks tell that they are full only now.
    beside.as_file().sync_all()?;
    beside.persist(&path).map_err(|error| Failure::from(error.error))?;
    Ok(())
}

/// Writes a file where there is none, making its folder; nothing is ever written over.
pub fn create(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let name = path.file_name().ok_or_else(|| Failure::new("has no file name"))?;
    let folder = folder_of(path);
    fs::create_dir_all(folder).map_err(|error| folder_failure(folder, error))?;
    let mut beside = beside(&hidden(name), folder)?;
    beside.write_all(bytes)?;
    beside.as_file().sync_all()?;
    match beside.persist_noclobber(path) {
        Ok(_) => Ok(()),
        Err(error) if error.error.kind() == ErrorKind::AlreadyExists => {
            Err(Failure::new("is there already"))
        }
        Err(error) => Err(error.error.into()),
    }
}

/// Writes a file in place of one that is there, which may be written and keeps its permissions.
pub fn replace(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let path = target(path)?;
    let permissions = fs::metadata(&path)?.permissions();
    // Another file in its place could be made all the same; but this one is not to be changed.
    File::options().append(true).open(&path)?;
    write(&path, |file| {
        file.get_ref().set_permissions(permissions)?;
        Ok(file.write_all(bytes)?)
    })
}

/// Whether [`write`] can be expected to work: makes the folder, and a file beside, which goes away
/// again.
pub fn ready(path: &Path) -> Result<Folders, Failure> {
    let path = target(path)?;
    let name = path.file_name().ok_or_else(|| Failure::new("has no file name"))?;
    let folder = folder_of(&path);
    let folders = Folders::missing(folder);
    fs::create_dir_all(folder).map_err(|error| folder_failure(folder, error))?;
    beside(&hidden(name), folder).map(|_| folders)
}

/// Folders that were made for files to come. Those that are empty at its end go away with it.
#[derive(Debug)]
pub struct Folders {
    /// The innermost first.
    made: Vec<PathBuf>,
}

impl Folders {
    /// Those that have to be made for `folder` to be there.
    fn missing(folder: &Path) -> Self {
        let all = folder.ancestors().filter(|folder| *folder != Path::new(""));
        let made = all.take_while(|folder| !folder.exists()).map(Path::to_path_buf).collect();
        Self { made }
    }
}

impl Drop for Folders {
    fn drop(&mut self) {
        // What holds something stays.
        let _ = self.made.iter().try_for_each(fs::remove_dir);
    }
}

/// Whether there is a folder of that name.
pub fn is_folder(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|metadata| metadata.is_dir())
}

/// The hidden file beside it whose lock says that somebody works on it.
pub(super) fn lock_name(path: &Path) -> Result<PathBuf, Failure> {
    let path = target(path)?;
    let mut name = hidden(path.file_name().ok_or_else(|| Failure::new("has no file name"))?);
    name.push(".lock");
    Ok(folder_of(&path).join(name))
}

/// Links from one to the next that are followed, as many as systems follow.
const MOST_LINKS: usize = 40;

/// Where the bytes go: through symbolic links, be there a file at their end or not yet, and only in
/// the place of a regular file.
fn target(path: &Path) -> Result<PathBuf, Failure> {
    let mut path = path.to_path_buf();
    let mut links = 0;
    while let Ok(next) = fs::read_link(&path) {
        links += 1;
        if links > MOST_LINKS {
            return Err(Failure::new("is a link that leads nowhere"));
        }
        path = folder_of(&path).join(next);
    }
    let path = fs::canonicalize(&path).unwrap_or(path);
    match fs::metadata(&path) {
        Ok(metadata) if metadata.is_dir() => Err(Failure::new("is a folder")),
        Ok(metadata) if !metadata.is_file() => {
            Err(Failure::new(regular::special(metadata.file_type())))
        }
        _ => Ok(path),
    }
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// How the name of the file beside begins.
fn hidden(name: &std::ffi::OsStr) -> std::ffi::OsString {
    let mut prefix = std::ffi::OsString::from(".");
    prefix.push(name);
    prefix
}

/// How the name of the file beside ends.
const BESIDE: &str = ".part";
/// Characters between that beginning and that end.
const RANDOM: usize = 6;

/// A hidden file in the same folder, with the permissions a new file gets there. It goes away by
/// itself unless it is renamed. Those that others left there go away too.
fn beside(prefix: &std::ffi::OsStr, folder: &Path) -> Result<tempfile::NamedTempFile, Failure> {
    sweep(prefix, folder);
    loop {
        let file = hidden_file(prefix, folder)?;
        // Somebody may have swept it up between its making and its locking.
        if lock(file.as_file()).is_err() || is_named(file.as_file()) {
            return Ok(file);
        }
    }
}

fn hidden_file(
    prefix: &std::ffi::OsStr,
    folder: &Path,
) -> Result<tempfile::NamedTempFile, Failure> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(prefix).suffix(BESIDE).rand_bytes(RANDOM);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder).map_err(|error| folder_failure(folder, error))
}

/// Removes what killed processes left beside. Nothing that goes wrong here matters.
fn sweep(prefix: &std::ffi::OsStr, folder: &Path) {
    let prefix = prefix.as_encoded_bytes();
    let left = |name: &std::ffi::OsStr| {
        let name = name.as_encoded_bytes();
        let middle = name.strip_prefix(prefix).and_then(|n| n.strip_suffix(BESIDE.as_bytes()));
        middle.is_some_and(|it| it.len() == RANDOM && it.iter().all(u8::is_ascii_alphanumeric))
    };
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    for entry in entries.filter(|entry| left(&entry.file_name())) {
        let path = entry.path();
        if let Ok((file, _)) = regular::open(&path, u64::MAX)
            && lock(&file).is_ok()
        {
            let _ = fs::remove_file(&path);
        }
    }
}

/// Whether another one has the lock of this file; takes it if not.
#[cfg(unix)]
pub(super) fn taken(file: &File) -> bool {
    lock(file) == Err(rustix::io::Errno::WOULDBLOCK)
}

#[cfg(not(unix))]
pub(super) fn taken(_file: &File) -> bool {
    false
}

/// Takes the lock of a file that is written, for as long as it is open. Not every disk knows locks.
#[cfg(unix)]
fn lock(file: &File) -> Result<(), rustix::io::Errno> {
    rustix::fs::flock(file, rustix::fs::FlockOperation::NonBlockingLockExclusive)
}

/// Other systems have other locks: nothing is swept there.
#[cfg(not(unix))]
fn lock(_file: &File) -> Result<(), ()> {
    Err(())
}

/// Whether the name of an open file still stands for it, or its folder does not tell.
#[cfg(unix)]
pub(super) fn is_named(file: &File) -> bool {
    use std::os::unix::fs::MetadataExt;
    file.metadata().map_or(true, |metadata| metadata.nlink() > 0)
}

#[cfg(not(unix))]
pub(super) fn is_named(_file: &File) -> bool {
    true
}

fn folder_failure(folder: &Path, error: std::io::Error) -> Failure {
    let folder = folder.display();
    match error.kind() {
        ErrorKind::AlreadyExists | ErrorKind::NotADirectory => {
            Failure::new(format!("needs the folder {folder}, but a file is in its way"))
        }
        ErrorKind::PermissionDenied => {
            Failure::new(format!("may not be made in the folder {folder}: permission denied"))
        }
        ErrorKind::ReadOnlyFilesystem => {
            Failure::new(format!("is to go to {folder}, on a disk that can only be read"))
        }
        ErrorKind::NotFound => {
            Failure::new(format!("needs the folder {folder}, which cannot be made"))
        }
        _ => error.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn put(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
        write(path, |file| Ok(file.write_all(bytes)?))
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        entries.map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect()
    }

    #[test]
    fn folders_are_made_and_files_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out/w01/a.txt");
        put(&path, b"old").unwrap();
        put(&path, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(names(&folder.path().join("out/w01")), ["a.txt"]);
    }

    #[test]
    fn readiness_makes_the_folder_and_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("new/out/a.txt");
        let (first, second) = (ready(&path).unwrap(), ready(&path).unwrap());
        assert!(is_folder(&folder.path().join("new/out")));
        assert!(names(&folder.path().join("new/out")).is_empty());
        drop(second);
        assert!(is_folder(&folder.path().join("new/out")), "made by the first");
        drop(first);
        assert!(names(folder.path()).is_empty());
        let held = ready(&path).unwrap();
        put(&path, b"old").unwrap();
        drop(held);
        drop(ready(&path).unwrap());
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(
            ready(&path.join("b")).unwrap_err().to_string(),
            format!("needs the folder {}, but a file is in its way", path.display())
        );
    }

    #[cfg(unix)]
    #[test]
    fn what_killed_processes_left_goes_away_and_what_others_write_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        let left = [".a.txtAbc123.part", ".a.txt000000.part"];
        let others =
            [".a.txt.part", ".a.txtAbc1234.part", ".b.txtAbc123.part", ".a.txtAb-123.part"];
        for name in left.iter().chain(&others) {
            fs::write(folder.path().join(name), b"half").unwrap();
        }
        let mut during = Vec::new();
        write(&path, |file| {
            file.write_all(b"one")?;
            // Somebody else writes the same meanwhile.
            put(&path, b"two")?;
            during = names(folder.path());
            Ok(())
        })
        .unwrap();
        assert!(left.iter().all(|name| !during.iter().any(|it| it == name)), "{during:?}");
        assert_eq!(during.len(), others.len() + 2, "{during:?}");
        assert_eq!(fs::read(&path).unwrap(), b"one");
        let mut after = names(folder.path());
        after.sort();
        let mut expected: Vec<_> = others.iter().map(|it| it.to_string()).collect();
        expected.push("a.txt".into());
        expected.sort();
        assert_eq!(after, expected);
    }

    #[test]
    fn a_failure_halfway_keeps_what_was_there_and_leaves_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        put(&path, b"old").unwrap();
        let full = write(&path, |file| {
            file.write_all(&[b'x'; 100_000])?;
            Err(std::io::Error::from(ErrorKind::StorageFull).into())
        });
        assert_eq!(full.unwrap_err().to_string(), "finds no space left on the disk");
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(names(folder.path()), ["a.txt"]);
    }

    #[test]
    fn a_file_where_a_folder_should_be_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("out");
        put(&file, b"I am a file").unwrap();
        let words = |path: &Path| put(path, b"").unwrap_err().to_string();
        let wanted = format!("needs the folder {}, but a file is in its way", file.display());
        assert_eq!(words(&file.join("a.txt")), wanted);
        assert_eq!(words(folder.path()), "is a folder");
        assert_eq!(fs::read(&file).unwrap(), b"I am a file");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn devices_and_other_peoples_folders_are_left_alone() {
        use std::os::unix::fs::{FileTypeExt, symlink};
        let words = |path: &str| put(Path::new(path), b"").unwrap_err().to_string();
        assert_eq!(words("/dev/full"), "is a device, not a file");
        assert!(fs::metadata("/dev/full").unwrap().file_type().is_char_device());
        assert_eq!(words("/proc/none/a.txt"), "needs the folder /proc/none, which cannot be made");
        // A link keeps pointing where it points.
        let folder = tempfile::tempdir().unwrap();
        let (link, file) = (folder.path().join("link"), folder.path().join("file"));
        put(&file, b"old").unwrap();
        symlink(&file, &link).unwrap();
        put(&link, b"new").unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        // To where there is nothing yet, too, by way of another link.
        fs::remove_file(&file).unwrap();
        let second = folder.path().join("second");
        symlink("link", &second).unwrap();
        put(&second, b"newer").unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"newer");
        assert!([&link, &second].iter().all(|it| fs::symlink_metadata(it).unwrap().is_symlink()));
        let ring = folder.path().join("ring");
        symlink("ring", &ring).unwrap();
        assert_eq!(put(&ring, b"").unwrap_err().to_string(), "is a link that leads nowhere");
    }

    #[cfg(unix)]
    #[test]
    fn what_is_replaced_keeps_its_permissions_and_must_be_there() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        assert_eq!(replace(&path, b"new").unwrap_err().to_string(), "does not exist");
        put(&path, b"old").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        replace(&path, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);
        assert_eq!(names(folder.path()), ["a.txt"]);
    }

    #[cfg(unix)]
    #[test]
    fn others_may_read_it_as_any_new_file() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (ours, theirs) = (folder.path().join("ours"), folder.path().join("theirs"));
        put(&ours, b"").unwrap();
        fs::write(&theirs, b"").unwrap();
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode();
        assert_eq!(mode(&ours), mode(&theirs));
    }
}
