//! The solution of a case: steady rolling, or rolling over time.

use crate::output::solution::SolutionReport;
use schlupf::problem::State;
use schlupf::reporting::Message;
use schlupf::solver::march;
use schlupf::wheel_rail::WheelSolution;
use schlupf::{Error, Method, Quantity, Solution, Watch};
use schlupf_case::{Case, CaseError, CaseFile, FieldNames, InputFile, Rolling};

use crate::output::{Report, figures};
use crate::request::{Asked, Kind, request};
use crate::task::{Found, Given, Task, Wanted};
use crate::{Notice, TaskError, contact_law, messages};

request! {
    /// What to start from.
    Request {
        /// Start from a state that an earlier run has written.
        initial_state: Option<InputFile> = Kind::file();
    }
}

/// `solve`: steady rolling, or rolling over time.
pub struct Solve;

const INITIAL_STATE: &str = "initial_state";

impl Task for Solve {
    const NAME: &'static str = "solve";
    const ABOUT: &'static str = "Solve a case";
    type Request = Request;
    type Report = SolutionReport;

    fn run(
        of: &Given,
        request: Request,
        wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<SolutionReport>, TaskError> {
        let state = request.initial_state.as_ref().map(|file| request.state(file)).transpose()?;
        let case = of.case.pose(watch)?;
        request.refuse_state(&case.method, wanted)?;
        let rolling = case.rolling(state)?;
        let report = solve(&case, rolling, watch);
        let mut report = report.map_err(|error| request.explain(&case, &error))?;
        report.warnings.extend(request.empty(&report.solution, wanted));
        Ok(report.into())
    }

    fn figure_names(case: &CaseFile, asked: &Asked) -> Vec<String> {
        let is_marched = asked.has(INITIAL_STATE) || case.is_marched();
        let mut names = SolutionReport::figure_names();
        names.retain(|name| is_marched || name != figures::HISTORY);
        names
    }
}

impl Request {
    /// Which of the outputs that are wanted have nothing in them.
    fn empty(&self, solution: &Solution, wanted: &Wanted) -> Vec<Message> {
        if solution.method.has_fields() {
            return Vec::new();
        }
        let given = [
            ("csv", "no rows are written", wanted.table),
            ("vtk", "no cells are written", wanted.file(SolutionReport::VTK).is_some()),
            ("figures", "nothing is drawn", wanted.figures),
        ];
        let given = given.into_iter().filter(|(.., is_wanted)| *is_wanted);
        let method = solution.method.name();
        let notice = |(output, what, _)| {
            let output = self.asked.output(output);
            Notice::EmptyOutput { output, what, method }.into()
        };
        given.map(notice).collect()
    }

    fn state(&self, file: &InputFile) -> Result<State, CaseError> {
        let refused = |message| self.asked.refuse(INITIAL_STATE, message);
        let bytes = file.read().map_err(|cause| {
            refused(format!("the state cannot be read: {cause}")).of_file(file.path(), &cause)
        })?;
        serde_json::from_slice(&bytes).map_err(|error| {
            let name = self.asked.name(INITIAL_STATE);
            let message = format!("{name} must be a state that a run has written, but: {error}");
            refused(message)
        })
    }

    /// Only the full method has a state.
    fn refuse_state(&self, method: &Method, wanted: &Wanted) -> Result<(), TaskError> {
        let final_state = wanted.file(SolutionReport::STATE).map(|_| "the final state".to_owned());
        let initial = self.initial_state.as_ref().map(|_| self.asked.name(INITIAL_STATE));
        match initial.or(final_state) {
            Some(name) if *method != Method::Full => Err(TaskError::Request(format!(
                "{name} goes with solver.method = \"full\" only, but that is {:?}, which has no state",
                method.name()
            ))),
            _ => Ok(()),
        }
    }

    fn explain(&self, case: &Case, error: &Error) -> CaseError {
        match &self.initial_state {
            // This one is no field of the case file.
            Some(_) if error.quantity() == Quantity::InitialState => {
                self.asked.refuse(INITIAL_STATE, error.text(&FieldNames::CASE))
            }
            _ => case.explain(error),
        }
    }
}

/// What to know about a wheel and about its contacts but the first, whose warnings are those of the
/// solution.
pub(crate) fn of_wheel(wheel: &WheelSolution) -> Vec<Message> {
    let own = wheel.warnings();
    let others = (2..).zip(wheel.contacts.iter().skip(1)).flat_map(|(k, contact)| {
        messages(&contact.solution.warnings)
            .map(move |message| message.about(&format!("contact {k}")))
    });
    messages(&own).chain(others).collect()
}

/// Solves what a case asks for: see [`Case::rolling`].
///
/// ```
/// use schlupf_case::{CaseFile, Folder, Overrides};
/// use schlupf_tasks::solve::solve;
///
/// let text = "kinematics.creepage_x = 0.002\ngrid = { cells_x = 10, cells_y = 10 }";
/// let file = CaseFile::from_str(text, "a case", Folder::new(""), Overrides::NONE)?;
/// let case = file.pose(&schlupf::unwatched)?;
/// let rolling = case.rolling(None)?;
/// let report = solve(&case, rolling, &schlupf::unwatched)?;
/// assert!(report.solution.force.x < 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve(case: &Case, rolling: Rolling, watch: Watch) -> Result<SolutionReport, Error> {
    let solution = match rolling {
        Rolling::Steady => case.steady_state(case.full_solver(), watch)?,
        Rolling::Transient(transient) => march(&transient, &case.options, watch)?,
    };
    Ok(report(case, solution))
}

/// A solution of a case, with all contacts of its wheel if it has one.
pub fn report(case: &Case, solution: Solution) -> SolutionReport {
    let contact_law = (solution.method == Method::Full).then(|| contact_law::of(case));
    let wheel = case.wheel.clone();
    let of_wheel = wheel.iter().flat_map(|wheel| of_wheel(wheel));
    let warnings = case.notices.iter().cloned().chain(messages(&solution.warnings));
    let warnings = warnings.chain(of_wheel).collect();
    SolutionReport { title: case.title.clone(), contact_law, solution, wheel, warnings }
}
