//! `schlupf fit`.

use std::path::{Path, PathBuf};

use clap::{Args, ValueHint};
use schlupf::identification::roughness::DEFAULT_GAMMA;
use schlupf::identification::{
    self, CreepForceModel, DataPoint, Parameter, PolachModel, RollingContactModel, sample_curves,
};
use schlupf::message::Message;
use schlupf::method::FastMethod;
use schlupf::{Error, Method, Quantity, Watch};
use schlupf_case::identification::{field, parameters, read_data};
use schlupf_case::{
    Case, CaseError, CaseErrors, CaseFile, FieldNames, Folder, InputFile, Overrides, Place,
};
use schlupf_output::identification::{FitReport, FittedRoughness};

use schlupf_tasks::messages;

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::notice::Notice;
use crate::outputs::Input;
use crate::progress::Progress;
use crate::task::{Found, OwnFile, Task};

const DATA: &str = "--data";
const FIT: &str = "--fit";

/// Points of a curve in the figure.
const CURVE_POINTS: usize = 41;

/// What to fit to which data, and where to write it.
#[derive(Debug, Args)]
pub struct Fit {
    /// Which case; its values are those to start from.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Measured points (CSV): creepage_x, creepage_y or spin [1/m], force_ratio (-Fx/N over
    /// creepage_x, -Fy/N over creepage_y) or force_ratio_x, force_ratio_y, and where they differ
    /// from the case speed [m/s], load [kN]; standard_deviation where known
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub data: PathBuf,
    /// What to find, such as friction.coefficient,contact_law.stiffness; contact_law.roughness is
    /// the r.m.s. height of both surfaces together, in place of the stiffness
    #[arg(long = "fit", value_name = "SECTION.FIELD,…")]
    pub parameters: String,
    /// γ, for contact_law.roughness: the rough surfaces approach by γ times that height when the
    /// pressure grows e-fold
    #[arg(long, value_name = "NUMBER", default_value_t = DEFAULT_GAMMA, value_parser = gamma)]
    pub gamma: f64,
    /// Maximum number of steps of the fit
    #[arg(long, value_name = "N", default_value_t = 100,
          value_parser = clap::value_parser!(u32).range(1..))]
    pub max_steps: u32,
    /// Write the case with the fitted values, keeping comments and layout
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub write_case: Option<PathBuf>,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

/// A γ that theory or measurement may have.
fn gamma(text: &str) -> Result<f64, String> {
    let gamma = text.parse().ok().filter(|gamma| (0.01..=10.0).contains(gamma));
    gamma.ok_or_else(|| "must be a number between 0.01 and 10".to_owned())
}

/// What is fitted to which data.
pub struct Plan {
    case: Case,
    parameters: Vec<Parameter>,
    data: Vec<DataPoint>,
    model: Model,
    /// Load of the case, in N.
    load: f64,
}

