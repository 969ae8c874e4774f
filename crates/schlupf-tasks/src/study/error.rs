//! Why a study cannot be read, run or merged.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use schlupf_case::{CaseError, CaseErrors};

/// Why a study cannot be read, run or merged.
#[derive(Debug)]
#[non_exhaustive]
pub enum StudyError {
    /// The study or its case is wrong.
    Input(CaseErrors),
    /// A file cannot be read or written.
    File {
        /// Which one.
        path: PathBuf,
        /// Why.
        cause: io::Error,
    },
    /// A table is not what it must be.
    Table {
        /// Which one.
        path: PathBuf,
        /// A sentence about it.
        reason: String,
    },
    /// Whoever watched had it stopped.
    Stopped,
}

impl StudyError {
    pub(crate) fn file(path: &Path, cause: impl Into<io::Error>) -> Self {
        Self::File { path: path.to_owned(), cause: cause.into() }
    }

    pub(crate) fn table(path: &Path, reason: impl Into<String>) -> Self {
        Self::Table { path: path.to_owned(), reason: reason.into() }
    }
}

impl From<CaseErrors> for StudyError {
    fn from(errors: CaseErrors) -> Self {
        Self::Input(errors)
    }
}

impl From<CaseError> for StudyError {
    fn from(error: CaseError) -> Self {
        Self::Input(error.into())
    }
}

impl fmt::Display for StudyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(errors) => errors.fmt(f),
            Self::File { path, cause } => write!(f, "{}: {cause}", path.display()),
            Self::Table { path, reason } => write!(f, "{}: {reason}", path.display()),
            Self::Stopped => f.write_str("stopped"),
        }
    }
}

impl std::error::Error for StudyError {}
