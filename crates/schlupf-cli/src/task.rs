//! What commands that find something have in common: check the outputs, read the case, plan, find,
//! write, print, warn.

use std::path::{Path, PathBuf};

use schlupf::{Status, Watch};
use schlupf_case::CaseFile;
use schlupf_output::Report;

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::{Failure, NOT_CONVERGED, SUCCESS};
use crate::figures::{Figures, MANIFEST, figure_files};
use crate::outputs::{self, Directory, Input, Output};
use crate::progress::Progress;
use crate::read_case::read_case;
use crate::{report, stdout};

/// A command that finds something and writes it.
pub trait Task: Send + Sync {
    /// What it is going to do, once the case is posed and all that can be refused is.
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

    /// Names of the figures that it may draw of the case.
    fn figure_names(&self, _file: &CaseFile) -> Vec<String> {
        Self::Report::figure_names()
    }

    /// The files that it reads.
    fn inputs(&self, file: &CaseFile) -> Vec<Input> {
        Input::of_case(&self.case(), file)
    }

    /// Poses what it needs of the case, and checks whatever can be checked before the work.
    fn plan(&self, file: CaseFile, watch: Watch) -> Result<Self::Plan, Failure>;

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

    /// The results do not have it.
    fn missing(&self) -> Failure {
        let Self { option, format, path } = self;
        let cause = format!("{option}: the results have no {format}; nothing was written");
        Failure::file(path, std::io::Error::other(cause))
    }
}

/// What a command has found.
pub struct Found<R> {
    /// The results.
    pub report: R,
    /// Why not all that was asked for can be written; the results are printed, but no file is
    /// written: one of an earlier run would look current beside them.
    pub failure: Option<Failure>,
}

impl<R> From<R> for Found<R> {
    fn from(report: R) -> Self {
        Self { report, failure: None }
    }
}

/// Runs a command.
pub fn run<T: Task>(task: &T) -> Result<u8, Failure> {
    let progress = Progress::start();
    let outputs = Outputs::of(task);
    outputs.check()?;
    let file = read_case(&task.case())?;
    outputs.refuse_inputs(&task.inputs(&file))?;
    outputs.refuse_foreign(&task.figure_names(&file))?;
    let reserved = outputs::reserve(&outputs.files, outputs.directory.as_ref())?;
    // Contact of profiles and of a rough surface may take a while.
    progress.stage("posing the problem");
    let plan = task.plan(file, &progress.watch())?;
    let Found { report, failure } = task.find(plan, &progress)?;
    if failure.is_none() {
        let (mut files, drawn) = files(task, &report, &progress)?;
        let directory = task.outputs().figures.as_deref();
        let mut stale = Vec::new();
        if let Some(directory) = directory {
            let figures = Figures::of(directory)?.renewed(&file_names::<T>(), drawn);
            files.extend(figures.files);
            stale = figures.stale;
        }
        outputs::write(&files, directory)?;
        outputs::remove(&stale);
    }
    drop(reserved);
    drop(progress);
    // Warnings are printed even where the results cannot be.
    let printed = print(task.outputs(), &report);
    report::warn_all(report.warnings(), report.status());
    printed?;
    match (failure, report.status()) {
        (Some(failure), _) => Err(failure),
        (None, Status::Converged) => Ok(SUCCESS),
        (None, Status::NotConverged) => Ok(NOT_CONVERGED),
    }
}

/// The JSON, if it goes to standard output, else the summary, unless none is wanted.
fn print(outputs: &OutputArguments, report: &impl Report) -> Result<(), Failure> {
    if outputs.prints_json() {
        stdout::write(&report.json())
    } else if outputs.quiet {
        Ok(())
    } else {
        stdout::write(&report.summary().to_string())
    }
}

/// Names of the files of all figures that a command may draw.
fn file_names<T: Task>() -> Vec<String> {
    T::Report::figure_names().iter().flat_map(|name| figure_files(name)).collect()
}

/// Where a command is going to write.
struct Outputs<'a> {
    files: Vec<Output>,
    directory: Option<Directory<'a>>,
}

impl<'a> Outputs<'a> {
    fn of<T: Task>(task: &'a T) -> Self {
        let outputs = task.outputs();
        let common = [("--json", outputs.json_file()), ("--csv", outputs.csv.as_deref())];
        let common = common.into_iter().filter_map(|(option, path)| Some((option, path?)));
        let own = task.own_files().into_iter().map(|file| (file.option, file.path));
        let output =
            |(option, path): (&'static str, &Path)| Output { option, path: path.to_owned() };
        let directory = outputs.figures.as_deref().map(|path| Directory {
            option: "--figures",
            path,
            names: file_names::<T>().into_iter().chain([MANIFEST.to_owned()]).collect(),
        });
        Self { files: common.chain(own).map(output).collect(), directory }
    }

    /// Checks that do not need the case.
    fn check(&self) -> Result<(), Failure> {
        outputs::check(&self.files, self.directory.as_ref())
    }

    /// Refuses to write figures over files that are not ours.
    fn refuse_foreign(&self, figures: &[String]) -> Result<(), Failure> {
        let Some(directory) = &self.directory else { return Ok(()) };
        let known = Figures::of(directory.path)?;
        let mut files = figures.iter().flat_map(|name| figure_files(name));
        files.try_for_each(|name| known.refuse_foreign(&name))
    }

    fn refuse_inputs(&self, inputs: &[Input]) -> Result<(), Failure> {
        outputs::refuse_inputs(&self.files, self.directory.as_ref(), inputs)
    }
}

/// Files with their contents.
type Files = Vec<(PathBuf, Vec<u8>)>;

/// All files in memory, and all figures: what cannot be made is known before the first one is
/// written.
fn files<T: Task>(
    task: &T,
    report: &T::Report,
    progress: &Progress,
) -> Result<(Files, Files), Failure> {
    let outputs = task.outputs();
    let mut files = Vec::new();
    if let Some(path) = outputs.json_file() {
        files.push((path.to_owned(), report.json().into_bytes()));
    }
    if let Some((path, table)) = outputs.csv.as_ref().zip(report.csv()) {
        files.push((path.clone(), table.into_bytes()));
    }
    for own in task.own_files() {
        let Some(bytes) = report.own_file(own.format) else { return Err(own.missing()) };
        files.push((own.path.to_owned(), bytes));
    }
    let mut drawn = Vec::new();
    if let Some(directory) = &outputs.figures {
        progress.stage("drawing figures");
        for figure in report.figures()? {
            let [svg, png] = figure_files(&figure.name).map(|name| directory.join(name));
            drawn.push((svg, figure.svg.into_bytes()));
            drawn.push((png, figure.png));
        }
    }
    Ok((files, drawn))
}
