//! The table of fields of a case, from which the package makes its documentation, its conversion of
//! numbers and its completion.

use std::ffi::OsString;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use schlupf_case::fields::{ALTERNATIVES, Field, Kind, SECTIONS};
use schlupf_case::{FieldNames, Preset, TableColumn};

/// Sections in the order of the case file; each a dictionary with `name`, `doc` and `fields`.
#[pyfunction]
pub fn field_table(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
    let sections = PyList::empty(py);
    for section in SECTIONS {
        let fields = PyList::empty(py);
        for field in section.fields {
            fields.append(entry(py, field)?)?;
        }
        let table = PyDict::new(py);
        table.set_item("name", section.name)?;
        table.set_item("doc", section.doc)?;
        table.set_item("fields", fields)?;
        sections.append(table)?;
    }
    Ok(sections)
}

/// A field: path, kind, unit (SI), whether its numbers may be text with a unit, default, whether it
/// may have no value, choices and documentation.
fn entry<'py>(py: Python<'py>, field: &Field) -> PyResult<Bound<'py, PyDict>> {
    let entry = PyDict::new(py);
    entry.set_item("path", field.path.as_str())?;
    entry.set_item("name", field.name())?;
    entry.set_item("kind", kind(field.kind))?;
    entry.set_item("units", field.kind.unit())?;
    let requirement = field.requirement.text(field.kind.unit(), &FieldNames::CASE);
    let requirement = if is_number(field.kind) { requirement } else { String::new() };
    entry.set_item("requirement", requirement)?;
    entry.set_item("default", field.default.text().or(field.default.in_words()))?;
    entry.set_item("is_optional", is_optional(field))?;
    let choices = field.kind.choices().iter().map(|choice| (choice.name, choice.doc));
    entry.set_item("choices", choices.collect::<Vec<_>>())?;
    let uses = field.uses().map(|(path, names)| (path.as_str(), names.to_vec()));
    entry.set_item("used_with", uses.collect::<Vec<_>>())?;
    let columns: Vec<_> = field.columns.iter().map(|kind| described_columns(kind)).collect();
    entry.set_item("columns", columns)?;
    entry.set_item("doc", field.doc)?;
    Ok(entry)
}

/// The columns of a table: name, unit (SI).
pub fn described_columns(columns: &[TableColumn]) -> Vec<(&'static str, &'static str)> {
    columns.iter().map(|column| (column.name, column.unit())).collect()
}

/// Whether there are cases in which it has no value.
fn is_optional(field: &Field) -> bool {
    let mut pairs = ALTERNATIVES.iter().flat_map(|pair| [pair.first, pair.second]);
    field.default.text().is_none()
        || field.default_with.is_some()
        || pairs.any(|paths| paths.contains(&field.path))
}

fn is_number(kind: Kind) -> bool {
    !matches!(kind, Kind::Flag | Kind::Choice(_) | Kind::Text | Kind::Path)
}

fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Quantity(_) => "quantity",
        Kind::Number => "number",
        Kind::Count => "count",
        Kind::Flag => "flag",
        Kind::Choice(_) => "choice",
        Kind::NumberOr(_) => "number-or-choice",
        Kind::Text => "text",
        Kind::Path => "path",
        Kind::Quantities(_) => "quantities",
        Kind::Numbers => "numbers",
    }
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

/// Constants to start with: group, name, what it is, its source, and its fields with values as
/// TOML.
#[pyfunction]
pub fn presets() -> Vec<(&'static str, &'static str, &'static str, &'static str, Fields)> {
    let presets = schlupf_case::presets().iter();
    presets
        .map(|preset| {
            let Preset { group, name, doc, source, fields } = preset;
            (group.as_str(), name.as_str(), doc.as_str(), source.as_str(), fields.clone())
        })
        .collect()
}

/// Fields with their values.
type Fields = Vec<(String, String)>;

/// The command `schlupf` with its name and its arguments; returns its exit code.
#[pyfunction]
pub fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| schlupf_cli::main(arguments))
}
