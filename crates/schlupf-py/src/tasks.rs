//! What a case can be asked: see the crate of tasks.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use pyo3::exceptions::{PyKeyError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyList, PyString};
use schlupf::Status;
use schlupf_case::{CaseError, CaseErrors, CaseFile as Case, Folder, InputFile, Overrides, Place};
use schlupf_tasks::request::{Field, Form, Need};
use schlupf_tasks::task::Found;
use schlupf_tasks::{Asked, Entry, Face, Given, TASKS, TaskError, Value, Wanted, study};

use crate::case_file::CaseFile;
use crate::errors;
use crate::report::Report;
use crate::study::raised;

/// Does a task: its name, its case (by default the standard one), what it is asked, whether its
/// figures are wanted, and its own files that are wanted, with where they are going to lie. Ctrl-C
/// stops it.
#[pyfunction]
#[pyo3(signature = (name, case, request, figures=false, files=Vec::new()))]
pub fn run(
    py: Python<'_>,
    name: &str,
    case: Option<PyRef<'_, CaseFile>>,
    request: &Bound<'_, PyDict>,
    figures: bool,
    files: Vec<(String, PathBuf)>,
) -> PyResult<Report> {
    let task = schlupf_tasks::find(name).ok_or_else(|| PyKeyError::new_err(name.to_owned()))?;
    let asked = asked(task, request)?;
    let own = |(format, path): (String, PathBuf)| {
        let mut own = (task.own_files)().iter();
        own.find(|file| file.format == format).map(|file| (file.format, path))
    };
    let files = files.into_iter().filter_map(own).collect();
    let wanted = Wanted { figures, table: false, files };
    let is_default = case.is_none();
    let case = match case {
        Some(case) => case,
        None => Bound::new(py, CaseFile::new_from(default_case(py)?))?.borrow(),
    };
    let found = case.run(py, &Arc::default(), |case, watch| {
        let given = Given { is_default, scratch: &study::scratch, ..Given::of(case) };
        (task.run)(&given, &asked, &wanted, watch)
    })?;
    match found {
        // That it has not converged explains more.
        Ok(Found { report, failure: Some(errors) }) if report.status() == Status::Converged => {
            Err(errors::of_case(py, &errors))
        }
        Ok(found) => Ok(Report::new(found.report)),
        Err(TaskError::Case(errors)) => Err(errors::of_case(py, &errors)),
        Err(TaskError::Study(error)) => Err(raised(py, error)),
        Err(TaskError::Request(message)) => {
            let place = Place::File { name: String::new() };
            Err(errors::of_case(py, &CaseError::new("", message, place).into()))
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
    let fields = (task.fields)();
    let mut asked = Asked::new(Face::Functions, fields.clone());
    for field in &fields {
        if let Some(value) = request.get_item(field.name)?.filter(|value| !value.is_none()) {
            asked.give(field.name, converted(field, &value)?);
        }
    }
    Ok(asked)
}

/// A value of Python.
fn converted(field: &Field, value: &Bound<'_, PyAny>) -> PyResult<Value> {
    if field.form == Form::Flag || value.is_instance_of::<PyBool>() {
        return Ok(Value::Flag(value.is_truthy()?));
    }
    if field.form == Form::File && field.need != Need::Several {
        return file(value);
    }
    if field.form == Form::File
        && (value.is_instance_of::<PyString>() || value.hasattr("__fspath__")?)
    {
        return file(value);
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
    let parts = parts.map(|part| converted(&field.clone(), &part?));
    Ok(Value::List(parts.collect::<PyResult<_>>()?))
}

/// A path, or a name with bytes.
fn file(value: &Bound<'_, PyAny>) -> PyResult<Value> {
    if let Ok((name, bytes)) = value.extract::<(String, Vec<u8>)>() {
        let files = BTreeMap::from([(name.clone(), bytes)]);
        return Ok(Value::File(InputFile::new(name, Arc::new(files))));
    }
    Ok(Value::File(InputFile::at(&value.extract::<PathBuf>()?)))
}

/// All tasks: name, what it does, and fields.
#[pyfunction]
pub fn tasks(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
    let tasks = PyList::empty(py);
    for task in TASKS {
        let entry = PyDict::new(py);
        entry.set_item("name", task.name)?;
        entry.set_item("about", task.about)?;
        entry.set_item("sources", task.sources)?;
        let fields = PyList::empty(py);
        for field in (task.fields)() {
            fields.append(described(py, &field)?)?;
        }
        entry.set_item("fields", fields)?;
        tasks.append(entry)?;
    }
    Ok(tasks)
}

/// A field: name, kind, how often it is given, default as text, unit (SI), choices, meaning.
fn described<'py>(py: Python<'py>, field: &Field) -> PyResult<Bound<'py, PyDict>> {
    let entry = PyDict::new(py);
    entry.set_item("name", field.name)?;
    entry.set_item("kind", kind(field.form))?;
    entry.set_item("is_several", field.need == Need::Several)?;
    let is_needed = field.need == Need::Once && field.default.is_none() && field.form != Form::Flag;
    entry.set_item("is_needed", is_needed)?;
    entry.set_item("default", field.default.as_deref())?;
    entry.set_item("units", field.form.unit())?;
    let choices = if let Form::Choice(choices) = field.form { choices } else { &[] };
    entry.set_item("choices", choices.to_vec())?;
    entry.set_item("doc", field.doc)?;
    Ok(entry)
}

fn kind(form: Form) -> &'static str {
    match form {
        Form::Flag => "flag",
        Form::Count(_) => "count",
        Form::Number(_) | Form::Position | Form::Length | Form::Angle => "number",
        Form::Depths | Form::Range(_) => "range",
        Form::Choice(_) => "choice",
        Form::Family => "family",
        Form::File => "file",
        Form::Text(_) => "text",
    }
}
