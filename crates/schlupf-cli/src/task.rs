//! The commands of tasks: their options are the fields of requests.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::parser::ValueSource;
use clap::{
    Arg, ArgAction, ArgGroup, ArgMatches, Args, Command, FromArgMatches, ValueHint, value_parser,
};
use schlupf::Status;
use schlupf_case::fields::Choice;
use schlupf_case::{CaseFile, InputFile};
use schlupf_tasks::output::Report;
use schlupf_tasks::output::report::OwnFile;
use schlupf_tasks::request::{Field, Form, Need, Rule};
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

/// The command of a task. What holds between its fields is in its usage, too.
pub fn command(task: &Entry) -> Command {
    let (named, positional): (Vec<Field>, Vec<Field>) =
        (task.fields)().into_iter().partition(|field| !field.is_positional);
    let command = Command::new(task.name);
    let command = command.args(positional.iter().map(argument)).args(case(task.case));
    let command = command.args(named.iter().map(argument));
    let command = task.rules.iter().fold(command, with_rule);
    let command = command.args((task.own_files)().iter().map(own_file));
    // Arguments that are added bring the comment of their type along.
    OutputArguments::augment_args(command).about(task.about)
}

/// The command with a rule between its arguments.
fn with_rule(command: Command, rule: &Rule) -> Command {
    match *rule {
        Rule::AnyOf(names) => {
            let group = ArgGroup::new(format!("<{}>", names.join("|"))).args(names);
            command.group(group.required(true).multiple(true))
        }
        Rule::Apart(ones, others) => ones.iter().fold(command, |command, one| {
            let others = others.iter().filter(|other| *other != one);
            command.mut_arg(one, |argument| argument.conflicts_with_all(others))
        }),
        Rule::With(ones, others) => {
            let all = format!("<{}>", others.join("|"));
            let command = command.group(ArgGroup::new(all.clone()).args(others).multiple(true));
            ones.iter().fold(command, |command, one| {
                command.mut_arg(one, |argument| argument.requires(all.clone()))
            })
        }
    }
}

/// The arguments of the case.
fn case(how: CaseArgument) -> [Arg; 2] {
    let help = format!("Case file (TOML, `-` for standard input) {}", how.doc());
    let case = Arg::new(CASE).value_name("CASE").help(help);
    let case = case.value_parser(value_parser!(PathBuf)).value_hint(ValueHint::FilePath);
    let case = if let CaseArgument::Option(_) = how { case.long(CASE) } else { case };
    let set = Arg::new(OVERRIDES)
        .long(OVERRIDES)
        .value_name("SECTION.FIELD=VALUE")
        .action(ArgAction::Append)
        .help("Override a field, such as normal.load=\"60 kN\"; an empty value removes the field");
    [case, set]
}

/// How a field of the case is given with its values.
const FAMILY: &str = "written as kinematics.speed=\"10 m/s,20 m/s\" or, at even steps, \
                      kinematics.speed=\"5..50 m/s:10\"";

/// The argument of a field.
fn argument(field: &Field) -> Arg {
    let help = field.doc.strip_suffix('.').unwrap_or(field.doc);
    let is_family = matches!(field.form, Form::Family);
    let help = if is_family { format!("{help}; {FAMILY}") } else { help.to_owned() };
    let argument = Arg::new(field.name).help(help).required(field.is_needed());
    let argument = if field.is_positional {
        argument.value_name(field.name.to_uppercase())
    } else {
        argument.value_name(field.form.placeholder()).long(field.long())
    };
    let argument = match &field.default {
        Some(default) => argument.default_value(default.clone()),
        None => argument,
    };
    if field.form.is_flag() {
        return argument.action(ArgAction::SetTrue);
    }
    let is_several = field.need == Need::Several;
    let argument = argument.action(if is_several { ArgAction::Append } else { ArgAction::Set });
    let choices = field.form.choices();
    if field.form.is_file() {
        argument.value_parser(value_parser!(PathBuf)).value_hint(ValueHint::FilePath)
    } else if choices.is_empty() {
        let argument = argument.allow_hyphen_values(field.form.is_signed());
        argument.allow_negative_numbers(true)
    } else {
        let value = |choice: &Choice| PossibleValue::new(choice.name).help(choice.doc);
        argument.value_parser(PossibleValuesParser::new(choices.iter().map(value)))
    }
}

/// The argument of a file that the task writes.
fn own_file(file: &OwnFile) -> Arg {
    let argument = Arg::new(file.option).long(file.option).value_name("FILE").help(file.doc);
    argument.value_parser(value_parser!(PathBuf)).value_hint(ValueHint::FilePath)
}

/// What was asked for.
fn asked(task: &Entry, matches: &ArgMatches) -> Result<Asked, Failure> {
    Asked::new(Face::Command, (task.fields)(), |field| {
        if matches.value_source(field.name) != Some(ValueSource::CommandLine) {
            return Ok(Vec::new());
        }
        Ok(if field.form.is_flag() {
            vec![Value::Flag(matches.get_flag(field.name))]
        } else if field.form.is_file() {
            let paths = matches.get_many::<PathBuf>(field.name).into_iter().flatten();
            paths.map(|path| Value::File(InputFile::at(path))).collect()
        } else {
            let texts = matches.get_many::<String>(field.name).into_iter().flatten();
            texts.cloned().map(Value::Text).collect()
        })
    })
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
        asked: asked(task, matches)?,
        outputs,
        own_files: (task.own_files)().iter().filter_map(own).collect(),
    };
    job.run()
}

impl Job<'_> {
    fn run(&self) -> Result<u8, Failure> {
        let progress = Progress::start();
        let (files, directory) = (self.files(), self.directory());
        let work = (self.task.read)(&self.asked)?;
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
        let Found { report, failure } = work(&given, &self.wanted(), &progress.watch())?;
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
            what: format!("that of {}", self.asked.name(name)),
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
                let files = figure.files().into_iter();
                drawn.extend(files.map(|(name, bytes)| (directory.join(name), bytes)));
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
