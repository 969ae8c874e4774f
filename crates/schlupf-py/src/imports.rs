//! Inputs of other programs as cases.

use std::path::PathBuf;

use pyo3::prelude::*;
use schlupf::reporting::Message;
use schlupf_case::CaseErrors;
use schlupf_case::import::contact::WheelBody;
use schlupf_case::import::{self, Request};

use crate::case_file::CaseFile;
use crate::errors;

/// Code, quantity and sentence of a message.
type Messages = Vec<(&'static str, String, String)>;

/// The cases of an input file of CONTACT, and what is left out of them. `is_wheel_second` tells
/// that body 2 of module 3 is the wheel; cases that are not available are an error, or with
/// `available_only` sentences.
#[pyfunction]
pub fn import_contact(
    py: Python<'_>,
    path: PathBuf,
    is_wheel_second: bool,
    available_only: bool,
) -> PyResult<(Vec<CaseFile>, Messages, Vec<String>)> {
    let wheel = if is_wheel_second { WheelBody::Second } else { WheelBody::First };
    let request = Request { path: &path, folder: None, wheel };
    let read = || -> Result<_, CaseErrors> {
        let imported = import::contact_file(request)?;
        let sentences: Vec<String> = if available_only {
            imported.errors.iter().map(ToString::to_string).collect()
        } else {
            CaseErrors::check(imported.errors)?;
            Vec::new()
        };
        let folder = request.output();
        let cases = imported.cases.iter().map(|case| import::read(case, folder));
        Ok((cases.collect::<Result<Vec<_>, _>>()?, imported.notices, sentences))
    };
    let (cases, notices, sentences) =
        py.detach(read).map_err(|errors| errors::of_case(py, &errors))?;
    let entry = |message: Message| (message.code, message.quantity, message.text);
    let cases = cases.into_iter().map(CaseFile::new_from).collect();
    Ok((cases, notices.into_iter().map(entry).collect(), sentences))
}
