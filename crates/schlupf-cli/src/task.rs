//! The commands of tasks: their options are the fields of requests.

use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches, ValueHint, value_parser};
use schlupf::Status;
use schlupf_case::{CaseFile, InputFile};
use schlupf_tasks::output::Report;
use schlupf_tasks::output::report::OwnFile;
use schlupf_tasks::request::{Field, Form, Need};
use schlupf_tasks::task::{CaseArgument, Found, Scratch};
use schlupf_tasks::{Asked, Entry, Face, Given, Value, Wanted};

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::{Failure, NOT_CONVERGED, SUCCESS};
use crate::figures::{Figures, MANIFEST, figure_files};
use crate::outputs::{self, Directory, Input, Output};
use crate::progress::Progress;
use crate::read_case::read_case;
use crate::{interrupt, report, stdout};

const SET: &str = "--set";
const CASE: &str = "case";
const OVERRIDES: &str = "set";

/// The command of a task.
pub fn command(task: &Entry) -> Command {
    let (named, positional): (Vec<Field>, Vec<Field>) =
        (task.fields)().into_iter().partition(|field| !field.is_positional);
    let command = Command::new(task.name);
    let command = command.args(positional.iter().map(argument)).args(case(task.case));
    let command = command.args(named.iter().map(argument));
    let command = command.args((task.own_files)().iter().map(own_file));
    // Arguments that are added bring the comment of their type along.
    OutputArguments::augment_args(command).about(task.about)
}

/// The arguments of the case.
fn case(how: CaseArgument) -> [Arg; 2] {
    let case = Arg::new(CASE).value_parser(value_parser!(PathBuf)).value_hint(ValueHint::FilePath);
    let case = match how {
        CaseArgument::Positional => case.value_name("CASE").help(
            "Case file (TOML), `-` for standard input; by default a steel wheel braking on a steel \
             rail",
        ),
        CaseArgument::Option => case
            .long(CASE)
            .value_name("CASE")
            .help("Case file of the bodies [default: steel wheel and rail]"),
    };
    let set = Arg::new(OVERRIDES)
        .long(OVERRIDES)
        .value_name("SECTION.FIELD=VALUE")
        .action(ArgAction::Append)
        .help("Override a field, such as normal.load=\"60 kN\"; an empty value removes the field");
    [case, set]
}

/// The argument of a field.
fn argument(field: &Field) -> Arg {
    let help = field.doc.strip_suffix('.').unwrap_or(field.doc);
    let is_needed = field.need == Need::Once && field.default.is_none();
    let argument = Arg::new(field.name).help(help).value_name(field.form.placeholder());
    let argument = if field.is_positional { argument } else { argument.long(field.long()) };
    let argument = match &field.default {
        Some(default) => argument.default_value(default.clone()),
        None => argument,
    };
    match field.form {
        Form::Flag => argument.action(ArgAction::SetTrue),
        Form::File => {
            let argument = argument.value_parser(value_parser!(PathBuf));
            argument.value_hint(ValueHint::FilePath).required(is_needed).action(action(field))
        }
        Form::Choice(choices) => {
            let names = choices.iter().map(|(name, _)| *name);
            argument.value_parser(PossibleValuesParser::new(names)).required(is_needed)
        }
        _ => argument.allow_hyphen_values(true).required(is_needed).action(action(field)),
    }
}

fn action(field: &Field) -> ArgAction {
    if field.need == Need::Several { ArgAction::Append } else { ArgAction::Set }
}

/// The argument of a file that the task writes.
fn own_file(file: &OwnFile) -> Arg {
    let argument = Arg::new(file.option).long(file.option).value_name("FILE").help(file.doc);
    argument.value_parser(value_parser!(PathBuf)).value_hint(ValueHint::FilePath)
}

/// What was asked for.
fn asked(task: &Entry, matches: &ArgMatches) -> Asked {
    let fields = (task.fields)();
    let mut asked = Asked::new(Face::Command, fields.clone());
    for field in &fields {
        if matches.value_source(field.name) != Some(clap::parser::ValueSource::CommandLine) {
            continue;
        }
        match field.form {
            Form::Flag => asked.give(field.name, Value::Flag(true)),
            Form::File => {
                for path in matches.get_many::<PathBuf>(field.name).into_iter().flatten() {
                    asked.give(field.name, Value::File(InputFile::at(path)));
                }
            }
            _ => {
                for text in matches.get_many::<String>(field.name).into_iter().flatten() {
                    asked.give(field.name, Value::Text(text.clone()));
                }
            }
        }
    }
    asked
}

/// A task with all that the command line says of it.
struct Job<'a> {
    task: &'a Entry,
    case: CaseArguments,
    asked: Asked,
    outputs: OutputArguments,
    own_files: Vec<(&'static OwnFile, PathBuf)>,
}

/// Runs the command of a task.
pub fn run(task: &Entry, matches: &ArgMatches) -> Result<u8, Failure> {
    let outputs = OutputArguments::from_arg_matches(matches);
    let outputs = outputs.map_err(|error| Failure::Arguments(error.to_string()))?;
    let own =
        |file: &'static OwnFile| Some((file, matches.get_one::<PathBuf>(file.option)?.clone()));
    let overrides = matches.get_many::<String>(OVERRIDES).into_iter().flatten().cloned().collect();
    let job = Job {
        task,
        case: CaseArguments { case: matches.get_one::<PathBuf>(CASE).cloned(), overrides },
        asked: asked(task, matches),
        outputs,
        own_files: (task.own_files)().iter().filter_map(own).collect(),
    };
    job.run()
}

