//! `schlupf fit`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use schlupf::identification::{
    self, CreepForceModel, DataPoint, Fit, Parameter, PolachModel, RollingContactModel,
    sample_curves,
};
use schlupf::method::FastMethod;
use schlupf::{Error, Method, Status};
use schlupf_case::identification::{parameters, read_data};
use schlupf_case::{Case, CaseErrors};
use schlupf_output::figures;
use schlupf_output::identification::{FitReport, FittedRoughness, csv, json, summary};

use crate::arguments::FitArguments;
use crate::commands::read_case;
use crate::failure::{Failure, NOT_CONVERGED};
use crate::outputs::{self, Input};
use crate::progress::Progress;
use crate::report;
use crate::solve::figure_files;

const DATA: &str = "--data";
const FIT: &str = "--fit";

/// Points of a curve in the figure.
const CURVE_POINTS: usize = 41;

/// Finds the parameters and writes them.
pub fn run(arguments: &FitArguments) -> Result<ExitCode, Failure> {
    let case = read_case(&arguments.case)?;
    let parameters = parameters(FIT, &arguments.fit).map_err(CaseErrors::from)?;
    let data =
        read_data(DATA, &arguments.data, &case.problem.kinematics).map_err(CaseErrors::from)?;
    let explain = |error: Error| explain(arguments, &case, &error);
    case.require_steady("a creep curve is").map_err(CaseErrors::from)?;
    let model = Model::new(&case, &parameters, arguments.gamma);
    let Some(mut model) = model.map_err(explain)? else { return Err(no_model(case.method)) };
    identification::check(model.creep_forces(), &data).map_err(explain)?;
    let load = case.problem.normal.normal_contact(None).map_err(explain)?.summary.load;
    check_outputs(arguments, &case)?;
    let other_loads = other_loads(&data, load);
    if let Some(text) = &other_loads {
        report::warn(text);
    }
    let progress = Progress::start();
    progress.stage("fitting");
    let steps = arguments.max_steps as usize;
    let fit = identification::fit(model.creep_forces(), &data, steps, &progress.watch());
    let mut fit = fit.map_err(explain)?;
    fit.warnings.extend(case.notices.iter().cloned().chain(other_loads));
    let points = if arguments.figures.is_some() { CURVE_POINTS } else { 0 };
    let curves = sample_curves(model.creep_forces(), &data, points, &progress.watch());
    let curves = curves.map_err(explain)?;
    let contact_stiffness = model.contact_stiffness();
    let roughness = parameters
        .contains(&Parameter::Roughness)
        .then_some(FittedRoughness { gamma: arguments.gamma, contact_stiffness });
    let report = FitReport {
        title: case.title.clone(),
        data: arguments.data.display().to_string(),
        load,
        fit,
        curves,
        roughness,
    };
    let mut files = files(arguments, &report, &progress)?;
    let fitted = arguments.write_case.as_ref().map(|path| {
        let text = fitted_case(&case, &report.fit, contact_stiffness, path)?;
        Ok((path.clone(), text.into_bytes()))
    });
    // What was found is written, whether a case can have it or not.
    let no_case = match fitted.transpose() {
        Ok(fitted) => {
            files.extend(fitted);
            None
        }
        Err(failure) => Some(failure),
    };
    drop(progress);
    outputs::write(&files, arguments.figures.as_deref())?;
    arguments.report.print(|| json::document(&report), || summary::text(&report))?;
    if let Some(failure) = no_case {
        return Err(failure);
    }
    match report.fit.status {
        Status::Converged => Ok(ExitCode::SUCCESS),
        Status::NotConverged => {
            let failures = report.fit.warnings.iter();
            failures
                .filter(|text| text.starts_with("not converged: "))
                .for_each(|t| report::warn(t));
            Ok(ExitCode::from(NOT_CONVERGED))
        }
    }
}

