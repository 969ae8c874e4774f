//! `schlupf compare`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use schlupf::normal::Pressure;
use schlupf::parallel;
use schlupf::simplified::FastContact;
use schlupf::{Error, Method, Problem, Solution, Solver, Watch};
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
    case.require_steady("a comparison is").map_err(CaseErrors::from)?;
    check_outputs(arguments, &case)?;
    for notice in &case.notices {
        report::warn(notice);
    }
    let progress = Progress::start();
    let entries = entries(&case, &progress.watch())?;
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

/// What all methods make of the case: all solutions on several threads first, then their times one after the other.
///
/// # Errors
/// What the first one says if none has an answer.
fn entries(case: &Case, watch: Watch) -> Result<Vec<Entry>, Failure> {
    let full = case.with(COMPARE, "solver.method=full")?;
    let solved = parallel::map(CANDIDATES.iter().collect(), |candidate| {
        candidate.case(&full).and_then(|case| Solved::new(case, watch))
    });
    let mut entries = Vec::new();
    let mut first_errors: Option<CaseErrors> = None;
    for (solved, candidate) in solved.into_iter().zip(CANDIDATES) {
        let answer = solved.and_then(|solved| solved.answer(watch)).map_err(|errors| {
            let messages: Vec<&str> = errors.iter().map(|error| error.message.as_str()).collect();
            let reason = messages.join("; ");
            first_errors.get_or_insert(errors);
            reason
        });
        let Candidate { name, method, elasticity } = candidate;
        entries.push(Entry { name, method, elasticity, answer });
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

/// A case that one method has solved.
struct Solved {
    case: Case,
    /// With its set-up.
    solver: Box<dyn Solver>,
    solution: Solution,
}

impl Solved {
    fn new(case: Case, watch: Watch) -> Result<Self, CaseErrors> {
        let mut solver = case.solver();
        let solution = solver.solve(&case.problem, watch);
        let solution = solution.map_err(|error| explained(&case, &error))?;
        Ok(Self { case, solver, solution })
    }

    /// Nothing else must run while times are measured.
    fn answer(mut self, watch: Watch) -> Result<Answer, CaseErrors> {
        let time = self.time(watch);
        let times = time.and_then(|time| Ok((time, self.time_again(watch)?)));
        let (time, time_again) = times.map_err(|error| explained(&self.case, &error))?;
        let solution = Solution { warnings: warnings(&self.solution), ..self.solution };
        Ok(Answer { solution, time, time_again })
    }

    /// Time of a solution from the set-up on, in s. The normal contact, which is the same for all, is known.
    fn time(&self, watch: Watch) -> Result<f64, Error> {
        let start = Instant::now();
        self.case.solver().solve(&self.case.problem, watch)?;
        Ok(start.elapsed().as_secs_f64())
    }

    /// Time with the set-up there, in s: of a solution without earlier ones, or, by a fast method, of the forces.
    fn time_again(&mut self, watch: Watch) -> Result<f64, Error> {
        let Case { problem, options, method, .. } = &self.case;
        match method {
            Method::Fast(method) => {
                forces_again(FastContact::new(problem, *method, options)?, problem)
            }
            Method::Full => {
                self.solver.forget();
                let start = Instant::now();
                self.solver.solve(problem, watch)?;
                Ok(start.elapsed().as_secs_f64())
            }
        }
    }
}

/// The warnings but one: the table shows what a fast method does not give.
fn warnings(solution: &Solution) -> Vec<String> {
    let is_told = |text: &&String| !text.contains("only, no fields and no temperatures");
    solution.warnings.iter().filter(is_told).cloned().collect()
}

/// Mean time of the forces by a contact that is set up, in s.
fn forces_again(mut contact: FastContact, problem: &Problem) -> Result<f64, Error> {
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
