//! `schlupf compare`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use schlupf::normal::Pressure;
use schlupf::rolling::{self, steady::SteadySolver};
use schlupf::simplified::FastContact;
use schlupf::{Error, Method, Options, Problem, Solution};
use schlupf_case::fields::STIFFNESSES;
use schlupf_case::{Case, CaseErrors, Effective, Place};
use schlupf_output::comparison::{Answer, Comparison, Entry, csv, json, summary};
use schlupf_output::figures;

use crate::arguments::CompareArguments;
use crate::commands::read_case;
use crate::failure::{Failure, NOT_CONVERGED};
use crate::outputs::Input;
use crate::progress::Progress;
use crate::solve::figure_files;
use crate::{outputs, report};

/// What the fields that a method sets come from, in messages.
const COMPARE: &str = "compare";

const MODEL: &str = "elasticity.model";
const BOUND: &str = "fastsim.bound";

const MARGIN: &str = "elasticity.margin";

/// Compares all methods on a case and writes the results.
pub fn run(arguments: &CompareArguments) -> Result<ExitCode, Failure> {
    let case = read_case(&arguments.case)?;
    refuse_history(&case)?;
    check_outputs(arguments, &case)?;
    for notice in &case.notices {
        report::warn(notice);
    }
    let progress = Progress::start();
    let entries = entries(&case, &progress)?;
    let comparison = Comparison { title: case.title, entries };
    let files = files(arguments, &comparison, &progress)?;
    drop(progress);
    outputs::write(&files, arguments.figures.as_deref())?;
    arguments.report.print(|| json::document(&comparison), || summary::text(&comparison))?;
    for entry in &comparison.entries {
        if let Some(reason) = entry.reason() {
            report::warn(&format!("{}: not available: {reason}", entry.name));
        } else if entry.is_unconverged() {
            report::warn(&format!("{}: not converged", entry.name));
        }
    }
    let code = if comparison.is_converged() { 0 } else { NOT_CONVERGED };
    Ok(ExitCode::from(code))
}

/// Only the full method could follow one.
fn refuse_history(case: &Case) -> Result<(), Failure> {
    if case.problem.history.is_none() {
        return Ok(());
    }
    let reason = "a comparison is of steady rolling, but there is a history".to_owned();
    let field = if case.files().iter().any(|(field, _)| *field == "history.file") {
        "history.file"
    } else {
        "history.time"
    };
    let error = Error::Contradiction { quantity: field, reason };
    Err(Failure::Case(case.explain(&error).into()))
}

/// What all methods make of the case.
///
/// # Errors
/// What the first one says if none has an answer.
fn entries(case: &Case, progress: &Progress) -> Result<Vec<Entry>, Failure> {
    let full = case.with(COMPARE, "solver.method=full")?;
    let mut entries = Vec::new();
    let mut first_errors: Option<CaseErrors> = None;
    for (k, candidate) in CANDIDATES.iter().enumerate() {
        let answer = candidate.case(&full).and_then(|case| answer(&case));
        let answer = answer.map_err(|errors| {
            let messages: Vec<&str> = errors.iter().map(|error| error.message.as_str()).collect();
            let reason = messages.join("; ");
            first_errors.get_or_insert(errors);
            reason
        });
        let Candidate { name, method, elasticity } = *candidate;
        entries.push(Entry { name, method, elasticity, answer });
        let steps = Some(CANDIDATES.len());
        progress.step(rolling::Progress { step: k + 1, steps, change: 0.0 });
    }
    match first_errors {
        Some(errors) if entries.iter().all(|entry| entry.answer.is_err()) => Err(errors.into()),
        _ => Ok(entries),
    }
}

fn explained(case: &Case, error: &Error) -> CaseErrors {
    case.explain(error).into()
}

/// A method, with a model of elasticity if it is the full one.
struct Candidate {
    name: &'static str,
    method: &'static str,
    elasticity: Option<&'static str>,
}

const fn full(name: &'static str, elasticity: &'static str) -> Candidate {
    Candidate { name, method: "full", elasticity: Some(elasticity) }
}

const fn fast(name: &'static str, method: &'static str) -> Candidate {
    Candidate { name, method, elasticity: None }
}

/// All methods.
const CANDIDATES: [Candidate; 8] = [
    full("full, half-space", "half-space"),
    full("full, elastic layer", "elastic-layer"),
    full("full, Winkler bedding", "winkler"),
    fast("FASTSIM", "fastsim"),
    fast("modified FASTSIM", "modified-fastsim"),
    fast("Polach", "polach"),
    fast("Shen–Hedrick–Elkins", "shen-hedrick-elkins"),
    fast("Kalker linear", "kalker-linear"),
];

impl Candidate {
    /// The case that asks for it, from one that asks for the full method.
    fn case(&self, full: &Case) -> Result<Case, CaseErrors> {
        if let Some(model) = self.elasticity {
            let effective = full.effective();
            let own = effective.iter().find(|field| field.path == MODEL);
            let is_own = own.is_some_and(|field| field.value.trim_matches('"') == model);
            return if is_own { Ok(full.clone()) } else { with_elasticity(full, model) };
        }
        let case = full.with(COMPARE, &format!("solver.method={}", self.method))?;
        if takes_paraboloid(&case)? {
            return case.with(COMPARE, &format!("{BOUND}=elliptic"));
        }
        Ok(case)
    }
}