/// Loads of the data (in N) far from that of the case: units, as a rule.
fn other_loads(data: &[DataPoint], load: f64) -> Option<String> {
    const FAR: f64 = 10.0;
    let loads = data.iter().filter_map(|point| point.condition.load);
    let far = loads.filter(|other| other / load > FAR || load / other > FAR);
    let other =
        far.max_by(|one, other| (one / load).ln().abs().total_cmp(&(other / load).ln().abs()))?;
    Some(format!(
        "the data have a load of {other:.4e} N, the case one of {load:.4e} N: are the units right?"
    ))
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
    fn contact_stiffness(&self) -> f64 {
        match self {
            Self::Full(model) => model.contact_stiffness(),
            Self::Polach(_) => f64::NAN,
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

/// An error of the core: of the data and what they are to determine, or of the case.
fn explain(arguments: &FitArguments, case: &Case, error: &Error) -> Failure {
    let (Error::Invalid { quantity, .. } | Error::Contradiction { quantity, .. }) = error else {
        return Failure::Case(case.explain(error).into());
    };
    let is_fitted = arguments.fit.split(',').any(|name| name.trim() == *quantity);
    let is_of_data = ["force_ratio", "standard_deviation", "gamma"].contains(quantity);
    if is_fitted || is_of_data {
        let data = arguments.data.display();
        Failure::Arguments(format!("{FIT} {} {DATA} {data}: {error}", arguments.fit))
    } else {
        Failure::Case(case.explain(error).into())
    }
}

/// The text of the case with the values found.
fn fitted_case(
    case: &Case,
    fit: &Fit,
    contact_stiffness: f64,
    path: &Path,
) -> Result<String, Failure> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut values: Vec<(&str, f64)> = fit
        .estimates
        .iter()
        .map(|estimate| match estimate.parameter {
            // k_c is what a case has.
            Parameter::Roughness => (Parameter::ContactStiffness.name(), contact_stiffness),
            parameter => (parameter.name(), estimate.value),
        })
        .collect();
    let stiffness = Parameter::ContactStiffness.name();
    let is_written = values.iter().any(|(name, _)| *name == stiffness);
    if !is_written && contact_stiffness.is_finite() && case.law_stiffness.is_from_roughness() {
        // From another μ0 the roughness would give another k_c than that of the fit.
        values.push((stiffness, contact_stiffness));
    }
    let text = case.edited(&values, folder).map_err(CaseErrors::from)?;
    // What is written can be read again.
    Case::from_str(&text, &path.display().to_string(), folder, &[])?;
    Ok(text)
}

fn check_outputs(arguments: &FitArguments, case: &Case) -> Result<(), Failure> {
    let json = arguments.report.json_file();
    let outputs: Vec<(&str, &Path)> = [
        ("--json", json),
        ("--csv", arguments.csv.as_deref()),
        ("--write-case", arguments.write_case.as_deref()),
    ]
    .into_iter()
    .filter_map(|(option, path)| Some((option, path?)))
    .collect();
    let mut inputs = Input::of_case(&arguments.case, case);
    inputs.push(Input { what: DATA.to_owned(), path: arguments.data.clone(), except: None });
    match &arguments.figures {
        None => outputs::check(&outputs, &inputs),
        Some(directory) => {
            let names = figure_files(figures::FIT);
            outputs::check_with_directory(&outputs, &inputs, ("--figures", directory), &names)
        }
    }
}

/// All files but the case in memory: what cannot be made is known before the first one is written.
fn files(
    arguments: &FitArguments,
    report: &FitReport,
    progress: &Progress,
) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
    let mut files = Vec::new();
    if let Some(path) = arguments.report.json_file() {
        files.push((path.to_owned(), json::document(report).into_bytes()));
    }
    if let Some(path) = &arguments.csv {
        files.push((path.clone(), csv::table(report).into_bytes()));
    }
    if let Some(directory) = &arguments.figures {
        progress.stage("drawing figures");
        let figure = figures::fit(report)?;
        let [svg, png] = figure_files(&figure.name).map(|name| directory.join(name));
        files.push((svg, figure.svg.into_bytes()));
        files.push((png, figure.png));
    }
    Ok(files)
}
