//! Output files: checked before the work, written whole or not at all.

use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use schlupf_case::CaseFile;
use schlupf_tasks::study::lock::OutputLock;
use tempfile::NamedTempFile;

use crate::arguments::CaseArguments;
use crate::failure::Failure;
use crate::interrupt;

/// A file that is read and must not be overwritten.
#[derive(Debug)]
pub struct Input {
    /// What it is, for messages.
    pub what: String,
    /// Where it is.
    pub path: PathBuf,
    /// The option that may write it all the same.
    pub except: Option<String>,
}

/// A file that is to be written.
#[derive(Debug, Clone)]
pub struct Output {
    /// The option that names it, or the directory that it stands in.
    pub option: String,
    /// Where it goes.
    pub path: PathBuf,
}

/// A directory, which may be missing yet, that an option fills with files.
#[derive(Debug)]
pub struct Directory<'a> {
    /// The option.
    pub option: &'static str,
    /// Where it is.
    pub path: &'a Path,
    /// Names of the files.
    pub names: Vec<String>,
}

/// Checks output paths before the work: they are no `-`, their directories exist or can be made,
/// files can be made there, they are no directories, and no two are the same file.
pub fn check(outputs: &[Output], directory: Option<&Directory>) -> Result<(), Failure> {
    if let Some(Directory { option, path, .. }) = directory {
        refuse_stdout(option, "directory", path)?;
        check_directory(path)?;
    }
    for Output { option, path } in outputs {
        refuse_stdout(option, "file", path)?;
        if !is_special(path) {
            check_directory(directory_of(path))?;
        }
    }
    let mut taken: Vec<Output> = Vec::new();
    for Output { option, path } in &all_files(outputs, directory) {
        if path.is_dir() {
            return Err(Failure::file(path, io::Error::from(ErrorKind::IsADirectory)));
        }
        let location = location(path)?;
        if let Some(other) = taken.iter().find(|other| other.path == location) {
            return Err(shared(option, path, &format!("that of {}", other.option)));
        }
        // Several outputs may go to /dev/null.
        if !is_special(path) {
            taken.push(Output { option: option.clone(), path: location });
        }
    }
    let Some(Directory { option, path, .. }) = directory else { return Ok(()) };
    // A directory can be made neither in place of a file nor below one.
    let location = resolved(path);
    match taken.iter().find(|other| location.starts_with(&other.path)) {
        Some(other) => Err(shared(option, path, &format!("that of {}", other.option))),
        None => Ok(()),
    }
}

/// Refuses outputs that would write over an input.
pub fn refuse_inputs(
    outputs: &[Output],
    directory: Option<&Directory>,
    inputs: &[Input],
) -> Result<(), Failure> {
    for Output { option, path } in &all_files(outputs, directory) {
        let location = location(path)?;
        if let Some(input) = inputs.iter().find(|input| input.is_at(&location, option)) {
            return Err(shared(option, path, &input.what));
        }
    }
    Ok(())
}

/// The files, with those of the directory.
fn all_files(outputs: &[Output], directory: Option<&Directory>) -> Vec<Output> {
    let mut files = outputs.to_vec();
    if let Some(Directory { option, path, names }) = directory {
        // In a directory that is still to be made nothing is in the way.
        let names = names.iter().filter(|_| path.is_dir());
        let output = |name: &String| Output { option: (*option).to_owned(), path: path.join(name) };
        files.extend(names.map(output));
    }
    files
}

fn shared(option: &str, path: &Path, other: &str) -> Failure {
    let path = path.display();
    Failure::Arguments(format!("{option} must write files of its own, but {path} is also {other}"))
}

fn refuse_stdout(option: &str, what: &str, path: &Path) -> Result<(), Failure> {
    if path != Path::new("-") {
        return Ok(());
    }
    let message = format!(
        "{option} must name a {what}, but is `-`: only --json writes to standard output \
         (a {what} of that name is `./-`)"
    );
    Err(Failure::Arguments(message))
}

