//! Parameters that fit measured creep curves.

use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use schlupf::identification::{
    self, CreepForceModel, DataPoint, Parameter, PolachModel, RollingContactModel, sample_curves,
};
use schlupf::message::Message;
use schlupf::method::FastMethod;
use schlupf::{Error, Method, Quantity, Watch};
use schlupf_case::identification::{field, read_data};
use schlupf_case::{
    Case, CaseError, CaseErrors, CaseFile, Cause, FieldNames, Folder, InputFile, Overrides, Place,
};
use schlupf_output::identification::{FitReport, FittedRoughness};

use crate::{Notice, TaskError, messages};

/// Largest number of steps by default.
pub const MAX_STEPS: u32 = 100;

/// Values of γ that theory or measurement may have, dimensionless.
pub const GAMMA: RangeInclusive<f64> = 0.01..=10.0;

/// What to fit to which data.
#[derive(Debug, Clone)]
pub struct Request {
    /// The parameters.
    pub parameters: Vec<Parameter>,
    /// Measured points (CSV).
    pub data: InputFile,
    /// γ, where the roughness is fitted, dimensionless.
    pub gamma: f64,
    /// Largest number of steps.
    pub max_steps: usize,
    /// Points of each curve of the model, for plots; none where zero.
    pub curve_points: usize,
    /// Where the case with the fitted values is going to lie, if it is wanted.
    pub fitted_case: Option<PathBuf>,
    /// What messages call data and parameters, and the parameters as they were given.
    pub names: Names,
}

/// What messages call the parts of a request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Names {
    /// The data.
    pub data: &'static str,
    /// The parameters.
    pub parameters: &'static str,
    /// The parameters as they were given, with what stands between them and the data.
    pub given: String,
}

/// What is fitted to which data, checked.
pub struct Plan {
    case: Case,
    request: Request,
    data: Vec<DataPoint>,
    model: Model,
    /// Load of the case, in N.
    load: f64,
}

/// What a fit has found.
#[derive(Debug)]
pub struct Found {
    /// The fit.
    pub report: FitReport,
    /// Why no case can have the fitted values.
    pub failure: Option<CaseErrors>,
}

/// Poses the case, whose values are those to start from, and reads the data.
///
/// # Errors
/// A case or data that are wrong, or that do not determine the parameters.
pub fn plan(file: &CaseFile, request: Request, watch: Watch) -> Result<Plan, TaskError> {
    request.check_gamma()?;
    let case = file.pose(watch)?;
    let data = read_data(request.names.data, &request.data, &case.problem.kinematics)?;
    let load = case.problem.normal.normal_contact(None);
    let load = load.map_err(|error| case.explain(&error))?.summary.load;
    let doubt = other_loads(&data, load);
    let explain = |error: Error| request.explain(&case, &error, doubt.as_ref());
    case.require_steady("a creep curve is")?;
    refuse_forces(file, &case)?;
    let model = Model::new(&case, &request).map_err(explain)?;
    let Some(mut model) = model else { return Err(no_model(case.method)) };
    identification::check(model.creep_forces(), &data).map_err(explain)?;
    if let Some(path) = &request.fitted_case {
        // Whether it can be written there at all.
        case.edited(&[], folder(path))?;
    }
    Ok(Plan { case, request, data, model, load })
}

impl Plan {
    /// Fits.
    ///
    /// # Errors
    /// Data that do not determine the parameters, or whatever the solver refuses.
    pub fn find(self, watch: Watch) -> Result<Found, TaskError> {
        let Self { case, request, data, mut model, load } = self;
        let doubt = other_loads(&data, load);
        let explain = |error: Error| request.explain(&case, &error, doubt.as_ref());
        let fit = identification::fit(model.creep_forces(), &data, request.max_steps, watch);
        let fit = fit.map_err(explain)?;
        let curves = sample_curves(model.creep_forces(), &data, request.curve_points, watch);
        let curves = curves.map_err(explain)?;
        let stiffness = model.contact_stiffness();
        let fitted = request.fitted_case.as_ref();
        let fitted = fitted.map(|path| fitted_case(&case, &fit, stiffness, path)).transpose();
        let is_fitted = request.parameters.contains(&Parameter::Roughness);
        let roughness = stiffness.filter(|_| is_fitted);
        let notices = case.notices.iter().cloned();
        let warnings = messages(&fit.warnings).chain(notices).chain(doubt.iter().cloned());
        let report = FitReport {
            data: request.data.path().display().to_string(),
            load,
            curves,
            roughness: roughness.map(|contact_stiffness| FittedRoughness {
                gamma: request.gamma,
                contact_stiffness,
            }),
            names: request
                .parameters
                .iter()
                .map(|parameter| field(*parameter).to_owned())
                .collect(),
            case: fitted.as_ref().ok().cloned().flatten(),
            warnings: warnings.collect(),
            fit,
            title: case.title,
        };
        // What was found is told, whether a case can have it or not.
        Ok(Found { report, failure: fitted.err() })
    }
}

impl Request {
    fn check_gamma(&self) -> Result<(), TaskError> {
        if GAMMA.contains(&self.gamma) {
            return Ok(());
        }
        let (least, largest, gamma) = (GAMMA.start(), GAMMA.end(), self.gamma);
        let message = format!("gamma must be between {least} and {largest}, but is {gamma}");
        Err(TaskError::Request(message))
    }

    /// An error of the core: of the data and what they are to determine, or of the case; with what
    /// is doubtful about the loads.
    fn explain(&self, case: &Case, error: &Error, doubt: Option<&Message>) -> TaskError {
        let quantity = error.quantity();
        let is_fitted = self.parameters.iter().any(|parameter| parameter.quantity() == quantity);
        let is_of_data = matches!(
            quantity,
            Quantity::ForceRatio | Quantity::StandardDeviation | Quantity::SlopeFactor
        );
        if !is_fitted && !is_of_data {
            return case.explain(error).into();
        }
        let Names { parameters, given, .. } = &self.names;
        let text = format!("{given} {}", self.data.path().display());
        let place = Place::Override { option: (*parameters).into(), text };
        let cause = if error.is_of_convergence() { Cause::NotConverged } else { Cause::Input };
        let error = CaseError::new("", error.text(&FieldNames::CASE), place);
        CaseError { cause, ..error }.help(doubt.map(|doubt| doubt.text.clone())).into()
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
    fn new(case: &Case, request: &Request) -> Result<Option<Self>, Error> {
        let Case { problem, options, .. } = case;
        let Request { parameters, gamma, .. } = request;
        Ok(match case.method {
            Method::Full => {
                let model = RollingContactModel::new(problem, options, parameters, *gamma)?;
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
const FORCES: [&str; 5] = [
    "kinematics.force_x",
    "kinematics.traction_coefficient",
    "kinematics.wheel_torque",
    "kinematics.force_y",
    "kinematics.moment_z",
];

/// Refuses forces that a fit does not hold, but would ignore.
fn refuse_forces(file: &CaseFile, case: &Case) -> Result<(), CaseError> {
    let Some(field) = FORCES.into_iter().find(|field| file.given().any(|path| path == *field))
    else {
        return Ok(());
    };
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
fn no_model(method: Method) -> TaskError {
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
    let stiffness = field(Parameter::ContactStiffness);
    let mut values = Vec::new();
    for estimate in &fit.estimates {
        match (estimate.parameter, contact_stiffness) {
            // k_c is what a case has.
            (Parameter::Roughness, Some(value)) => values.push((stiffness, value)),
            (parameter, _) => values.push((field(parameter), estimate.value)),
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
