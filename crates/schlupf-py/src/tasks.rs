//! What a case can be asked besides its solution: see the crate of tasks.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use schlupf::calibration::CalibrationOptions;
use schlupf::creep_curve::{MAX_POINTS, Sampling, Spacing, VariedForce};
use schlupf::identification::roughness::DEFAULT_GAMMA;
use schlupf::{Status, Watch};
use schlupf_case::identification::parameters;
use schlupf_case::{CaseError, Family, InputFile, Place, direction, range, read_displacements};
use schlupf_tasks::{
    TaskError, bulk, calibrate, compare, curve, fit, roughness, subsurface, temperature, wear,
    wheelset,
};

use crate::case_file::CaseFile;
use crate::errors;
use crate::report::{Found, Report};

/// Start and end.
type Range = [f64; 2];

/// Ranges of ξ, η and φ; that of the total creepage with its direction; a force with its range.
type Varied = ([Option<Range>; 3], Option<(Range, String)>, Option<(String, Range)>);

/// Does a task, which Ctrl-C stops.
fn report(
    py: Python<'_>,
    case: &CaseFile,
    task: impl FnOnce(&schlupf_case::CaseFile, Watch) -> Result<Found, TaskError> + Send,
) -> PyResult<Report> {
    match case.run(py, &Arc::default(), task)? {
        Ok(found) => Ok(Report::new(found)),
        Err(TaskError::Case(errors)) => Err(errors::of_case(py, &errors)),
        Err(TaskError::Request(message)) => Err(refused(py, message)),
    }
}

/// A number of points of a line or curve.
fn checked_points(py: Python<'_>, points: usize) -> PyResult<usize> {
    if (2..=MAX_POINTS).contains(&points) {
        return Ok(points);
    }
    let message = format!("points must be between 2 and {MAX_POINTS}, but is {points}");
    Err(refused(py, message))
}

/// An argument is wrong, not a field of the case.
fn refused(py: Python<'_>, message: String) -> PyErr {
    let place = Place::File { name: String::new() };
    errors::of_case(py, &CaseError::new("", message, place).into())
}

/// Forces that a curve may vary, by their names in Python.
const FORCES: [(&str, VariedForce); 4] = [
    ("force_x", VariedForce::X),
    ("traction_coefficient", VariedForce::OverLoad),
    ("force_y", VariedForce::Y),
    ("moment_z", VariedForce::MomentZ),
];

/// Traces creep curves of a case: start and end of ξ, η and φ (in 1/m), or `None` for that of the
/// case; in place of ξ and η start and end of the total creepage, and its direction, such as
/// `45 deg`; or in place of all of them a force and its start and end. There is one curve for each
/// value of `over`, such as `"kinematics.speed=10 m/s,20 m/s"`, or for each pair of values of two;
/// each has so many points, and they are evenly spaced or not.
#[pyfunction]
#[pyo3(signature = (case, varied, over, sampling))]
pub fn creep_curve(
    py: Python<'_>,
    case: &CaseFile,
    varied: Varied,
    over: Vec<String>,
    sampling: (usize, bool),
) -> PyResult<Report> {
    let (points, is_even) = sampling;
    let spacing = if is_even { Spacing::Even } else { Spacing::Refined };
    let over = over.iter().map(|text| Family::parse("over", text)).collect::<Result<_, _>>();
    let over = over.map_err(|error| errors::of_case(py, &error.into()))?;
    let ([creepage_x, creepage_y, spin], total, force) = varied;
    let force = force.and_then(|(name, range)| {
        let (name, force) = FORCES.into_iter().find(|(own, _)| *own == name)?;
        Some((name, (force, range)))
    });
    let given = force.map_or("the creepages of the curve", |(name, _)| name);
    let angle = |text: &str| direction("direction", text);
    let total = total.map(|(range, text)| angle(&text).map(|angle| (range, angle))).transpose();
    let total = total.map_err(|error| errors::of_case(py, &error.into()))?;
    let request = curve::Request {
        varied: curve::Varied {
            creepage_x,
            creepage_y,
            spin,
            total,
            force: force.map(|(_, force)| force),
        },
        over,
        sampling: Sampling { points: checked_points(py, points)?, spacing },
        names: curve::Names {
            creepage_x: "creepage_x",
            creepage_y: "creepage_y",
            spin: "spin",
            creepage: "creepage",
            force: given,
            over: "over",
            given: given.to_owned(),
        },
    };
    report(py, case, |file, watch| {
        let found = curve::plan(file, request, watch)?.find(watch)?;
        Ok(Found::Curve(Box::new(found)))
    })
}

/// Temperatures below a point and along its row: depths of the profile and length of the wake (in
/// m), with so many points on each line.
#[pyfunction]
pub fn temperatures(
    py: Python<'_>,
    case: &CaseFile,
    point: [Option<f64>; 2],
    lines: (Option<[f64; 2]>, Option<f64>, usize),
) -> PyResult<Report> {
    let ([x, y], (depth, wake, points)) = (point, lines);
    let points = checked_points(py, points)?;
    let request =
        temperature::Request { x, y, depth, wake, points, names: ["x", "y", "depth", "wake"] };
    report(py, case, |file, watch| {
        let found = temperature::plan(file, request, watch)?.find(watch)?;
        Ok(Found::Temperature(Box::new(found)))
    })
}

