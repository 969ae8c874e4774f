//! A case: what to solve, and how.
//!
//! Posing a case solves the normal contact of profiles and rough surfaces. It is kept with the
//! case, and `Case::with` reuses it where surface, modulus and largest pressure are the same,
//! because families and comparisons pose a case many times. With two profiles and a position a case
//! holds a request in place of a normal contact: friction carries a part of the vertical force, so
//! the contacts are found together with the tangential solution.

mod force_element;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use schlupf::analysis::bulk_temperature::Cooling;
use schlupf::analysis::damage::Laws;
use schlupf::bodies::{Kinematics, Material};
use schlupf::normal::NormalContact;
use schlupf::problem::{Driver, History, State};
use schlupf::reporting::Message;
use schlupf::wheel_rail::WheelSolution;
use schlupf::{Error, Method, Options, Problem, Quantity, Solution, Solver, Transient, Watch};

use crate::case_file::{CaseFile, Overrides};
use crate::error::{CaseError, CaseErrors};
use crate::fields::choice::{DriverChoice, ElasticityModel};
use crate::fields::{self, Field, HISTORY};
use crate::files::Folder;
use crate::law_stiffness::{LawStiffness, MicroContact, StiffnessOrigin};
use crate::notice::Notice;
use crate::place::{Place, Source};
use crate::read::{self, Posed, WheelSolver};
use crate::setting::Setting;
use crate::subsurface::SubsurfaceRequest;
use crate::{FieldPath, edited, names, profiles};

/// Fields behind the laws of damage that are not its own.
const FOR_DAMAGE: [FieldPath; 6] = fields![
    "title",
    "kinematics.speed",
    "kinematics.wheel_radius",
    "wheel.radius_x",
    "wheel.density",
    "rail.density",
];

fn is_for_damage(field: &Field) -> bool {
    field.section() == "damage" || FOR_DAMAGE.contains(&field.path)
}

/// A case with its problem.
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
    /// How the bodies deform.
    pub elasticity: ElasticityModel,
    /// The driver that was asked for.
    pub driver: Option<Driver>,
    /// How accurately.
    pub options: Options,
    /// What cools the wheel in the long run, where the case says so.
    pub cooling: Option<Cooling>,
    /// k_c of the contact law, and where it comes from.
    pub law_stiffness: LawStiffness,
    /// Speed and creepages that the case gives, or those found for its forces: those of the
    /// problem, but of a wheel with profiles those of its nominal radius.
    pub motion: Kinematics,
    /// The wheel with all its contacts, if the case has profiles; the contact is then the one with
    /// the largest normal force.
    pub wheel: Option<Arc<WheelSolution>>,
    /// What was given without effect or is unusual, each with its place, and what to know about a
    /// roughness.
    pub notices: Vec<Message>,
    wheel_solver: Option<WheelSolver>,
    pub(crate) file: CaseFile,
}

/// What a case asks for.
pub enum Rolling {
    /// Steady rolling.
    Steady,
    /// Rolling over time.
    Transient(Box<Transient>),
}

/// A field in effect.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Effective {
    /// Its path.
    pub path: FieldPath,
    /// Its value as it was written, or the default.
    pub value: String,
    /// Where it was given.
    pub place: Place,
    /// The tasks that alone use it; none where all may.
    pub tasks: &'static [&'static str],
}

impl CaseFile {
    /// Whether a history is given.
    pub fn has_history(&self) -> bool {
        self.settings.any_given(HISTORY)
    }

    /// Whether a history is given, or time steps are asked for.
    pub fn is_marched(&self) -> bool {
        let driver = self.settings.chosen(field!("solver.driver")).ok();
        self.has_history() || driver == Some(DriverChoice::Marching)
    }

    /// The case with its problem: solves the normal contact of profiles and the micro model of a
    /// roughness, where it has such. `watch` sees how far that is and may stop it.
    pub fn pose(&self, watch: Watch) -> Result<Case, CaseErrors> {
        self.pose_like(None, watch)
    }

    /// The same beside another case, whose micro model is taken over where it serves this one.
    pub fn pose_beside(&self, other: &Case, watch: Watch) -> Result<Case, CaseErrors> {
        self.pose_like(other.micro_contact(), watch)
    }

