//! Errors as exceptions of the package, which are defined in `schlupf._errors`.

use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use schlupf_case::{CaseError, CaseErrors, Cause};

/// The exception for errors of a case: `schlupf.CaseError`, or that of their cause.
pub fn of_case(py: Python<'_>, errors: &CaseErrors) -> PyErr {
    match errors.first.cause {
        Cause::Stopped => PyKeyboardInterrupt::new_err(errors.to_string()),
        Cause::Input | Cause::NoContact => raised(py, "CaseError", errors),
        Cause::FileSystem => raised(py, "CaseFileError", errors),
        Cause::NotConverged => raised(py, "CaseNotConverged", errors),
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
    entry.set_item("message", &error.message)?;
    entry.set_item("place", error.place.to_string())?;
    entry.set_item("help", error.help.as_ref().into_bound_py_any(py)?)?;
    Ok(entry)
}
