//! What a task has found.

use std::any::Any;

use numpy::{PyArray1, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use schlupf::Quantity;
use schlupf::analysis::subsurface::PointStress;
use schlupf::reporting::Record;
use schlupf::surface::Lattice;
use schlupf_tasks::output::roughness::RoughnessReport;
use schlupf_tasks::output::subsurface::StressReport;
use schlupf_tasks::output::table::columns;

use crate::records::{arrays, described, lines};

/// What a task has found: documented JSON, summary, tables and warnings.
#[pyclass(frozen, module = "schlupf._core")]
pub struct Report {
    report: Box<dyn schlupf_tasks::output::Report>,
}

impl Report {
    /// That of a task.
    pub fn new(report: Box<dyn schlupf_tasks::output::Report>) -> Self {
        Self { report }
    }

    /// It as a report of one kind, if it is of that.
    fn of<T: 'static>(&self) -> Option<&T> {
        (&*self.report as &dyn Any).downcast_ref()
    }
}

#[pymethods]
impl Report {
    /// The documented JSON.
    fn json(&self) -> String {
        self.report.json()
    }

    /// The text summary.
    fn summary(&self) -> String {
        self.report.summary().to_string()
    }

    /// The summary by lines: see [`lines`].
    fn lines<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        lines(py, &self.report.summary())
    }

    /// The table as text.
    fn csv(&self) -> Option<String> {
        self.report.csv()
    }

    /// `converged` or `not-converged`.
    fn status(&self) -> &'static str {
        self.report.status().name()
    }

    /// Code, quantity and text of each warning.
    fn warnings(&self) -> Vec<(String, String, String)> {
        let warnings = self.report.warnings().iter();
        warnings.map(|w| (w.code.to_string(), w.quantity.clone(), w.text.clone())).collect()
    }

    /// The figures that the command draws: name and SVG.
    fn drawings(&self) -> PyResult<Vec<(String, String)>> {
        self.report.drawings().map_err(|error| PyValueError::new_err(error.to_string()))
    }

    /// Tables by name, each a list with the columns of every member.
    fn tables<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let tables = PyDict::new(py);
        for (name, table) in self.report.tables() {
            let members = match tables.get_item(name)? {
                Some(members) => members.cast_into::<PyList>()?,
                None => PyList::empty(py),
            };
            members.append(arrays(py, table)?)?;
            tables.set_item(name, members)?;
        }
        Ok(tables)
    }

    /// Stresses in layers: each column as an array over depth, y and x, and these three.
    fn volume<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(report) = self.of::<StressReport>() else { return Ok(None) };
        let volume = &report.volume;
        let grid = &volume.grid;
        let table = PyDict::new(py);
        for column in <[PointStress]>::COLUMNS {
            let (count, value): (usize, Box<dyn Fn(usize) -> f64>) = match column.quantity {
                Quantity::X => (grid.columns, Box::new(|i| grid.x(i))),
                Quantity::Y => (grid.rows, Box::new(|j| grid.y(j))),
                Quantity::Depth => (volume.layers.len(), Box::new(|k| volume.layers[k].depth)),
                _ => {
                    let value = |k: usize| {
                        let stress = volume.layers[k / grid.len()].stress[k % grid.len()];
                        let point = PointStress { x: 0.0, y: 0.0, depth: 0.0, stress };
                        (column.value)(std::slice::from_ref(&point), 0).number().unwrap_or(f64::NAN)
                    };
                    (volume.layers.len() * grid.len(), Box::new(value))
                }
            };
            let values = PyArray1::from_vec(py, (0..count).map(value).collect());
            let is_place = count < volume.layers.len() * grid.len();
            let values = if is_place {
                values.into_any()
            } else {
                values.reshape([volume.layers.len(), grid.rows, grid.columns])?.into_any()
            };
            table.set_item(column.name, described(py, column.quantity, values)?)?;
        }
        Ok(Some(table))
    }

    /// Values over a surface with cells of equal size: spacings along x and y (in m), then the
    /// columns, each an array with rows along x.
    fn surface<'py>(&self, py: Python<'py>) -> PyResult<Option<([f64; 2], Bound<'py, PyDict>)>> {
        let Some(report) = self.of::<RoughnessReport>() else { return Ok(None) };
        let lattice = report.surface.lattice();
        let table = PyDict::new(py);
        let add = |name, quantity, values: &[f64]| {
            table.set_item(name, described(py, quantity, map(py, lattice, values)?)?)
        };
        add("height", Quantity::Heights, report.surface.heights())?;
        if let Some(spots) = &report.spots {
            add("pressure", Quantity::Pressure, &spots.pressure)?;
            add("gap", Quantity::Gap, &spots.gap)?;
        }
        Ok(Some(([lattice.spacing_x, lattice.spacing_y], table)))
    }
}

/// The text of a file that only one kind of result has, by the name of its format.
#[pyfunction]
pub fn own_file(report: &Report, format: &str) -> Option<String> {
    report.report.own_file(format).and_then(|bytes| String::from_utf8(bytes).ok())
}

/// Stresses at places (x, y and depth in m) as columns; `None` for a report without stresses.
#[pyfunction]
pub fn stresses_at<'py>(
    py: Python<'py>,
    report: &Report,
    places: Vec<[f64; 3]>,
) -> PyResult<Option<Bound<'py, PyDict>>> {
    let Some(report) = report.of::<StressReport>() else { return Ok(None) };
    let point = |place| report.stresses.point(place);
    let points: Vec<PointStress> = py.detach(|| places.into_iter().map(point).collect());
    arrays(py, columns(points.as_slice())).map(Some)
}

/// Values of all cells as an array with rows along x.
fn map<'py>(py: Python<'py>, lattice: &Lattice, values: &[f64]) -> PyResult<Bound<'py, PyAny>> {
    let values = PyArray1::from_slice(py, values);
    Ok(values.reshape([lattice.rows, lattice.columns])?.into_any())
}
