//! States of a case: what it comes to with other values of some of its fields.
//!
//! A state is that of the case with these fields, [`CaseFile::with`], and nothing else: whatever a
//! solver takes without another case ([`CaseFile::condition`]) is only a faster way to it.

use std::sync::Arc;

use schlupf::bodies::Kinematics;
use schlupf::normal::{AtLoad, PressureSource};
use schlupf::problem::FastMethod;
use schlupf::reporting::Message;
use schlupf::solution::Resultant;
use schlupf::solver::simplified::FastContact;
use schlupf::wheel_rail::WheelSolution;
use schlupf::{Error, Method, Problem, Quantity, Solution, Solver, Status, Warning, Watch};
use schlupf_case::fields::{Field, Kind};
use schlupf_case::{Case, CaseError, CaseErrors, CaseFile, Cause, FieldPath, Notice, Place, field};

/// The value of a field: numbers in SI units, temperatures in degC.
#[derive(Debug, Clone, PartialEq)]
pub enum Entry {
    /// A number.
    Number(f64),
    /// Anything else, as it would stand in a case file without quotes.
    Text(String),
}

impl Entry {
    fn is(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Number(one), Self::Number(other)) => one.to_bits() == other.to_bits(),
            _ => self == other,
        }
    }

    fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            Self::Text(_) => None,
        }
    }
}

/// A value as an assignment `section.field=value` of a case.
pub fn assignment(field: &Field, entry: &Entry) -> String {
    let unit = field.kind.unit();
    match entry {
        Entry::Number(number) if matches!(field.kind, Kind::Count) => {
            format!("{}={number}", field.path)
        }
        Entry::Number(number) if unit.is_empty() => format!("{}={number:?}", field.path),
        Entry::Number(number) => format!("{}=\"{number:?} {unit}\"", field.path),
        Entry::Text(text) => format!("{}={text}", field.path),
    }
}

/// Notices of a state: those of the case that was posed for it or for one that differs in
/// conditions, and what is unusual in its own values. `name` is what messages call the state.
pub fn notices(
    case: &Case,
    fields: &[&'static Field],
    entries: &[Entry],
    name: &str,
) -> Vec<Message> {
    let is_of = |message: &Message, code| {
        message.code == code && fields.iter().any(|field| *field.path == *message.quantity)
    };
    let of_case = case.notices.iter().filter(|message| !is_of(message, Notice::UNUSUAL)).cloned();
    let own = fields.iter().zip(entries).filter_map(|(field, entry)| {
        let text = assignment(field, entry);
        let place = Place::Override { option: name.into(), text };
        Notice::of_unusual(field, &[entry.number()?], &place)
    });
    of_case.chain(own.map(Message::from)).collect()
}

/// Contacts of a wheel that tables have columns for: those with the largest normal forces.
pub const CONTACTS: usize = 3;

/// The status of a state in which nothing acts, and that of one that has no solution at all.
pub const NO_CONTACT: &str = "no-contact";
/// See [`NO_CONTACT`].
pub const FAILED: &str = "failed";

/// Why there is no solution.
#[derive(Debug)]
pub enum NoState {
    /// Nothing acts: there is no normal load, or the wheel does not touch the rail.
    NoContact,
    /// The case cannot be, or cannot be solved.
    Failed(CaseErrors),
    /// Whoever watched had it stopped.
    Stopped,
}

impl NoState {
    /// As errors of its case.
    pub fn errors(self, file: &CaseFile) -> CaseErrors {
        match self {
            Self::Failed(errors) => errors,
            Self::Stopped => file.explain(&Error::Stopped {}).into(),
            Self::NoContact => {
                let message = format!("{LOAD}: the wheel does not touch the rail");
                let error = CaseError::new(LOAD, message, Place::Default);
                CaseError { cause: Cause::NoContact, ..error }.into()
            }
        }
    }
}

impl From<CaseErrors> for NoState {
    fn from(errors: CaseErrors) -> Self {
        match errors.first.cause {
            Cause::NoContact => Self::NoContact,
            Cause::Stopped => Self::Stopped,
            _ => Self::Failed(errors),
        }
    }
}

/// What acts in a state.
#[derive(Debug, Clone)]
pub struct Acting<'a> {
    /// On the wheel; of several contacts of a wheel in that with the largest normal force.
    pub force: Resultant,
    /// Normal load, in N.
    pub load: f64,
    /// Whether the state converged.
    pub status: Status,
    /// The wheel with all its contacts, if the case has profiles.
    pub wheel: Option<&'a WheelSolution>,
}

