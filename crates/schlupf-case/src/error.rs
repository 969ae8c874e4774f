//! Why a case cannot be read.

use std::fmt;
use std::io;
use std::path::PathBuf;

use crate::place::Place;
use schlupf::reporting::shortened;

/// One thing that is wrong with a case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CaseError {
    /// Dotted path of the field; empty where the file as a whole is wrong.
    pub field: String,
    /// A sentence that names the field, what it must be and what it is.
    pub message: String,
    /// Where it stands.
    pub place: Place,
    /// What to do about it.
    pub help: Option<Box<str>>,
    /// Whose fault it is.
    pub cause: Cause,
    /// The file that cannot be read, where that is the fault.
    pub unread: Option<Box<Unread>>,
}

/// A file that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unread {
    /// Which one.
    pub path: PathBuf,
    /// Why.
    pub kind: io::ErrorKind,
    /// The system's number for that, if it has one.
    pub code: Option<i32>,
}

/// Whose fault an error is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// The input is wrong.
    Input,
    /// A file cannot be read.
    FileSystem,
    /// The input may be right, but what follows from it was not found.
    NotConverged,
    /// The wheel does not touch the rail.
    NoContact,
    /// Nobody: whoever watched had it stopped.
    Stopped,
}

impl CaseError {
    /// An error of the input.
    pub fn new(field: impl AsRef<str>, message: impl Into<String>, place: Place) -> Self {
        Self {
            field: shortened(field.as_ref()).into_owned(),
            message: message.into(),
            place,
            help: None,
            cause: Cause::Input,
            unread: None,
        }
    }

    /// A file that cannot be read.
    pub(crate) fn unreadable(field: &str, what: &str, name: &str, error: &io::Error) -> Self {
        let place = Place::File { name: name.to_owned() };
        Self::new(field, format!("{what} cannot be read: {error}"), place).of_file(name, error)
    }

    /// The same, because a file cannot be read.
    pub fn of_file(self, path: impl Into<PathBuf>, error: &io::Error) -> Self {
        let unread = Unread { path: path.into(), kind: error.kind(), code: error.raw_os_error() };
        Self { cause: Cause::FileSystem, unread: Some(Box::new(unread)), ..self }
    }

    /// The same with advice.
    pub fn help(self, help: impl Into<Option<String>>) -> Self {
        Self { help: help.into().map(String::into_boxed_str), ..self }
    }
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.message)?;
        match &self.help {
            Some(help) => write!(f, " ({help})"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for CaseError {}

/// Everything that was found wrong with a case: at least one error.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CaseErrors {
    /// The first one.
    pub first: Box<CaseError>,
    /// All others, in the order of the input.
    pub others: Vec<CaseError>,
}

impl CaseErrors {
    /// Fails if there are errors.
    pub fn check(errors: Vec<CaseError>) -> Result<(), Self> {
        let mut errors = errors.into_iter();
        match errors.next() {
            Some(first) => Err(Self { first: Box::new(first), others: errors.collect() }),
            None => Ok(()),
        }
    }

    /// All errors.
    pub fn iter(&self) -> impl Iterator<Item = &CaseError> {
        std::iter::once(&*self.first).chain(&self.others)
    }
}

impl From<CaseError> for CaseErrors {
    fn from(first: CaseError) -> Self {
        Self { first: Box::new(first), others: Vec::new() }
    }
}

impl fmt::Display for CaseErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<String> = self.iter().map(ToString::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for CaseErrors {}
