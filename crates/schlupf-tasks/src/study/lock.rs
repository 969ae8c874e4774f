//! Who writes a file: a lock that others see as long as the process lives that has it.

use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use fs4::{FileExt, TryLockError};

/// Lock files of this process.
static HELD: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// A lock of an output, in a file beside it that goes with it. On a file system that has no locks
/// it keeps nobody away.
#[derive(Debug)]
pub struct OutputLock {
    path: PathBuf,
    /// The system ends the lock with it, however the process ends.
    file: Option<File>,
}

/// How often a lock file is made anew that another process has just removed.
const ATTEMPTS: u32 = 100;

impl OutputLock {
    /// Locks an output, whose folder is there.
    ///
    /// # Errors
    /// [`ErrorKind::WouldBlock`] where another process writes it, and a lock file that cannot be
    /// made.
    pub fn take(output: &Path) -> io::Result<Self> {
        Self::take_by(output, FileExt::try_lock)
    }

    /// Removes the files of all locks of this process, which is about to end.
    pub fn remove_all() {
        for path in held().drain(..) {
            let _ = fs::remove_file(path);
        }
    }

    fn take_by(
        output: &Path,
        try_lock: impl Fn(&File) -> Result<(), TryLockError>,
    ) -> io::Result<Self> {
        let mut name = std::ffi::OsString::from(".");
        name.push(output.file_name().unwrap_or_default());
        name.push(".lock");
        let path = output.with_file_name(name);
        let mut held = held();
        for _ in 0..ATTEMPTS {
            let file = File::options().create(true).truncate(false).write(true).open(&path)?;
            // Other errors are those of a file system without locks, or of one mounted so.
            let is_locked = match try_lock(&file) {
                Ok(()) => true,
                Err(TryLockError::WouldBlock) => {
                    let message =
                        "another run is writing it: wait for its end, or name another output";
                    return Err(io::Error::new(ErrorKind::WouldBlock, message));
                }
                Err(TryLockError::Error(_)) => false,
            };
            // Whoever had it before may have removed the file after it was opened here.
            if !is_locked || is_at(&file, &path) {
                held.push(path.clone());
                return Ok(Self { path, file: Some(file) });
            }
        }
        Err(io::Error::other("its lock file changes all the time"))
    }
}

impl Drop for OutputLock {
    fn drop(&mut self) {
        let mut held = held();
        let Some(place) = held.iter().position(|path| *path == self.path) else { return };
        held.swap_remove(place);
        // What cannot be removed stays, without a lock. Only the owner of the lock removes it;
        // where an open file cannot be removed, it is closed before.
        if cfg!(unix) {
            let _ = fs::remove_file(&self.path);
            self.file = None;
        } else {
            self.file = None;
            let _ = fs::remove_file(&self.path);
        }
    }
}

fn held() -> MutexGuard<'static, Vec<PathBuf>> {
    HELD.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Whether an open file is the one that has the path.
fn is_at(file: &File, path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let id = |metadata: fs::Metadata| [metadata.dev(), metadata.ino()];
        let found = fs::metadata(path).map(id);
        found.is_ok_and(|found| file.metadata().map(id).is_ok_and(|own| own == found))
    }
    #[cfg(not(unix))]
    {
        let _ = file;
        path.exists()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Locks of one process exclude each other, too, as they belong to open files.
    #[test]
    fn a_lock_excludes_others_and_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let [one, other] = ["a.csv", "b.csv"].map(|name| folder.path().join(name));
        let lock = OutputLock::take(&one).unwrap();
        let refused = OutputLock::take(&one).unwrap_err();
        assert_eq!(refused.kind(), ErrorKind::WouldBlock);
        assert!(refused.to_string().contains("another run is writing it"));
        drop(OutputLock::take(&other).unwrap());
        drop(lock);
        drop(OutputLock::take(&one).unwrap());
        // The file of a process that was killed has no lock.
        fs::write(folder.path().join(".a.csv.lock"), "").unwrap();
        drop(OutputLock::take(&one).unwrap());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    /// A file system without locks (Lustre and NFS may be mounted so) does not stop a run.
    #[test]
    fn where_there_are_no_locks_runs_go_on() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("a.csv");
        let none = |_: &File| Err(TryLockError::Error(io::Error::from(ErrorKind::Unsupported)));
        let lock = OutputLock::take_by(&output, none).unwrap();
        drop(OutputLock::take_by(&output, none).unwrap());
        drop(lock);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
