//! All methods on the same case.

use std::time::{Duration, Instant};

use crate::output::comparison::{Answer, Comparison, Entry};
use schlupf::normal::Pressure;
use schlupf::numerics::parallel;
use schlupf::reporting::Message;
use schlupf::solver::simplified::FastContact;
use schlupf::{Error, Method, Problem, Solution, Solver, Watch};
use schlupf_case::fields::STIFFNESSES;
use schlupf_case::fields::choice::NormalSolution;
use schlupf_case::{Case, CaseErrors, CaseFile, ElasticityModel, FieldPath, field};

use crate::request::Nothing;
use crate::task::{Found, Given, Task, Wanted};
use crate::{Notice, TaskError, messages};

/// What the fields that a method sets come from, in messages.
const COMPARE: &str = "compare";

const BOUND: FieldPath = field!("fastsim.bound");

const MARGIN: FieldPath = field!("elasticity.margin");

/// `compare`.
pub struct Compare;

impl Task for Compare {
    const NAME: &'static str = "compare";
    const ABOUT: &'static str =
        "Solve a case by all methods and compare forces, temperatures and times";
    const HAS_SEVERAL: bool = true;
    type Request = Nothing;
    type Report = Comparison;

    fn run(
        of: &Given,
        _request: Nothing,
        _wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<Comparison>, TaskError> {
        let case = of.case.pose(watch)?;
        case.require_steady("a comparison is")?;
        let entries = entries(of.case, &case, watch)?;
        let warnings =
            Notice::of_first_contact(&case).into_iter().chain(warnings(&entries)).collect();
        Ok(Comparison { title: case.title, entries, warnings }.into())
    }
}

/// What all methods make of the case: all solutions on several threads first, then their times one
/// after the other.
///
/// # Errors
/// What the first one says if none has an answer.
fn entries(of: &CaseFile, case: &Case, watch: Watch) -> Result<Vec<Entry>, TaskError> {
    let full = case.with(COMPARE, &["solver.method=full".to_owned()], watch)?;
    let (candidates, bound) = (candidates(&full), bound(of, &full)?);
    let solved = parallel::map(candidates.iter().collect(), |candidate: &Candidate| {
        candidate.case(&full, bound.as_deref(), watch).and_then(|case| Solved::new(case, watch))
    });
    let mut entries = Vec::new();
    let mut first_errors: Option<CaseErrors> = None;
    for (solved, candidate) in solved.into_iter().zip(candidates) {
        let answer = solved.and_then(|solved| solved.answer(watch)).map_err(|errors| {
            let messages: Vec<&str> = errors.iter().map(|error| error.message.as_str()).collect();
            let reason = messages.join("; ");
            first_errors.get_or_insert(errors);
            reason
        });
        let Candidate { name, method, elasticity, normal } = candidate;
        let elasticity = elasticity.map(ElasticityModel::name);
        let normal = normal.map(NormalSolution::name);
        entries.push(Entry { name, method, elasticity, normal, answer });
    }
    match first_errors {
        Some(errors) if entries.iter().all(|entry| entry.answer.is_err()) => Err(errors.into()),
        _ => Ok(entries),
    }
}

fn explained(case: &Case, error: &Error) -> CaseErrors {
    case.explain(error).into()
}

/// A method, with a model of elasticity if it is the full one, and that of the normal contact of
/// two profiles if it is not the case's.
struct Candidate {
    name: &'static str,
    method: &'static str,
    elasticity: Option<ElasticityModel>,
    normal: Option<NormalSolution>,
}

const fn full(name: &'static str, elasticity: ElasticityModel) -> Candidate {
    Candidate { name, method: "full", elasticity: Some(elasticity), normal: None }
}

const fn fast(name: &'static str, method: &'static str) -> Candidate {
    Candidate { name, method, elasticity: None, normal: None }
}

const fn fastsim(name: &'static str, normal: NormalSolution) -> Candidate {
    Candidate { name, method: "fastsim", elasticity: None, normal: Some(normal) }
}

/// All methods, and the model of the case where it is of none of them: next to its like.
fn candidates(case: &Case) -> Vec<Candidate> {
    let is_rigid = case.elasticity == ElasticityModel::Rigid;
    let own = is_rigid.then_some(full("full, rigid bodies", ElasticityModel::Rigid));
    let of_profiles = case.wheel.is_some().then_some(OF_PROFILES);
    own.into_iter().chain(CANDIDATES).chain(of_profiles.into_iter().flatten()).collect()
}

/// Approximate normal contacts of two profiles, each with what is mostly used on it.
const OF_PROFILES: [Candidate; 4] = [
    fastsim("FASTSIM, Kik–Piotrowski", NormalSolution::KikPiotrowski),
    fastsim("FASTSIM, corrected ellipse", NormalSolution::EllipseCorrected),
    fastsim("FASTSIM, equivalent ellipse", NormalSolution::EquivalentEllipse),
    fastsim("FASTSIM, ANALYN", NormalSolution::Analyn),
];

/// The methods that every case is solved by.
const CANDIDATES: [Candidate; 9] = [
    full("full, half-space", ElasticityModel::HalfSpace),
    full("full, elastic layer", ElasticityModel::ElasticLayer),
    full("full, Winkler bedding", ElasticityModel::Winkler),
    fast("look-up table", "table"),
    fast("FASTSIM", "fastsim"),
    fast("modified FASTSIM", "modified-fastsim"),
    fast("Polach", "polach"),
    fast("Shen–Hedrick–Elkins", "shen-hedrick-elkins"),
    fast("Kalker linear", "kalker-linear"),
];

impl Candidate {
    /// The case that asks for it, from one that asks for the full method, with a bound of FASTSIM.
    fn case(&self, full: &Case, bound: Option<&str>, watch: Watch) -> Result<Case, CaseErrors> {
        if let Some(model) = self.elasticity {
            let is_own = full.elasticity == model;
            return if is_own { Ok(full.clone()) } else { with_elasticity(full, model, watch) };
        }
        let method = format!("solver.method={}", self.method);
        let normal = self.normal.map(|normal| format!("normal.method={}", normal.name()));
        let bound = bound.filter(|_| self.method.ends_with("fastsim")).map(str::to_owned);
        let assignments: Vec<String> = [method].into_iter().chain(normal).chain(bound).collect();
        full.with(COMPARE, &assignments, watch)
    }
}

/// What bounds the traction of FASTSIM by the pressure itself, if nothing bounds it in the case: a
/// pressure that is not Hertz's has no paraboloid.
fn bound(of: &CaseFile, full: &Case) -> Result<Option<String>, CaseErrors> {
    // Pressures of two profiles are found by the solution.
    let is_elliptic = full.wheel.is_none() && {
        let normal = full.problem.normal.normal_contact(None);
        let normal = normal.map_err(|error| explained(full, &error))?;
        matches!(normal.pressure, Pressure::Elliptic)
    };
    let is_open = !is_elliptic && of.given().all(|path| path != BOUND);
    Ok(is_open.then(|| format!("{BOUND}=elliptic")))
}

/// The case with another model of elasticity, without the stiffnesses of its own: the layer with
/// its default ones, which answer like the half-space, the Winkler bedding with those of FASTSIM, c
/// = 1/L.
fn with_elasticity(case: &Case, model: ElasticityModel, watch: Watch) -> Result<Case, CaseErrors> {
    let without = STIFFNESSES.iter().chain(&[MARGIN]).map(|field| format!("{field}="));
    let assignments: Vec<String> =
        [format!("elasticity.model={}", model.name())].into_iter().chain(without).collect();
    case.with(COMPARE, &assignments, watch)
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
        Ok(Answer { solution: self.solution, time, time_again })
    }