/// Solves states of a case, one after the other: each starts from those before.
///
/// ```
/// use schlupf_case::{CaseFile, Folder, Overrides, field};
/// use schlupf_tasks::states::{Entry, StateSolver};
///
/// let text = "grid = { cells_x = 10, cells_y = 10 }";
/// let file = CaseFile::from_str(text, "a case", Folder::new(""), Overrides::NONE)?;
/// let load = vec![field!("normal.load").field()];
/// let mut solver = StateSolver::new(file, load);
/// let state = solver.solve(&[Entry::Number(60e3)], "state 0", &schlupf::unwatched);
/// let (_, solution) = state.unwrap();
/// assert_eq!(solution.normal.load, 60e3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct StateSolver {
    file: CaseFile,
    fields: Vec<&'static Field>,
    /// The place of the load among them.
    load: Option<usize>,
    as_asked: bool,
    /// The first case, whose micro model serves all that have the same.
    base: Option<Case>,
    posed: Option<Box<Posed>>,
}

/// A case with the values of its fields, and its solvers.
struct Posed {
    entries: Vec<Entry>,
    /// Which of the fields a solver takes without another case.
    conditions: Vec<Option<Quantity>>,
    case: Case,
    /// The motion of the latest state, and its load if that varies.
    motion: Kinematics,
    load: Option<f64>,
    solver: Box<dyn Solver>,
    /// The normal contact under the load of the latest state.
    loaded: Option<(f64, Arc<dyn PressureSource>)>,
    /// The fast method that finds forces alone, if there is one, and what it has set up.
    of_forces: Option<FastMethod>,
    fast: Option<Fast>,
}

/// A fast method for forces alone.
struct Fast {
    contact: FastContact,
    load: f64,
    /// What to know of all its forces.
    warnings: Vec<Warning>,
}

impl StateSolver {
    /// For forces and fields of states that differ in the values of some fields.
    pub fn new(file: CaseFile, fields: Vec<&'static Field>) -> Self {
        let load = place_of_load(&fields);
        Self { file, fields, load, as_asked: false, base: None, posed: None }
    }

    /// Has solutions contain all that the case asks for, such as derivatives, and the state of the
    /// material.
    #[must_use]
    pub fn as_asked(self) -> Self {
        Self { as_asked: true, ..self }
    }

    /// One for the same fields, with what is posed already, but without solutions.
    #[must_use]
    pub fn fork(&self) -> Self {
        let posed = self.posed.as_ref().map(|posed| {
            Box::new(Posed {
                entries: posed.entries.clone(),
                conditions: posed.conditions.clone(),
                case: posed.case.clone(),
                motion: posed.motion,
                load: posed.load,
                solver: solver(&posed.case, self.as_asked),
                loaded: None,
                of_forces: posed.of_forces.clone(),
                fast: None,
            })
        });
        let (file, fields, base) = (self.file.clone(), self.fields.clone(), self.base.clone());
        Self { file, fields, load: self.load, as_asked: self.as_asked, base, posed }
    }

    /// Poses the case with these values of the fields, unless that is done.
    ///
    /// # Errors
    /// See [`NoState`].
    pub fn prepare(
        &mut self,
        entries: &[Entry],
        name: &str,
        watch: Watch,
    ) -> Result<&Case, NoState> {
        self.pose(entries, || name.to_owned(), watch).map(|posed| &posed.case)
    }

    /// Fields that vary from now on.
    pub fn vary(&mut self, fields: Vec<&'static Field>) {
        let is_same = |(one, other): (&&Field, &&Field)| one.path == other.path;
        if self.fields.len() != fields.len() || !self.fields.iter().zip(&fields).all(is_same) {
            self.load = place_of_load(&fields);
            self.fields = fields;
            self.posed = None;
        }
    }

    /// The case before anything varies.
    pub fn file(&self) -> &CaseFile {
        &self.file
    }

    /// Which of the fields a solver takes without another case, in a state with these values.
    pub fn conditions(&self, entries: &[Entry]) -> Vec<bool> {
        let file = self.file.with("a state", &self.assignments(entries));
        let file = file.as_ref().unwrap_or(&self.file);
        self.fields.iter().map(|field| file.condition(field.path).is_some()).collect()
    }

