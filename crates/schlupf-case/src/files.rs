//! Where the files that a case names come from.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Finds the files that a case names: in a folder, in memory, or wherever the caller has them.
pub trait Files: Debug + Send + Sync {
    /// The bytes of a file, by the name that the case gives it.
    ///
    /// # Errors
    /// Whatever keeps it from being read.
    fn read(&self, name: &str) -> io::Result<Vec<u8>>;

    /// Where it lies: what messages call it, and what tells whether two names mean the same file.
    fn locate(&self, name: &str) -> PathBuf {
        PathBuf::from(name)
    }
}

/// Files of a folder: relative paths start there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Folder(PathBuf);

impl Folder {
    /// A folder; the working directory where the path is empty.
    pub fn new(path: impl Into<PathBuf>) -> Arc<Self> {
        Arc::new(Self(path.into()))
    }

    /// The folder of a file.
    pub fn of(path: &Path) -> Arc<Self> {
        Self::new(path.parent().unwrap_or(Path::new("")))
    }
}

impl Files for Folder {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        std::fs::read(self.locate(name))
    }

    fn locate(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

/// Files in memory, by their names.
impl Files for BTreeMap<String, Vec<u8>> {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        let bytes = self.get(name).cloned();
        bytes.ok_or_else(|| io::Error::new(io::ErrorKind::NotFound, "no such file was given"))
    }
}

/// Files anywhere, by other names than their paths, which need not be text.
impl Files for BTreeMap<String, PathBuf> {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        std::fs::read(self.locate(name))
    }

    fn locate(&self, name: &str) -> PathBuf {
        self.get(name).cloned().unwrap_or_else(|| PathBuf::from(name))
    }
}

/// One of them.
#[derive(Debug, Clone)]
pub struct InputFile {
    name: String,
    files: Arc<dyn Files>,
}

impl InputFile {
    /// A file that a case names.
    pub fn new(name: impl Into<String>, files: Arc<dyn Files>) -> Self {
        Self { name: name.into(), files }
    }

    /// A file by its path from the working directory.
    pub fn at(path: &Path) -> Self {
        let name = path.to_string_lossy().into_owned();
        Self::new(name.clone(), Arc::new(BTreeMap::from([(name, path.to_owned())])))
    }

    /// Where it lies.
    pub fn path(&self) -> PathBuf {
        self.files.locate(&self.name)
    }

    /// What is in it.
    ///
    /// # Errors
    /// Whatever keeps it from being read.
    pub fn read(&self) -> io::Result<Vec<u8>> {
        self.files.read(&self.name)
    }
}

impl PartialEq for InputFile {
    fn eq(&self, other: &Self) -> bool {
        self.path() == other.path()
    }
}
