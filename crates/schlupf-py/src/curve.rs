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

/// Traces a creep curve of a case: start and end of ξ, η and φ (in 1/m), or `None` for that of the
/// case.
#[pyfunction]
pub fn creep_curve(
    py: Python<'_>,
    case: &CaseFile,
    ranges: [Option<[f64; 2]>; 3],
    points: usize,
    is_even: bool,
) -> PyResult<CreepCurve> {
    let spacing = if is_even { Spacing::Even } else { Spacing::Refined };
    let sampling = Sampling { points, spacing };
    let found = interruptible(py, |watch| -> Result<CurveFamily, CaseErrors> {
        let case = case.file.pose(watch)?;
        case.require_steady("a creep curve is")?;
        let own = Creepages::of(&case.problem.kinematics);
        let [x, y, spin] = [(ranges[0], own.x), (ranges[1], own.y), (ranges[2], own.spin)]
            .map(|(range, own)| range.unwrap_or([own; 2]));
        let [start, end] = [0, 1].map(|k| Creepages { x: x[k], y: y[k], spin: spin[k] });
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
