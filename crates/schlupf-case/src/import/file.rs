//! Inputs of other programs as case files.

use std::collections::BTreeMap;
use std::fs::File;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use crate::files::text;
use crate::import::contact::{self, Import, ImportedCase, Options, WheelBody};
use crate::{
    CaseError, CaseErrors, CaseFile, Files, LARGEST_FILE, Overrides, Place, Source, read_up_to,
};

/// Largest input file that is read, in bytes.
pub const LARGEST_INPUT: u64 = 256 << 20;

/// What is imported, and where to.
#[derive(Debug, Clone, Copy)]
pub struct Request<'a> {
    /// The input file.
    pub path: &'a Path,
    /// The folder of the case files; that of the input file by default.
    pub folder: Option<&'a Path>,
    /// Which body of module 3 is the wheel.
    pub wheel: WheelBody,
}

impl<'a> Request<'a> {
    /// The folder of the case files.
    pub fn output(&self) -> &'a Path {
        self.folder.unwrap_or_else(|| folder_of(self.path))
    }
}

/// The files of a case: those that were made with it, and those of a folder, which may be missing
/// yet.
#[derive(Debug)]
struct Beside {
    made: BTreeMap<String, Vec<u8>>,
    folder: PathBuf,
}

impl Files for Beside {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        match self.made.get(name) {
            Some(bytes) => Ok(bytes.clone()),
            None => read_up_to(LARGEST_FILE, File::open(self.locate(name))?),
        }
    }

    fn locate(&self, name: &str) -> PathBuf {
        resolved(&self.folder.join(name))
    }
}

/// An absolute path without `..`, also through folders that are missing yet, which are no links.
fn resolved(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or(path.to_owned());
    let mut resolved = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(resolved.pop()),
            part => resolved.push(part),
        }
        if let Ok(existing) = resolved.canonicalize() {
            resolved = existing;
        }
    }
    resolved
}

/// Imports an input file of CONTACT. Every case file that it returns was read and checked.
///
/// # Errors
/// A file that cannot be read. What is wrong in it, or not available, is part of the result.
pub fn contact_file(request: Request) -> Result<Import, CaseErrors> {
    let name = request.path.display().to_string();
    let unreadable =
        |message: String| CaseError::new("", message, Place::File { name: name.clone() });
    let bytes = File::open(request.path).and_then(|file| read_up_to(LARGEST_INPUT, file));
    let bytes = bytes.map_err(|error| {
        let message = format!("the input file cannot be read: {error}");
        unreadable(message).of_file(request.path, &error)
    })?;
    let Some(text) = text(&bytes) else {
        let message = "the input file must be text, but is not".to_owned();
        return Err(unreadable(message).into());
    };
    let source = Arc::new(Source { name, text });
    let stem = request.path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let options = Options {
        stem: stem.unwrap_or_default(),
        folder: relative(request.output(), folder_of(request.path)),
        wheel: request.wheel,
    };
    let mut import = contact::import(&source, &options);
    let is_empty = [import.cases.len(), import.refused.len(), import.skipped.len()] == [0; 3];
    if is_empty && import.errors.is_empty() {
        let place = Place::File { name: source.name.clone() };
        let message = "the input file has no cases: it begins with MODULE = 0, or is empty";
        import.errors.push(CaseError::new("MODULE", message, place));
    }
    let mut accepted = Vec::new();
    for case in std::mem::take(&mut import.cases) {
        match read(&case, request.output()) {
            Ok(_) => accepted.push(case),
            Err(errors) => {
                import.refused.extend(&case.numbers);
                for error in errors.iter().map(|error| at_case(&case, error)) {
                    // A profile is missing once, in however many cases.
                    if !import.errors.contains(&error) {
                        import.errors.push(error);
                    }
                }
            }
        }
    }
    import.errors.sort_by_key(|error| error.place.order());
    import.refused.sort_unstable();
    import.cases = accepted;
    Ok(import)
}

/// The case of a case file that was imported; it need not be written.
pub fn read(case: &ImportedCase, output: &Path) -> Result<CaseFile, CaseErrors> {
    let made = case.files.iter().cloned().collect();
    let files = Arc::new(Beside { made, folder: output.to_owned() });
    CaseFile::from_str(&case.text, &case.name, files, Overrides::NONE)
}

/// What a case file is refused for, at the place that it was made from.
fn at_case(case: &ImportedCase, error: &CaseError) -> CaseError {
    let named = case.places.iter().find(|(field, _)| **field == *error.field);
    let (place, message) = if let Some((_, place)) = named {
        (place.clone(), error.message.clone())
    } else {
        let number = case.numbers.first().copied().unwrap_or_default();
        (case.place.clone(), format!("case {number}: {}", error.message))
    };
    CaseError {
        cause: error.cause,
        help: error.help.clone(),
        unread: error.unread.clone(),
        ..CaseError::new(&error.field, message, place)
    }
}

fn folder_of(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

/// What to put before a path that is relative to one folder for it to be relative to another:
/// empty, or with a slash at its end.
fn relative(from: &Path, to: &Path) -> String {
    let [from, to] =
        [from, to].map(|path| resolved(if path == Path::new("") { Path::new(".") } else { path }));
    let common = from.components().zip(to.components()).take_while(|(a, b)| a == b).count();
    if common == 0 {
        return format!("{}/", to.display());
    }
    let up = from.components().skip(common).map(|_| "..".to_owned());
    let down = to.components().skip(common).filter_map(|part| match part {
        Component::Normal(name) => Some(name.to_string_lossy().into_owned()),
        _ => None,
    });
    up.chain(down).map(|part| part + "/").collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_lead_from_one_folder_to_another() {
        let relative = |from: &str, to: &str| relative(Path::new(from), Path::new(to));
        assert_eq!(relative("/nowhere/a", "/nowhere/a"), "");
        assert_eq!(relative("/nowhere/a", "/nowhere/b/c"), "../b/c/");
        assert_eq!(relative("/nowhere/a/b", "/nowhere"), "../../");
        assert_eq!(relative("", ""), "");
    }
}
