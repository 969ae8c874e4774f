//! Forces under many conditions, without a loop in Python.

use std::sync::{Arc, Mutex, PoisonError};

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schlupf::columns::{Column, Record};
use schlupf::message::Message;
use schlupf::progress::Stage;
use schlupf::tally::{Tallied, Tally};
use schlupf::wheel_rail::{Contact, WheelSolution};
use schlupf::{Error, Method, Progress, Quantity, Status, Warning, Watch, parallel};
use schlupf_case::fields::{self, Field};
use schlupf_case::{CaseError, CaseErrors, Cause, FieldNames, Notice, Place, quantity_field};
use schlupf_tasks::solve::report;
use schlupf_tasks::states::{Acting, CONTACTS, Entry, FAILED, NO_CONTACT, NoState, StateSolver};

use crate::case_file::CaseFile;
use crate::errors;
use crate::interruptible::{brief, interruptible};
use crate::laws::Raised;
use crate::records::described;
use crate::solution::Solution;

/// Fields that are conditions under a short name, too.
const NAMED: [Quantity; 5] =
    [Quantity::CreepageX, Quantity::CreepageY, Quantity::Spin, Quantity::Speed, Quantity::Load];

/// Short names of conditions, each with its field.
#[pyfunction]
pub fn conditions() -> Vec<(&'static str, &'static str)> {
    NAMED.map(|quantity| (quantity.name(), quantity_field(quantity))).to_vec()
}

/// Values of fields, one for each condition.
struct Conditions {
    fields: Vec<&'static Field>,
    values: Vec<Vec<f64>>,
}

impl Conditions {
    /// Copies arrays of equal length, by the paths of their fields.
    fn read(arrays: &Bound<'_, PyDict>) -> PyResult<Self> {
        let mut conditions = Self { fields: Vec::new(), values: Vec::new() };
        for (path, values) in arrays {
            let path: String = path.extract()?;
            let values: PyReadonlyArray1<'_, f64> = values.extract()?;
            let field = fields::find(&path);
            let no_field = || PyValueError::new_err(format!("no field: {path}"));
            conditions.fields.push(field.ok_or_else(no_field)?);
            conditions.values.push(values.as_slice()?.to_vec());
        }
        let count = conditions.count();
        if conditions.values.iter().any(|values| values.len() != count) {
            return Err(PyValueError::new_err("arrays must have the same length"));
        }
        Ok(conditions)
    }

    fn count(&self) -> usize {
        self.values.first().map_or(1, Vec::len)
    }

    fn entries(&self, k: usize) -> Vec<Entry> {
        self.values.iter().map(|values| Entry::Number(values[k])).collect()
    }

    /// The same in place of earlier ones.
    fn put(&self, k: usize, entries: &mut [Entry]) {
        for (entry, values) in entries.iter_mut().zip(&self.values) {
            *entry = Entry::Number(values[k]);
        }
    }

