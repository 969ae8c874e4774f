//! Studies: many states of a case, a row of results each.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use numpy::PyArray1;
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::{PyKeyboardInterrupt, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schlupf_tasks::study::run::{self, Report, Run, Solved, Started};
use schlupf_tasks::study::table::{Cells, Reader};
use schlupf_tasks::study::{StudyError, run::run as run_study};

use crate::case_file::CaseFile;
use crate::errors;
use crate::interruptible::interruptible;

/// A failure of a study as an exception.
pub fn raised(py: Python<'_>, error: StudyError) -> PyErr {
    match error {
        StudyError::Input(cause) => errors::of_case(py, &cause),
        StudyError::File { path, cause } => errors::of_file(py, &path, &cause),
        StudyError::Stopped => PyKeyboardInterrupt::new_err(error.to_string()),
        other => PyValueError::new_err(other.to_string()),
    }
}

/// Rows, those that were there already, those not converged, those that failed, the first of them
/// with its reason, and warnings as code, field and text.
type Counts =
    (usize, usize, usize, usize, Option<(usize, String)>, Vec<(&'static str, String, String)>);

fn counts(report: Report) -> Counts {
    let Report { rows, resumed, not_converged, failed, first_failure, warnings, .. } = report;
    let messages = warnings.messages().into_iter();
    let messages = messages.map(|told| (told.code, told.quantity, told.text)).collect();
    (rows, resumed, not_converged, failed, first_failure, messages)
}

/// A study.
#[pyclass(frozen, module = "schlupf._core")]
pub struct Study {
    study: schlupf_tasks::study::Study,
}

#[pymethods]
impl Study {
    /// Of a file.
    #[new]
    fn new(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let study = py.detach(|| schlupf_tasks::study::Study::from_path(&path, None));
        Ok(Self { study: study.map_err(|error| raised(py, error))? })
    }

    /// Of a text about a case; relative paths start in a folder.
    #[staticmethod]
    fn of_case(py: Python<'_>, case: &CaseFile, text: &str, folder: PathBuf) -> PyResult<Self> {
        let case = case.file();
        let study =
            py.detach(|| schlupf_tasks::study::Study::from_str(text, "study", &folder, Some(case)));
        Ok(Self { study: study.map_err(|error| raised(py, error))? })
    }

    /// What tells it from another study, files included.
    fn digest(&self) -> &str {
        self.study.digest()
    }

    /// Number of rows.
    fn rows(&self) -> usize {
        self.study.rows()
    }

    /// Solves a share on all threads and writes its table.
    fn run(&self, py: Python<'_>, shard: [usize; 2], output: PathBuf) -> PyResult<Counts> {
        let done = interruptible(py, &Arc::default(), |watch| {
            run_study(&self.study, shard, &output, watch)
        })?;
        done.map(counts).map_err(|error| raised(py, error))
    }

    /// Solves a batch: its rows as text.
    fn solve(&self, py: Python<'_>, batch: usize) -> PyResult<String> {
        let done = interruptible(py, &Arc::default(), |watch| {
            run::solve(&self.study, batch, watch)?.to_text()
        })?;
        done.map_err(|error| raised(py, error))
    }
}

/// A run whose batches are solved elsewhere.
#[pyclass(frozen, module = "schlupf._core")]
pub struct StudyRun {
    study: Py<Study>,
    /// Taken at the end.
    run: Mutex<Option<Run>>,
    report: Option<Counts>,
}

#[pymethods]
impl StudyRun {
    /// Begins or goes on.
    #[new]
    fn new(py: Python<'_>, study: Py<Study>, output: PathBuf) -> PyResult<Self> {
        let started = Run::start_elsewhere(&study.get().study, &output);
        Ok(match started.map_err(|error| raised(py, error))? {
            Started::Open(run) => Self { study, run: Mutex::new(Some(*run)), report: None },
            Started::Done(report) => {
                Self { study, run: Mutex::new(None), report: Some(counts(report)) }
            }
        })
    }

    /// Batches that are left.
    fn left(&self) -> Vec<usize> {
        let run = self.run.lock().unwrap_or_else(PoisonError::into_inner);
        run.as_ref().map_or_else(Vec::new, |run| run.left().to_vec())
    }

    /// Keeps a batch.
    fn keep(&self, py: Python<'_>, batch: usize, text: &str) -> PyResult<()> {
        let run = self.run.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(run) = run.as_ref() else { return Ok(()) };
        let solved = Solved::from_text(&self.study.get().study, batch, text);
        let kept = solved.and_then(|solved| run.keep(batch, &solved));
        kept.map_err(|error| raised(py, error))
    }

    /// Writes the table.
    fn finish(&self, py: Python<'_>) -> PyResult<Counts> {
        let run = self.run.lock().unwrap_or_else(PoisonError::into_inner).take();
        match (run, &self.report) {
            (Some(run), _) => run.finish().map(counts).map_err(|error| raised(py, error)),
            (None, Some(report)) => Ok(report.clone()),
            (None, None) => Err(PyValueError::new_err("the run has ended")),
        }
    }
}

/// Puts the tables of shards together.
#[pyfunction]
pub fn merge(py: Python<'_>, shards: Vec<PathBuf>, output: PathBuf) -> PyResult<Counts> {
    let merged = py.detach(|| schlupf_tasks::study::merge::merge(&shards, &output));
    merged.map(counts).map_err(|error| raised(py, error))
}

/// The columns of a table: each a dictionary with `values`, `units` and `long_name`.
#[pyfunction]
pub fn read_table(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyDict>> {
    let fail = |error| raised(py, error);
    let mut reader = Reader::open(&path).map_err(fail)?;
    let columns = reader.contents().columns.clone();
    let mut all: Vec<Cells> = columns.iter().map(|column| Cells::empty(column.kind)).collect();
    while let Some(rows) = reader.next_batch().map_err(fail)? {
        for (all, part) in all.iter_mut().zip(rows) {
            all.append(part);
        }
    }
    let table = PyDict::new(py);
    for (column, cells) in columns.iter().zip(all) {
        let values = match cells {
            Cells::Numbers(numbers) => PyArray1::from_vec(py, numbers).into_any(),
            Cells::Counts(counts) => PyArray1::from_vec(py, counts).into_any(),
            Cells::Texts(texts) => texts.into_bound_py_any(py)?,
            _ => continue,
        };
        let entry = PyDict::new(py);
        entry.set_item("values", values)?;
        entry.set_item("units", &column.unit)?;
        table.set_item(&column.name, entry)?;
    }
    Ok(table)
}
