//! A case: what to solve, and how.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use schlupf::bulk_temperature::Cooling;
use schlupf::history::History;
use schlupf::message::Message;
use schlupf::rolling::MarchingSolver;
use schlupf::state::State;
use schlupf::{Method, Options, Problem, Solver, Transient};

use crate::document::{self, Entry};
use crate::edited;
use crate::error::{CaseError, CaseErrors, Cause};
use crate::fields;
use crate::law_stiffness::{LawStiffness, MicroContact, StiffnessOrigin};
use crate::place::{Place, Source};
use crate::read;
use crate::settings::Settings;
use crate::template::template;

/// What makes a history, each by itself.
const HISTORY: [&str; 4] = ["history.file", "history.time", "history.shift_x", "history.shift_y"];

/// A case that was read and checked.
#[derive(Debug, Clone)]
pub struct Case {
    /// Title for the summary and the figures.
    pub title: String,
    /// The contact.
    pub problem: Problem,
    /// Creepages, speed and load over time, where it is no steady rolling.
    pub history: Option<History>,
    /// All equations, or a fast method.
    pub method: Method,
    /// Which way to the solution was asked for.
    pub driver: Option<Driver>,
    /// How accurately.
    pub options: Options,
    /// What cools the wheel in the long run, where the case says so.
    pub cooling: Option<Cooling>,
    /// k_c of the contact law, and where it comes from.
    pub law_stiffness: LawStiffness,
    /// What was given without effect, each with its place, and what to know about a roughness.
    pub notices: Vec<Message>,
    settings: Settings,
    /// The text that was read, without overrides.
    text: String,
    pub(crate) entries: Vec<Entry>,
    pub(crate) name: String,
    pub(crate) folder: PathBuf,
}

/// A way to the solution of the full equations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Driver {
    /// The steady state at once.
    Steady,
    /// Time step after time step: the paper's procedure, and transient rolling.
    Marching,
}

/// What a case asks for.
pub enum Task {
    /// Steady rolling, and what finds it.
    Steady(Box<dyn Solver>),
    /// Rolling over time.
    Transient(Box<Transient>),
}

/// A field in effect.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Effective {
    /// Dotted path.
    pub path: &'static str,
    /// Its value as it was written, or the default.
    pub value: String,
    /// Where it was given.
    pub place: Place,
}

impl Case {
    /// The text of the case that is solved when none is named.
    pub fn default_text() -> String {
        template()
    }

    /// Reads the text of a case. `name` is for messages, `folder` is where relative paths start, and
    /// each override is `section.field=value`.
    ///
    /// ```
    /// use schlupf_case::Case;
    /// use std::path::Path;
    ///
    /// let text = "[kinematics]\nspeed = \"72 km/h\"";
    /// let set = ["normal.load=100 kN".to_owned()];
    /// let case = Case::from_str(text, "a case", Path::new(""), &set)?;
    /// assert!((case.problem.kinematics.speed - 20.0).abs() < 1e-12);
    /// # Ok::<(), schlupf_case::CaseErrors>(())
    /// ```
    pub fn from_str(
        text: &str,
        name: &str,
        folder: &Path,
        overrides: &[String],
    ) -> Result<Self, CaseErrors> {
        let source = Arc::new(Source { name: name.to_owned(), text: text.to_owned() });
        let (mut entries, mut errors) = document::parse(&source)?;
        for text in overrides {
            errors.extend(document::apply(&mut entries, "--set", text).err());
        }
        Self::from_entries(entries, errors, (name, text, folder), None)
    }

    /// The same case with another field, `section.field=value`, that an option of the command line gives.
    pub fn with(&self, option: &'static str, assignment: &str) -> Result<Self, CaseErrors> {
        self.with_all(option, &[assignment.to_owned()])
    }

    /// The same case with several other fields, which need to fit together only when all are in place.
    pub fn with_all(
        &self,
        option: &'static str,
        assignments: &[String],
    ) -> Result<Self, CaseErrors> {
        let mut entries = self.entries.clone();
        for assignment in assignments {
            document::apply(&mut entries, option, assignment)?;
        }
        let solved = self.micro_contact();
        Self::from_entries(entries, Vec::new(), (&self.name, &self.text, &self.folder), solved)
    }

    fn from_entries(
        entries: Vec<Entry>,
        mut errors: Vec<CaseError>,
        (name, text, folder): (&str, &str, &Path),
        solved: Option<&Arc<MicroContact>>,
    ) -> Result<Self, CaseErrors> {
        let file = Place::File { name: name.to_owned() };
        let (settings, wrong_fields) = Settings::read(&entries, file);
        errors.extend(wrong_fields);
        errors.sort_by_key(|error| error.place.order());
        CaseErrors::check(errors)?;
        let (problem, history, law_stiffness) = read::problem(&settings, folder, solved)?;
        let mut notices = settings.idle();
        let caveats = law_stiffness.caveats().into_iter();
        notices.extend(caveats.map(|message| message.about("contact_law.roughness")));
        Ok(Self {
            title: settings.text("title")?,
            problem,
            history,
            method: read::method(&settings)?,
            driver: read::driver(&settings)?,
            options: read::options(&settings)?,
            cooling: read::cooling(&settings)?,
            law_stiffness,
            notices,
            settings,
            text: text.to_owned(),
            entries,
            name: name.to_owned(),
            folder: folder.to_owned(),
        })
    }

    /// The micro model of its roughness, if it has one.
    pub fn micro_contact(&self) -> Option<&Arc<MicroContact>> {
        match &self.law_stiffness.origin {
            StiffnessOrigin::MicroModel(micro) => Some(micro),
            _ => None,
        }
    }