/// Stresses below the surface, with a profile below a point.
#[pyfunction]
pub fn subsurface_stresses(
    py: Python<'_>,
    case: &CaseFile,
    point: [Option<f64>; 2],
) -> PyResult<Report> {
    let [x, y] = point;
    let request = subsurface::Request { x, y, points: None, names: ["x", "y"] };
    report(py, case, |file, watch| {
        let found = subsurface::plan(file, request, watch)?.find(watch)?;
        Ok(Found::Subsurface(Box::new(found)))
    })
}

/// Wear, fatigue and melting of one passage.
#[pyfunction]
pub fn passage_damage(py: Python<'_>, case: &CaseFile) -> PyResult<Report> {
    report(py, case, |file, watch| {
        Ok(Found::Wear(Box::new(wear::plan(file, wear::Cells::IfAny, watch)?.find(watch)?)))
    })
}

/// The bulk temperature of the wheel in the long run.
#[pyfunction]
pub fn bulk_temperature(py: Python<'_>, case: &CaseFile) -> PyResult<Report> {
    report(py, case, |file, watch| {
        let found = bulk::plan(file, watch)?.find(watch)?;
        Ok(Found::Bulk(Box::new(found)))
    })
}

/// The case by all methods.
#[pyfunction]
pub fn comparison(py: Python<'_>, case: &CaseFile) -> PyResult<Report> {
    report(py, case, |file, watch| {
        let found = compare::plan(file, watch)?.find(watch)?;
        Ok(Found::Comparison(Box::new(found)))
    })
}

/// Stiffnesses of the elastic layer for the patch of the case.
#[pyfunction]
pub fn calibration(
    py: Python<'_>,
    case: &CaseFile,
    is_direct: bool,
    displacements: Vec<PathBuf>,
    cells: usize,
) -> PyResult<Report> {
    let files = displacements.iter();
    let files = files.map(|path| read_displacements("displacements", &InputFile::at(path)));
    let displacements = files.collect::<Result<Vec<_>, _>>();
    let displacements = displacements.map_err(|error| errors::of_case(py, &error.into()))?;
    let request = calibrate::Request { direct: is_direct, displacements, cells, with_sides: false };
    report(py, case, |file, watch| {
        let found = calibrate::plan(file.clone(), request, watch)?.find(watch)?;
        Ok(Found::Calibration(Box::new(found)))
    })
}

/// Parameters that fit measured points: a CSV file, or its bytes under a name. The options are the
/// folder in which paths of the case with the fitted values start, γ of the roughness, and the
/// largest number of steps.
#[pyfunction]
pub fn fitted(
    py: Python<'_>,
    case: &CaseFile,
    names: &str,
    data: (PathBuf, Option<Vec<u8>>),
    options: (PathBuf, f64, usize),
) -> PyResult<Report> {
    let (folder, gamma, max_steps) = options;
    let data = match data {
        (path, Some(bytes)) => {
            let name = path.display().to_string();
            InputFile::new(name.clone(), Arc::new(BTreeMap::from([(name, bytes)])))
        }
        (path, None) => InputFile::at(&path),
    };
    let parameters = parameters("parameters", names);
    let request = fit::Request {
        parameters: parameters.map_err(|error| errors::of_case(py, &error.into()))?,
        data,
        gamma,
        max_steps,
        curve_points: 0,
        fitted_case: Some(folder.join("fitted case")),
        names: fit::Names { data: "data", parameters: "fit", given: format!("{names} to") },
    };
    report(py, case, |file, watch| {
        let fit::Found { report, failure } = fit::plan(file, request, watch)?.find(watch)?;
        match failure {
            // That it has not converged explains more.
            Some(errors) if report.fit.status == Status::Converged => Err(errors.into()),
            _ => Ok(Found::Fit(Box::new(report))),
        }
    })
}

/// The rough surface of a case, pressed and moved; with the spots at the largest mean pressure.
#[pyfunction]
pub fn rough_contact(py: Python<'_>, case: &CaseFile, with_spots: bool) -> PyResult<Report> {
    report(py, case, |file, watch| {
        let found = roughness::Plan::of_case(file, with_spots, watch)?.find(watch)?;
        Ok(Found::Roughness(Box::new(found)))
    })
}

/// The contacts of a wheelset between two lateral positions (in m), at so many of them.
#[pyfunction]
pub fn wheelset_contacts(
    py: Python<'_>,
    case: &CaseFile,
    lateral_position: Range,
    points: usize,
) -> PyResult<Report> {
    const NAME: &str = "lateral_position";
    let points = checked_points(py, points)?;
    let [from, to] = lateral_position;
    let range = range(NAME, "wheelset.lateral_position", &format!("{from}..{to} m"));
    let range = range.map_err(|error| errors::of_case(py, &error.into()))?;
    report(py, case, |file, watch| {
        let found = wheelset::plan(file, wheelset::Request { range, points })?.find(watch)?;
        Ok(Found::Wheelset(Box::new(found)))
    })
}

/// Numbers that are taken where none is given, by name.
#[pyfunction]
pub fn defaults(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let numbers = PyDict::new(py);
    numbers.set_item("curve_points", Sampling::default().points)?;
    numbers.set_item("line_points", temperature::POINTS)?;
    numbers.set_item("calibration_cells", CalibrationOptions::default().cells)?;
    numbers.set_item("fit_steps", fit::MAX_STEPS)?;
    numbers.set_item("gamma", DEFAULT_GAMMA)?;
    numbers.set_item("wheelset_points", wheelset::POINTS)?;
    numbers.set_item("lateral_position", wheelset::RANGE)?;
    Ok(numbers)
}
