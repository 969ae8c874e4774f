//! `schlupf solve`.

use std::borrow::Cow;
use std::fs::File;
use std::path::{Path, PathBuf};

use clap::{Args, ValueHint};
use schlupf::message::{Message, Words};
use schlupf::state::State;
use schlupf::{Error, Method, Quantity, Solution, Watch};
use schlupf_case::{Case, CaseErrors, CaseFile, FieldNames, LARGEST_FILE, Rolling, read_up_to};
use schlupf_output::Report;
use schlupf_output::figures;
use schlupf_output::solution::SolutionReport;

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::notice::Notice;
use crate::outputs::Input;
use crate::progress::Progress;
use crate::task::{Found, OwnFile, Task};

const INITIAL_STATE: &str = "--initial-state";
const FINAL_STATE: &str = "--final-state";

/// What to solve and where to write it.
#[derive(Debug, Args)]
pub struct Solve {
    /// Which case.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Write the fields as a VTK file
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub vtk: Option<PathBuf>,
    /// Write the history as CSV, one row for each time step
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub history: Option<PathBuf>,
    /// Start from a state written by --final-state
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub initial_state: Option<PathBuf>,
    /// Write the final state, from which another run may start
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub final_state: Option<PathBuf>,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

/// A case with what of it is solved.
pub struct Plan {
    case: Case,
    rolling: Rolling,
}

impl Task for Solve {
    type Plan = Plan;
    type Report = SolutionReport;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn own_files(&self) -> Vec<OwnFile<'_>> {
        let vtk = OwnFile::given("--vtk", SolutionReport::VTK, self.vtk.as_ref());
        let state = OwnFile::given(FINAL_STATE, SolutionReport::STATE, self.final_state.as_ref());
        let history = OwnFile::given("--history", SolutionReport::HISTORY, self.history.as_ref());
        vtk.into_iter().chain(history).chain(state).collect()
    }

    fn plan(&self, file: CaseFile, watch: Watch) -> Result<Plan, Failure> {
        let initial_state = self.initial_state.as_deref().map(read_state).transpose()?;
        let case = file.pose(watch)?;
        self.refuse_state(case.method)?;
        let rolling = case.rolling(initial_state).map_err(CaseErrors::from)?;
        Ok(Plan { case, rolling })
    }

    fn inputs(&self, file: &CaseFile) -> Vec<Input> {
        let mut inputs = Input::of_case(&self.case, file);
        // A state may be carried on in place.
        let state = self.initial_state.iter().map(|path| Input {
            what: INITIAL_STATE.to_owned(),
            path: path.clone(),
            except: Some(FINAL_STATE),
        });
        inputs.extend(state);
        inputs
    }

    fn figure_names(&self, file: &CaseFile) -> Vec<String> {
        let is_marched = self.initial_state.is_some() || file.is_marched();
        let mut names = SolutionReport::figure_names();
        names.retain(|name| is_marched || name != figures::HISTORY);
        names
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<SolutionReport>, Failure> {
        let Plan { case, rolling } = plan;
        let report = schlupf_tasks::solve::solve(&case, rolling, &progress.watch());
        let mut report = report.map_err(|error| self.explain(&case, &error))?;
        report.warnings.extend(self.empty(&report.solution));
        Ok(report.into())
    }
}

impl Solve {
    /// Which of the outputs that were asked for have nothing in them.
    fn empty(&self, solution: &Solution) -> Vec<Message> {
        if solution.method.has_fields() {
            return Vec::new();
        }
        let given = [
            ("--csv", "no rows", &self.outputs.csv),
            ("--vtk", "no cells", &self.vtk),
            ("--figures", "nothing to draw", &self.outputs.figures),
        ];
        let given = given.into_iter().filter(|(_, _, path)| path.is_some());
        let method = solution.method.name();
        given.map(|(option, what, _)| Notice::EmptyOutput { option, what, method }.into()).collect()
    }

    /// Only the full method has a state.
    fn refuse_state(&self, method: Method) -> Result<(), Failure> {
        let given = [(INITIAL_STATE, &self.initial_state), (FINAL_STATE, &self.final_state)];
        match given.into_iter().find(|(_, path)| path.is_some()) {
            Some((option, _)) if method != Method::Full => Err(Failure::Arguments(format!(
                "{option} goes with solver.method = \"full\" only, but that is {:?}, which has no state",
                method.name()
            ))),
            _ => Ok(()),
        }
    }

    fn explain(&self, case: &Case, error: &Error) -> Failure {
        match &self.initial_state {
            // This one is no field of the case file.
            Some(path) if error.quantity() == Quantity::InitialState => {
                Failure::Arguments(error.text(&StateFile(path)))
            }
            _ => Failure::Case(case.explain(error).into()),
        }
    }
}

/// What the file of a state is called in messages.
struct StateFile<'a>(&'a Path);

impl Words for StateFile<'_> {
    fn word(&self, quantity: Quantity) -> Cow<'static, str> {
        match quantity {
            Quantity::InitialState => format!("{INITIAL_STATE} {}", self.0.display()).into(),
            other => FieldNames::CASE.word(other),
        }
    }
}

fn read_state(path: &Path) -> Result<State, Failure> {
    let bytes = File::open(path).and_then(|file| read_up_to(LARGEST_FILE, file));
    let bytes = bytes.map_err(|cause| Failure::file(path, cause))?;
    serde_json::from_slice(&bytes).map_err(|error| {
        let path = path.display();
        Failure::Arguments(format!(
            "--initial-state must be a file of --final-state, but {path} is not: {error}"
        ))
    })
}
