//! The batches that are done, each a file in a folder beside the table, so that a run that ends
//! early goes on where it was.

use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use crate::error::StudyError;
use crate::table::{Contents, Rows, read_rows, write_rows};

/// The name of the file that says what the batches are of.
const MANIFEST: &str = "manifest.json";

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
        let mut name = output.file_name().unwrap_or_default().to_owned();
        name.push(".parts");
        let folder = output.with_file_name(name);
        let mut parts = Self { folder, is_new: false };
        let wanted = serde_json::to_vec_pretty(contents);
        let wanted = wanted.map_err(|error| StudyError::file(&parts.folder, error))?;
        match fs::create_dir(&parts.folder) {
            Ok(()) => {}
            Err(cause) if cause.kind() == ErrorKind::AlreadyExists => {}
            Err(cause) => return Err(StudyError::file(&parts.folder, cause)),
        }
        match fs::read(parts.folder.join(MANIFEST)) {
            Ok(found) if found == wanted => Ok(parts),
            Ok(_) => {
                let reason = "it has batches of another study or shard: remove it to begin anew, \
                              or name another output";
                Err(StudyError::table(&parts.folder, reason))
            }
            Err(cause) if cause.kind() == ErrorKind::NotFound => {
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
        match rows.first().map_or(0, crate::table::Cells::len) {
            found if found == wanted => Ok(rows),
            found => {
                let reason = format!("it has {found} rows, but should have {wanted}: remove it");
                Err(StudyError::table(&path, reason))
            }
        }
    }

    /// Removes it all; what cannot be removed stays.
    pub fn remove(self) {
        let _ = fs::remove_dir_all(&self.folder);
    }

    fn path(&self, batch: usize) -> PathBuf {
        self.folder.join(name(batch))
    }

    /// Writes a file whole or not at all.
    fn put(&self, name: &str, bytes: &[u8]) -> Result<(), StudyError> {
        let path = self.folder.join(name);
        let fail = |cause| StudyError::file(&path, cause);
        let mut file = tempfile::NamedTempFile::new_in(&self.folder).map_err(fail)?;
        file.write_all(bytes).map_err(fail)?;
        file.as_file().sync_all().map_err(fail)?;
        file.persist(&path).map_err(|error| StudyError::file(&path, error.error))?;
        sync(&self.folder);
        Ok(())
    }
}

fn name(batch: usize) -> String {
    format!("batch-{batch:08}.csv")
}

/// Lets a file be read as any other new file, not by its owner alone as a temporary one.
pub(crate) fn make_readable(path: &Path) {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let _ = fs::set_permissions(path, fs::Permissions::from_mode(0o644));
    }
    #[cfg(not(unix))]
    let _ = path;
}

/// Makes sure that names of a folder are on the disk, where the system can do that.
pub(crate) fn sync(folder: &Path) {
    let folder = if folder == Path::new("") { Path::new(".") } else { folder };
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
}
