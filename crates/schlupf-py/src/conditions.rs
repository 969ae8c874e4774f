//! Forces under many conditions, without a loop in Python.

use std::sync::{Arc, Mutex, PoisonError};

use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1, PyReadwriteArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schlupf::numerics::parallel;
use schlupf::reporting::{Column, Message, Record, Stage, Tallied, Tally};
use schlupf::wheel_rail::{Contact, WheelSolution};
use schlupf::{Error, Method, Progress, Quantity, Status, Warning, Watch};
use schlupf_case::fields::Field;
use schlupf_case::{CaseError, CaseErrors, FieldNames, FieldPath, Notice, Place, fields};
use schlupf_tasks::solve::report;
use schlupf_tasks::states::{Acting, CONTACTS, Entry, FAILED, NO_CONTACT, NoState, StateSolver};

use crate::case_file::CaseFile;
use crate::errors;
use crate::interruptible::{brief, interruptible};
use crate::laws::Raised;
use crate::records::described;
use crate::solution::Solution;

/// Fields that are conditions under a short name, too.
const NAMED: &[FieldPath] = &fields![
    "kinematics.creepage_x",
    "kinematics.creepage_y",
    "kinematics.spin",
    "kinematics.speed",
    "normal.load",
];

/// Short names of conditions, each with its field.
#[pyfunction]
pub fn conditions() -> Vec<(&'static str, &'static str)> {
    NAMED.iter().map(|path| (path.name(), path.as_str())).collect()
}

/// Arrays of fields by their paths.
type Arrays<'py> = Vec<(String, PyReadonlyArray1<'py, f64>)>;

/// Values of fields, one for each condition.
struct Conditions<'a> {
    fields: Vec<&'static Field>,
    values: Vec<&'a [f64]>,
}

impl<'a> Conditions<'a> {
    /// Arrays of equal length.
    fn of(py: Python<'_>, arrays: &'a Arrays) -> PyResult<Self> {
        let mut conditions = Self { fields: Vec::new(), values: Vec::new() };
        for (path, values) in arrays {
            let field = fields::named(path, || Place::Default);
            conditions.fields.push(field.map_err(|error| errors::of_case(py, &error.into()))?);
            conditions.values.push(values.as_slice()?);
        }
        let count = conditions.count();
        if conditions.values.iter().any(|values| values.len() != count) {
            return Err(PyValueError::new_err("arrays must have the same length"));
        }
        Ok(conditions)
    }

    fn count(&self) -> usize {
        self.values.first().map_or(1, |values| values.len())
    }

    fn entries(&self, k: usize) -> Vec<Entry> {
        self.values.iter().map(|values| Entry::Number(values[k])).collect()
    }

    /// Puts those entries in place of earlier ones.
    fn put(&self, k: usize, entries: &mut [Entry]) {
        for (entry, values) in entries.iter_mut().zip(&self.values) {
            *entry = Entry::Number(values[k]);
        }
    }

    /// Whether a notice is about the value of a field that they vary.
    fn varies(&self, notice: &Message) -> bool {
        let is_of = |field: &&Field| *field.path == *notice.quantity;
        notice.code == Notice::UNUSUAL && self.fields.iter().any(is_of)
    }

    /// The most unusual value of each field.
    fn unusual(&self) -> impl Iterator<Item = Tallied<Message, usize>> {
        self.fields.iter().zip(&self.values).filter_map(|(field, values)| {
            let (place, count) = fields::unusual(field, values)?;
            let of = Place::Override { option: CONDITION.into(), text: place.to_string() };
            let worst = Notice::of_unusual(field, &[values[place]], &of)?.into();
            Some(Tallied { worst, place, count, is_even: count == 1 })
        })
    }

    /// The order in which they are solved: those of a case after one another, with growing loads.
    fn order(&self, is_condition: &[bool]) -> Order {
        let by_case = (0..self.fields.len()).filter(|c| !is_condition[*c]);
        let by_load =
            (0..self.fields.len()).filter(|c| is_condition[*c] && self.fields[*c].shapes_contact);
        let keys: Vec<&[f64]> = by_case.chain(by_load).map(|c| self.values[c]).collect();
        if keys.is_empty() {
            return Order(None);
        }
        let mut order: Vec<usize> = (0..self.count()).collect();
        order.sort_by(|one, other| {
            let each = keys.iter().map(|key| key[*one].total_cmp(&key[*other]));
            each.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
        });
        Order(Some(order))
    }
}

