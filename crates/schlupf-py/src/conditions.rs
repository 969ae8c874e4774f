//! Forces under many conditions, without a loop in Python.

use std::sync::{Arc, Mutex, PoisonError};

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schlupf::kinematics::Kinematics;
use schlupf::message::Message;
use schlupf::method::FastMethod;
use schlupf::progress::Stage;
use schlupf::simplified::FastContact;
use schlupf::solution::Resultant;
use schlupf::{Error, Method, Progress, Quantity, Status, Watch, parallel};
use schlupf_case::{Case, CaseError, CaseErrors, Place, quantity_field};
use schlupf_output::solution::SolutionReport;
use schlupf_tasks::loaded_solver::LoadedSolver;
use schlupf_tasks::{contact_law, messages};

use crate::case_file::CaseFile;
use crate::errors;
use crate::interruptible::{brief, interruptible};
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
    /// Copies arrays of equal length, by name.
    fn read(arrays: &Bound<'_, PyDict>) -> PyResult<Self> {
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
        Ok(conditions)
    }

    fn kinematics(&self, k: usize, own: &Kinematics) -> Kinematics {
        let [creepage_x, creepage_y, spin, speed, _] = &self.0;
        let of = |values: &Option<Vec<f64>>, own| values.as_ref().map_or(own, |values| values[k]);
        Kinematics {
            creepage_x: of(creepage_x, own.creepage_x),
            creepage_y: of(creepage_y, own.creepage_y),
            spin: of(spin, own.spin),
            speed: of(speed, own.speed),
        }
    }

    fn load(&self, k: usize) -> Option<f64> {
        let [.., load] = &self.0;
        load.as_ref().map(|values| values[k])
    }
}

/// Forces on the wheel, one row for each condition.
#[derive(Debug)]
struct Forces {
    /// Forces along x and y, the moment (not a number where the method has none), and |F|/N.
    values: [Vec<f64>; COLUMNS.len()],
    converged: Vec<bool>,
    warnings: Vec<Repeated>,
}

/// The quantities of its columns.
const COLUMNS: [Quantity; 4] =
    [Quantity::ForceX, Quantity::ForceY, Quantity::MomentZ, Quantity::TractionCoefficient];

/// A warning that several conditions may have.
#[derive(Debug)]
struct Repeated {
    message: Message,
    /// The first condition that has it.
    first: usize,
    count: usize,
}

impl Forces {
    /// As arrays by name, without copies.
    fn columns(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let table = PyDict::new(py);
        for (quantity, values) in COLUMNS.into_iter().zip(self.values) {
            let values = PyArray1::from_vec(py, values).into_any();
            table.set_item(quantity.name(), described(py, quantity, values)?)?;
        }
        Ok(table)
    }
}

/// Counts a warning together with those that are alike; of a condition only what the table does not
/// show.
fn note(warnings: &mut Vec<Repeated>, new: Repeated) {
    let is_alike = |old: &&mut Repeated| {
        old.message.code == new.message.code && old.message.quantity == new.message.quantity
    };
    match warnings.iter_mut().find(is_alike) {
        _ if SHOWN.contains(&new.message.code) => {}
        None => warnings.push(new),
        Some(old) => {
            old.count += new.count;
            if new.first < old.first {
                (old.first, old.message) = (new.first, new.message);
            }
        }
    }
}

/// Codes of warnings about what the table shows: that there are forces only, and their status.
const SHOWN: [&str; 2] = ["forces-only", Message::NOT_CONVERGED];

/// Conditions that one solver takes, one after the other: fixed numbers, so that the results do not
/// depend on how many threads there are.
const FAST_BLOCK: usize = 4096;
const FULL_BLOCK: usize = 64;

/// An error, and the condition that it is about if it is not about all.
type Failure = (Option<usize>, CaseErrors);

/// What messages call a condition, counted from 0.
const CONDITION: &str = "condition";

/// Successive conditions of a case, which one solver takes one after the other, and their results.
struct Block<'a> {
    case: &'a Case,
    conditions: &'a Conditions,
    start: usize,
    values: [&'a mut [f64]; COLUMNS.len()],
    converged: &'a mut [bool],
}

/// The forces of all conditions on all threads: case by case as many as `counts` says.
fn forces(
    files: &[schlupf_case::CaseFile],
    counts: &[usize],
    conditions: &Conditions,
    watch: Watch,
) -> Result<Forces, Failure> {
    let posed = parallel::try_map(files.iter().collect(), |file| {
        let case = file.pose(watch)?;
        case.require_steady("forces under many conditions are those")?;
        Ok::<_, CaseErrors>(case)
    });
    let posed = posed.map_err(|errors| (None, errors))?;
    let total = counts.iter().sum();
    let mut values = COLUMNS.map(|_| vec![0.0; total]);
    let mut converged = vec![false; total];
    let mut warnings = Vec::new();
    let mut blocks = Vec::new();
    let mut rest = values.each_mut().map(Vec::as_mut_slice);
    let mut rest_converged = converged.as_mut_slice();
    let mut start = 0;
    for (case, count) in posed.iter().zip(counts) {
        for message in case.notices.iter().cloned() {
            note(&mut warnings, Repeated { message, first: start, count: *count });
        }
        let size = if case.method == Method::Full { FULL_BLOCK } else { FAST_BLOCK };
        let end = start + count;
        while start < end {
            let size = size.min(end - start);
            let values = rest.each_mut().map(|rest| rest.split_off_mut(..size).unwrap_or_default());
            let converged = rest_converged.split_off_mut(..size).unwrap_or_default();
            blocks.push(Block { case, conditions, start, values, converged });
            start += size;
        }
    }
    let found = parallel::try_map(blocks, |block| match block.case.method {
        Method::Fast(method) if block.case.problem.prescribed.is_none() => {
            block.fast(method, watch)
        }
        _ => block.full(watch),
    })?;
    for warning in found.into_iter().flatten() {
        note(&mut warnings, warning);
    }
    Ok(Forces { values, converged, warnings })
}