impl Job<'_> {
    fn run(&self) -> Result<u8, Failure> {
        let progress = Progress::start();
        let (files, directory) = (self.files(), self.directory());
        outputs::check(&files, directory.as_ref())?;
        let case = read_case(&self.case)?;
        outputs::refuse_inputs(&files, directory.as_ref(), &self.inputs(&case))?;
        self.refuse_foreign(&case)?;
        let reserved = outputs::reserve(&files, directory.as_ref())?;
        // Contact of profiles and of a rough surface may take a while.
        progress.stage("posing the problem");
        let given = Given {
            case: &case,
            is_default: self.case.case.is_none(),
            overrides: (SET, &self.case.overrides),
            scratch: &|| Ok(Box::new(interrupt::scratch()?) as Scratch),
        };
        let found = (self.task.run)(&given, &self.asked, &self.wanted(), &progress.watch())?;
        let Found { report, failure } = found;
        // A file of an earlier run would look current beside results that cannot be written.
        if failure.is_none() {
            self.write(&*report, &progress)?;
        }
        drop(reserved);
        drop(progress);
        // Warnings are printed even where the results cannot be.
        let printed = self.print(&*report);
        report::warn_all(report.warnings(), report.status());
        printed?;
        match (failure, report.status()) {
            (Some(errors), _) => Err(errors.into()),
            (None, Status::Converged) => Ok(SUCCESS),
            (None, Status::NotConverged) => Ok(NOT_CONVERGED),
        }
    }

    fn wanted(&self) -> Wanted {
        let files = self.own_files.iter().map(|(file, path)| (file.format, path.clone()));
        Wanted {
            figures: self.outputs.figures.is_some(),
            table: self.outputs.csv.is_some(),
            files: files.collect(),
        }
    }

    /// The files that are to be written, besides figures.
    fn files(&self) -> Vec<Output> {
        let outputs = &self.outputs;
        let common = [("--json", outputs.json_file()), ("--csv", outputs.csv.as_deref())];
        let common =
            common.into_iter().filter_map(|(option, path)| Some((option.to_owned(), path?)));
        let own = self.own_files.iter();
        let own = own.map(|(file, path)| (format!("--{}", file.option), path.as_path()));
        let output = |(option, path): (String, &Path)| Output { option, path: path.to_owned() };
        common.chain(own).map(output).collect()
    }

    /// The directory of the figures.
    fn directory(&self) -> Option<Directory<'_>> {
        self.outputs.figures.as_deref().map(|path| Directory {
            option: "--figures",
            path,
            names: self.figure_files().into_iter().chain([MANIFEST.to_owned()]).collect(),
        })
    }

    /// Names of the files of all figures that the task may draw.
    fn figure_files(&self) -> Vec<String> {
        (self.task.all_figures)().iter().flat_map(|name| figure_files(name)).collect()
    }

    /// The files that are read.
    fn inputs(&self, case: &CaseFile) -> Vec<Input> {
        let replacing = |name: &str| {
            let mut own = (self.task.own_files)().iter();
            own.find(|file| file.replaces == Some(name)).map(|file| format!("--{}", file.option))
        };
        let files = self.asked.files(case).into_iter().map(|(name, path)| Input {
            what: self.asked.name(name),
            path,
            // A state may be carried on in place.
            except: replacing(name),
        });
        Input::of_case(&self.case, case).into_iter().chain(files).collect()
    }

    /// Refuses to write figures over files that are not ours.
    fn refuse_foreign(&self, case: &CaseFile) -> Result<(), Failure> {
        let Some(directory) = &self.outputs.figures else { return Ok(()) };
        let known = Figures::of(directory)?;
        let names = (self.task.figure_names)(case, &self.asked);
        let mut files = names.iter().flat_map(|name| figure_files(name));
        files.try_for_each(|name| known.refuse_foreign(&name))
    }

    /// Makes all files in memory, and all figures, before it writes any: what cannot be made is
    /// known before.
    fn write(&self, report: &dyn Report, progress: &Progress) -> Result<(), Failure> {
        let mut files = Vec::new();
        if let Some(path) = self.outputs.json_file() {
            files.push((path.to_owned(), report.json().into_bytes()));
        }
        if let Some((path, table)) = self.outputs.csv.as_ref().zip(report.csv()) {
            files.push((path.clone(), table.into_bytes()));
        }
        for (own, path) in &self.own_files {
            let Some(bytes) = report.own_file(own.format) else { return Err(missing(own, path)) };
            files.push((path.clone(), bytes));
        }
        let mut stale = Vec::new();
        if let Some(directory) = &self.outputs.figures {
            progress.stage("drawing figures");
            let mut drawn = Vec::new();
            for figure in report.figures()? {
                let [svg, png] = figure_files(&figure.name).map(|name| directory.join(name));
                drawn.push((svg, figure.svg.into_bytes()));
                drawn.push((png, figure.png));
            }
            let figures = Figures::of(directory)?.renewed(&self.figure_files(), drawn);
            files.extend(figures.files);
            stale = figures.stale;
        }
        outputs::write(&files, self.outputs.figures.as_deref())?;
        outputs::remove(&stale);
        Ok(())
    }

    /// Prints the JSON, if it goes to standard output, else the summary, unless none is wanted.
    fn print(&self, report: &dyn Report) -> Result<(), Failure> {
        if self.outputs.prints_json() {
            stdout::write(&report.json())
        } else if self.outputs.quiet {
            Ok(())
        } else {
            stdout::write(&report.summary().to_string())
        }
    }
}

/// The results do not have a file.
fn missing(OwnFile { option, format, .. }: &OwnFile, path: &Path) -> Failure {
    let cause = format!("--{option}: the results have no {format}; nothing was written");
    Failure::file(path, std::io::Error::other(cause))
}