    /// The same; a micro model that was solved for a like case is taken over.
    pub(crate) fn pose_like(
        &self,
        solved: Option<&Arc<MicroContact>>,
        watch: Watch,
    ) -> Result<Case, CaseErrors> {
        let Posed { problem, stiffness: law_stiffness, motion, wheel } =
            self.parts.pose(&self.settings, solved, watch)?;
        let (wheel, wheel_solver) = wheel.unzip();
        let waviness = law_stiffness.waviness(&problem).map_err(|error| self.explain(&error))?;
        let caveats = law_stiffness.caveats().into_iter().chain(waviness);
        let caveats = caveats.map(|notice| Message::from(notice).about("contact_law.roughness"));
        Ok(Case {
            title: self.title()?,
            problem,
            history: self.parts.history.clone(),
            method: self.method()?,
            elasticity: self.settings.chosen(field!("elasticity.model"))?,
            driver: read::driver(&self.settings)?,
            options: self.options()?,
            cooling: read::cooling(&self.settings)?,
            law_stiffness,
            motion,
            wheel,
            wheel_solver,
            notices: self.notices().into_iter().chain(caveats).collect(),
            file: self.clone(),
        })
    }

    /// The part of the problem that a field is, where it is that and nothing else: with another
    /// value the problem differs in its creepages, its speed, or by [`AtLoad`] only.
    ///
    /// [`AtLoad`]: schlupf::normal::AtLoad
    pub fn condition(&self, path: FieldPath) -> Option<Quantity> {
        /// From which, with the speed, other creepages follow.
        const TURNING: [FieldPath; 2] =
            fields!["kinematics.angular_velocity", "kinematics.yaw_angle"];
        const CONDITIONS: [Quantity; 5] = [
            Quantity::CreepageX,
            Quantity::CreepageY,
            Quantity::Spin,
            Quantity::Speed,
            Quantity::Load,
        ];
        let quantity =
            CONDITIONS.into_iter().find(|of| names::quantity_field(*of) == Some(path))?;
        let is_one = match quantity {
            Quantity::Load => {
                self.laws().pressure.is_some()
                    || self.parts.scales_with_load(&self.settings).unwrap_or(false)
            }
            Quantity::Spin => true,
            _ => !self.settings.any_given(&TURNING),
        };
        let is_used = self.settings.is_used(path.field());
        let is_free = !self.settings.is_replaced(path) && !self.parts.has_wheel();
        (is_one && is_used && is_free).then_some(quantity)
    }

    /// Title for the summary and the figures.
    pub fn title(&self) -> Result<String, CaseError> {
        self.settings.text(field!("title"))
    }

    /// How accurately to solve.
    pub fn options(&self) -> Result<Options, CaseError> {
        read::options(&self.settings)
    }

    /// All equations, or a fast method.
    pub fn method(&self) -> Result<Method, CaseError> {
        read::method(&self.settings)
    }

    /// What turns rolling of its wheel into damage; nothing is solved for it.
    ///
    /// # Errors
    /// A wheel without a rolling radius.
    pub fn damage_laws(&self) -> Result<Laws, CaseError> {
        let laws = Laws {
            wheel_radius: read::rolling_radius(&self.settings)?,
            densities: self.materials().map(|material| material.density),
            ..read::damage(&self.settings)?
        };
        laws.check().map_err(|error| self.explain(&error))?;
        Ok(laws)
    }

    /// What was given without effect or is far from what it is in almost all cases, each with its
    /// place.
    pub fn notices(&self) -> Vec<Message> {
        let nothing = self.entries.is_empty().then_some(Notice::NothingGiven {});
        let is_of_material = |notice: &Notice| match notice {
            Notice::NoEffect { field, .. } => field.field().is_of_material,
            _ => false,
        };
        let idle = self.settings.idle().into_iter().filter(|notice| !is_of_material(notice));
        let of_fields = idle.chain(self.settings.unusual());
        let of_history = self
            .parts
            .history
            .iter()
            .flat_map(|history| read::unusual_history(&self.settings, history));
        let of_profiles = self.parts.notices().iter().cloned();
        let of_files = of_history.chain(of_profiles);
        nothing.into_iter().chain(of_fields).chain(of_files).map(Message::from).collect()
    }