impl Block<'_> {
    /// Finds the forces; returns the warnings.
    fn fast(mut self, method: FastMethod, watch: Watch) -> Result<Vec<Repeated>, Failure> {
        let Self { case, conditions, start, .. } = self;
        let explain = |k, error: &Error| (Some(k), CaseErrors::from(case.explain(error)));
        let contact = FastContact::new(&case.problem, method, &case.options);
        let mut contact = contact.map_err(|error| explain(start, &error))?;
        if watch(Progress::count(Stage::Curve, start)).is_break() {
            return Err(explain(start, &Error::Stopped {}));
        }
        let mut warnings = Vec::new();
        for message in messages(&contact.warnings()) {
            note(&mut warnings, Repeated { message, first: start, count: self.converged.len() });
        }
        let own = case.problem.kinematics;
        let mut load = contact.contact().normal.load;
        for k in start..start + self.converged.len() {
            let explain = |error| explain(k, &error);
            if let Some(wanted) = conditions.load(k).filter(|wanted| *wanted != load) {
                contact.set_load(wanted).map_err(explain)?;
                load = wanted;
            }
            let force = contact.force(&conditions.kinematics(k, &own)).map_err(explain)?;
            self.set(k, &force, load, Status::Converged);
            for message in messages(contact.beyond_friction(&force).as_slice()) {
                note(&mut warnings, Repeated { message, first: k, count: 1 });
            }
        }
        Ok(warnings)
    }

    /// The same by a solver: by the full method, or where forces are prescribed.
    fn full(mut self, watch: Watch) -> Result<Vec<Repeated>, Failure> {
        let Self { case, conditions, start, .. } = self;
        let mut warnings = Vec::new();
        let mut solver = LoadedSolver::without_state(case);
        for k in start..start + self.converged.len() {
            let explain = |error| (Some(k), CaseErrors::from(case.explain(&error)));
            let kinematics = conditions.kinematics(k, &case.problem.kinematics);
            let solution = solver.solve(case, kinematics, conditions.load(k), watch);
            let solution = solution.map_err(explain)?;
            self.set(k, &solution.force, solution.normal.load, solution.status);
            for message in messages(&solution.warnings) {
                note(&mut warnings, Repeated { message, first: k, count: 1 });
            }
        }
        Ok(warnings)
    }

    fn set(&mut self, k: usize, force: &Resultant, load: f64, status: Status) {
        let k = k - self.start;
        let moment = force.moment_z.unwrap_or(f64::NAN);
        let row = [force.x, force.y, moment, force.tangential() / load];
        for (column, value) in self.values.iter_mut().zip(row) {
            column[k] = value;
        }
        self.converged[k] = status == Status::Converged;
    }
}

/// Warnings as code, quantity, text, number of conditions, and the first of them.
type Warnings = Vec<(String, String, String, usize, usize)>;

/// Forces on the wheel under many conditions: columns by name, whether each converged, and
/// warnings. The conditions are those of the first case, as many as `counts` says, then those of
/// the second and so on; `places` are their numbers in messages, if they have others.
#[pyfunction]
pub fn batch<'py>(
    py: Python<'py>,
    cases: Vec<PyRef<'py, CaseFile>>,
    counts: Vec<usize>,
    places: Option<Vec<usize>>,
    arrays: &Bound<'py, PyDict>,
) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyArray1<bool>>, Warnings)> {
    let conditions = Conditions::read(arrays)?;
    let place = |k: usize| places.as_ref().map_or(k, |places| places[k]);
    let found = CaseFile::run_all(&cases, py, &Arc::default(), |files, watch| {
        forces(files, &counts, &conditions, watch).map_err(|(k, errors)| match k {
            None => errors,
            Some(k) => CaseErrors::from(CaseError {
                place: Place::Override { option: CONDITION.into(), text: place(k).to_string() },
                ..*errors.first
            }),
        })
    })?;
    let mut forces = found.map_err(|errors| errors::of_case(py, &errors))?;
    let warnings = std::mem::take(&mut forces.warnings).into_iter();
    let warnings = warnings.map(|Repeated { message, first, count }| {
        (message.code.to_owned(), message.quantity, message.text, count, place(first))
    });
    let warnings = warnings.collect();
    let converged = PyArray1::from_slice(py, &forces.converged);
    Ok((forces.columns(py)?, converged, warnings))
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
        let conditions = Conditions::read(arrays)?;
        let work = |watch: Watch<'_>| {
            // A panic within a solution leaves a solver that starts anew.
            let mut solver = self.solver.lock().unwrap_or_else(PoisonError::into_inner);
            let case = &self.case;
            let kinematics = conditions.kinematics(0, &case.problem.kinematics);
            solver.solve(case, kinematics, conditions.load(0), watch)
        };
        let solved = match self.case.method {
            Method::Full => interruptible(py, &self.raised, work)?,
            Method::Fast(_) => brief(py, &self.raised, work)?,
        };
        let case = &self.case;
        let solution = solved.map_err(|error| errors::of_case(py, &case.explain(&error).into()))?;
        let contact_law = (solution.method == Method::Full).then(|| contact_law::of(case));
        let warnings = case.notices.iter().cloned().chain(messages(&solution.warnings)).collect();
        let title = case.title.clone();
        Ok(Solution::new(SolutionReport { title, contact_law, solution, wheel: None, warnings }))
    }
}