/// The conditions in the order of their solutions, if it is not that of the conditions.
struct Order(Option<Vec<usize>>);

impl Order {
    /// The condition that is solved at this place.
    fn at(&self, place: usize) -> usize {
        self.0.as_ref().map_or(place, |order| order[place])
    }
}

/// Conditions that one solver takes, one after the other: fixed numbers, so that the results do not
/// depend on how many threads there are.
const FAST_BLOCK: usize = 4096;
const FULL_BLOCK: usize = 64;
/// A wheel with profiles is found anew in each.
const WHEEL_BLOCK: usize = 1;

/// What messages call a condition, counted from 0.
const CONDITION: &str = "condition";

/// What became of a condition, under its number in `status`.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Became {
    Converged,
    NotConverged,
    NoContact,
    Failed,
}

/// Names of the numbers in `status`.
#[pyfunction]
pub fn condition_status() -> [&'static str; 4] {
    [Status::Converged.name(), Status::NotConverged.name(), NO_CONTACT, FAILED]
}

/// The quantities of a contact.
const COLUMNS: [Quantity; 4] =
    [Quantity::ForceX, Quantity::ForceY, Quantity::MomentZ, Quantity::TractionCoefficient];

/// Names of all columns of forces.
#[pyfunction]
pub fn force_names() -> Vec<String> {
    let of_wheel = <WheelSolution as Record>::COLUMNS.iter().map(|column| column.quantity);
    let names = COLUMNS.into_iter().chain(of_wheel).map(|quantity| quantity.name().to_owned());
    names.chain(<Contact as Record>::COLUMNS.iter().map(of_contact)).collect()
}

/// The name of a column of contacts.
fn of_contact(column: &Column<Contact>) -> String {
    format!("contact_{}", column.name.replace('.', "_"))
}

/// Forces on the wheel, a row for each condition: [`COLUMNS`], columns of a wheel and of contacts.
struct Forces<'py> {
    columns: Vec<Filled<'py>>,
    status: Bound<'py, PyArray1<u8>>,
}

/// A column, with some values a row.
struct Filled<'py> {
    name: String,
    quantity: Quantity,
    width: usize,
    values: Bound<'py, PyArray1<f64>>,
}

/// Successive rows.
struct Rows<'a> {
    columns: Vec<&'a mut [f64]>,
    status: &'a mut [u8],
}

/// What is to be told of conditions.
#[derive(Default)]
struct Told {
    warnings: Tally<Message, usize>,
    /// The first condition that failed, and how many did.
    failure: Option<(usize, CaseErrors)>,
    failed: usize,
}

impl Told {
    fn fail(&mut self, condition: usize, errors: CaseErrors) {
        self.failed += 1;
        if self.failure.as_ref().is_none_or(|(first, _)| condition < *first) {
            self.failure = Some((condition, errors));
        }
    }

    fn add(&mut self, other: Self) {
        let failed = self.failed + other.failed;
        self.warnings.extend(other.warnings);
        if let Some((k, errors)) = other.failure {
            self.fail(k, errors);
        }
        self.failed = failed;
    }
}

impl<'py> Forces<'py> {
    /// With room for so many rows.
    fn new(py: Python<'py>, rows: usize, has_wheel: bool) -> Self {
        let column = |name: String, quantity, width| {
            let values = PyArray1::zeros(py, rows * width, false);
            Filled { name, quantity, width, values }
        };
        let contact = COLUMNS.into_iter().map(|of| column(of.name().to_owned(), of, 1));
        let wheel = <WheelSolution as Record>::COLUMNS.iter();
        let wheel = wheel.map(|of| column(of.quantity.name().to_owned(), of.quantity, 1));
        let contacts = <Contact as Record>::COLUMNS.iter();
        let contacts = contacts.map(|of| column(of_contact(of), of.quantity, CONTACTS));
        let of_wheel = wheel.chain(contacts).take_while(|_| has_wheel);
        let columns = contact.chain(of_wheel).collect();
        Self { columns, status: PyArray1::zeros(py, rows, false) }
    }

