//! Forces under many conditions, without a loop in Python.

use std::sync::{Arc, Mutex, PoisonError};

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schlupf::kinematics::Kinematics;
use schlupf::message::Message;
use schlupf::method::FastMethod;
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
    /// The value of a quantity in a condition, if it varies.
    fn value(&self, quantity: Quantity, k: usize) -> Option<f64> {
        let slot = VARIED.iter().position(|varied| *varied == quantity)?;
        self.0[slot].as_ref().map(|values| values[k])
    }

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
    warnings: Vec<Repeated>,
}

/// A warning that several conditions may have.
#[derive(Debug)]
struct Repeated {
    message: Message,
    /// The first condition that has it.
    first: usize,
    count: usize,
}

impl Forces {
    /// Room for a number of conditions.
    fn blank(count: usize) -> Self {
        let blank = || vec![f64::NAN; count];
        Self {
            x: blank(),
            y: blank(),
            moment_z: blank(),
            traction_coefficient: blank(),
            status: vec![Status::NotConverged; count],
            warnings: Vec::new(),
        }
    }

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

    /// Takes over the forces of some conditions.
    fn fill(&mut self, places: &[usize], part: Self) {
        for (k, place) in places.iter().enumerate() {
            self.x[*place] = part.x[k];
            self.y[*place] = part.y[k];
            self.moment_z[*place] = part.moment_z[k];
            self.traction_coefficient[*place] = part.traction_coefficient[k];
            self.status[*place] = part.status[k];
        }
        for warning in part.warnings {
            self.note(warning);
        }
    }

    fn push(&mut self, force: &schlupf::solution::Resultant, load: f64, status: Status) {
        self.x.push(force.x);
        self.y.push(force.y);
        self.moment_z.push(force.moment_z.unwrap_or(f64::NAN));
        self.traction_coefficient.push(force.tangential() / load);
        self.status.push(status);
    }

    /// Warnings of a condition, apart from those that the table shows.
    fn warn(&mut self, condition: usize, messages: impl IntoIterator<Item = Message>) {
        for message in messages {
            if !SHOWN.contains(&message.code) {
                self.note(Repeated { message, first: condition, count: 1 });
            }
        }
    }

