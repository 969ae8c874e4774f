//! What a case can be asked: see the crate of tasks.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::exceptions::{PyKeyError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString, PyTuple};
use schlupf::Status;
use schlupf_case::{CaseError, CaseErrors, CaseFile as Case, Folder, InputFile, Overrides, Place};
use schlupf_tasks::request::{Field, Need};
use schlupf_tasks::task::Found;
use schlupf_tasks::{Asked, Entry, Face, Given, TaskError, Value, Wanted, study};

use crate::case_file::CaseFile;
use crate::errors;
use crate::report::Report;
use crate::study::raised;

/// Does a task: its name, its case (by default the standard one) with the folder that its files lie
/// in, and what it is asked. Ctrl-C stops it.
#[pyfunction]
pub fn run(
    py: Python<'_>,
    name: &str,
    case: Option<PyRef<'_, CaseFile>>,
    folder: PathBuf,
    request: &Bound<'_, PyDict>,
) -> PyResult<Report> {
    let task = schlupf_tasks::find(name).ok_or_else(|| PyKeyError::new_err(name.to_owned()))?;
    let work = (task.read)(&asked(task, request)?).map_err(|error| failed(py, error))?;
    // What is part of a result is there, whether it is asked for later or not.
    let parts = (task.own_files)().iter().filter(|file| file.is_part);
    let files = parts.map(|file| (file.format, folder.join(file.option))).collect();
    let wanted = Wanted { files, ..Wanted::default() };
    let is_default = case.is_none();
    let case = match case {
        Some(case) => case,
        None => Bound::new(py, CaseFile::new_from(default_case(py)?))?.borrow(),
    };
    let found = case.run(py, &Arc::default(), |case, watch| {
        let given = Given { is_default, scratch: &study::scratch, ..Given::of(case) };
        work(&given, &wanted, watch)
    })?;
    match found {
        // That it has not converged explains more.
        Ok(Found { report, failure: Some(errors) }) if report.status() == Status::Converged => {
            Err(errors::of_case(py, &errors))
        }
        Ok(found) => Ok(Report::new(found.report)),
        Err(error) => Err(failed(py, error)),
    }
}

/// Why a task cannot be done, as an exception.
fn failed(py: Python<'_>, error: TaskError) -> PyErr {
    match error {
        TaskError::Case(errors) => errors::of_case(py, &errors),
        TaskError::Study(error) => raised(py, error),
        TaskError::Request(message) => {
            let place = Place::File { name: String::new() };
            errors::of_case(py, &CaseError::new("", message, place).into())
        }
    }
}

fn default_case(py: Python<'_>) -> PyResult<Case> {
    let text = Case::default_text();
    let case = Case::from_str(&text, "default case", Folder::new(""), Overrides::NONE);
    case.map_err(|errors: CaseErrors| errors::of_case(py, &errors))
}

/// The request that a dictionary makes; what is `None` in it is left out.
fn asked(task: &Entry, request: &Bound<'_, PyDict>) -> PyResult<Asked> {
    Asked::new(Face::Functions, (task.fields)(), |field| {
        let value = request.get_item(field.name)?.filter(|value| !value.is_none());
        value.map(|value| converted(field, &value)).into_iter().collect()
    })
}

/// A value of Python.
fn converted(field: &Field, value: &Bound<'_, PyAny>) -> PyResult<Value> {
    // NumPy's booleans, too.
    if let Ok(flag) = value.extract::<bool>() {
        return Ok(Value::Flag(flag));
    }
    let is_path = value.is_instance_of::<PyString>() || value.hasattr("__fspath__")?;
    if field.form.is_file() && (field.need != Need::Several || is_path) {
        return Ok(Value::File(InputFile::at(&value.extract::<PathBuf>()?)));
    }
    if let Ok(text) = value.extract::<String>() {
        return Ok(Value::Text(text));
    }
    if let Ok(number) = value.extract::<f64>() {
        return Ok(Value::Number(number));
    }
    let Ok(parts) = value.try_iter() else {
        let kind = value.get_type().name()?;
        return Err(PyTypeError::new_err(format!(
            "{} must be text, a number or a sequence of them, but is of type {kind}",
            field.name
        )));
    };
    let parts = parts.map(|part| converted(field, &part?)).collect::<PyResult<Vec<_>>>()?;
    let is_range = value.is_instance_of::<PyTuple>() && field.form.is_points();
    Ok(match <[Value; 2]>::try_from(parts) {
        Ok(ends) if is_range => Value::Range(Box::new(ends)),
        Ok(both) => Value::List(both.into()),
        Err(parts) => Value::List(parts),
    })
}