    /// Time of a solution from the set-up on, in s. The normal contact, which is the same for all,
    /// is known.
    fn time(&self, watch: Watch) -> Result<f64, Error> {
        let start = Instant::now();
        self.case.solver().solve(&self.case.problem, watch)?;
        Ok(start.elapsed().as_secs_f64())
    }

    /// Time with the set-up there, in s: of a solution without earlier ones, or, by a fast method,
    /// of the forces.
    fn time_again(&mut self, watch: Watch) -> Result<f64, Error> {
        let Case { problem, options, method, .. } = &self.case;
        match method {
            Method::Fast(method) if problem.prescribed.is_none() => {
                forces_again(FastContact::new(problem, method.clone(), options)?, problem)
            }
            _ => {
                self.solver.forget();
                let start = Instant::now();
                self.solver.solve(problem, watch)?;
                Ok(start.elapsed().as_secs_f64())
            }
        }
    }
}

/// Warnings of all methods.
fn warnings(entries: &[Entry]) -> Vec<Message> {
    let of = |entry: &Entry| match &entry.answer {
        Err(reason) => vec![Notice::NotAvailable { reason: reason.clone() }.into()],
        Ok(answer) => messages(&answer.solution.warnings).collect(),
    };
    entries.iter().flat_map(|entry| of(entry).into_iter().map(|m| m.about(entry.name))).collect()
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
