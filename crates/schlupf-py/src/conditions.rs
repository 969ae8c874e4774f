//! Forces under many conditions, without a loop in Python.

use std::sync::{Arc, Mutex, PoisonError};

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schlupf::kinematics::Kinematics;
use schlupf::normal::PressureSource;
use schlupf::normal::at_load::AtLoad;
use schlupf::progress::Stage;
use schlupf::simplified::FastContact;
use schlupf::{Error, Method, Problem, Progress, Quantity, Solver, Status, Watch, parallel};
use schlupf_case::{Case, CaseErrors, quantity_field};
use schlupf_output::solution::SolutionReport;
use schlupf_tasks::{contact_law, messages};

use crate::case_file::CaseFile;
use crate::errors;
use crate::interruptible::interruptible;
use crate::laws::Raised;
use crate::records::described;
use crate::solution::Solution;

/// What may vary from condition to condition without another case; the rest is that of the case.
const VARIED: [Quantity; 5] =
    [Quantity::CreepageX, Quantity::CreepageY, Quantity::Spin, Quantity::Speed, Quantity::Load];

/// Names of the conditions that need no other case, each with its field.
#[pyfunction]
pub fn conditions() -> Vec<(&'static str, &'static str)> {
    VARIED.map(|quantity| (quantity.name(), quantity_field(quantity))).to_vec()
}

/// Values of what varies.
#[derive(Default)]
struct Conditions([Option<Vec<f64>>; VARIED.len()]);

impl Conditions {
    /// The value of a quantity in a condition, if it varies.
    fn value(&self, quantity: Quantity, k: usize) -> Option<f64> {
        let slot = VARIED.iter().position(|varied| *varied == quantity)?;
        self.0[slot].as_ref().map(|values| values[k])
    }

    /// Copies arrays of equal length, by name.
    fn read(arrays: &Bound<'_, PyDict>) -> PyResult<(Self, usize)> {
        let mut conditions = Self::default();
        let mut count = None;
        for (name, values) in arrays {
            let name: String = name.extract()?;
            let values: PyReadonlyArray1<'_, f64> = values.extract()?;
            let values = values.as_slice()?.to_vec();
            if *count.get_or_insert(values.len()) != values.len() {
                return Err(PyValueError::new_err("arrays must have the same length"));
            }
            let slot = VARIED.iter().position(|quantity| quantity.name() == name);
            let slot =
                slot.ok_or_else(|| PyValueError::new_err(format!("no condition: {name}")))?;
            conditions.0[slot] = Some(values);
        }
        Ok((conditions, count.unwrap_or(1)))
    }

    fn kinematics(&self, k: usize, own: &Kinematics) -> Kinematics {
        let of = |quantity, own| self.value(quantity, k).unwrap_or(own);
        Kinematics {
            creepage_x: of(Quantity::CreepageX, own.creepage_x),
            creepage_y: of(Quantity::CreepageY, own.creepage_y),
            spin: of(Quantity::Spin, own.spin),
            speed: of(Quantity::Speed, own.speed),
        }
    }

    fn load(&self, k: usize) -> Option<f64> {
        self.value(Quantity::Load, k)
    }
}

/// Forces on the wheel, one row for each condition.
#[derive(Debug, Default)]
struct Forces {
    x: Vec<f64>,
    y: Vec<f64>,
    /// Not a number where the method has none.
    moment_z: Vec<f64>,
    traction_coefficient: Vec<f64>,
    status: Vec<Status>,
}

impl Forces {
    /// As arrays by name, without copies.
    fn columns(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let table = PyDict::new(py);
        for (quantity, values) in [
            (Quantity::ForceX, self.x),
            (Quantity::ForceY, self.y),
            (Quantity::MomentZ, self.moment_z),
            (Quantity::TractionCoefficient, self.traction_coefficient),
        ] {
            let values = PyArray1::from_vec(py, values).into_any();
            table.set_item(quantity.name(), described(py, quantity, values)?)?;
        }
        Ok(table)
    }

    fn append(&mut self, mut other: Self) {
        self.x.append(&mut other.x);
        self.y.append(&mut other.y);
        self.moment_z.append(&mut other.moment_z);
        self.traction_coefficient.append(&mut other.traction_coefficient);
        self.status.append(&mut other.status);
    }

    fn push(&mut self, force: &schlupf::solution::Resultant, load: f64, status: Status) {
        self.x.push(force.x);
        self.y.push(force.y);
        self.moment_z.push(force.moment_z.unwrap_or(f64::NAN));
        self.traction_coefficient.push(force.tangential() / load);
        self.status.push(status);
    }
}

/// Conditions that one solver takes, one after the other: fixed numbers, so that the results do not
/// depend on how many threads there are.
const FAST_BLOCK: usize = 4096;
const FULL_BLOCK: usize = 64;

/// An error with the condition that it is about.
type Failure = (usize, Error);

/// The forces of all conditions, in their order, on all threads.
fn forces(
    case: &Case,
    conditions: &Conditions,
    count: usize,
    watch: Watch,
) -> Result<Forces, Failure> {
    let block = if case.method == Method::Full { FULL_BLOCK } else { FAST_BLOCK };
    let blocks = (0..count).step_by(block).map(|start| start..(start + block).min(count));
    let found = parallel::try_map(blocks.collect(), |block| match case.method {
        Method::Fast(method) => {
            let contact = FastContact::new(&case.problem, method, &case.options);
            fast(contact.map_err(|error| (block.start, error))?, case, conditions, block, watch)
        }
        Method::Full => full(case, conditions, block, watch),
    })?;
    let mut forces = Forces::default();
    for part in found {
        forces.append(part);
    }
    Ok(forces)
}