impl Task for Fit {
    type Plan = Plan;
    type Report = FitReport;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn own_files(&self) -> Vec<OwnFile<'_>> {
        let case = OwnFile::given("--write-case", FitReport::CASE, self.write_case.as_ref());
        case.into_iter().collect()
    }

    fn plan(&self, file: CaseFile, watch: Watch) -> Result<Plan, Failure> {
        let parameters = parameters(FIT, &self.parameters).map_err(CaseErrors::from)?;
        let case = file.pose(watch)?;
        let data = read_data(DATA, &InputFile::at(&self.data), &case.problem.kinematics);
        let data = data.map_err(CaseErrors::from)?;
        let load = case.problem.normal.normal_contact(None);
        let load =
            load.map_err(|error| case.explain(&error)).map_err(CaseErrors::from)?.summary.load;
        let doubt = other_loads(&data, load);
        let explain = |error: Error| self.explain(&case, &error, doubt.as_ref());
        case.require_steady("a creep curve is").map_err(CaseErrors::from)?;
        let model = Model::new(&case, &parameters, self.gamma).map_err(explain)?;
        let Some(mut model) = model else { return Err(no_model(case.method)) };
        identification::check(model.creep_forces(), &data).map_err(explain)?;
        if let Some(path) = &self.write_case {
            // Whether it can be written there at all.
            case.edited(&[], folder(path)).map_err(CaseErrors::from)?;
        }
        Ok(Plan { case, parameters, data, model, load })
    }

    fn inputs(&self, file: &CaseFile) -> Vec<Input> {
        let mut inputs = Input::of_case(&self.case, file);
        inputs.push(Input { what: DATA.to_owned(), path: self.data.clone(), except: None });
        inputs
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<FitReport>, Failure> {
        let Plan { case, parameters, data, mut model, load } = plan;
        progress.stage("fitting");
        let doubt = other_loads(&data, load);
        let explain = |error: Error| self.explain(&case, &error, doubt.as_ref());
        let steps = self.max_steps as usize;
        let fit = identification::fit(model.creep_forces(), &data, steps, &progress.watch());
        let fit = fit.map_err(explain)?;
        let points = if self.outputs.figures.is_some() { CURVE_POINTS } else { 0 };
        let curves = sample_curves(model.creep_forces(), &data, points, &progress.watch());
        let curves = curves.map_err(explain)?;
        let stiffness = model.contact_stiffness();
        let fitted = self.write_case.as_ref();
        let fitted = fitted.map(|path| fitted_case(&case, &fit, stiffness, path)).transpose();
        let is_fitted = parameters.contains(&Parameter::Roughness);
        let roughness = stiffness.filter(|_| is_fitted);
        let notices = case.notices.iter().cloned();
        let warnings = messages(&fit.warnings).chain(notices).chain(doubt.iter().cloned());
        let report = FitReport {
            data: self.data.display().to_string(),
            load,
            curves,
            roughness: roughness
                .map(|contact_stiffness| FittedRoughness { gamma: self.gamma, contact_stiffness }),
            names: parameters.iter().map(|parameter| name(*parameter).to_owned()).collect(),
            case: fitted.as_ref().ok().cloned().flatten(),
            warnings: warnings.collect(),
            fit,
            title: case.title,
        };
        // What was found is printed, whether a case can have it or not.
        Ok(Found { report, failure: fitted.err() })
    }
}

impl Fit {
    /// An error of the core: of the data and what they are to determine, or of the case; with what
    /// is doubtful about the loads.
    fn explain(&self, case: &Case, error: &Error, doubt: Option<&Message>) -> Failure {
        let quantity = error.quantity();
        let mut fitted = parameters(FIT, &self.parameters).into_iter().flatten();
        let is_fitted = fitted.any(|parameter| parameter.quantity() == quantity);
        let is_of_data = matches!(
            quantity,
            Quantity::ForceRatio | Quantity::StandardDeviation | Quantity::SlopeFactor
        );
        if is_fitted || is_of_data {
            let text = format!("{} {DATA} {}", self.parameters, self.data.display());
            let place = Place::Override { option: FIT.into(), text };
            let error = CaseError::new("", error.text(&FieldNames::CASE), place);
            Failure::Case(error.help(doubt.map(|doubt| doubt.text.clone())).into())
        } else {
            Failure::Case(case.explain(error).into())
        }
    }
}

/// What a parameter is called.
fn name(parameter: Parameter) -> &'static str {
    field(parameter)
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
pub enum Model {
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

/// Only some methods can be fitted.
fn no_model(method: Method) -> Failure {
    Failure::Arguments(format!(
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
) -> Result<String, Failure> {
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
    let text = case.edited(&values, folder).map_err(CaseErrors::from)?;
    // What is written can be read again.
    CaseFile::from_str(&text, &path.display().to_string(), Folder::new(folder), Overrides::NONE)?;
    Ok(text)
}