    /// Whether a notice is about the value of a field that they vary.
    fn varies(&self, notice: &Message) -> bool {
        let is_of = |field: &&Field| field.path == notice.quantity;
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
    fn order(&self, is_condition: &[bool]) -> Vec<usize> {
        let by_case = (0..self.fields.len()).filter(|c| !is_condition[*c]);
        let by_load =
            (0..self.fields.len()).filter(|c| is_condition[*c] && self.fields[*c].shapes_contact);
        let keys: Vec<&[f64]> = by_case.chain(by_load).map(|c| &*self.values[c]).collect();
        let mut order: Vec<usize> = (0..self.count()).collect();
        if !keys.is_empty() {
            order.sort_by(|one, other| {
                let each = keys.iter().map(|key| key[*one].total_cmp(&key[*other]));
                each.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
            });
        }
        order
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

/// What acts on the wheel, a row for each condition.
#[derive(Default)]
struct Forces {
    /// Of each of [`COLUMNS`]; a moment is not a number where the method has none.
    values: [Vec<f64>; COLUMNS.len()],
    /// Of each column of a wheel, and of each column of a contact, [`CONTACTS`] a row; none without
    /// a wheel.
    wheel: Vec<Vec<f64>>,
    contacts: Vec<Vec<f64>>,
    status: Vec<u8>,
    warnings: Tally<Message, usize>,
    /// The first condition that failed, and how many did.
    failure: Option<(usize, CaseErrors)>,
    failed: usize,
}

/// The quantities of a contact.
const COLUMNS: [Quantity; 4] =
    [Quantity::ForceX, Quantity::ForceY, Quantity::MomentZ, Quantity::TractionCoefficient];

/// Names of all columns of forces.
#[pyfunction]
pub fn force_names() -> Vec<String> {
    let of_wheel = <WheelSolution as Record>::columns().iter().map(|column| column.quantity);
    let names = COLUMNS.into_iter().chain(of_wheel).map(|quantity| quantity.name().to_owned());
    names.chain(<Contact as Record>::columns().iter().map(of_contact)).collect()
}

/// The name of a column of contacts.
fn of_contact(column: &Column<Contact>) -> String {
    format!("contact_{}", column.name.replace('.', "_"))
}

impl Forces {
    /// With room for so many rows.
    fn new(rows: usize, has_wheel: bool) -> Self {
        let columns = |count: usize, width: usize| {
            vec![vec![f64::NAN; rows * width]; if has_wheel { count } else { 0 }]
        };
        Self {
            values: COLUMNS.map(|_| vec![f64::NAN; rows]),
            wheel: columns(<WheelSolution as Record>::columns().len(), 1),
            contacts: columns(<Contact as Record>::columns().len(), CONTACTS),
            status: vec![0; rows],
            ..Self::default()
        }
    }

    fn set(&mut self, row: usize, acting: &Acting) {
        let moment = acting.force.moment_z.unwrap_or(f64::NAN);
        let coefficient = acting.force.tangential() / acting.load;
        let values = [acting.force.x, acting.force.y, moment, coefficient];
        for (column, value) in self.values.iter_mut().zip(values) {
            column[row] = value;
        }
        if let Some(wheel) = acting.wheel {
            put(&mut self.wheel, row, wheel);
            for (k, contact) in wheel.contacts.iter().take(CONTACTS).enumerate() {
                put(&mut self.contacts, CONTACTS * row + k, contact);
            }
        }
        self.status[row] = match acting.status {
            Status::Converged => Became::Converged as u8,
            Status::NotConverged => Became::NotConverged as u8,
        };
    }

    /// Nothing acts: forces, not their ratios, are zero.
    fn set_none(&mut self, row: usize) {
        let [x, y, moment, _] = &mut self.values;
        for column in [x, y, moment] {
            column[row] = 0.0;
        }
        let of_wheel = <WheelSolution as Record>::columns().iter();
        for (column, of) in self.wheel.iter_mut().zip(of_wheel) {
            if matches!(of.quantity.unit(), "N") || of.quantity == Quantity::ContactCount {
                column[row] = 0.0;
            }
        }
        self.status[row] = Became::NoContact as u8;
    }

    fn fail(&mut self, row: usize, condition: usize, errors: CaseErrors) {
        self.status[row] = Became::Failed as u8;
        self.failed += 1;
        if self.failure.as_ref().is_none_or(|(first, _)| condition < *first) {
            self.failure = Some((condition, errors));
        }
    }

    /// Takes the rows of a block, whose conditions are these.
    fn take(&mut self, block: Self, conditions: &[usize]) {
        let scatter = |into: &mut [f64], from: &[f64], width: usize| {
            for (row, k) in conditions.iter().enumerate() {
                into[k * width..][..width].copy_from_slice(&from[row * width..][..width]);
            }
        };
        for (into, from) in self.values.iter_mut().zip(&block.values) {
            scatter(into, from, 1);
        }
        for (into, from) in self.wheel.iter_mut().zip(&block.wheel) {
            scatter(into, from, 1);
        }
        for (into, from) in self.contacts.iter_mut().zip(&block.contacts) {
            scatter(into, from, CONTACTS);
        }
        for (row, k) in conditions.iter().enumerate() {
            self.status[*k] = block.status[row];
        }
        self.warnings.extend(block.warnings);
        let failed = self.failed + block.failed;
        if let Some((k, errors)) = block.failure {
            self.fail(k, k, errors);
        }
        self.failed = failed;
    }

    /// As arrays by name, without copies: those of a contact have [`CONTACTS`] values a row.
    fn columns(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let table = PyDict::new(py);
        let add = |name: &str, quantity, values: Vec<f64>| {
            let values = PyArray1::from_vec(py, values).into_any();
            table.set_item(name, described(py, quantity, values)?)
        };
        for (quantity, values) in COLUMNS.into_iter().zip(self.values) {
            add(quantity.name(), quantity, values)?;
        }
        let of_wheel = <WheelSolution as Record>::columns().iter();
        for (column, values) in of_wheel.zip(self.wheel) {
            add(column.quantity.name(), column.quantity, values)?;
        }
        for (column, values) in <Contact as Record>::columns().iter().zip(self.contacts) {
            add(&of_contact(column), column.quantity, values)?;
        }
        Ok(table)
    }
}

/// The only row of a record.
fn put<R: Record>(columns: &mut [Vec<f64>], row: usize, record: &R) {
    for (values, Column { value, .. }) in columns.iter_mut().zip(R::columns()) {
        values[row] = value(record, 0).number().unwrap_or(f64::NAN);
    }
}

/// The forces of all conditions on all threads.
fn forces(
    file: &schlupf_case::CaseFile,
    conditions: &Conditions,
    watch: Watch,
) -> Result<Forces, CaseErrors> {
    let mut solver = StateSolver::new(file.clone(), conditions.fields.clone());
    let order = conditions.order(&solver.conditions(&conditions.entries(0)));
    let (mut has_wheel, mut size, mut notices) = (file.wheel().is_ok(), FULL_BLOCK, Vec::new());
    // What cannot be posed is told with its condition.
    for k in &order {
        match solver.prepare(&conditions.entries(*k), CONDITION, watch) {
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
    let found = parallel::try_map(order.chunks(size).collect(), |block: &[usize]| {
        let forces = block_of(&mut solver.fork(), conditions, (block, has_wheel), watch);
        forces.map(|forces| (forces, block))
    });
    let stopped = |()| CaseErrors::from(file.explain(&Error::Stopped {}));
    let mut all = Forces::new(conditions.count(), has_wheel);
    for message in notices.into_iter().filter(|notice| !conditions.varies(notice)) {
        all.warnings.add(Tallied::new(message, 0, conditions.count()));
    }
    all.warnings.extend(conditions.unusual());
    for (forces, block) in found.map_err(stopped)? {
        all.take(forces, block);
    }
    Ok(all)
}

/// Those of successive conditions, which one solver takes one after the other; an error if it was
/// stopped.
fn block_of(
    solver: &mut StateSolver,
    conditions: &Conditions,
    (block, has_wheel): (&[usize], bool),
    watch: Watch,
) -> Result<Forces, ()> {
    let mut forces = Forces::new(block.len(), has_wheel);
    let mut warnings = Tally::default();
    let mut entries = conditions.entries(block[0]);
    if watch(Progress::count(Stage::Curve, block[0])).is_break() {
        return Err(());
    }
    for (row, k) in block.iter().enumerate() {
        conditions.put(*k, &mut entries);
        let mut warn = |warning: &Warning| {
            // Of a condition only what the table does not show.
            if !matches!(warning, Warning::NotConverged { .. }) {
                warnings.note(warning.clone(), *k);
            }
        };
        let name = || format!("{CONDITION} {k}");
        match solver.acting(&entries, name, &mut warn, watch) {
            Ok(acting) => forces.set(row, &acting),
            Err(NoState::NoContact) => forces.set_none(row),
            Err(NoState::Failed(errors)) => forces.fail(row, *k, errors),
            Err(NoState::Stopped) => return Err(()),
        }
    }
    let warnings = warnings.into_iter().map(|found: Tallied<Warning, usize>| Tallied {
        worst: found.worst.message(&FieldNames::CASE),
        place: found.place,
        count: found.count,
        is_even: found.is_even,
    });
    forces.warnings.extend(warnings);
    Ok(forces)
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
    let conditions = Conditions::read(arrays)?;
    let raised = Arc::default();
    let found = case.run(py, &raised, |file, watch| forces(file, &conditions, watch))?;
    let mut forces = found.map_err(|errors| errors::of_case(py, &errors))?;
    let mut warnings = Vec::new();
    if let Some((k, errors)) = forces.failure.take() {
        let place = Place::Override { option: CONDITION.into(), text: k.to_string() };
        let first = CaseError { place, ..*errors.first };
        if strict || forces.failed == conditions.count() {
            return Err(errors::of_case(py, &first.into()));
        }
        let text = first.message;
        warnings.push(("failed".to_owned(), first.field, text, forces.failed, k, true));
    }
    let of_states = std::mem::take(&mut forces.warnings).into_iter();
    warnings.extend(of_states.map(|Tallied { worst, place, count, is_even }| {
        (worst.code.to_owned(), worst.quantity, worst.text, count, place, is_even)
    }));
    let status = PyArray1::from_slice(py, &forces.status);
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
                Err(failure) => Err(reason(failure, file)),
            }
        })?;
        let (solver, is_fast) = posed.map_err(|errors| errors::of_case(py, &errors))?;
        Ok(Self { solver: Mutex::new(solver), is_fast, raised })
    }

    /// Solves with other values of fields, by their paths; the rest is that of the case.
    fn solve(&self, py: Python<'_>, arrays: &Bound<'_, PyDict>) -> PyResult<Solution> {
        let conditions = Conditions::read(arrays)?;
        let work = |watch: Watch<'_>| {
            // A panic within a solution leaves a solver that starts anew.
            let mut solver = self.solver.lock().unwrap_or_else(PoisonError::into_inner);
            solver.vary(conditions.fields.clone());
            match solver.solve(&conditions.entries(0), "solve", watch) {
                Ok((case, solution)) => Ok(report(case, solution)),
                Err(failure) => Err(reason(failure, solver.file())),
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

/// Why there is no state, as an error of its case.
fn reason(failure: NoState, file: &schlupf_case::CaseFile) -> CaseErrors {
    match failure {
        NoState::Failed(errors) => errors,
        NoState::Stopped => file.explain(&Error::Stopped {}).into(),
        NoState::NoContact => {
            let load = quantity_field(Quantity::Load);
            let message = format!("{load}: the wheel does not touch the rail");
            let error = CaseError::new(load, message, Place::Default);
            CaseError { cause: Cause::NoContact, ..error }.into()
        }
    }
}