/// Whether the traction is bounded by a paraboloid by default, which a pressure that is not Hertz's does not have.
fn takes_paraboloid(case: &Case) -> Result<bool, CaseErrors> {
    let is_default =
        |field: &Effective| field.path == BOUND && matches!(field.place, Place::Default);
    let normal = case.problem.normal.normal_contact(None);
    let normal = normal.map_err(|error| explained(case, &error))?;
    let is_elliptic = matches!(normal.pressure, Pressure::Elliptic);
    Ok(!is_elliptic && case.effective().iter().any(is_default))
}

/// The case with another model of elasticity, without the stiffnesses of its own: the layer with its
/// default ones, which answer like the half-space, the Winkler bedding with those of FASTSIM, c = 1/L.
fn with_elasticity(case: &Case, model: &str) -> Result<Case, CaseErrors> {
    let without = STIFFNESSES.iter().chain(&[MARGIN]).map(|field| format!("{field}="));
    let assignments: Vec<String> =
        [format!("{MODEL}={model}")].into_iter().chain(without).collect();
    case.with_all(COMPARE, &assignments)
}

/// Repetitions last so long, or are so many.
const REPEATED_FOR: Duration = Duration::from_millis(2);
const MOST_REPETITIONS: u32 = 1000;

fn answer(case: &Case) -> Result<Answer, CaseErrors> {
    let explain = |error: Error| explained(case, &error);
    let problem = &case.problem;
    // Derivatives are not compared, and would count in the time.
    let options = Options { sensitivity: false, ..case.options.clone() };
    // The normal contact is the same for all, and counts for none.
    problem.normal.normal_contact(None).map_err(explain)?;
    let start = Instant::now();
    let solution = rolling::solve(problem, &options, &mut |_| ()).map_err(explain)?;
    let time = start.elapsed().as_secs_f64();
    let time_again = if options.method == Method::Full {
        again_full(problem, &options)
    } else {
        again_fast(problem, &options)
    };
    let time_again = time_again.map_err(explain)?;
    let solution = Solution { warnings: warnings(&solution), ..solution };
    Ok(Answer { solution, time, time_again })
}

/// The warnings but one: the table shows what a fast method does not give.
fn warnings(solution: &Solution) -> Vec<String> {
    let is_told = |text: &&String| !text.contains("only, no fields and no temperatures");
    solution.warnings.iter().filter(is_told).cloned().collect()
}

/// Time of a solution by a solver with its set-up and without earlier solutions, in s.
fn again_full(problem: &Problem, options: &Options) -> Result<f64, Error> {
    let mut solver = SteadySolver::new(options);
    solver.solve(problem, &mut |_| ())?;
    solver.forget();
    let start = Instant::now();
    solver.solve(problem, &mut |_| ())?;
    Ok(start.elapsed().as_secs_f64())
}

/// Mean time of the forces by a contact that is set up, in s.
fn again_fast(problem: &Problem, options: &Options) -> Result<f64, Error> {
    let mut contact = FastContact::new(problem, options)?;
    contact.force(&problem.kinematics)?;
    let start = Instant::now();
    let mut repetitions = 0;
    while repetitions < MOST_REPETITIONS && start.elapsed() < REPEATED_FOR {
        contact.force(&problem.kinematics)?;
        repetitions += 1;
    }
    Ok(start.elapsed().as_secs_f64() / f64::from(repetitions.max(1)))
}

fn check_outputs(arguments: &CompareArguments, case: &Case) -> Result<(), Failure> {
    let json = arguments.report.json_file();
    let outputs: Vec<(&str, &Path)> = [("--json", json), ("--csv", arguments.csv.as_deref())]
        .into_iter()
        .filter_map(|(option, path)| Some((option, path?)))
        .collect();
    let input = |what: &str, path: &Path| Input {
        what: what.to_owned(),
        path: path.to_owned(),
        except: None,
    };
    let mut inputs: Vec<Input> =
        arguments.case.case.iter().map(|path| input("the case file", path)).collect();
    inputs.extend(case.files().iter().map(|(field, path)| input(field, path)));
    match &arguments.figures {
        None => outputs::check(&outputs, &inputs),
        Some(directory) => {
            let names = figure_files(figures::COMPARISON);
            outputs::check_with_directory(&outputs, &inputs, ("--figures", directory), &names)
        }
    }
}

/// All files in memory: what cannot be made is known before the first one is written.
fn files(
    arguments: &CompareArguments,
    comparison: &Comparison,
    progress: &Progress,
) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
    let mut files = Vec::new();
    if let Some(path) = arguments.report.json_file() {
        files.push((path.to_owned(), json::document(comparison).into_bytes()));
    }
    if let Some(path) = &arguments.csv {
        files.push((path.clone(), csv::table(comparison).into_bytes()));
    }
    if let Some(directory) = &arguments.figures {
        progress.stage("drawing figures");
        let figure = figures::comparison(comparison)?;
        let [svg, png] = figure_files(&figure.name).map(|name| directory.join(name));
        files.push((svg, figure.svg.into_bytes()));
        files.push((png, figure.png));
    }
    Ok(files)
}
