//! Errors as exceptions of the package, which are defined in `schlupf._errors`.

use std::io;
use std::path::Path;

use pyo3::IntoPyObjectExt;
use pyo3::exceptions::{PyKeyboardInterrupt, PyOSError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use schlupf_case::error::Unread;
use schlupf_case::{CaseError, CaseErrors, Cause};

/// The exception for errors of a case: `schlupf.CaseError`, or that of their cause.
pub fn of_case(py: Python<'_>, errors: &CaseErrors) -> PyErr {
    match errors.first.cause {
        Cause::Stopped => PyKeyboardInterrupt::new_err(errors.to_string()),
        Cause::Input | Cause::NoContact => raised(py, "CaseError", errors),
        Cause::FileSystem => raised(py, "file_error", errors),
        Cause::NotConverged => raised(py, "CaseNotConverged", errors),
    }
}

/// An exception for a file that cannot be read or written, of the class that its reason has.
pub fn of_file(py: Python<'_>, path: &Path, cause: &io::Error) -> PyErr {
    let reason = errno(cause.kind(), cause.raw_os_error());
    let text = without_number(&cause.to_string(), cause.raw_os_error());
    let arguments = (reason, text, path.as_os_str());
    let made = py.get_type::<PyOSError>().call1(arguments);
    made.map_or_else(|error| error, PyErr::from_value)
}

/// A message without the number of its reason, which is an attribute of the exception.
fn without_number(message: &str, code: Option<i32>) -> String {
    code.map_or_else(
        || message.to_owned(),
        |code| message.replace(&format!(" (os error {code})"), ""),
    )
}

/// The number of C for a reason.
fn errno(kind: io::ErrorKind, code: Option<i32>) -> i32 {
    match kind {
        io::ErrorKind::NotFound => 2,
        io::ErrorKind::PermissionDenied => 13,
        io::ErrorKind::IsADirectory => 21,
        _ => code.unwrap_or(5),
    }
}

fn raised(py: Python<'_>, class: &str, errors: &CaseErrors) -> PyErr {
    let made = || -> PyResult<PyErr> {
        let list = PyList::empty(py);
        for error in errors.iter() {
            list.append(entry(py, error)?)?;
        }
        let class = py.import("schlupf._errors")?.getattr(class)?;
        Ok(PyErr::from_value(class.call1((list,))?))
    };
    made().unwrap_or_else(|error| error)
}

fn entry<'py>(py: Python<'py>, error: &CaseError) -> PyResult<Bound<'py, PyDict>> {
    let entry = PyDict::new(py);
    entry.set_item("field", &error.field)?;
    let code = error.unread.as_deref().and_then(|unread| unread.code);
    entry.set_item("message", without_number(&error.message, code))?;
    entry.set_item("place", error.place.to_string())?;
    if let Some(Unread { path, kind, code }) = error.unread.as_deref() {
        entry.set_item("filename", path.as_os_str())?;
        entry.set_item("errno", errno(*kind, *code))?;
    }
    entry.set_item("help", error.help.as_deref().into_bound_py_any(py)?)?;
    Ok(entry)
}