    /// The case and its steady state with these values of the fields. `name` is what messages call
    /// the state.
    ///
    /// # Errors
    /// See [`NoState`].
    pub fn solve(
        &mut self,
        entries: &[Entry],
        name: &str,
        watch: Watch,
    ) -> Result<(&Case, Solution), NoState> {
        let posed = self.pose(entries, || name.to_owned(), watch)?;
        let solution = posed.solve(watch)?;
        Ok((&posed.case, solution))
    }

    /// What acts in the same state; `warn` is told each warning. By a fast method this allocates
    /// nothing where only conditions vary.
    ///
    /// # Errors
    /// See [`NoState`].
    pub fn acting(
        &mut self,
        entries: &[Entry],
        name: impl FnOnce() -> String,
        warn: &mut dyn FnMut(&Warning),
        watch: Watch,
    ) -> Result<Acting<'_>, NoState> {
        let posed = self.pose(entries, name, watch)?;
        match posed.force(warn) {
            Ok(Some((force, load))) => {
                return Ok(Acting { force, load, status: Status::Converged, wheel: None });
            }
            Ok(None) => {}
            Err(error) => return Err(CaseErrors::from(posed.case.explain(&error)).into()),
        }
        let solution = posed.solve(watch)?;
        let wheel = posed.case.wheel.as_deref();
        let further = wheel.map(WheelSolution::further_warnings).unwrap_or_default();
        solution.warnings.iter().chain(&further).for_each(warn);
        let status = wheel.map_or(solution.status, WheelSolution::status);
        Ok(Acting { force: solution.force, load: solution.normal.load, status, wheel })
    }

    fn assignments(&self, entries: &[Entry]) -> Vec<String> {
        self.fields.iter().zip(entries).map(|(field, entry)| assignment(field, entry)).collect()
    }

    /// Makes the case with these values, unless it is there.
    fn pose(
        &mut self,
        entries: &[Entry],
        name: impl FnOnce() -> String,
        watch: Watch,
    ) -> Result<&mut Posed, NoState> {
        if self.load.and_then(|load| entries[load].number()) == Some(0.0) {
            return Err(NoState::NoContact);
        }
        let mut before = self.posed.take();
        let mut posed = match before.take_if(|posed| posed.serves(&self.fields, entries)) {
            Some(posed) => posed,
            None => match self.posed_anew(entries, name(), watch) {
                Ok(mut posed) => {
                    if let Some(before) = before {
                        posed.take_over(*before, &self.fields);
                    }
                    posed
                }
                Err(failure) => {
                    self.posed = before;
                    return Err(failure);
                }
            },
        };
        posed.set(entries);
        Ok(self.posed.insert(posed))
    }

    fn posed_anew(
        &mut self,
        entries: &[Entry],
        name: String,
        watch: Watch,
    ) -> Result<Box<Posed>, NoState> {
        let assignments = self.assignments(entries);
        let file = self.file.with(name, &assignments)?;
        let case = match &self.base {
            Some(base) => file.pose_beside(base, watch)?,
            None => self.base.insert(file.pose(watch)?).clone(),
        };
        case.require_steady("states are those").map_err(CaseErrors::from)?;
        let conditions = self.fields.iter().map(|field| file.condition(field.path)).collect();
        let solver = solver(&case, self.as_asked);
        let is_free = case.problem.prescribed.is_none() && case.wheel.is_none();
        let of_forces = match &case.method {
            Method::Fast(method) if is_free => Some(method.clone()),
            Method::Fast(_) | Method::Full => None,
        };
        let entries = entries.to_vec();
        Ok(Box::new(Posed {
            entries,
            conditions,
            motion: case.problem.kinematics,
            load: None,
            case,
            solver,
            loaded: None,
            of_forces,
            fast: None,
        }))
    }
}