    /// Materials of wheel and rail.
    pub fn materials(&self) -> [Material; 2] {
        self.parts.materials()
    }

    /// The normal contact, of a history that with the largest load; nothing else is solved.
    pub fn normal_contact(&self, watch: Watch) -> Result<NormalContact, CaseErrors> {
        Ok(self.parts.normal_contact(&self.settings, watch)?)
    }

    /// An error of the core, at the place of the field that it names.
    pub fn explain(&self, error: &Error) -> CaseError {
        self.settings.explain(error)
    }

    /// The value of a field in effect (numbers in SI units, temperatures in degC): the one given or
    /// the default; `None` if there is neither, if the default has to be computed, or if other
    /// fields are given in place of it.
    ///
    /// ```
    /// use schlupf_case::{CaseFile, Folder, Overrides, Setting, field};
    ///
    /// let text = "kinematics.speed = \"72 km/h\"";
    /// let file = CaseFile::from_str(text, "a case", Folder::new(""), Overrides::NONE)?;
    /// assert_eq!(file.value(field!("kinematics.speed")), Some(Setting::Number(20.0)));
    /// # Ok::<(), schlupf_case::CaseErrors>(())
    /// ```
    pub fn value(&self, path: FieldPath) -> Option<Setting> {
        if self.settings.is_replaced(path) {
            return None;
        }
        self.settings.setting(path).ok()
    }

    /// Paths of the fields that are given, in the order of the file, overrides last.
    pub fn given(&self) -> impl Iterator<Item = FieldPath> {
        self.entries.iter().filter_map(|entry| Some(fields::find(&entry.path)?.path))
    }

    /// The text of the case with other values of some fields (in SI units, or dimensionless) and
    /// all overrides in it, comments and layout kept. Paths are those from `folder`, where the text
    /// is to be.
    pub fn edited(&self, values: &[(FieldPath, f64)], folder: &Path) -> Result<String, CaseError> {
        let own = self.folder();
        let is_moved = edited::absolute(folder) != edited::absolute(&own);
        let mut text = edited::Edited::new(&self.source)?;
        text.take_over(&self.entries, is_moved.then_some(&own))?;
        for (path, value) in values {
            if *path == field!("contact_law.stiffness") {
                // A case has k_c or the roughness that it follows from.
                text.remove("contact_law.roughness");
            }
            text.set_number(*path, *value)?;
        }
        Ok(text.finish())
    }

    /// The case of a text that may have come from elsewhere, for damage: where it cannot be read,
    /// say without a file that it names, all but what damage needs is left out: fields of `damage`,
    /// the rolling radius of the wheel, the densities. `name` is what messages call it.
    ///
    /// # Errors
    /// A text that is no case.
    pub fn for_damage(text: &str, name: &str) -> Result<Self, CaseErrors> {
        let read = |text: &str| Self::from_str(text, name, Folder::new(""), Overrides::NONE);
        read(text).or_else(|_| read(&Self::text_for_damage(text, name)?))
    }

    /// Refuses overrides that do not count for damage: of a run whose states are to be solved with
    /// them those of what `varies` in it, of another one all but the laws.
    ///
    /// # Errors
    /// The first field of that kind.
    pub fn refuse_for_damage(
        &self,
        assignments: &[String],
        varies: Option<&[FieldPath]>,
    ) -> Result<(), CaseError> {
        let field = |assignment: &String| fields::find(assignment.split_once('=')?.0.trim());
        let counts = |field: &Field| match varies {
            Some(varies) => !varies.contains(&field.path),
            None => is_for_damage(field) && field.path != field!("kinematics.speed"),
        };
        let mut given = assignments.iter().filter_map(field);
        let Some(Field { path, .. }) = given.find(|field| !counts(field)) else { return Ok(()) };
        let message = format!("{path} would be ignored: the states are those of the run");
        Err(self.settings.error(*path, message))
    }

