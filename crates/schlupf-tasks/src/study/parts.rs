//! The batches that are done, each a file in a folder beside the table, so that a run that ends
//! early goes on where it was.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::study::error::StudyError;
use crate::study::table::{Contents, Rows, read_rows, write_rows};

/// The name of the file that says what the batches are of.
const MANIFEST: &str = "manifest.json";

/// What names of files begin with that are not whole.
const UNFINISHED: &str = ".schlupf-";

/// What names of batches begin with.
const BATCH: &str = "batch-";

/// The folder of the batches of a table.
#[derive(Debug)]
pub(crate) struct Parts {
    folder: PathBuf,
    is_new: bool,
}

impl Parts {
    /// That of a table; makes it where it is missing.
    ///
    /// # Errors
    /// A folder with batches of another study, or one that cannot be made.
    pub fn of(output: &Path, contents: &Contents) -> Result<Self, StudyError> {
        let mut parts = Self { folder: folder_of(output), is_new: false };
        let wanted = manifest(&parts.folder, contents)?;
        match fs::create_dir(&parts.folder) {
            Ok(()) => {}
            Err(cause) if cause.kind() == ErrorKind::AlreadyExists => {}
            Err(cause) => return Err(StudyError::file(&parts.folder, cause)),
        }
        match fs::read(parts.folder.join(MANIFEST)) {
            Ok(found) if found == wanted => {
                parts.clear(|name| name.starts_with(UNFINISHED));
                Ok(parts)
            }
            Ok(found) => {
                let found = serde_json::from_slice::<Contents>(&found);
                let unknown = |_| "another study".to_owned();
                let what = found.map_or_else(unknown, |found| contents.other(&found));
                let reason = format!(
                    "it has batches of {what}: remove it to begin anew, or name another output"
                );
                Err(StudyError::table(&parts.folder, reason))
            }
            Err(cause) if cause.kind() == ErrorKind::NotFound => {
                // Nobody knows of which study batches without a manifest are.
                parts.clear(|name| name.starts_with(UNFINISHED) || name.starts_with(BATCH));
                parts.is_new = true;
                parts.put(MANIFEST, &wanted)?;
                Ok(parts)
            }
            Err(cause) => Err(StudyError::file(&parts.folder.join(MANIFEST), cause)),
        }
    }

    /// Whether there were no batches of an earlier run.
    pub fn is_new(&self) -> bool {
        self.is_new
    }

    /// Whether a batch is done.
    pub fn has(&self, batch: usize) -> bool {
        self.path(batch).is_file()
    }

    /// Keeps the rows of a batch: they are on the disk then.
    pub fn keep(&self, batch: usize, rows: &Rows) -> Result<(), StudyError> {
        let mut bytes = Vec::new();
        write_rows(&mut bytes, rows).map_err(|cause| StudyError::file(&self.path(batch), cause))?;
        self.put(&name(batch), &bytes)
    }

    /// The rows of a batch that is done.
    pub fn rows(&self, batch: usize, contents: &Contents) -> Result<Rows, StudyError> {
        let path = self.path(batch);
        let file = File::open(&path).map_err(|cause| StudyError::file(&path, cause))?;
        let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(file);
        let wanted = contents.rows_of(batch).len();
        let rows = read_rows(&mut reader, &contents.columns, wanted);
        let rows = rows.map_err(|reason| StudyError::table(&path, reason))?;
        match rows.first().map_or(0, crate::study::table::Cells::len) {
            found if found == wanted => Ok(rows),
            found => {
                let reason = format!("it has {found} rows, but should have {wanted}: remove it");
                Err(StudyError::table(&path, reason))
            }
        }
    }

    /// Removes it all, the manifest last; what cannot be removed stays.
    pub fn remove(self) {
        self.clear(|name| name != MANIFEST);
        let _ = fs::remove_dir_all(&self.folder);
    }

    /// Removes what a run has left that was killed after its table was in its place.
    pub fn remove_done(output: &Path, contents: &Contents) -> Result<(), StudyError> {
        let parts = Self { folder: folder_of(output), is_new: false };
        let wanted = manifest(&parts.folder, contents)?;
        match fs::read(parts.folder.join(MANIFEST)) {
            Ok(found) if found == wanted => parts.remove(),
            Ok(_) => {}
            // Only if it is empty.
            Err(_) => drop(fs::remove_dir(&parts.folder)),
        }
        Ok(())
    }

    /// A file that is not whole, which a later run removes if this one is killed.
    pub fn unfinished(&self) -> io::Result<NamedTempFile> {
        unfinished(&self.folder)
    }

    fn clear(&self, is_removed: impl Fn(&str) -> bool) {
        for entry in fs::read_dir(&self.folder).into_iter().flatten().flatten() {
            if entry.file_name().to_str().is_some_and(&is_removed) {
                let _ = fs::remove_file(entry.path());
            }
        }
    }

    fn path(&self, batch: usize) -> PathBuf {
        self.folder.join(name(batch))
    }

    /// Writes a file whole or not at all.
    fn put(&self, name: &str, bytes: &[u8]) -> Result<(), StudyError> {
        let path = self.folder.join(name);
        let fail = |cause| StudyError::file(&path, cause);
        let mut file = self.unfinished().map_err(fail)?;
        file.write_all(bytes).map_err(fail)?;
        file.as_file().sync_all().map_err(fail)?;
        file.persist(&path).map_err(|error| StudyError::file(&path, error.error))?;
        sync(&self.folder);
        Ok(())
    }
}

fn name(batch: usize) -> String {
    format!("{BATCH}{batch:08}.csv")
}

fn folder_of(output: &Path) -> PathBuf {
    let mut name = output.file_name().unwrap_or_default().to_owned();
    name.push(".parts");
    output.with_file_name(name)
}

fn manifest(folder: &Path, contents: &Contents) -> Result<Vec<u8>, StudyError> {
    serde_json::to_vec_pretty(contents).map_err(|error| StudyError::file(folder, error))
}

/// A file that is not whole; who may read it is as for any other new file, while a temporary one
/// would be its owner's alone.
pub(crate) fn unfinished(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(UNFINISHED);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}

/// The folder with a file.
pub(crate) fn folder_with(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// Makes sure that names of a folder are on the disk, where the system can do that.
pub(crate) fn sync(folder: &Path) {
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
}