fn place_of_load(fields: &[&'static Field]) -> Option<usize> {
    fields.iter().position(|field| field.path == LOAD)
}

fn solver(case: &Case, as_asked: bool) -> Box<dyn Solver> {
    if as_asked { case.full_solver() } else { case.solver_without_state() }
}

/// The field of the normal load.
const LOAD: FieldPath = field!("normal.load");

impl Posed {
    /// Whether a state with these values needs no other case.
    #[inline]
    fn serves(&self, fields: &[&'static Field], entries: &[Entry]) -> bool {
        let mut states = fields.iter().zip(entries).enumerate();
        states.all(|(k, (field, entry))| match (self.conditions[k], entry) {
            (Some(_), Entry::Number(number)) => field.requirement.holds(*number),
            _ => self.entries[k].is(entry),
        })
    }

    /// Sets the motion and the load to those of a state that the case serves. What does not vary is
    /// that of the case.
    #[inline]
    fn set(&mut self, entries: &[Entry]) {
        let own = &self.case.problem.kinematics;
        for (quantity, entry) in self.conditions.iter().zip(entries) {
            let Some(quantity) = quantity else { continue };
            let number = entry.number();
            match quantity {
                Quantity::CreepageX => self.motion.creepage_x = number.unwrap_or(own.creepage_x),
                Quantity::CreepageY => self.motion.creepage_y = number.unwrap_or(own.creepage_y),
                Quantity::Spin => self.motion.spin = number.unwrap_or(own.spin),
                Quantity::Load => self.load = number,
                _ => self.motion.speed = number.unwrap_or(own.speed),
            }
        }
    }

    /// Keeps what a solver has set up where only fields differ that do not shape the contact.
    fn take_over(&mut self, before: Self, fields: &[&'static Field]) {
        let is_same = |k: usize| self.entries[k].is(&before.entries[k]);
        let is_alike = (0..fields.len()).all(|k| is_same(k) || !fields[k].shapes_contact);
        let (own, other) = (&self.case, &before.case);
        let is_like =
            own.wheel.is_none() && (&own.method, own.driver) == (&other.method, other.driver);
        if is_alike && is_like && self.case.options == before.case.options {
            self.case.problem.normal = Arc::clone(&before.case.problem.normal);
            self.case.problem.interface.elasticity =
                Arc::clone(&before.case.problem.interface.elasticity);
            self.solver = before.solver;
            self.solver.forget();
        }
    }

    fn solve(&mut self, watch: Watch) -> Result<Solution, NoState> {
        let wheel = self.case.wheel.as_ref().and_then(|wheel| wheel.contacts.first());
        if let Some(main) = wheel {
            return Ok(main.solution.clone());
        }
        let Self { case, motion: kinematics, load, solver, loaded, .. } = self;
        let own = &case.problem.normal;
        let mut found = || -> Result<Solution, Error> {
            let normal = match (*load, &*loaded) {
                (None, _) => Arc::clone(own),
                (Some(load), Some((of, normal))) if of.to_bits() == load.to_bits() => {
                    Arc::clone(normal)
                }
                (Some(load), _) => {
                    let normal: Arc<dyn PressureSource> =
                        Arc::new(AtLoad::new(Arc::clone(own), load)?);
                    normal.prepare(None, watch)?;
                    *loaded = Some((load, Arc::clone(&normal)));
                    normal
                }
            };
            let problem = Problem { kinematics: *kinematics, normal, ..case.problem.clone() };
            solver.solve(&problem, watch)
        };
        found().map_err(|error| CaseErrors::from(case.explain(&error)).into())
    }

    /// By a fast method that finds forces alone, if there is one.
    #[inline]
    fn force(&mut self, warn: &mut dyn FnMut(&Warning)) -> Result<Option<(Resultant, f64)>, Error> {
        if self.fast.is_none() {
            self.fast = self.set_up()?;
        }
        let Some(fast) = &mut self.fast else { return Ok(None) };
        if let Some(load) = self.load.filter(|load| *load != fast.load) {
            fast.set_load(load, &self.case.problem)?;
        }
        let force = fast.contact.force(&self.motion)?;
        fast.warnings.iter().for_each(&mut *warn);
        if fast.contact.is_beyond_friction(&force) {
            fast.contact.beyond_friction(&force).iter().for_each(warn);
        }
        Ok(Some((force, fast.load)))
    }

    fn set_up(&self) -> Result<Option<Fast>, Error> {
        let Some(method) = &self.of_forces else { return Ok(None) };
        let contact = FastContact::new(&self.case.problem, method.clone(), &self.case.options)?;
        let (load, warnings) = (contact.contact().normal.load, contact.warnings());
        Ok(Some(Fast { contact, load, warnings }))
    }
}

impl Fast {
    fn set_load(&mut self, load: f64, problem: &Problem) -> Result<(), Error> {
        self.contact.set_load(load)?;
        self.load = load;
        let pressure = self.contact.contact().normal.peak_pressure;
        self.warnings.retain(|warning| !matches!(warning, Warning::BeyondElastic { .. }));
        self.warnings.extend(problem.interface.beyond_elastic(pressure));
        Ok(())
    }
}
