//! `schlupf solve`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use schlupf::rolling::marching::march;
use schlupf::state::State;
use schlupf::{Error, Method, Solution, Status};
use schlupf_case::{Case, CaseErrors, Task};
use schlupf_output::contact_law::ContactLaw;
use schlupf_output::{csv, figures, json, summary, vtk};

use crate::arguments::SolveArguments;
use crate::commands::read_case;
use crate::failure::{Failure, NOT_CONVERGED};
use crate::outputs::Input;
use crate::progress::Progress;
use crate::{contact_law, outputs, report};

const FINAL_STATE: &str = "--final-state";

/// Solves a case and writes the results.
pub fn run(arguments: &SolveArguments) -> Result<ExitCode, Failure> {
    let case = read_case(&arguments.case)?;
    check_outputs(arguments, &case)?;
    let initial_state = arguments.initial_state.as_deref().map(read_state).transpose()?;
    refuse_state(arguments, case.method)?;
    let task = case.task(initial_state).map_err(CaseErrors::from)?;
    let progress = Progress::start();
    let solution = match task {
        Task::Steady(mut solver) => solver.solve(&case.problem, &progress.watch()),
        Task::Transient(transient) => march(&transient, &case.options, &progress.watch()),
    };
    let mut solution = solution.map_err(|error| explain(arguments, &case, &error))?;
    solution.warnings.splice(0..0, case.notices.iter().cloned());
    if !has_fields(&solution) {
        warn_of_empty_files(arguments, solution.method);
    }
    let texts = Texts::new(&case, &solution);
    let files = files(arguments, &texts, &progress)?;
    drop(progress);
    outputs::write(&files, arguments.figures.as_deref())?;
    arguments.report.print(|| texts.json(), || texts.summary())?;
    match solution.status {
        Status::Converged => Ok(ExitCode::SUCCESS),
        Status::NotConverged => {
            report::warn(&format!(
                "not converged: the relative residual is {:.1e}",
                solution.residual
            ));
            Ok(ExitCode::from(NOT_CONVERGED))
        }
    }
}

/// Says which of the outputs that were asked for have nothing in them.
fn warn_of_empty_files(arguments: &SolveArguments, method: Method) {
    let given = [
        ("--csv", "no rows", &arguments.csv),
        ("--vtk", "no cells", &arguments.vtk),
        ("--figures", "nothing to draw", &arguments.figures),
    ];
    for (option, what, _) in given.into_iter().filter(|(_, _, path)| path.is_some()) {
        let name = method.name();
        report::warn(&format!("{option} has {what}: solver.method = {name:?} gives no fields"));
    }
}

/// Only the full method has a state.
fn refuse_state(arguments: &SolveArguments, method: Method) -> Result<(), Failure> {
    let given =
        [("--initial-state", &arguments.initial_state), (FINAL_STATE, &arguments.final_state)];
    match given.into_iter().find(|(_, path)| path.is_some()) {
        Some((option, _)) if method != Method::Full => Err(Failure::Arguments(format!(
            "{option} goes with solver.method = \"full\" only, but that is {:?}, which has no state",
            method.name()
        ))),
        _ => Ok(()),
    }
}

fn check_outputs(arguments: &SolveArguments, case: &Case) -> Result<(), Failure> {
    let json = arguments.report.json_file();
    let outputs: Vec<(&str, &Path)> = [
        ("--json", json),
        ("--csv", arguments.csv.as_deref()),
        ("--vtk", arguments.vtk.as_deref()),
        (FINAL_STATE, arguments.final_state.as_deref()),
    ]
    .into_iter()
    .filter_map(|(option, path)| Some((option, path?)))
    .collect();
    let inputs = inputs(arguments, case);
    match &arguments.figures {
        None => outputs::check(&outputs, &inputs),
        Some(directory) => {
            let names: Vec<String> =
                figures::names().iter().flat_map(|name| figure_files(name)).collect();
            outputs::check_with_directory(&outputs, &inputs, ("--figures", directory), &names)
        }
    }
}

/// Whatever is read.
fn inputs(arguments: &SolveArguments, case: &Case) -> Vec<Input> {
    let mut inputs = Input::of_case(&arguments.case, case);
    // A state may be carried on in place.
    let state = arguments.initial_state.iter().map(|path| Input {
        what: "--initial-state".to_owned(),
        path: path.clone(),
        except: Some(FINAL_STATE),
    });
    inputs.extend(state);
    inputs
}

/// Names of the files of a figure: the drawing and the picture.
pub fn figure_files(name: &str) -> [String; 2] {
    [format!("{name}.svg"), format!("{name}.png")]
}

fn read_state(path: &Path) -> Result<State, Failure> {
    let bytes = fs::read(path).map_err(|cause| Failure::file(path, cause))?;
    serde_json::from_slice(&bytes).map_err(|error| {
        let path = path.display();
        Failure::Arguments(format!(
            "--initial-state must be a file of --final-state, but {path} is not: {error}"
        ))
    })
}

fn explain(arguments: &SolveArguments, case: &Case, error: &Error) -> Failure {
    match (error, &arguments.initial_state) {
        // This one is no field of the case file.
        (Error::Contradiction { quantity: "solver.initial_state", reason }, Some(path)) => {
            Failure::Arguments(format!("--initial-state {}: {reason}", path.display()))
        }
        _ => Failure::Case(case.explain(error).into()),
    }
}

/// Whether there is anything in cells to draw.
fn has_fields(solution: &Solution) -> bool {
    solution.method.has_fields()
}

/// A solution with what is said about it.
struct Texts<'a> {
    title: &'a str,
    /// None for a fast method, which has no contact law.
    contact_law: Option<ContactLaw>,
    solution: &'a Solution,
}

impl<'a> Texts<'a> {
    fn new(case: &'a Case, solution: &'a Solution) -> Self {
        let contact_law = (solution.method == Method::Full).then(|| contact_law::of(case));
        Self { title: &case.title, contact_law, solution }
    }

    fn json(&self) -> String {
        match &self.contact_law {
            Some(law) => json::document_with_law(self.title, law, self.solution),
            None => json::document(self.title, self.solution),
        }
    }

    fn summary(&self) -> String {
        match &self.contact_law {
            Some(law) => summary::text_with_law(self.title, law, self.solution),
            None => summary::text(self.title, self.solution),
        }
    }
}

/// All files in memory: what cannot be made is known before the first one is written.
fn files(
    arguments: &SolveArguments,
    texts: &Texts,
    progress: &Progress,
) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
    let (title, solution) = (texts.title, texts.solution);
    let mut files = Vec::new();
    if let Some(path) = arguments.report.json_file() {
        files.push((path.to_owned(), texts.json().into_bytes()));
    }
    if let Some(path) = &arguments.csv {
        files.push((path.clone(), csv::fields(solution).into_bytes()));
    }
    if let Some(path) = &arguments.vtk {
        files.push((path.clone(), vtk::structured_points(title, solution)));
    }
    if let Some(path) = &arguments.final_state {
        let state = serde_json::to_vec(&solution.state)
            .map_err(|error| Failure::file(path, std::io::Error::from(error)))?;
        files.push((path.clone(), state));
    }
    if let Some(directory) = arguments.figures.as_ref().filter(|_| has_fields(solution)) {
        progress.stage("drawing figures");
        for figure in figures::all(title, solution)? {
            let [svg, png] = figure_files(&figure.name).map(|name| directory.join(name));
            files.push((svg, figure.svg.into_bytes()));
            files.push((png, figure.png));
        }
    }
    Ok(files)
}