impl Input {
    /// The case file and what it names: files that nothing may overwrite.
    pub fn of_case(arguments: &CaseArguments, case: &CaseFile) -> Vec<Self> {
        let input = |what: String, path: &Path| Self { what, path: path.to_owned(), except: None };
        let file = arguments.case.iter().map(|path| input("the case file".to_owned(), path));
        let named = case.files();
        let named = named.iter().map(|(field, path)| input(format!("that of {field}"), path));
        file.chain(named).collect()
    }

    /// Whether an option would write over it: over the name it was given by, or what that links to.
    fn is_at(&self, output: &Path, option: &str) -> bool {
        let named = location(&self.path).is_ok_and(|path| path == output);
        let linked = fs::canonicalize(&self.path).is_ok_and(|path| path == output);
        self.except.as_deref() != Some(option) && !is_special(&self.path) && (named || linked)
    }
}

/// Checks that a directory exists or can be created, and files in it.
fn check_directory(path: &Path) -> Result<(), Failure> {
    // The metadata of a link that leads nowhere are those of the link.
    let existing = path.ancestors().find(|part| fs::symlink_metadata(part).is_ok());
    let existing = existing.unwrap_or(Path::new("."));
    if !existing.is_dir() {
        return Err(Failure::file(path, io::Error::from(ErrorKind::NotADirectory)));
    }
    // No interruption while it is there.
    let _unfinished = interrupt::unfinished();
    let tried = tempfile::Builder::new().prefix(UNFINISHED).tempfile_in(existing);
    tried.map(drop).map_err(|cause| {
        let message = format!("no file can be made in {}: {cause}", existing.display());
        Failure::file(path, io::Error::new(cause.kind(), message))
    })
}

/// What names of files begin with that are not whole.
const UNFINISHED: &str = ".schlupf-";

/// The path with that part of it resolved which exists.
fn resolved(path: &Path) -> PathBuf {
    for ancestor in path.ancestors() {
        let start = if ancestor == Path::new("") { Path::new(".") } else { ancestor };
        if let Ok(start) = fs::canonicalize(start) {
            let rest = path.strip_prefix(ancestor).unwrap_or(Path::new(""));
            return rest.components().fold(start, |path, part| path.join(part));
        }
    }
    path.to_owned()
}

/// The path with its directory resolved.
fn location(path: &Path) -> Result<PathBuf, Failure> {
    match path.file_name() {
        Some(name) => Ok(resolved(directory_of(path)).join(name)),
        None => Err(Failure::file(path, io::Error::from(ErrorKind::IsADirectory))),
    }
}

fn directory_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}

