//! Arguments that several commands share.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, ValueHint};
use schlupf_case::Preset;
use schlupf_tasks::output::figures::FORMATS;

/// Which case.
#[derive(Debug, Clone, Args)]
pub struct CaseArguments {
    /// Case file (TOML), `-` for standard input; by default a steel wheel braking on a steel rail
    #[arg(value_hint = ValueHint::FilePath)]
    pub case: Option<PathBuf>,
    /// Override a field, such as normal.load="60 kN"; an empty value removes the field
    #[arg(long = "set", value_name = "SECTION.FIELD=VALUE")]
    pub overrides: Vec<String>,
}

/// The case that `schlupf check` reads.
#[derive(Debug, Args)]
pub struct CheckArguments {
    #[command(flatten)]
    pub case: CaseArguments,
    /// Draw the profiles of wheel and rail in place into a directory
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath,
        help = drawn("the profiles of wheel and rail in place"))]
    pub figures: Option<PathBuf>,
}

fn drawn(what: &str) -> String {
    format!("Draw {what} ({FORMATS}) into a directory, created if missing")
}

/// What stands for standard input or output.
pub const STANDARD_STREAM: &str = "-";

/// Where to write the results.
#[derive(Debug, Args)]
pub struct OutputArguments {
    /// Write the results as JSON; `-` is standard output, in place of the summary
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub json: Option<PathBuf>,
    /// Write the table of the results as CSV, one row for each cell, point or method
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub csv: Option<PathBuf>,
    /// Draw the figures into a directory
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath, help = drawn("the figures"))]
    pub figures: Option<PathBuf>,
    /// Print no summary
    #[arg(short, long)]
    pub quiet: bool,
}

impl OutputArguments {
    /// The file of the JSON, if it goes into one.
    pub fn json_file(&self) -> Option<&Path> {
        self.json.as_deref().filter(|path| *path != Path::new(STANDARD_STREAM))
    }

    /// Whether the JSON goes to standard output.
    pub fn prints_json(&self) -> bool {
        self.json.is_some() && self.json_file().is_none()
    }
}

/// Where to write a case file.
#[derive(Debug, Args)]
pub struct InitArguments {
    /// File to write; `-` is standard output
    #[arg(default_value = "case.toml", value_hint = ValueHint::FilePath)]
    pub file: PathBuf,
    /// Condition of the rail, for a first guess of friction; its source is in the file
    #[arg(long, value_name = "NAME", value_parser = conditions())]
    pub condition: Option<String>,
    /// Overwrite an existing file
    #[arg(long)]
    pub force: bool,
}

/// The conditions of a rail by name.
fn conditions() -> PossibleValuesParser {
    let value = |preset: &'static Preset| PossibleValue::new(&*preset.name).help(&*preset.doc);
    PossibleValuesParser::new(schlupf_case::conditions().map(value))
}