fn fast(
    mut contact: FastContact,
    case: &Case,
    conditions: &Conditions,
    block: std::ops::Range<usize>,
    watch: Watch,
) -> Result<Forces, Failure> {
    let own = case.problem.kinematics;
    if watch(Progress::count(Stage::Curve, block.start)).is_break() {
        return Err((block.start, Error::Stopped {}));
    }
    let mut forces = Forces::default();
    let mut load = contact.contact().normal.load;
    for k in block {
        let with_place = |error| (k, error);
        if let Some(wanted) = conditions.load(k).filter(|wanted| *wanted != load) {
            contact.set_load(wanted).map_err(with_place)?;
            load = wanted;
        }
        let force = contact.force(&conditions.kinematics(k, &own)).map_err(with_place)?;
        forces.push(&force, load, Status::Converged);
    }
    Ok(forces)
}

fn full(
    case: &Case,
    conditions: &Conditions,
    block: std::ops::Range<usize>,
    watch: Watch,
) -> Result<Forces, Failure> {
    let mut forces = Forces::default();
    let mut solver = LoadedSolver::new(case);
    for k in block {
        let with_place = |error| (k, error);
        let kinematics = conditions.kinematics(k, &case.problem.kinematics);
        let problem = solver.problem(case, kinematics, conditions.load(k), watch);
        let problem = problem.map_err(with_place)?;
        let solution = solver.solver.solve(&problem, watch).map_err(with_place)?;
        forces.push(&solution.force, solution.normal.load, solution.status);
    }
    Ok(forces)
}

/// A solver with the normal contact of the latest load.
struct LoadedSolver {
    solver: Box<dyn Solver>,
    normal: Arc<dyn PressureSource>,
    load: Option<f64>,
}

impl LoadedSolver {
    fn new(case: &Case) -> Self {
        Self { solver: case.solver(), normal: Arc::clone(&case.problem.normal), load: None }
    }

    /// The problem under these conditions.
    fn problem(
        &mut self,
        case: &Case,
        kinematics: Kinematics,
        load: Option<f64>,
        watch: Watch,
    ) -> Result<Problem, Error> {
        let own = &case.problem.normal;
        if let Some(load) = load.filter(|load| self.load != Some(*load)) {
            self.normal = Arc::new(AtLoad::new(Arc::clone(own), load)?);
            self.normal.prepare(None, watch)?;
            self.load = Some(load);
        }
        let normal = if load.is_some() { Arc::clone(&self.normal) } else { Arc::clone(own) };
        Ok(Problem { kinematics, normal, ..case.problem.clone() })
    }
}

fn explained(case: &Case, row: usize, error: &Error) -> CaseErrors {
    case.explain(error).help(format!("in condition {row}, counted from 0")).into()
}

/// Forces on the wheel of a case under many conditions: columns by name, and whether each
/// converged.
#[pyfunction]
pub fn batch<'py>(
    py: Python<'py>,
    case: &CaseFile,
    arrays: &Bound<'py, PyDict>,
) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyArray1<bool>>)> {
    let (conditions, count) = Conditions::read(arrays)?;
    let found = case.run(py, &Arc::default(), |file, watch| -> Result<Forces, CaseErrors> {
        let case = file.pose(watch)?;
        case.require_steady("forces under many conditions are those")?;
        forces(&case, &conditions, count, watch)
            .map_err(|(row, error)| explained(&case, row, &error))
    })?;
    let forces = found.map_err(|errors| errors::of_case(py, &errors))?;
    let converged = forces.status.iter().map(|status| *status == Status::Converged);
    let converged = PyArray1::from_iter(py, converged);
    Ok((forces.columns(py)?, converged))
}

/// A solver that keeps its set-up and its earlier solutions, for callers with loops of their own.
#[pyclass(frozen, module = "schlupf._core")]
pub struct BatchSolver {
    case: Case,
    solver: Mutex<LoadedSolver>,
    raised: Arc<Raised>,
}

#[pymethods]
impl BatchSolver {
    /// Of a case of steady rolling.
    #[new]
    fn new(py: Python<'_>, case: &CaseFile) -> PyResult<Self> {
        let raised = Arc::default();
        let posed = case.run(py, &raised, |file, watch| -> Result<Case, CaseErrors> {
            let case = file.pose(watch)?;
            case.require_steady("a solver is")?;
            Ok(case)
        })?;
        let case = posed.map_err(|errors| errors::of_case(py, &errors))?;
        let solver = Mutex::new(LoadedSolver::new(&case));
        Ok(Self { case, solver, raised })
    }

    /// Solves under other conditions, given by name; the rest is that of the case.
    fn solve(&self, py: Python<'_>, arrays: &Bound<'_, PyDict>) -> PyResult<Solution> {
        let (conditions, _) = Conditions::read(arrays)?;
        let solved = interruptible(py, &self.raised, |watch| {
            // A panic within a solution leaves a solver that starts anew.
            let mut solver = self.solver.lock().unwrap_or_else(PoisonError::into_inner);
            let case = &self.case;
            let kinematics = conditions.kinematics(0, &case.problem.kinematics);
            let problem = solver.problem(case, kinematics, conditions.load(0), watch)?;
            solver.solver.solve(&problem, watch)
        })?;
        let case = &self.case;
        let solution = solved.map_err(|error| errors::of_case(py, &case.explain(&error).into()))?;
        let contact_law = (solution.method == Method::Full).then(|| contact_law::of(case));
        let warnings = case.notices.iter().cloned().chain(messages(&solution.warnings)).collect();
        let title = case.title.clone();
        Ok(Solution::new(SolutionReport { title, contact_law, solution, warnings }))
    }
}