/// Whether it is a device or a pipe, which must not be replaced by a file.
fn is_special(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

/// Outputs that are locked, in directories that are there.
#[derive(Debug, Default)]
pub struct Reserved {
    locks: Vec<OutputLock>,
    created: Created,
}

/// Makes the directories of outputs, and refuses those that another run writes.
pub fn reserve(outputs: &[Output], directory: Option<&Directory>) -> Result<Reserved, Failure> {
    let paths = outputs.iter().map(|output| output.path.as_path());
    let mut reserved = Reserved::default();
    for path in paths.chain(directory.map(|directory| directory.path)) {
        // Devices and the root directory are nobody's.
        if is_special(path) || path.file_name().is_none() {
            continue;
        }
        reserved.created.directory(directory_of(path))?;
        let lock = OutputLock::take(path).map_err(|cause| Failure::file(path, cause))?;
        reserved.locks.push(lock);
    }
    Ok(reserved)
}

impl Drop for Reserved {
    fn drop(&mut self) {
        self.locks.clear();
        // Those without a file in them.
        self.created.remove();
    }
}

/// Makes the directory of an output; it goes with what is returned if it is empty then.
pub fn make_directory(path: &Path) -> Result<Reserved, Failure> {
    let mut reserved = Reserved::default();
    if !is_special(path) {
        reserved.created.directory(directory_of(path))?;
    }
    Ok(reserved)
}

/// Writes all files: first to temporary ones beside them, then renames those. Their directories and
/// `directory` are created before if they are missing. On failure, what this run has created is
/// removed again.
pub fn write(files: &[(PathBuf, Vec<u8>)], directory: Option<&Path>) -> Result<(), Failure> {
    let mut created = Created::default();
    let result = created.write(files, directory);
    if result.is_err() {
        created.remove();
    }
    result
}

/// Removes files; what cannot be removed stays.
pub fn remove(files: &[PathBuf]) {
    for file in files {
        let _ = fs::remove_file(file);
    }
}

/// What was not there before.
#[derive(Debug, Default)]
struct Created {
    /// From the outermost inwards.
    directories: Vec<PathBuf>,
    files: Vec<PathBuf>,
}

impl Created {
    fn write(
        &mut self,
        files: &[(PathBuf, Vec<u8>)],
        directory: Option<&Path>,
    ) -> Result<(), Failure> {
        if let Some(directory) = directory {
            self.directory(directory)?;
        }
        let (special, plain): (Vec<_>, Vec<_>) =
            files.iter().partition(|(path, _)| is_special(path));
        for (path, _) in &plain {
            self.directory(directory_of(path))?;
        }
        let mut pending = Vec::new();
        for (path, bytes) in plain {
            let file = temporary(path, bytes).map_err(|cause| Failure::file(path, cause))?;
            pending.push((path, file));
        }
        for (path, bytes) in special {
            fs::write(path, bytes).map_err(|cause| Failure::file(path, cause))?;
        }
        let mut unfinished = interrupt::unfinished();
        for (path, file) in pending {
            let is_new = fs::symlink_metadata(path).is_err();
            file.persist(path).map_err(|error| Failure::file(path, error.error))?;
            if is_new {
                self.files.push(path.clone());
            }
        }
        unfinished.finish(!files.is_empty());
        Ok(())
    }

    fn directory(&mut self, path: &Path) -> Result<(), Failure> {
        let is_missing = |part: &&Path| *part != Path::new("") && !part.exists();
        let missing: Vec<&Path> = path.ancestors().take_while(is_missing).collect();
        for part in missing.into_iter().rev() {
            let mut unfinished = interrupt::unfinished();
            match fs::create_dir(part) {
                Ok(()) => {
                    unfinished.directory(part);
                    self.directories.push(part.to_owned());
                }
                Err(_) if part.is_dir() => {}
                Err(cause) => return Err(Failure::file(part, cause)),
            }
        }
        Ok(())
    }

    /// Removes all of it. What cannot be removed stays: the failure to tell is another.
    fn remove(&self) {
        for file in &self.files {
            let _ = fs::remove_file(file);
        }
        for directory in self.directories.iter().rev() {
            let _ = fs::remove_dir(directory);
        }
    }
}

/// Writes a file unless there is one.
pub fn write_new(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let _directory = make_directory(path)?;
    let file = temporary(path, bytes).map_err(|cause| Failure::file(path, cause))?;
    file.persist_noclobber(path).map_err(|error| Failure::file(path, error.error))?;
    Ok(())
}

fn temporary(path: &Path, bytes: &[u8]) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(UNFINISHED);
    #[cfg(unix)]
    {
        // As any other new file, not readable by its owner alone; the umask still applies.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut unfinished = interrupt::unfinished();
    let mut file = builder.tempfile_in(directory_of(path))?;
    unfinished.file(file.path());
    drop(unfinished);
    file.write_all(bytes)?;
    file.flush()?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_leaves_nothing_new_behind() {
        let folder = tempfile::tempdir().unwrap();
        let figures = folder.path().join("a/b");
        fs::create_dir_all(folder.path().join("blocked/x")).unwrap();
        let files = ["a/b/1", "2", "blocked"].map(|name| (folder.path().join(name), vec![1]));
        assert!(write(&files, Some(&figures)).is_err());
        let left: Vec<_> = fs::read_dir(folder.path()).unwrap().collect();
        assert_eq!(left.len(), 1, "{left:?}");
        write(&files[..2], Some(&figures)).unwrap();
        assert!(figures.join("1").exists());
    }
}
