//! `schlupf import`.

use std::fmt::Write;
use std::io::{self, ErrorKind};
use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use schlupf_case::CaseErrors;
use schlupf_case::import::contact::{self, Grouped, Import, WheelBody, ranges};
use schlupf_case::import::{self, Request};

use crate::failure::{Failure, SUCCESS};
use crate::outputs::{self, Directory, Input, Output};
use crate::{report, stdout};

const OUTPUT: &str = "--output";
const FILE: &str = "FILE";

/// Which input file, and where to write its cases.
#[derive(Debug, Args)]
pub struct ImportArguments {
    /// Input file of CONTACT, module 1 or 3 (.inp)
    #[arg(value_hint = ValueHint::FilePath)]
    pub file: PathBuf,
    /// Directory of the case files, created if missing [default: that of the input file]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub output: Option<PathBuf>,
    /// Which body of module 3 is the wheel: signs follow from it
    #[arg(long, value_name = "BODY", value_enum, default_value_t = Body::First)]
    pub wheel_body: Body,
    /// Write cases that differ in numbers only as one study: the first of them, a table of what
    /// differs, and NAME_study.toml for `schlupf sweep`
    #[arg(long)]
    pub study: bool,
    /// Overwrite existing files
    #[arg(long)]
    pub force: bool,
    /// Print no summary
    #[arg(short, long)]
    pub quiet: bool,
}

/// A body of module 3.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Body {
    /// Body 1, towards which z points.
    #[value(name = "1")]
    First,
    /// Body 2.
    #[value(name = "2")]
    Second,
}

/// Writes the cases of an input file that are available, and tells what is not.
pub fn import(arguments: &ImportArguments) -> Result<u8, Failure> {
    let wheel = match arguments.wheel_body {
        Body::First => WheelBody::First,
        Body::Second => WheelBody::Second,
    };
    let request = Request { path: &arguments.file, folder: arguments.output.as_deref(), wheel };
    let mut imported = import::contact_file(request)?;
    let folder = request.output();
    let cases = std::mem::take(&mut imported.cases);
    let written = if arguments.study {
        contact::grouped(cases)
    } else {
        Grouped { cases, studies: Vec::new() }
    };
    let mut files = Vec::new();
    for case in written.cases.iter().chain(written.studies.iter().map(|study| &study.case)) {
        files.push((folder.join(&case.name), case.text.clone().into_bytes()));
        files.extend(case.files.iter().map(|(name, bytes)| (folder.join(name), bytes.clone())));
    }
    for (name, text) in written.studies.iter().flat_map(|study| [&study.study, &study.states]) {
        files.push((folder.join(name), text.clone().into_bytes()));
    }
    let names = files.iter().filter_map(|(path, _)| path.file_name());
    let names = names.map(|name| name.to_string_lossy().into_owned()).collect();
    let given = arguments.output.as_deref();
    let directory = given.map(|path| Directory { option: OUTPUT, path, names });
    outputs::check(&[], directory.as_ref())?;
    let what = "the input file".to_owned();
    let input = Input { what, path: arguments.file.clone(), except: None };
    let option = if given.is_some() { OUTPUT } else { FILE };
    let overwritten =
        files.iter().map(|(path, _)| Output { option: option.to_owned(), path: path.clone() });
    let overwritten: Vec<Output> = overwritten.filter(|output| output.path.exists()).collect();
    outputs::refuse_inputs(&overwritten, None, &[input])?;
    if let Some((path, _)) = files.iter().find(|(path, _)| path.exists() && !arguments.force) {
        let advice = "there is a file already; --force overwrites it";
        return Err(Failure::file(path, io::Error::new(ErrorKind::AlreadyExists, advice)));
    }
    imported.notices.iter().for_each(report::warn);
    outputs::write(&files, given)?;
    if !arguments.quiet {
        stdout::write(&summary(arguments, &imported, &written))?;
    }
    match CaseErrors::check(imported.errors) {
        Ok(()) => Ok(SUCCESS),
        Err(errors) => {
            let failure = Failure::Case(errors);
            report::print(&failure);
            Ok(failure.exit_code())
        }
    }
}

fn summary(arguments: &ImportArguments, imported: &Import, written: &Grouped) -> String {
    let folder = arguments.output.as_deref().or(arguments.file.parent());
    let path = |name: &str| folder.map_or(PathBuf::from(name), |folder| folder.join(name));
    let mut text = String::new();
    for case in &written.cases {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "wrote {}: {}", path(&case.name).display(), case.title);
    }
    for study in &written.studies {
        let path = path(&study.study.0);
        let (cases, numbers) = (study.numbers.len(), ranges(&study.numbers));
        let _ = writeln!(
            text,
            "wrote {}: cases {numbers} as {cases} states of {}",
            path.display(),
            study.case.name
        );
    }
    for (numbers, what) in [
        (&imported.refused, "not available, see the errors"),
        (&imported.skipped, "skipped by the file itself (digit R)"),
    ] {
        if !numbers.is_empty() {
            let cases = if numbers.len() == 1 { "case" } else { "cases" };
            let _ = writeln!(text, "{cases} {}: {what}", ranges(numbers));
        }
    }
    text
}