    fn text_for_damage(text: &str, name: &str) -> Result<String, CaseError> {
        let mut kept = edited::Edited::new(&Source { name: name.into(), text: text.into() })?;
        for field in fields::all().filter(|field| !is_for_damage(field)) {
            kept.remove(&field.path);
        }
        Ok(kept.finish())
    }

    /// Where relative paths of files start.
    pub fn folder(&self) -> PathBuf {
        self.files.locate("")
    }

    /// Files that the case names, each with the field that does, whether that has an effect or not.
    pub fn files(&self) -> Vec<(FieldPath, PathBuf)> {
        fields::all()
            .filter(|field| matches!(field.kind, fields::Kind::Path))
            .filter_map(|field| Some((field.path, self.settings.given_text(field.path)?)))
            .filter(|(_, file)| profiles::names_file(file))
            .map(|(field, file)| (field, self.files.locate(file)))
            .collect()
    }
}

impl Case {
    /// The same case with other fields, each `section.field=value`, that an option, say of the
    /// command line, gives. They need to fit together only when all are in place.
    pub fn with(
        &self,
        option: impl Into<Arc<str>>,
        assignments: &[String],
        watch: Watch,
    ) -> Result<Self, CaseErrors> {
        self.file.with(option, assignments)?.pose_beside(self, watch)
    }

    /// The value of a field with its SI unit (temperatures in degC), which may be empty, if it is a
    /// number: see [`CaseFile::value`].
    pub fn number(&self, path: FieldPath) -> Option<(f64, &'static str)> {
        match self.file.value(path)? {
            Setting::Number(number) => Some((number, path.field().kind.unit())),
            _ => None,
        }
    }

    /// The micro model of its roughness, if it has one.
    pub fn micro_contact(&self) -> Option<&Arc<MicroContact>> {
        match &self.law_stiffness.origin {
            StiffnessOrigin::MicroModel(micro) => Some(micro),
            StiffnessOrigin::Given
            | StiffnessOrigin::Default
            | StiffnessOrigin::ClosedForm { .. } => None,
        }
    }

    /// What is to be solved, from a state if there is one.
    ///
    /// ```
    /// use schlupf_case::{CaseFile, Folder, Overrides, Rolling};
    ///
    /// let text = CaseFile::default_text();
    /// let file = CaseFile::from_str(&text, "template", Folder::new(""), Overrides::NONE)?;
    /// let case = file.pose(&schlupf::unwatched)?;
    /// assert!(matches!(case.rolling(None), Ok(Rolling::Steady)));
    /// # Ok::<(), schlupf_case::CaseErrors>(())
    /// ```
    ///
    /// # Errors
    /// A history or a state where the method or the way that was asked for cannot follow it.
    pub fn rolling(&self, initial_state: Option<State>) -> Result<Rolling, CaseError> {
        if self.history.is_none() && initial_state.is_none() {
            return Ok(Rolling::Steady);
        }
        let starts_rolling = self.history.as_ref().is_some_and(|history| history.starts_rolling);
        if starts_rolling && initial_state.is_some() {
            let reason = "must be \"rest\" with an initial state, from which it starts";
            return Err(self.contradiction(field!("history.start"), reason));
        }
        let what = if self.history.is_some() { "a history" } else { "an initial state" };
        match (self.method.clone(), self.driver) {
            (Method::Fast(method), _) => {
                let name = method.name();
                let reason = format!("{name:?} solves steady rolling only, but there is {what}");
                Err(self.contradiction(field!("solver.method"), &reason))
            }
            (Method::Full, Some(Driver::Steady)) => {
                let reason =
                    format!("{what} needs solver.driver = \"marching\", but it is \"steady\"");
                Err(self.contradiction(field!("solver.driver"), &reason))
            }
            (Method::Full, Some(Driver::Marching) | None) => {
                let history = self.history.clone().unwrap_or_default();
                let problem = self.problem.clone();
                Ok(Rolling::Transient(Box::new(Transient { problem, history, initial_state })))
            }
        }
    }

