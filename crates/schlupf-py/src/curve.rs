//! Creep curves.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use schlupf::creep_curve::{Creepages, Path, Sampling, Spacing, trace};
use schlupf_case::{CaseErrors, FieldNames};
use schlupf_output::Report;
use schlupf_output::creep_curve::{CurveFamily, Member};

use crate::case_file::CaseFile;
use crate::errors;
use crate::interruptible::interruptible;
use crate::records;

/// Forces along a path of creepages.
#[pyclass(frozen, module = "schlupf._core")]
pub struct CreepCurve {
    report: CurveFamily,
}

#[pymethods]
impl CreepCurve {
    /// The documented JSON.
    fn json(&self) -> String {
        self.report.json()
    }

    /// The text summary.
    fn summary(&self) -> String {
        self.report.summary()
    }

    /// The points as columns.
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        match self.report.members.first() {
            Some(member) => records::columns(py, &member.curve),
            None => Ok(PyDict::new(py)),
        }
    }

    /// Code, quantity and text of each warning.
    fn warnings(&self) -> Vec<(String, String, String)> {
        let warnings = self.report.warnings().iter();
        warnings.map(|w| (w.code.to_string(), w.quantity.clone(), w.text.clone())).collect()
    }
}

/// Traces the creep curve of a case between two creepages [ξ, η, φ in 1/m].
#[pyfunction]
pub fn creep_curve(
    py: Python<'_>,
    case: &CaseFile,
    range: [[f64; 3]; 2],
    points: usize,
    is_even: bool,
) -> PyResult<CreepCurve> {
    let spacing = if is_even { Spacing::Even } else { Spacing::Refined };
    let sampling = Sampling { points, spacing };
    let found = interruptible(py, |watch| -> Result<CurveFamily, CaseErrors> {
        let case = case.file.pose(watch)?;
        case.require_steady("a creep curve is")?;
        let [start, end] = range.map(|[x, y, spin]| Creepages { x, y, spin });
        let explain = |error: schlupf::Error| CaseErrors::from(case.explain(&error));
        let path = Path::new(start, end).map_err(explain)?;
        let mut solver = case.solver();
        let curve = trace(&mut *solver, &case.problem, &path, &sampling, watch);
        let curve = curve.map_err(explain)?;
        let of_curve = curve.warnings.iter().map(|w| w.message(&FieldNames::CASE));
        let warnings = case.notices.iter().cloned().chain(of_curve).collect();
        let member = Member { value: None, warnings, curve };
        Ok(CurveFamily::new(case.title.clone(), None, sampling, vec![member]))
    })?;
    found.map(|report| CreepCurve { report }).map_err(|errors| errors::of_case(py, &errors))
}
