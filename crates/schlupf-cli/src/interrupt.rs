//! What becomes of SIGINT and SIGTERM: the command ends at once, and nothing of it stays behind.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use schlupf_tasks::study::lock::OutputLock;
use tempfile::TempDir;

use crate::stdout;

/// Exit code of a command that was interrupted, that of a shell for SIGINT.
const INTERRUPTED: i32 = 130;

/// Files that are not finished, and directories that were made for them.
#[derive(Debug, Default)]
pub struct Unfinished {
    files: Vec<PathBuf>,
    directories: Vec<PathBuf>,
    /// Folders to work in, which go with what is in them.
    scratch: Vec<PathBuf>,
    /// Whether all files of the command are in their places.
    is_written: bool,
    /// Whether what is done is kept for the next run of the command.
    keeps_parts: bool,
}

static UNFINISHED: Mutex<Unfinished> = Mutex::new(Unfinished {
    files: Vec::new(),
    directories: Vec::new(),
    scratch: Vec::new(),
    is_written: false,
    keeps_parts: false,
});

/// What is unfinished now. While this is held, no interruption takes place: files that are put in
/// their places are all there, or none is.
pub fn unfinished() -> MutexGuard<'static, Unfinished> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Unfinished {
    /// Notes a temporary file.
    pub fn file(&mut self, path: &Path) {
        self.files.push(path.to_owned());
    }

    /// Notes a directory that was made.
    pub fn directory(&mut self, path: &Path) {
        self.directories.push(path.to_owned());
    }

    /// What is done stays: the same command goes on from there.
    pub fn keep_parts(&mut self) {
        self.keeps_parts = true;
    }

    /// All is in its place, if there was anything to write.
    pub fn finish(&mut self, is_written: bool) {
        *self = Self { is_written, ..Self::default() };
    }

    /// What cannot be removed stays: nobody is left to tell.
    fn remove(&self) {
        for file in &self.files {
            let _ = std::fs::remove_file(file);
        }
        OutputLock::remove_all();
        for directory in self.directories.iter().rev() {
            let _ = std::fs::remove_dir(directory);
        }
        for folder in &self.scratch {
            // Threads still work, and may put something in while it is emptied.
            let _ = (0..ATTEMPTS).find(|_| std::fs::remove_dir_all(folder).is_ok());
        }
    }
}

/// How often a folder is emptied that may fill again.
const ATTEMPTS: u32 = 10;

/// A folder to work in, that goes with all that is in it even if the command is interrupted.
pub fn scratch() -> io::Result<TempDir> {
    let mut unfinished = unfinished();
    let folder = tempfile::tempdir()?;
    unfinished.scratch.push(folder.path().to_owned());
    Ok(folder)
}

/// Listens from now on. Where no handler can be set, the system ends the command in its own way.
pub fn listen() {
    let _ = ctrlc::set_handler(|| {
        let unfinished = unfinished();
        unfinished.remove();
        let what = match (unfinished.is_written, unfinished.keeps_parts) {
            (true, _) => "the files are written",
            (false, true) => "what is done is kept; the same command goes on from there",
            (false, false) => "no file was written",
        };
        let cut = if stdout::is_writing() { "; standard output is incomplete" } else { "" };
        let _ = writeln!(io::stderr(), "interrupted: {what}{cut}");
        std::process::exit(INTERRUPTED);
    });
}
