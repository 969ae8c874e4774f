//! Parameters that fit measured creep curves.

use std::path::Path;

use crate::output::identification::{FitReport, FittedRoughness};
use schlupf::analysis::identification::roughness::DEFAULT_GAMMA;
use schlupf::analysis::identification::{
    self, CreepForceModel, DataPoint, Parameter, PolachModel, RollingContactModel, sample_curves,
};
use schlupf::problem::FastMethod;
use schlupf::reporting::Message;
use schlupf::{Error, Method, Quantity, Watch};
use schlupf_case::identification::{field, parameters, read_data};
use schlupf_case::{
    CREEP_COLUMNS, Case, CaseError, CaseErrors, CaseFile, Cause, FieldNames, FieldPath, Folder,
    InputFile, Overrides, Place, field, fields, quantity_field,
};

use crate::request::{Kind, request};
use crate::task::{Found, Given, Task, Wanted};
use crate::{Notice, TaskError, messages};

request! {
    /// What to fit to which data.
    Request {
        /// Parameters to fit, such as "friction.coefficient,contact_law.stiffness";
        /// "contact_law.roughness" is the r.m.s. height of both surfaces together, in place of the
        /// stiffness.
        parameters: String = Kind::list("SECTION.FIELD,…"), option("fit");
        /// Measured points (CSV): creepage_x, creepage_y or spin [1/m], force_ratio (-Fx/N over
        /// creepage_x, -Fy/N over creepage_y) or force_ratio_x, force_ratio_y, and where they
        /// differ from the case speed [m/s], load [kN]; standard_deviation where known.
        data: InputFile = Kind::table(&CREEP_COLUMNS);
        /// γ, for "contact_law.roughness": the rough surfaces approach by γ times that height when
        /// the pressure grows e-fold (Persson 2007).
        gamma: f64 = Kind::number(0.01, 10.0), default(DEFAULT_GAMMA);
        /// Maximum number of steps of the fit.
        max_steps: usize = Kind::count(1, 1_000_000), default(100);
    }
}

/// `fit`: from the values of the case.
pub struct Fit;

impl Task for Fit {
    const NAME: &'static str = "fit";
    const ABOUT: &'static str =
        "Fit constants of friction and contact law to measured creep forces";
    type Request = Request;
    type Report = FitReport;

    fn run(
        of: &Given,
        request: Request,
        wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<FitReport>, TaskError> {
        let posed = Posed::new(of.case, request, watch)?;
        let fitted_case = wanted.file(FitReport::CASE);
        if let Some(path) = fitted_case {
            // Whether it can be written there at all.
            posed.case.edited(&[], folder(path))?;
        }
        posed.fit(if wanted.figures { CURVE_POINTS } else { 0 }, fitted_case, watch)
    }
}

/// Points of each curve of the model in the figure.
const CURVE_POINTS: usize = 41;

/// What is fitted to which data, checked.
struct Posed {
    case: Case,
    request: Request,
    parameters: Vec<Parameter>,
    data: Vec<DataPoint>,
    /// Load of the case, in N.
    load: f64,
    /// What is doubtful about the loads of the data.
    doubt: Option<Message>,
}

impl Posed {
    /// Poses the case and reads the data; the model is checked with them.
    fn new(file: &CaseFile, request: Request, watch: Watch) -> Result<Self, TaskError> {
        let parameters = parameters(&request.asked.name("parameters"), &request.parameters)?;
        let case = file.pose(watch)?;
        let name = request.asked.name("data");
        let data = read_data(&name, &request.data, &case.problem.kinematics)?;
        let load = case.problem.normal.normal_contact(None);
        let load = load.map_err(|error| case.explain(&error))?.summary.load;
        let doubt = other_loads(&data, load);
        case.require_steady("a creep curve is")?;
        refuse_forces(file, &case)?;
        let posed = Self { case, request, parameters, data, load, doubt };
        let mut model = posed.model()?;
        let checked = identification::check(model.creep_forces(), &posed.data);
        checked.map_err(|error| posed.explain(&error))?;
        Ok(posed)
    }

    fn model(&self) -> Result<Model, TaskError> {
        let model = Model::new(&self.case, &self.parameters, self.request.gamma);
        let model = model.map_err(|error| self.explain(&error))?;
        model.ok_or_else(|| no_model(&self.case.method))
    }

    /// The fit; the case with its values is going to lie at a path, if it is wanted.
    fn fit(
        self,
        curve_points: usize,
        fitted: Option<&Path>,
        watch: Watch,
    ) -> Result<Found<FitReport>, TaskError> {
        let mut model = self.model()?;
        let explain = |error: Error| self.explain(&error);
        let max_steps = self.request.max_steps;
        let fit = identification::fit(model.creep_forces(), &self.data, max_steps, watch);
        let fit = fit.map_err(explain)?;
        let curves = sample_curves(model.creep_forces(), &self.data, curve_points, watch);
        let curves = curves.map_err(explain)?;
        let stiffness = model.contact_stiffness();
        let fitted = fitted.map(|path| fitted_case(&self.case, &fit, stiffness, path)).transpose();
        let is_fitted = self.parameters.contains(&Parameter::Roughness);
        let roughness = stiffness.filter(|_| is_fitted).map(|contact_stiffness| FittedRoughness {
            gamma: self.request.gamma,
            contact_stiffness,
        });
        let notices = self.case.notices.iter().cloned();
        let warnings = messages(&fit.warnings).chain(notices).chain(self.doubt).collect();
        let report = FitReport {
            data: self.request.data.path().display().to_string(),
            load: self.load,
            curves,
            roughness,
            names: self.parameters.iter().map(|p| field(*p).to_owned()).collect(),
            case: fitted.as_ref().ok().cloned().flatten(),
            warnings,
            fit,
            title: self.case.title,
        };
        // What was found is told, whether a case can have it or not. That it has not converged
        // explains more.
        Ok(Found { report: Box::new(report), failure: fitted.err() })
    }

