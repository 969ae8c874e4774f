//! What can go wrong, and with which exit code.

use std::io;
use std::path::{Path, PathBuf};

use schlupf_case::{CaseErrors, Cause};
use schlupf_tasks::TaskError;
use schlupf_tasks::output::figures::FigureError;
use schlupf_tasks::study::StudyError;

/// Exit code of what was done.
pub const SUCCESS: u8 = 0;

/// Exit code of results that did not converge.
pub const NOT_CONVERGED: u8 = 3;

/// Why the command cannot do what it was asked to.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The case is wrong.
    #[error(transparent)]
    Case(#[from] CaseErrors),
    /// The arguments are wrong in a way that the argument parser does not see.
    #[error("{0}")]
    Arguments(String),
    /// A file or directory cannot be read or written.
    #[error("{}: {cause}", path.display())]
    File {
        /// Which one.
        path: PathBuf,
        /// Why.
        cause: io::Error,
    },
    /// A figure cannot be drawn.
    #[error("figures: {0}")]
    Figures(#[from] FigureError),
}

impl From<TaskError> for Failure {
    fn from(error: TaskError) -> Self {
        match error {
            TaskError::Case(errors) => Self::Case(errors),
            TaskError::Request(message) => Self::Arguments(message),
            TaskError::Study(error) => error.into(),
        }
    }
}

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::Input(errors) => Self::Case(errors),
            StudyError::File { path, cause } => Self::File { path, cause },
            other => Self::Arguments(other.to_string()),
        }
    }
}

impl Failure {
    /// A failure of the file system.
    pub fn file(path: &Path, cause: impl Into<io::Error>) -> Self {
        Self::File { path: path.to_owned(), cause: cause.into() }
    }

    /// Exit code: 1 for the file system, 2 for the input, 3 where what it asks for was not found.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::File { .. } | Self::Figures(_) => 1,
            Self::Case(errors) if errors.first.cause == Cause::FileSystem => 1,
            Self::Case(errors) if errors.first.cause == Cause::NotConverged => NOT_CONVERGED,
            Self::Case(_) | Self::Arguments(_) => 2,
        }
    }
}
