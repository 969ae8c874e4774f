//! What a task has found.

use numpy::{PyArray1, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use schlupf::Quantity;
use schlupf::columns::Record;
use schlupf::subsurface::PointStress;
use schlupf::surface::Lattice;
use schlupf_output::bulk_temperature::BulkReport;
use schlupf_output::calibration::CalibrationReport;
use schlupf_output::comparison::Comparison;
use schlupf_output::creep_curve::CurveFamily;
use schlupf_output::damage::DamageReport;
use schlupf_output::identification::FitReport;
use schlupf_output::roughness::RoughnessReport;
use schlupf_output::subsurface::StressReport;
use schlupf_output::temperature::{Line, Temperatures};
use schlupf_output::wear::WearReport;
use schlupf_output::wheelset::WheelsetReport;

use crate::records::{columns, described, lines};

/// What a task has found, of any kind.
pub enum Found {
    Bulk(Box<BulkReport>),
    Calibration(Box<CalibrationReport>),
    Comparison(Box<Comparison>),
    Curve(Box<CurveFamily>),
    Damage(Box<DamageReport>),
    Fit(Box<FitReport>),
    Roughness(Box<RoughnessReport>),
    Subsurface(Box<StressReport>),
    Temperature(Box<Temperatures>),
    Wear(Box<WearReport>),
    Wheelset(Box<WheelsetReport>),
}

/// What a task has found: documented JSON, summary, tables and warnings.
#[pyclass(frozen, module = "schlupf._core")]
pub struct Report {
    found: Found,
}

impl Report {
    /// That of a task.
    pub fn new(found: Found) -> Self {
        Self { found }
    }

    fn report(&self) -> &dyn schlupf_output::Report {
        match &self.found {
            Found::Bulk(report) => &**report,
            Found::Calibration(report) => &**report,
            Found::Comparison(report) => &**report,
            Found::Curve(report) => &**report,
            Found::Damage(report) => &**report,
            Found::Fit(report) => &**report,
            Found::Roughness(report) => &**report,
            Found::Subsurface(report) => &**report,
            Found::Temperature(report) => &**report,
            Found::Wear(report) => &**report,
            Found::Wheelset(report) => &**report,
        }
    }
}

#[pymethods]
impl Report {
    /// The documented JSON.
    fn json(&self) -> String {
        self.report().json()
    }

    /// The text summary.
    fn summary(&self) -> String {
        self.report().summary().to_string()
    }

    /// The same by lines: see [`lines`].
    fn lines<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        lines(py, &self.report().summary())
    }

    /// The table as text.
    fn csv(&self) -> Option<String> {
        self.report().csv()
    }

    /// `converged` or `not-converged`.
    fn status(&self) -> &'static str {
        self.report().status().name()
    }

    /// Code, quantity and text of each warning.
    fn warnings(&self) -> Vec<(String, String, String)> {
        let warnings = self.report().warnings().iter();
        warnings.map(|w| (w.code.to_string(), w.quantity.clone(), w.text.clone())).collect()
    }

    /// The figures that the command draws: name and SVG.
    fn drawings(&self) -> PyResult<Vec<(String, String)>> {
        self.report().drawings().map_err(|error| PyValueError::new_err(error.to_string()))
    }

    /// The case with fitted values, or the section with the calibrated stiffnesses, as TOML.
    fn case(&self) -> Option<String> {
        match &self.found {
            Found::Fit(report) => report.case.clone(),
            Found::Calibration(report) => Some(report.snippet()),
            _ => None,
        }
    }

    /// Tables by name, each a list with the columns of every member.
    fn tables<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let tables = PyDict::new(py);
        let add = |name: &str, members: Vec<PyResult<Bound<'py, PyDict>>>| {
            tables.set_item(name, members.into_iter().collect::<PyResult<Vec<_>>>()?)
        };
        match &self.found {
            Found::Bulk(_) | Found::Calibration(_) => {}
            Found::Comparison(report) => add("methods", vec![columns(py, &**report)])?,
            Found::Curve(report) => {
                add("points", report.members.iter().map(|m| columns(py, &m.curve)).collect())?;
            }
            Found::Damage(report) => {
                add("profile", vec![columns(py, &report.damage.profile)])?;
                add("run", vec![columns(py, report.damage.points.as_slice())])?;
            }
            Found::Fit(report) => add("points", vec![columns(py, &**report)])?,
            Found::Roughness(report) => {
                let result = &report.result;
                add("spectrum", vec![columns(py, &report.spectrum)])?;
                add("loads", vec![columns(py, &result.normal)])?;
                add("curves", result.tangential.iter().map(|c| columns(py, c)).collect())?;
            }
            Found::Subsurface(report) => {
                add("profile", vec![columns(py, report.profile.as_slice())])?;
            }
            Found::Temperature(report) => {
                add("profile", vec![line(py, Quantity::Depth, &report.profile)])?;
                let rows = report.rows.iter().map(|row| line(py, Quantity::X, &row.line));
                add("rows", rows.collect())?;
            }
            Found::Wear(report) => {
                if let Some(wear) = &report.passage.wear {
                    add("profile", vec![columns(py, &wear.profile)])?;
                    add("cells", vec![columns(py, &wear.cells)])?;
                }
            }
            Found::Wheelset(report) => {
                add("contacts", vec![columns(py, &**report)])?;
                add("conicity", vec![columns(py, &report.conicity)])?;
            }
        }
        Ok(tables)
    }

    /// Stresses in layers: each column as an array over depth, y and x, and these three.
    fn volume<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Found::Subsurface(report) = &self.found else { return Ok(None) };
        let volume = &report.volume;
        let grid = &volume.grid;
        let table = PyDict::new(py);
        for column in <[PointStress]>::columns() {
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
        let Found::Roughness(report) = &self.found else { return Ok(None) };
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

/// Stresses at places (x, y and depth in m) as columns; `None` for a report without stresses.
#[pyfunction]
pub fn stresses_at<'py>(
    py: Python<'py>,
    report: &Report,
    places: Vec<[f64; 3]>,
) -> PyResult<Option<Bound<'py, PyDict>>> {
    let Found::Subsurface(report) = &report.found else { return Ok(None) };
    let point = |place| report.stresses.point(place);
    let points: Vec<PointStress> = py.detach(|| places.into_iter().map(point).collect());
    columns(py, points.as_slice()).map(Some)
}

/// Temperatures along a line with the places of its points.
fn line<'py>(py: Python<'py>, place: Quantity, line: &Line) -> PyResult<Bound<'py, PyDict>> {
    let table = columns(py, line)?;
    let places = PyArray1::from_slice(py, &line.position).into_any();
    table.set_item(place.name(), described(py, place, places)?)?;
    Ok(table)
}

/// Values of all cells as an array with rows along x.
fn map<'py>(py: Python<'py>, lattice: &Lattice, values: &[f64]) -> PyResult<Bound<'py, PyAny>> {
    let values = PyArray1::from_slice(py, values);
    Ok(values.reshape([lattice.rows, lattice.columns])?.into_any())
}
