//! What there is, from which the package makes its documentation, its conversion of numbers and its
//! completion; and the command.

use std::ffi::OsString;

use pyo3::prelude::*;

/// Sections and fields of a case, tasks and presets, as JSON.
#[pyfunction]
pub fn catalogue() -> String {
    schlupf_tasks::catalogue().to_string()
}

/// The codes of all warnings and what they mean.
#[pyfunction]
pub fn warning_codes() -> Vec<(&'static str, &'static str)> {
    schlupf_tasks::warning_codes()
}

/// The codes of all errors and what they mean.
#[pyfunction]
pub fn error_codes() -> Vec<(&'static str, &'static str)> {
    schlupf::Error::codes()
}

/// The command `schlupf` with its name and its arguments; returns its exit code.
#[pyfunction]
pub fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| schlupf_cli::main(arguments))
}
