//! Output files: checked before the work, written whole or not at all.

use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::failure::Failure;

/// Checks output paths before the work: their directories exist, they are no directories, no two are
/// the same file, and none is `input`.
pub fn check(outputs: &[(&str, &Path)], input: Option<&Path>) -> Result<(), Failure> {
    let mut seen: Vec<(&str, PathBuf)> = Vec::new();
    if let Some(input) = input.and_then(|input| location(input).ok()) {
        seen.push(("the case file", input));
    }
    for (option, path) in outputs {
        if path.is_dir() {
            return Err(Failure::file(path, io::Error::from(ErrorKind::IsADirectory)));
        }
        let location = location(path)?;
        if let Some((other, _)) = seen.iter().find(|(_, other)| *other == location) {
            let path = path.display();
            let message =
                format!("{option} must name a file of its own, but {path} is that of {other}, too");
            return Err(Failure::Arguments(message));
        }
        // Several outputs may go to /dev/null.
        if !is_special(path) {
            seen.push((option, location));
        }
    }
    Ok(())
}

/// Checks that a directory exists or can be created.
pub fn check_directory(path: &Path) -> Result<(), Failure> {
    if path.exists() && !path.is_dir() {
        return Err(Failure::file(path, io::Error::from(ErrorKind::NotADirectory)));
    }
    Ok(())
}

/// The path with its directory resolved.
fn location(path: &Path) -> Result<PathBuf, Failure> {
    let directory = directory(path);
    let resolved = fs::canonicalize(directory).map_err(|cause| {
        Failure::file(
            path,
            io::Error::new(cause.kind(), format!("its directory {}: {cause}", directory.display())),
        )
    })?;
    match path.file_name() {
        Some(name) => Ok(resolved.join(name)),
        None => Err(Failure::file(path, io::Error::from(ErrorKind::IsADirectory))),
    }
}

fn directory(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}

/// Whether it is a device or a pipe, which must not be replaced by a file.
fn is_special(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

/// Writes all files: first to temporary ones beside them, then renames those.
pub fn write(files: &[(PathBuf, Vec<u8>)]) -> Result<(), Failure> {
    let mut pending = Vec::new();
    for (path, bytes) in files {
        let failure = |cause| Failure::file(path, cause);
        if is_special(path) {
            fs::write(path, bytes).map_err(failure)?;
        } else {
            pending.push((path, temporary(path, bytes).map_err(failure)?));
        }
    }
    for (path, file) in pending {
        file.persist(path).map_err(|error| Failure::file(path, error.error))?;
    }
    Ok(())
}

/// Writes a file unless there is one.
pub fn write_new(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let file = temporary(path, bytes).map_err(|cause| Failure::file(path, cause))?;
    file.persist_noclobber(path).map_err(|error| Failure::file(path, error.error))?;
    Ok(())
}

fn temporary(path: &Path, bytes: &[u8]) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".schlupf-");
    #[cfg(unix)]
    {
        // As any other new file, not readable by its owner alone; the umask still applies.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(directory(path))?;
    file.write_all(bytes)?;
    file.flush()?;
    Ok(file)
}
