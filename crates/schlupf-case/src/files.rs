//! Where the files that a case names come from.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Largest file of data that is read, in bytes.
pub const LARGEST_FILE: u64 = 1 << 30;

/// Reads up to so many bytes.
///
/// # Errors
/// Whatever keeps them from being read, and more bytes.
pub fn read_up_to(most: u64, reader: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    reader.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        let most = most >> 20;
        return Err(io::Error::other(format!(
            "it is larger than {most} MiB, the most that is read"
        )));
    }
    Ok(bytes)
}

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
        read_up_to(LARGEST_FILE, File::open(self.locate(name))?)
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
        read_up_to(LARGEST_FILE, File::open(self.locate(name))?)
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