    /// An error of the core: of the data and what they are to determine, or of the case; with what
    /// is doubtful about the loads.
    fn explain(&self, error: &Error) -> TaskError {
        let Self { request, case, .. } = self;
        let quantity = error.quantity();
        let is_fitted = self.parameters.iter().any(|parameter| parameter.quantity() == quantity);
        let is_of_data = matches!(
            quantity,
            Quantity::ForceRatio | Quantity::StandardDeviation | Quantity::SlopeFactor
        );
        if !is_fitted && !is_of_data {
            return case.explain(error).into();
        }
        let (parameters, data) = (&request.parameters, request.data.path());
        let name = request.asked.name("data");
        let text = format!("{parameters} {name} {}", data.display());
        let place = Place::Override { option: request.asked.name("parameters").into(), text };
        let cause = if error.is_of_convergence() { Cause::NotConverged } else { Cause::Input };
        let error = CaseError::new("", error.text(&FieldNames::CASE), place);
        CaseError { cause, ..error }
            .help(self.doubt.as_ref().map(|doubt| doubt.text.clone()))
            .into()
    }
}

/// Loads of the data (in N) far from that of the case: units, as a rule.
fn other_loads(data: &[DataPoint], load: f64) -> Option<Message> {
    const FAR: f64 = 10.0;
    let loads = data.iter().filter_map(|point| point.condition.load);
    let far = loads.filter(|other| other / load > FAR || load / other > FAR);
    let other =
        far.max_by(|one, other| (one / load).ln().abs().total_cmp(&(other / load).ln().abs()))?;
    Some(Notice::OtherLoads { of_data: other, of_case: load }.into())
}

/// What is fitted.
enum Model {
    Full(Box<RollingContactModel>),
    Polach(Box<PolachModel>),
}

impl Model {
    /// `None` where the method cannot be fitted.
    fn new(case: &Case, parameters: &[Parameter], gamma: f64) -> Result<Option<Self>, Error> {
        let Case { problem, options, .. } = case;
        Ok(match case.method {
            Method::Full => {
                let model = RollingContactModel::new(problem, options, parameters, gamma)?;
                Some(Self::Full(Box::new(model)))
            }
            Method::Fast(FastMethod::Polach(reduction)) => {
                let model = PolachModel::new(problem, reduction, parameters)?;
                Some(Self::Polach(Box::new(model)))
            }
            Method::Fast(_) => None,
        })
    }

    fn creep_forces(&mut self) -> &mut dyn CreepForceModel {
        match self {
            Self::Full(model) => &mut **model,
            Self::Polach(model) => &mut **model,
        }
    }

    /// k_c at the present values (in 1/m), where there is one.
    fn contact_stiffness(&self) -> Option<f64> {
        match self {
            Self::Full(model) => Some(model.contact_stiffness()),
            Self::Polach(_) => None,
        }
    }
}

/// Forces in place of creepages, by their fields.
const FORCES: &[FieldPath] = &fields![
    "kinematics.force_x",
    "kinematics.traction_coefficient",
    "kinematics.wheel_torque",
    "kinematics.force_y",
    "kinematics.moment_z",
];

/// Refuses forces that a fit does not hold, but would ignore.
fn refuse_forces(file: &CaseFile, case: &Case) -> Result<(), CaseError> {
    let Some(field) = file.given().find(|path| FORCES.contains(path)) else { return Ok(()) };
    let reason = if case.wheel.is_some() {
        "a fit with normal.model = \"wheel-rail\" is one of the largest contact with the creepages of \
         the data, so a force on the wheel must be left out, but is given"
    } else if matches!(case.method, Method::Fast(FastMethod::Polach(_))) {
        "a fit of Polach's method needs creepages, so a force must be left out, but is given; with \
         solver.method = \"full\" forces of other directions than that of the data are held"
    } else {
        return Ok(());
    };
    Err(case.contradiction(field, reason))
}

/// Only some methods can be fitted.
fn no_model(method: &Method) -> TaskError {
    TaskError::Request(format!(
        "solver.method: what can be fitted is \"full\" and \"polach\", but the method is {:?}",
        method.name()
    ))
}

/// Where a file lies.
fn folder(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

/// The text of the case with the values found.
fn fitted_case(
    case: &Case,
    fit: &identification::Fit,
    contact_stiffness: Option<f64>,
    path: &Path,
) -> Result<String, CaseErrors> {
    let folder = folder(path);
    let stiffness = field!("contact_law.stiffness");
    let mut values = Vec::new();
    for estimate in &fit.estimates {
        match (estimate.parameter, contact_stiffness) {
            // k_c is what a case has.
            (Parameter::Roughness, Some(value)) => values.push((stiffness, value)),
            (parameter, _) => {
                let path = quantity_field(parameter.quantity());
                values.extend(path.map(|path| (path, estimate.value)));
            }
        }
    }
    let is_written = values.iter().any(|(name, _)| *name == stiffness);
    if let Some(value) = contact_stiffness
        && !is_written
        && case.law_stiffness.is_from_roughness()
    {
        // From another μ0 the roughness would give another k_c than that of the fit.
        values.push((stiffness, value));
    }
    let text = case.edited(&values, folder)?;
    // What is written can be read again.
    CaseFile::from_str(&text, &path.display().to_string(), Folder::new(folder), Overrides::NONE)?;
    Ok(text)
}