    /// Reads a case file.
    pub fn from_path(path: &Path, overrides: &[String]) -> Result<Self, CaseErrors> {
        let name = path.display().to_string();
        let bytes = std::fs::read(path).map_err(|error| CaseError {
            cause: Cause::FileSystem,
            ..CaseError::new(
                "",
                format!("the case file cannot be read: {error}"),
                Place::File { name: name.clone() },
            )
        })?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
            let line = before.split(|byte| *byte == b'\n').count();
            let message = format!("the case file must be text in UTF-8, but is not in line {line}");
            CaseError::new("", message, Place::File { name: name.clone() })
        })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        Self::from_str(&text, &name, folder, overrides)
    }

    /// What is to be solved, from a state if there is one.
    ///
    /// ```
    /// use schlupf_case::{Case, Task};
    /// use std::path::Path;
    ///
    /// let case = Case::from_str(&Case::default_text(), "template", Path::new(""), &[])?;
    /// assert!(matches!(case.task(None), Ok(Task::Steady(_))));
    /// # Ok::<(), schlupf_case::CaseErrors>(())
    /// ```
    ///
    /// # Errors
    /// A history or a state where the method or the way that was asked for cannot follow it.
    pub fn task(&self, initial_state: Option<State>) -> Result<Task, CaseError> {
        if self.history.is_none() && initial_state.is_none() {
            return Ok(Task::Steady(self.any_solver(&self.options)));
        }
        let what = if self.history.is_some() { "a history" } else { "an initial state" };
        match (self.method, self.driver) {
            (Method::Fast(method), _) => {
                let name = method.name();
                let reason = format!("{name:?} is of steady rolling, but there is {what}");
                Err(self.contradiction("solver.method", &reason))
            }
            (Method::Full, Some(Driver::Steady)) => {
                let reason =
                    format!("{what} needs solver.driver = \"marching\", but it is \"steady\"");
                Err(self.contradiction("solver.driver", &reason))
            }
            (Method::Full, Some(Driver::Marching) | None) => {
                let history = self.history.clone().unwrap_or_default();
                let problem = self.problem.clone();
                Ok(Task::Transient(Box::new(Transient { problem, history, initial_state })))
            }
        }
    }

    /// Checks that the case is one of steady rolling. `what` says for what, such as "a creep curve is".
    ///
    /// # Errors
    /// A history.
    pub fn require_steady(&self, what: &str) -> Result<(), CaseError> {
        if self.history.is_none() {
            return Ok(());
        }
        let field = HISTORY.into_iter().find(|field| self.settings.is_given(field));
        let reason = format!("{what} of steady rolling, but there is a history");
        Err(self.contradiction(field.unwrap_or("history.time"), &reason))
    }

    /// What finds steady states of the case, without derivatives; see [`Self::require_steady`].
    pub fn solver(&self) -> Box<dyn Solver> {
        self.any_solver(&Options { sensitivity: false, ..self.options.clone() })
    }

    fn any_solver(&self, options: &Options) -> Box<dyn Solver> {
        match (self.method, self.driver) {
            (Method::Full, Some(Driver::Marching)) => Box::new(MarchingSolver::new(options)),
            (method, _) => method.solver(options),
        }
    }

    fn contradiction(&self, field: &str, reason: &str) -> CaseError {
        self.settings.error(field, format!("{field}: {reason}"))
    }

    /// An error of the core, at the place of the field that it names.
    pub fn explain(&self, error: &schlupf::Error) -> CaseError {
        self.settings.explain(error)
    }

    /// What cools the wheel in the long run.
    ///
    /// # Errors
    /// The field that is missing where the case does not say so.
    pub fn require_cooling(&self) -> Result<Cooling, CaseError> {
        self.cooling.ok_or_else(|| read::missing_cooling(&self.settings))
    }

    /// Rolling radius of the wheel (in m), where it has one: it may be straight where the pressure
    /// does not follow from the radii.
    pub fn wheel_radius(&self) -> Option<f64> {
        self.settings.number("kinematics.wheel_radius").ok()
    }

    /// Files that the case names, each with the field that does, whether that has an effect or not.
    pub fn files(&self) -> Vec<(&'static str, PathBuf)> {
        fields::all()
            .filter(|field| matches!(field.kind, fields::Kind::Path))
            .filter_map(|field| Some((field.path, self.settings.given_text(field.path)?)))
            .map(|(field, file)| (field, self.folder.join(file)))
            .collect()
    }

    /// The text of the case with other values of some fields (in SI units, or dimensionless) and all
    /// overrides in it, comments and layout kept. Paths are those from `folder`, where the text is to be.
    pub fn edited(&self, values: &[(&str, f64)], folder: &Path) -> Result<String, CaseError> {
        let is_moved = edited::absolute(folder) != edited::absolute(&self.folder);
        let mut text = edited::Edited::new(&self.text, &self.name)?;
        text.take_over(&self.entries, is_moved.then_some(&self.folder))?;
        for (path, value) in values {
            if *path == "contact_law.stiffness" {
                // A case has k_c or the roughness that it follows from.
                text.remove("contact_law.roughness");
            }
            text.set_number(path, *value)?;
        }
        Ok(text.finish())
    }

    /// All fields in effect, given or by default.
    pub fn effective(&self) -> Vec<Effective> {
        fields::all()
            .filter(|field| self.settings.is_used(field))
            .map(|field| Effective {
                path: field.path,
                value: self.settings.shown(field.path),
                place: self.settings.place(field.path),
            })
            .filter(|effective| !effective.value.is_empty())
            .collect()
    }
}
