//! `schlupf compare`.

use std::time::{Duration, Instant};

use clap::Args;
use schlupf::message::Message;
use schlupf::normal::Pressure;
use schlupf::rolling::{self, steady::SteadySolver};
use schlupf::simplified::FastContact;
use schlupf::{Error, Method, Options, Problem, Quantity, Warning};
use schlupf_case::fields::STIFFNESSES;
use schlupf_case::{Case, CaseErrors, Effective, Place};
use schlupf_output::comparison::{Answer, Comparison, Entry};
use schlupf_output::figures;

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::outputs::Input;
use crate::progress::Progress;
use crate::task::{Found, Task, messages};

/// What the fields that a method sets come from, in messages.
const COMPARE: &str = "compare";

const MODEL: &str = "elasticity.model";
const BOUND: &str = "fastsim.bound";

const MARGIN: &str = "elasticity.margin";

/// What to compare, and where to write it.
#[derive(Debug, Args)]
pub struct Compare {
    /// Which case.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

impl Task for Compare {
    type Plan = Case;
    type Report = Comparison;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn figure_names(&self) -> Vec<String> {
        vec![figures::COMPARISON.to_owned()]
    }

    fn plan(&self, case: Case) -> Result<Case, Failure> {
        refuse_history(&case)?;
        Ok(case)
    }

    fn inputs(&self, case: &Case) -> Vec<Input> {
        Input::of_case(&self.case, case)
    }

    fn find(&self, case: Case, progress: &Progress) -> Result<Found<Comparison>, Failure> {
        let entries = entries(&case, progress)?;
        let warnings = case.notices.iter().cloned().chain(warnings(&entries)).collect();
        Ok(Comparison { title: case.title, entries, warnings }.into())
    }
}

/// Only the full method could follow one.
fn refuse_history(case: &Case) -> Result<(), Failure> {
    if case.problem.history.is_none() {
        return Ok(());
    }
    let error = Error::NotSteady { quantity: Quantity::Time, what: "a comparison is of" };
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
    Ok(Answer { solution, time, time_again })
}

/// Whatever the reader of the numbers must know, but for what the table shows: that a fast method
/// gives no fields.
fn warnings(entries: &[Entry]) -> Vec<Message> {
    let of = |entry: &Entry| match &entry.answer {
        Err(reason) => {
            vec![Message::new("not-available", "solver.method", reason).about("not available")]
        }
        Ok(answer) => {
            let told = |warning: &&Warning| !matches!(warning, Warning::ForcesOnly { .. });
            messages(answer.solution.warnings.iter().filter(told)).collect()
        }
    };
    entries.iter().flat_map(|entry| of(entry).into_iter().map(|m| m.about(entry.name))).collect()
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
