//! Look-up tables of creep forces for arrays of states.

use std::path::PathBuf;

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use schlupf::numerics::parallel;
use schlupf::problem::look_up_table::NormalisedForce;
use schlupf_case::look_up_table::{StoredTable, TableFileError};

use crate::errors;

/// States that a thread computes in turn.
const CHUNK: usize = 4096;

/// Forces of all states one after the other, their derivatives row by row, and whether the table
/// covers the state.
type Found<'py> =
    (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<bool>>);

/// A table.
#[pyclass(frozen, module = "schlupf._core")]
pub struct LookUpTable(StoredTable);

#[pymethods]
impl LookUpTable {
    /// The table in a file, or the standard one.
    #[new]
    #[pyo3(signature = (path=None))]
    fn new(py: Python<'_>, path: Option<PathBuf>) -> PyResult<Self> {
        let Some(path) = path else {
            return schlupf_case::look_up_table::standard()
                .map(Self)
                .map_err(|error| refused("", &error));
        };
        let bytes = std::fs::read(&path).map_err(|cause| errors::of_file(py, &path, &cause))?;
        let named = format!("{} ", path.display());
        schlupf_case::look_up_table::shared(&bytes)
            .map(Self)
            .map_err(|error| refused(&named, &error))
    }

    /// What the file says, as JSON.
    fn metadata(&self) -> PyResult<String> {
        let text = serde_json::to_string(&self.0.metadata);
        text.map_err(|error| PyValueError::new_err(error.to_string()))
    }

    /// Smallest and largest a/b.
    fn axis_ratios(&self) -> [f64; 2] {
        self.0.table.axis_ratios()
    }

    /// Normalised forces of states as arrays of equal length: a/b, ξ', η', φ'.
    fn normalised<'py>(
        &self,
        py: Python<'py>,
        axis_ratio: PyReadonlyArray1<'py, f64>,
        creepages: [PyReadonlyArray1<'py, f64>; 3],
    ) -> PyResult<Found<'py>> {
        let ratios = axis_ratio.as_slice()?.to_vec();
        let mut parts = Vec::new();
        for creepage in &creepages {
            parts.push(creepage.as_slice()?.to_vec());
        }
        if parts.iter().any(|part| part.len() != ratios.len()) {
            return Err(PyValueError::new_err("arrays must have the same length"));
        }
        let table = &self.0.table;
        let found: Vec<NormalisedForce> = py.detach(|| {
            let starts = (0..ratios.len()).step_by(CHUNK).collect();
            let chunks = parallel::map(starts, |start: usize| {
                let states = start..(start + CHUNK).min(ratios.len());
                let of = |k: usize| {
                    table.normalised_force(ratios[k], std::array::from_fn(|axis| parts[axis][k]))
                };
                states.map(of).collect::<Vec<_>>()
            });
            chunks.into_iter().flatten().collect()
        });
        let forces = found.iter().flat_map(|found| found.force);
        let slopes = found.iter().flat_map(|found| found.by_creepage.into_iter().flatten());
        let covered = found.iter().map(|found| found.is_covered);
        Ok((
            PyArray1::from_iter(py, forces),
            PyArray1::from_iter(py, slopes),
            PyArray1::from_iter(py, covered),
        ))
    }
}

fn refused(file: &str, error: &TableFileError) -> PyErr {
    PyValueError::new_err(format!("{file}{error}"))
}