    /// Lets work fill its rows, in blocks.
    fn fill<R>(&self, size: usize, work: impl FnOnce(Vec<Rows>) -> R) -> PyResult<R> {
        let mut status = self.status.try_readwrite()?;
        let columns = self.columns.iter().map(|column| Ok(column.values.try_readwrite()?));
        let mut columns: Vec<PyReadwriteArray1<'_, f64>> = columns.collect::<PyResult<_>>()?;
        let with_status = |status| Rows { columns: Vec::new(), status };
        let mut blocks: Vec<Rows> =
            status.as_slice_mut()?.chunks_mut(size).map(with_status).collect();
        for (column, values) in self.columns.iter().zip(&mut columns) {
            let values = values.as_slice_mut()?.chunks_mut(size * column.width);
            for (block, values) in blocks.iter_mut().zip(values) {
                block.columns.push(values);
            }
        }
        Ok(work(blocks))
    }

    /// Puts rows that were filled in an order to their conditions.
    fn reorder(&self, order: &Order) -> PyResult<()> {
        let Order(Some(order)) = order else { return Ok(()) };
        for column in &self.columns {
            let (mut values, width) = (column.values.try_readwrite()?, column.width);
            let from = values.as_slice()?.to_vec();
            let to = values.as_slice_mut()?;
            for (values, k) in from.chunks(width).zip(order) {
                to[k * width..][..width].copy_from_slice(values);
            }
        }
        let mut status = self.status.try_readwrite()?;
        let from = status.as_slice()?.to_vec();
        let to = status.as_slice_mut()?;
        for (status, k) in from.into_iter().zip(order) {
            to[*k] = status;
        }
        Ok(())
    }

    /// Its arrays by name: those of a contact have [`CONTACTS`] values a row.
    fn columns(self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let table = PyDict::new(py);
        for Filled { name, quantity, values, .. } in self.columns {
            table.set_item(name, described(py, quantity, values.into_any())?)?;
        }
        Ok(table)
    }
}

impl Rows<'_> {
    fn set(&mut self, row: usize, acting: &Acting) {
        let moment = acting.force.moment_z.unwrap_or(f64::NAN);
        let coefficient = acting.force.tangential() / acting.load;
        if let [x, y, moment_z, traction_coefficient, ..] = &mut self.columns[..] {
            x[row] = acting.force.x;
            y[row] = acting.force.y;
            moment_z[row] = moment;
            traction_coefficient[row] = coefficient;
        }
        if let Some(wheel) = acting.wheel {
            let (of_wheel, of_contacts) =
                self.columns[COLUMNS.len()..].split_at_mut(WheelSolution::COLUMNS.len());
            put(of_wheel, row, wheel);
            for (k, contact) in wheel.contacts.iter().take(CONTACTS).enumerate() {
                put(of_contacts, CONTACTS * row + k, contact);
            }
        }
        self.status[row] = match acting.status {
            Status::Converged => Became::Converged as u8,
            Status::NotConverged => Became::NotConverged as u8,
        };
    }

    /// Nothing acts: forces, not their ratios, are zero.
    fn set_none(&mut self, row: usize) {
        let of_wheel = <WheelSolution as Record>::COLUMNS.iter().map(|column| column.quantity);
        let quantities = COLUMNS.into_iter().chain(of_wheel);
        for (column, quantity) in self.columns.iter_mut().zip(quantities) {
            let is_zero =
                matches!(quantity.unit(), "N" | "N m") || quantity == Quantity::ContactCount;
            column[row] = if is_zero { 0.0 } else { f64::NAN };
        }
        self.status[row] = Became::NoContact as u8;
    }

    /// Nothing is known.
    fn set_failed(&mut self, row: usize) {
        self.columns.iter_mut().take(COLUMNS.len()).for_each(|column| column[row] = f64::NAN);
        self.status[row] = Became::Failed as u8;
    }
}

