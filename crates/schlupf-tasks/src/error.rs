//! Why a task cannot be done.

use schlupf_case::{CaseError, CaseErrors};

/// Why a task cannot be done.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TaskError {
    /// The case is wrong, or its solution failed.
    Case(CaseErrors),
    /// What was asked of it is wrong, beside the case.
    Request(String),
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

impl std::fmt::Display for TaskError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Case(errors) => errors.fmt(f),
            Self::Request(message) => f.write_str(message),
        }
    }
}

impl std::error::Error for TaskError {}
