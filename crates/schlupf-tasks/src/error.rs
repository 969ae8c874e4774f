//! Why a task cannot be done.

use schlupf_case::{CaseError, CaseErrors};

/// Why a task cannot be done.
#[derive(Debug)]
pub enum TaskError {
    /// The case is wrong, or its solution failed.
    Case(CaseErrors),
    /// What was asked of it is wrong, beside the case.
    Request(String),
    /// A study or its table is wrong, or cannot be read or written.
    #[cfg(feature = "study")]
    Study(crate::study::StudyError),
}

impl From<CaseErrors> for TaskError {
    fn from(errors: CaseErrors) -> Self {
        Self::Case(errors)
    }
}

impl From<CaseError> for TaskError {
    fn from(error: CaseError) -> Self {
        Self::Case(error.into())
    }
}

#[cfg(feature = "study")]
impl From<crate::study::StudyError> for TaskError {
    fn from(error: crate::study::StudyError) -> Self {
        Self::Study(error)
    }
}

impl std::fmt::Display for TaskError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Case(errors) => errors.fmt(f),
            Self::Request(message) => f.write_str(message),
            #[cfg(feature = "study")]
            Self::Study(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for TaskError {}