/// The only row of a record.
fn put<R: Record>(columns: &mut [&mut [f64]], row: usize, record: &R) {
    for (values, Column { value, .. }) in columns.iter_mut().zip(R::COLUMNS) {
        values[row] = value(record, 0).number().unwrap_or(f64::NAN);
    }
}

/// How conditions are solved: from which solver, in which order, and in blocks of which size.
struct Plan {
    solver: StateSolver,
    order: Order,
    has_wheel: bool,
    size: usize,
    /// Of all conditions.
    notices: Vec<Message>,
}

impl Plan {
    fn new(
        file: &schlupf_case::CaseFile,
        conditions: &Conditions,
        watch: Watch,
    ) -> Result<Self, CaseErrors> {
        let mut solver = StateSolver::new(file.clone(), conditions.fields.clone());
        let order = conditions.order(&solver.conditions(&conditions.entries(0)));
        let (mut has_wheel, mut size, mut notices) = (false, FULL_BLOCK, Vec::new());
        // What cannot be posed is told with its condition.
        for place in 0..conditions.count() {
            match solver.prepare(&conditions.entries(order.at(place)), CONDITION, watch) {
                Ok(case) => {
                    has_wheel = case.wheel.is_some();
                    notices.clone_from(&case.notices);
                    size = match case.method {
                        _ if has_wheel => WHEEL_BLOCK,
                        Method::Full => FULL_BLOCK,
                        Method::Fast(_) => FAST_BLOCK,
                    };
                    break;
                }
                Err(NoState::Stopped) => return Err(file.explain(&Error::Stopped {}).into()),
                Err(_) => {}
            }
        }
        Ok(Self { solver, order, has_wheel, size, notices })
    }

    /// The forces of all conditions on all threads.
    fn run(
        &self,
        conditions: &Conditions,
        rows: Vec<Rows>,
        watch: Watch,
    ) -> Result<Told, CaseErrors> {
        let places = (0..conditions.count()).step_by(self.size).zip(rows).collect();
        let found = parallel::try_map(places, |(place, rows): (usize, Rows)| {
            block_of(&mut self.solver.fork(), (conditions, &self.order), (place, rows), watch)
        });
        let stopped = |()| CaseErrors::from(self.solver.file().explain(&Error::Stopped {}));
        let mut told = Told::default();
        for notice in self.notices.iter().filter(|notice| !conditions.varies(notice)) {
            told.warnings.add(Tallied::new(notice.clone(), 0, conditions.count()));
        }
        told.warnings.extend(conditions.unusual());
        found.map_err(stopped)?.into_iter().for_each(|of_block| told.add(of_block));
        Ok(told)
    }
}

/// Those of successive conditions from a place on, which one solver takes one after the other; an
/// error if it was stopped.
fn block_of(
    solver: &mut StateSolver,
    (conditions, order): (&Conditions, &Order),
    (place, mut rows): (usize, Rows),
    watch: Watch,
) -> Result<Told, ()> {
    let (mut told, mut warnings) = (Told::default(), Tally::default());
    // Those of a contact are set in every row.
    rows.columns.iter_mut().skip(COLUMNS.len()).for_each(|column| column.fill(f64::NAN));
    let mut entries = conditions.entries(order.at(place));
    if watch(Progress::count(Stage::Curve, place)).is_break() {
        return Err(());
    }
    for row in 0..rows.status.len() {
        let k = order.at(place + row);
        conditions.put(k, &mut entries);
        let mut warn = |warning: &Warning| {
            // Of a condition only what the table does not show.
            if !matches!(warning, Warning::NotConverged { .. }) {
                warnings.note(warning.clone(), k);
            }
        };
        let name = || format!("{CONDITION} {k}");
        match solver.acting(&entries, name, &mut warn, watch) {
            Ok(acting) => rows.set(row, &acting),
            Err(NoState::NoContact) => rows.set_none(row),
            Err(NoState::Failed(errors)) => {
                rows.set_failed(row);
                told.fail(k, errors);
            }
            Err(NoState::Stopped) => return Err(()),
        }
    }
    told.warnings.extend(warnings.into_iter().map(|found: Tallied<Warning, usize>| Tallied {
        worst: found.worst.message(&FieldNames::CASE),
        place: found.place,
        count: found.count,
        is_even: found.is_even,
    }));
    Ok(told)
}

