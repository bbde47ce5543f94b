//! A file that one process alone may write, for as long as it works on it.
//!
//! Said by a lock on a hidden file beside: the system frees it when the process ends, however that
//! comes, and a file without a lock says nothing. Not every disk and system knows locks; where there
//! are none, nobody is refused.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use super::{Failure, whole};

/// A file held by this process. The file beside goes away with it.
#[derive(Debug)]
pub struct Held {
    beside: PathBuf,
    /// Open, for the lock lasts as long.
    _lock: File,
}

impl Held {
    /// Holds the file called `path`, which need not be there; its folder must be. None if somebody
    /// holds it already, this process too.
    pub fn take(path: &Path) -> Result<Option<Self>, Failure> {
        let beside = whole::lock_name(path)?;
        loop {
            let file = open(&beside)?;
            if whole::taken(&file) {
                return Ok(None);
            }
            // Who held it may have removed it between its opening and its locking.
            if whole::is_named(&file) {
                return Ok(Some(Self { beside, _lock: file }));
            }
        }
    }
}

impl Drop for Held {
    fn drop(&mut self) {
        // Removed while it is locked. Nothing that goes wrong here matters.
        let _ = fs::remove_file(&self.beside);
    }
}

/// Opens it, made if there is none; no link is followed, and nothing is waited for.
fn open(path: &Path) -> Result<File, Failure> {
    let mut options = File::options();
    options.append(true).create(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        let flags = rustix::fs::OFlags::NONBLOCK | rustix::fs::OFlags::NOFOLLOW;
        options.custom_flags(flags.bits() as i32);
    }
    options.open(path).map_err(|error| {
        let failure = Failure::from(error);
        Failure::new(format!("needs the file {}, which {failure}", path.display()))
    })
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn one_alone_holds_it_and_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.checkpoint");
        let names = || fs::read_dir(folder.path()).unwrap().count();
        let held = Held::take(&path).unwrap();
        assert!(held.is_some());
        assert!(Held::take(&path).unwrap().is_none());
        // Through a link it is the same file.
        fs::write(&path, b"").unwrap();
        let link = folder.path().join("link");
        std::os::unix::fs::symlink(&path, &link).unwrap();
        assert!(Held::take(&link).unwrap().is_none());
        assert!(Held::take(&folder.path().join("b.checkpoint")).unwrap().is_some());
        drop(held);
        assert_eq!(names(), 2);
        // What a killed process left holds nobody off.
        fs::write(folder.path().join(".a.checkpoint.lock"), b"").unwrap();
        drop(Held::take(&path).unwrap().unwrap());
        assert_eq!(names(), 2);
    }

    #[test]
    fn what_is_in_the_way_is_told() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.checkpoint");
        fs::create_dir(folder.path().join(".a.checkpoint.lock")).unwrap();
        let why = Held::take(&path).unwrap_err().to_string();
        assert!(why.ends_with("/.a.checkpoint.lock, which is a folder"), "{why}");
    }
}