    /// Counts a warning together with those that are alike.
    fn note(&mut self, new: Repeated) {
        let is_alike = |old: &&mut Repeated| {
            old.message.code == new.message.code && old.message.quantity == new.message.quantity
        };
        match self.warnings.iter_mut().find(is_alike) {
            None => self.warnings.push(new),
            Some(old) => {
                old.count += new.count;
                if new.first < old.first {
                    (old.first, old.message) = (new.first, new.message);
                }
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

/// An error with the condition that it is about.
type Failure = (usize, CaseErrors);

/// Some conditions of a case, which one solver takes one after the other.
struct Block<'a> {
    case: &'a Case,
    conditions: &'a Conditions,
    places: &'a [usize],
}

/// The forces of all conditions on all threads. Each case has its conditions.
fn forces(
    files: &[schlupf_case::CaseFile],
    places: &[Vec<usize>],
    conditions: &Conditions,
    watch: Watch,
) -> Result<Forces, CaseErrors> {
    let posed = parallel::try_map(files.iter().collect(), |file| {
        let case = file.pose(watch)?;
        case.require_steady("forces under many conditions are those")?;
        Ok::<_, CaseErrors>(case)
    })?;
    let blocks = posed.iter().zip(places).flat_map(|(case, places)| {
        let size = if case.method == Method::Full { FULL_BLOCK } else { FAST_BLOCK };
        places.chunks(size).map(move |places| Block { case, conditions, places })
    });
    let found = parallel::try_map(blocks.collect(), |block| {
        let found = match block.case.method {
            Method::Fast(method) => block.fast(method, watch),
            Method::Full => block.full(watch),
        };
        Ok::<_, CaseErrors>((block.places, found.map_err(|(place, error)| help(place, error))?))
    })?;
    let mut forces = Forces::blank(places.iter().map(Vec::len).sum());
    for (places, part) in found {
        forces.fill(places, part);
    }
    for (case, places) in posed.iter().zip(places) {
        if let Some(first) = places.first() {
            for message in case.notices.iter().cloned() {
                forces.note(Repeated { message, first: *first, count: places.len() });
            }
        }
    }
    Ok(forces)
}

impl Block<'_> {
    fn fast(&self, method: FastMethod, watch: Watch) -> Result<Forces, Failure> {
        let Self { case, conditions, places } = *self;
        let start = places[0];
        let explain = |place, error: &Error| (place, CaseErrors::from(case.explain(error)));
        let contact = FastContact::new(&case.problem, method, &case.options);
        let mut contact = contact.map_err(|error| explain(start, &error))?;
        if watch(Progress::count(Stage::Curve, start)).is_break() {
            return Err(explain(start, &Error::Stopped {}));
        }
        let mut forces = Forces::default();
        for message in messages(&contact.warnings()) {
            forces.note(Repeated { message, first: start, count: places.len() });
        }
        let own = case.problem.kinematics;
        let mut load = contact.contact().normal.load;
        for k in places.iter().copied() {
            let explain = |error| explain(k, &error);
            if let Some(wanted) = conditions.load(k).filter(|wanted| *wanted != load) {
                contact.set_load(wanted).map_err(explain)?;
                load = wanted;
            }
            let force = contact.force(&conditions.kinematics(k, &own)).map_err(explain)?;
            forces.push(&force, load, Status::Converged);
            if let Some(warning) = contact.beyond_friction(&force) {
                forces.warn(k, messages(&[warning]));
            }
        }
        Ok(forces)
    }

    fn full(&self, watch: Watch) -> Result<Forces, Failure> {
        let Self { case, conditions, places } = *self;
        let mut forces = Forces::default();
        let mut solver = LoadedSolver::new(case);
        for k in places.iter().copied() {
            let explain = |error| (k, CaseErrors::from(case.explain(&error)));
            let kinematics = conditions.kinematics(k, &case.problem.kinematics);
            let problem = solver.problem(case, kinematics, conditions.load(k), watch);
            let problem = problem.map_err(explain)?;
            let solution = solver.solver.solve(&problem, watch).map_err(explain)?;
            forces.push(&solution.force, solution.normal.load, solution.status);
            forces.warn(k, messages(&solution.warnings));
        }
        Ok(forces)
    }
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

/// An error with its condition.
fn help(place: usize, errors: CaseErrors) -> CaseErrors {
    errors.first.help(format!("in condition {place}, counted from 0")).into()
}

/// Warnings as code, quantity, text, number of conditions, and the first of them.
type Warnings = Vec<(String, String, String, usize, usize)>;

/// Forces on the wheel under many conditions: columns by name, whether each converged, and
/// warnings. Condition k is one of the case `which[k]`.
#[pyfunction]
pub fn batch<'py>(
    py: Python<'py>,
    cases: Vec<PyRef<'py, CaseFile>>,
    which: PyReadonlyArray1<'py, i64>,
    arrays: &Bound<'py, PyDict>,
) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyArray1<bool>>, Warnings)> {
    let conditions = Conditions::read(arrays)?;
    let mut places = vec![Vec::new(); cases.len()];
    for (k, case) in which.as_array().iter().enumerate() {
        places[*case as usize].push(k);
    }
    let found = CaseFile::run_all(&cases, py, &Arc::default(), |files, watch| {
        forces(files, &places, &conditions, watch)
    })?;
    let mut forces = found.map_err(|errors| errors::of_case(py, &errors))?;
    let warnings = std::mem::take(&mut forces.warnings).into_iter();
    let warnings = warnings.map(|Repeated { message, first, count }| {
        (message.code.to_owned(), message.quantity, message.text, count, first)
    });
    let warnings = warnings.collect();
    let converged = forces.status.iter().map(|status| *status == Status::Converged);
    let converged = PyArray1::from_iter(py, converged);
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
            let problem = solver.problem(case, kinematics, conditions.load(0), watch)?;
            solver.solver.solve(&problem, watch)
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
        Ok(Solution::new(SolutionReport { title, contact_law, solution, warnings }))
    }
}
