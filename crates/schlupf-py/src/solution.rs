//! A solution with its numbers.

use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList};
use schlupf_tasks::output::Report;
use schlupf_tasks::output::solution::SolutionReport;
use schlupf_tasks::output::table::columns;

use crate::records;

/// Time steps, times and columns.
type FieldHistory<'py> = (Vec<usize>, Vec<f64>, Bound<'py, PyDict>);

/// A solved case.
#[pyclass(frozen, module = "schlupf._core")]
pub struct Solution {
    report: SolutionReport,
}

impl Solution {
    /// That of a report.
    pub fn new(report: SolutionReport) -> Self {
        Self { report }
    }
}

#[pymethods]
impl Solution {
    /// The documented JSON.
    fn json(&self) -> String {
        self.report.json()
    }

    /// The text summary.
    fn summary(&self) -> String {
        self.report.summary().to_string()
    }

    /// The summary by lines: see [`records::lines`].
    fn lines<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        records::lines(py, &self.report.summary())
    }

    /// The fields as columns over one instant, y and x.
    fn fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        records::on_grid(py, &[&self.report.solution.fields])
    }

    /// Time steps, times (in s) and fields over them, y and x.
    fn field_history<'py>(&self, py: Python<'py>) -> PyResult<FieldHistory<'py>> {
        let history = &self.report.solution.field_history;
        let fields: Vec<_> = history.iter().map(|at| &at.fields).collect();
        Ok((
            history.iter().map(|at| at.step).collect(),
            history.iter().map(|at| at.time).collect(),
            records::on_grid(py, &fields)?,
        ))
    }

    /// The time steps as columns.
    fn history<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        records::arrays(py, columns(self.report.solution.history.as_slice()))
    }

    /// Centres of the columns and of the rows of the grid, in m.
    fn axes<'py>(&self, py: Python<'py>) -> [Bound<'py, PyArray1<f64>>; 2] {
        let grid = &self.report.solution.fields.grid;
        let centres = |count: usize, origin: f64, spacing: f64| {
            PyArray1::from_iter(py, (0..count).map(|k| origin + (k as f64 + 0.5) * spacing))
        };
        [
            centres(grid.columns, grid.origin_x, grid.spacing_x),
            centres(grid.rows, grid.origin_y, grid.spacing_y),
        ]
    }

    /// The final state as JSON, from which another run may start.
    fn state<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyBytes>> {
        self.report.own_file(SolutionReport::STATE).map(|bytes| PyBytes::new(py, &bytes))
    }

    /// The fields for `ParaView`.
    fn vtk<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyBytes>> {
        self.report.own_file(SolutionReport::VTK).map(|bytes| PyBytes::new(py, &bytes))
    }

    /// The table of the cells as text.
    fn csv(&self) -> Option<String> {
        self.report.csv()
    }

    /// Code, quantity and text of each warning.
    fn warnings(&self) -> Vec<(String, String, String)> {
        let warnings = self.report.warnings.iter();
        warnings.map(|w| (w.code.to_string(), w.quantity.clone(), w.text.clone())).collect()
    }
}
