//! What commands that find something have in common: read the case, check the outputs, find, write,
//! print, warn.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use schlupf::message::Message;
use schlupf::{Status, Watch};
use schlupf_case::Case;
use schlupf_output::Report;
use schlupf_output::figures::MARK;

use crate::arguments::{CaseArguments, OutputArguments};
use crate::commands::read_case;
use crate::failure::{Failure, NOT_CONVERGED};
use crate::outputs::{self, Directory, Input, Output};
use crate::progress::Progress;
use crate::{report, stdout};

/// A command that finds something and writes it.
pub trait Task: Send + Sync {
    /// What it is going to do, once the case is read and all that can be refused is.
    type Plan;
    /// What it finds.
    type Report: Report;

    /// Which case.
    fn case(&self) -> CaseArguments;

    /// Where to write the results.
    fn outputs(&self) -> &OutputArguments;

    /// Files of its own that it writes.
    fn own_files(&self) -> Vec<OwnFile<'_>> {
        Vec::new()
    }

    /// Checks whatever can be checked before the work.
    fn plan(&self, case: Case, watch: Watch) -> Result<Self::Plan, Failure>;

    /// The files that it reads.
    fn inputs(&self, plan: &Self::Plan) -> Vec<Input>;

    /// Does the work.
    fn find(&self, plan: Self::Plan, progress: &Progress) -> Result<Found<Self::Report>, Failure>;
}

/// A file that only one command writes.
pub struct OwnFile<'a> {
    /// The option that names it.
    pub option: &'static str,
    /// The name of its format in the report.
    pub format: &'static str,
    /// Where it goes.
    pub path: &'a Path,
}

impl<'a> OwnFile<'a> {
    /// A file, where the option was given.
    pub fn given(
        option: &'static str,
        format: &'static str,
        path: Option<&'a PathBuf>,
    ) -> Option<Self> {
        path.map(|path| Self { option, format, path })
    }
}

/// What a command has found.
pub struct Found<R> {
    /// The results.
    pub report: R,
    /// What went wrong besides; the results are written all the same.
    pub failure: Option<Failure>,
}

impl<R> From<R> for Found<R> {
    fn from(report: R) -> Self {
        Self { report, failure: None }
    }
}

/// Runs a command.
pub fn run<T: Task>(task: &T) -> Result<ExitCode, Failure> {
    let progress = Progress::start();
    let plan = task.plan(read_case(&task.case(), &progress)?, &progress.watch())?;
    check_outputs(task, &plan)?;
    let Found { report, failure } = task.find(plan, &progress)?;
    let files = files(task, &report, &progress)?;
    drop(progress);
    let figures = task.outputs().figures.as_deref();
    outputs::write(&files, figures)?;
    if let Some(directory) = figures {
        outputs::remove(&stale::<T>(directory, &files));
    }
    print(task.outputs(), &report)?;
    report::warn_all(report.warnings(), report.status());
    match (failure, report.status()) {
        (Some(failure), _) => Err(failure),
        (None, Status::Converged) => Ok(ExitCode::SUCCESS),
        (None, Status::NotConverged) => Ok(ExitCode::from(NOT_CONVERGED)),
    }
}

/// The JSON, if it goes to standard output, else the summary, unless none is wanted.
fn print(outputs: &OutputArguments, report: &impl Report) -> Result<(), Failure> {
    if outputs.prints_json() {
        stdout::write(&report.json())
    } else if outputs.quiet {
        Ok(())
    } else {
        stdout::write(&report.summary())
    }
}

/// Names of the files of a figure: the drawing and the picture.
fn figure_files(name: &str) -> [String; 2] {
    [format!("{name}.svg"), format!("{name}.png")]
}

fn check_outputs<T: Task>(task: &T, plan: &T::Plan) -> Result<(), Failure> {
    let outputs = task.outputs();
    let common = [("--json", outputs.json_file()), ("--csv", outputs.csv.as_deref())];
    let common = common.into_iter().filter_map(|(option, path)| Some((option, path?)));
    let own = task.own_files().into_iter().map(|file| (file.option, file.path));
    let output = |(option, path): (&'static str, &Path)| Output { option, path: path.to_owned() };
    let files: Vec<Output> = common.chain(own).map(output).collect();
    let names = T::Report::figure_names();
    let directory = outputs.figures.as_deref().map(|path| Directory {
        option: "--figures",
        path,
        names: names.iter().flat_map(|name| figure_files(name)).collect(),
    });
    outputs::check(&files, &task.inputs(plan), directory.as_ref())?;
    let mut figures = outputs.figures.iter().flat_map(|path| names.iter().map(move |n| (path, n)));
    figures.try_for_each(|(path, name)| refuse_foreign(path, name))
}

/// Refuses to write over, or to remove later, a figure that is not ours.
fn refuse_foreign(directory: &Path, name: &str) -> Result<(), Failure> {
    let [drawing, picture] = figure_files(name).map(|file| directory.join(file));
    let is_there = [&drawing, &picture].into_iter().find(|path| path.exists());
    match is_there {
        Some(path) if !is_ours(&drawing) => Err(Failure::Arguments(format!(
            "--figures must name a directory without other files of the names of figures, but {} is not \
             drawn by schlupf",
            path.display()
        ))),
        _ => Ok(()),
    }
}

/// Whether a drawing is one of ours.
fn is_ours(drawing: &Path) -> bool {
    let text = std::fs::read_to_string(drawing).unwrap_or_default();
    text.lines().take(4).any(|line| line.contains(MARK))
}

/// Figures of an earlier run of this command that this one has not drawn.
fn stale<T: Task>(directory: &Path, written: &[(PathBuf, Vec<u8>)]) -> Vec<PathBuf> {
    let names = T::Report::figure_names().into_iter();
    let files = names.map(|name| figure_files(&name).map(|file| directory.join(file)));
    let is_written = |path: &PathBuf| written.iter().any(|(written, _)| written == path);
    let old = files.filter(|[drawing, _]| !is_written(drawing) && is_ours(drawing));
    old.flatten().filter(|path| path.exists()).collect()
}

/// All files in memory: what cannot be made is known before the first one is written.
fn files<T: Task>(
    task: &T,
    report: &T::Report,
    progress: &Progress,
) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
    let outputs = task.outputs();
    let mut files = Vec::new();
    if let Some(path) = outputs.json_file() {
        files.push((path.to_owned(), report.json().into_bytes()));
    }
    if let Some((path, table)) = outputs.csv.as_ref().zip(report.csv()) {
        files.push((path.clone(), table.into_bytes()));
    }
    for own in task.own_files() {
        if let Some(bytes) = report.own_file(own.format) {
            files.push((own.path.to_owned(), bytes));
        }
    }
    if let Some(directory) = &outputs.figures {
        progress.stage("drawing figures");
        for figure in report.figures()? {
            let [svg, png] = figure_files(&figure.name).map(|name| directory.join(name));
            files.push((svg, figure.svg.into_bytes()));
            files.push((png, figure.png));
        }
    }
    Ok(files)
}

/// Warnings of the core in the words of a case file.
pub fn messages<'a>(
    warnings: impl IntoIterator<Item = &'a schlupf::Warning>,
) -> impl Iterator<Item = Message> {
    warnings.into_iter().map(|warning| warning.message(&schlupf_case::FieldNames::CASE))
}
