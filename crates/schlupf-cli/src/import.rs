//! `schlupf import`.

use std::fmt::Write;
use std::io::{self, ErrorKind};
use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use schlupf_case::CaseErrors;
use schlupf_import::contact::{Import, WheelBody};
use schlupf_tasks::import::{self, Request};

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
    let imported = import::contact(request)?;
    let folder = request.output();
    let mut files = Vec::new();
    for case in &imported.cases {
        files.push((folder.join(&case.name), case.text.clone().into_bytes()));
        files.extend(case.files.iter().map(|(name, bytes)| (folder.join(name), bytes.clone())));
    }
    let names = files.iter().filter_map(|(path, _)| path.file_name());
    let names = names.map(|name| name.to_string_lossy().into_owned()).collect();
    let given = arguments.output.as_deref();
    let directory = given.map(|path| Directory { option: OUTPUT, path, names });
    outputs::check(&[], directory.as_ref())?;
    let what = "the input file".to_owned();
    let input = Input { what, path: arguments.file.clone(), except: None };
    let option = if given.is_some() { OUTPUT } else { FILE };
    let written = files.iter().map(|(path, _)| Output { option, path: path.clone() });
    let written: Vec<Output> = written.filter(|output| output.path.exists()).collect();
    outputs::refuse_inputs(&written, None, &[input])?;
    if let Some((path, _)) = files.iter().find(|(path, _)| path.exists() && !arguments.force) {
        let advice = "there is a file already; --force overwrites it";
        return Err(Failure::file(path, io::Error::new(ErrorKind::AlreadyExists, advice)));
    }
    imported.notices.iter().for_each(report::warn);
    outputs::write(&files, given)?;
    if !arguments.quiet {
        stdout::write(&summary(arguments, &imported))?;
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

fn summary(arguments: &ImportArguments, imported: &Import) -> String {
    let folder = arguments.output.as_deref().or(arguments.file.parent());
    let mut text = String::new();
    for case in &imported.cases {
        let path = folder.map_or(PathBuf::from(&case.name), |folder| folder.join(&case.name));
        // Writing to a string cannot fail.
        let _ = writeln!(text, "wrote {}: {}", path.display(), case.title);
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

/// Ascending numbers, with runs of them as ranges.
fn ranges(numbers: &[usize]) -> String {
    let runs = numbers.chunk_by(|a, b| a + 1 == *b).map(|run| match run {
        [first, .., last] => format!("{first}–{last}"),
        run => run.iter().map(ToString::to_string).collect(),
    });
    runs.collect::<Vec<_>>().join(", ")
}