/// Warnings as code, quantity, text, number of conditions, the worst or first of them, and whether
/// all are equally severe.
type Warnings = Vec<(String, String, String, usize, usize, bool)>;

/// Forces on the wheel under many conditions, which are values of fields by their paths: columns by
/// name, the number in [`condition_status`] of each, and warnings. An error is that of the first
/// condition that failed, where all have, or `strict` asks for it.
#[pyfunction]
pub fn batch<'py>(
    py: Python<'py>,
    case: &CaseFile,
    arrays: &Bound<'py, PyDict>,
    strict: bool,
) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyArray1<u8>>, Warnings)> {
    let arrays: Arrays = arrays.items().extract()?;
    let conditions = Conditions::of(py, &arrays)?;
    let raised = Arc::default();
    let planned = case.run(py, &raised, |file, watch| Plan::new(file, &conditions, watch))?;
    let plan = planned.map_err(|errors| errors::of_case(py, &errors))?;
    let forces = Forces::new(py, conditions.count(), plan.has_wheel);
    let told = forces.fill(plan.size, |rows| {
        interruptible(py, &raised, |watch| plan.run(&conditions, rows, watch))
    })??;
    let told = told.map_err(|errors| errors::of_case(py, &errors))?;
    forces.reorder(&plan.order)?;
    let mut warnings = Vec::new();
    if let Some((k, errors)) = told.failure {
        let place = Place::Override { option: CONDITION.into(), text: k.to_string() };
        let first = CaseError { place, ..*errors.first };
        if strict || told.failed == conditions.count() {
            return Err(errors::of_case(py, &first.into()));
        }
        let text = first.message;
        warnings.push(("failed".to_owned(), first.field, text, told.failed, k, true));
    }
    warnings.extend(told.warnings.into_iter().map(|Tallied { worst, place, count, is_even }| {
        (worst.code.to_owned(), worst.quantity, worst.text, count, place, is_even)
    }));
    let status = forces.status.clone();
    Ok((forces.columns(py)?, status, warnings))
}

/// A solver that keeps its set-up and its earlier solutions, for callers with loops of their own.
#[pyclass(frozen, module = "schlupf._core")]
pub struct BatchSolver {
    solver: Mutex<StateSolver>,
    is_fast: bool,
    raised: Arc<Raised>,
}

#[pymethods]
impl BatchSolver {
    /// Of a case of steady rolling.
    #[new]
    fn new(py: Python<'_>, case: &CaseFile) -> PyResult<Self> {
        let raised = Arc::default();
        let posed = case.run(py, &raised, |file, watch| -> Result<_, CaseErrors> {
            let mut solver = StateSolver::new(file.clone(), Vec::new()).as_asked();
            match solver.prepare(&[], "Case", watch) {
                Ok(case) => {
                    let is_fast = case.method != Method::Full;
                    Ok((solver, is_fast))
                }
                Err(failure) => Err(failure.errors(file)),
            }
        })?;
        let (solver, is_fast) = posed.map_err(|errors| errors::of_case(py, &errors))?;
        Ok(Self { solver: Mutex::new(solver), is_fast, raised })
    }

    /// Solves with other values of fields, by their paths; the rest is that of the case.
    fn solve(&self, py: Python<'_>, arrays: &Bound<'_, PyDict>) -> PyResult<Solution> {
        let arrays: Arrays = arrays.items().extract()?;
        let conditions = Conditions::of(py, &arrays)?;
        let work = |watch: Watch<'_>| {
            // A panic within a solution leaves a solver that starts anew.
            let mut solver = self.solver.lock().unwrap_or_else(PoisonError::into_inner);
            solver.vary(conditions.fields.clone());
            match solver.solve(&conditions.entries(0), "solve", watch) {
                Ok((case, solution)) => Ok(report(case, solution)),
                Err(failure) => Err(failure.errors(solver.file())),
            }
        };
        let solved = if self.is_fast {
            brief(py, &self.raised, work)?
        } else {
            interruptible(py, &self.raised, work)?
        };
        solved.map(Solution::new).map_err(|errors| errors::of_case(py, &errors))
    }
}