    /// Checks that the case is one of steady rolling. `what` says for what, such as "a creep curve
    /// is".
    ///
    /// # Errors
    /// A history.
    pub fn require_steady(&self, what: &str) -> Result<(), CaseError> {
        let field = HISTORY.iter().copied().find(|field| self.file.settings.is_given(*field));
        let Some(field) = field else { return Ok(()) };
        let reason = format!("{what} of steady rolling, but there is a history");
        Err(self.contradiction(field, &reason))
    }

    /// The steady state of its contact, by one of its solvers; that of a wheel was found with all
    /// its contacts.
    ///
    /// # Errors
    /// As [`Solver::solve`].
    pub fn steady_state(
        &self,
        mut solver: Box<dyn Solver>,
        watch: Watch,
    ) -> Result<Solution, Error> {
        match self.wheel.as_ref().and_then(|wheel| wheel.contacts.first()) {
            Some(main) => Ok(main.solution.clone()),
            None => solver.solve(&self.problem, watch),
        }
    }

    /// What finds steady states of the case, without derivatives; see [`Self::require_steady`].
    pub fn solver(&self) -> Box<dyn Solver> {
        self.any_solver(&Options { sensitivity: false, ..self.options.clone() })
    }

    /// The same for forces and fields alone: solutions keep no state of the material.
    pub fn solver_without_state(&self) -> Box<dyn Solver> {
        let options = Options { sensitivity: false, keeps_state: false, ..self.options.clone() };
        self.any_solver(&options)
    }

    /// What finds steady states for the [`motion`](Self::motion) of the case: of its contact, or of
    /// a wheel with profiles as a whole.
    pub fn solver_of_motion(&self) -> Box<dyn Solver> {
        match &self.wheel_solver {
            Some(wheel) => Box::new(wheel.of_forces()),
            None => self.solver_without_state(),
        }
    }

    /// What finds steady states of its contact, as its options ask for them: see
    /// [`Self::require_steady`].
    pub fn full_solver(&self) -> Box<dyn Solver> {
        self.any_solver(&self.options)
    }

    fn any_solver(&self, options: &Options) -> Box<dyn Solver> {
        self.method.solver_by(self.driver.unwrap_or_default(), options)
    }

    /// An error at the place of a field, with the reason why it cannot be.
    pub fn contradiction(&self, field: FieldPath, reason: &str) -> CaseError {
        self.file.settings.error(field, format!("{field}: {reason}"))
    }

    /// An error of the core, at the place of the field that it names.
    pub fn explain(&self, error: &Error) -> CaseError {
        self.file.explain(error)
    }

    /// What cools the wheel in the long run.
    ///
    /// # Errors
    /// The field that is missing where the case does not say so.
    pub fn require_cooling(&self) -> Result<Cooling, CaseError> {
        self.cooling.ok_or_else(|| read::missing_cooling(&self.file.settings))
    }

    /// Where to compute stresses below the surface.
    ///
    /// # Errors
    /// A field that cannot be.
    pub fn subsurface(&self) -> Result<SubsurfaceRequest, CaseError> {
        read::subsurface(&self.file.settings)
    }

    /// Rolling radius of the wheel (in m), where it has one: it may be straight where the pressure
    /// does not follow from the radii.
    pub fn wheel_radius(&self) -> Option<f64> {
        read::rolling_radius(&self.file.settings).ok()
    }

    /// Files that the case names, each with the field that does, whether that has an effect or not.
    pub fn files(&self) -> Vec<(FieldPath, PathBuf)> {
        self.file.files()
    }

    /// The text of the case with other values of some fields: see [`CaseFile::edited`].
    pub fn edited(&self, values: &[(FieldPath, f64)], folder: &Path) -> Result<String, CaseError> {
        self.file.edited(values, folder)
    }

    /// All fields in effect, given or by default.
    pub fn effective(&self) -> Vec<Effective> {
        let settings = &self.file.settings;
        let all = fields::SECTIONS
            .iter()
            .flat_map(|section| section.fields.iter().map(move |field| (section, field)));
        all.filter(|(_, field)| settings.has_effect(field))
            .map(|(section, field)| Effective {
                path: field.path,
                value: settings.shown(field.path),
                place: settings.place(field.path),
                tasks: section.tasks,
            })
            .filter(|effective| !effective.value.is_empty())
            .collect()
    }
}
