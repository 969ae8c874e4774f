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
    use schlupf_case::Notice as OfCase;
    use schlupf_case::import::Notice as OfImport;
    use schlupf_tasks::Notice as OfTask;
    let codes = [schlupf::Warning::CODES, OfCase::CODES, OfImport::CODES, OfTask::CODES];
    let meanings =
        [schlupf::Warning::MEANINGS, OfCase::MEANINGS, OfImport::MEANINGS, OfTask::MEANINGS];
    let (codes, meanings) = (codes.concat(), meanings.concat());
    codes.into_iter().zip(meanings.into_iter().map(str::trim)).collect()
}

/// The codes of all errors and what they mean, without those of which the code is that of the error
/// within.
#[pyfunction]
pub fn error_codes() -> Vec<(&'static str, &'static str)> {
    use schlupf::Error;
    use schlupf::reporting::{FitError, ForceError, SurfaceError, WheelRailError};
    const OUTER: [&str; 6] =
        ["at-time", "no-rolling-at-patch", "surface", "fit", "force", "wheel-rail"];
    let codes = [
        Error::CODES,
        ForceError::CODES,
        SurfaceError::CODES,
        WheelRailError::CODES,
        FitError::CODES,
    ];
    let meanings = [
        Error::MEANINGS,
        ForceError::MEANINGS,
        SurfaceError::MEANINGS,
        WheelRailError::MEANINGS,
        FitError::MEANINGS,
    ];
    let all = codes.concat().into_iter().zip(meanings.concat().into_iter().map(str::trim));
    all.filter(|(code, _)| !OUTER.contains(code)).collect()
}

/// The command `schlupf` with its name and its arguments; returns its exit code.
#[pyfunction]
pub fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| schlupf_cli::main(arguments))
}
