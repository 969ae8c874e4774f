//! Arguments of the command line.

use std::path::{Path, PathBuf};

use clap::{Args, Parser, Subcommand, ValueHint};
use clap_complete::Shell;

use crate::bulk::Bulk;
use crate::calibrate::Calibrate;
use crate::compare::Compare;
use crate::curve::Curve;
use crate::fit::Fit;
use crate::roughness::Roughness;
use crate::solve::Solve;
use crate::temperature::Temperature;

const EXIT_CODES: &str = "\
Exit codes:
  0  converged
  1  the file system failed
  2  bad input
  3  not converged: the results are written and marked; if the normal contact was not found, there are none
130  interrupted: nothing was written";

/// Rolling contact of wheel and rail: forces, stress, slip and temperature in the contact patch.
#[derive(Debug, Parser)]
#[command(name = "schlupf", version, after_help = EXIT_CODES)]
pub struct Arguments {
    /// Threads for what can be computed at the same time; all cores when left out. Results do not depend on it
    #[arg(long, global = true, value_name = "N", value_parser = number_of_threads)]
    pub threads: Option<usize>,
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Solve a case
    #[command(after_help = EXIT_CODES)]
    Solve(Box<Solve>),
    /// Compute creep curves: forces over creepage
    #[command(after_help = EXIT_CODES)]
    Curve(Box<Curve>),
    /// From rough surfaces to the contact stiffness k_c: statistics, contact area, tangential curves
    #[command(after_help = EXIT_CODES)]
    Roughness(Box<Roughness>),
    /// Compare all methods on a case: forces, temperature, time
    #[command(after_help = EXIT_CODES)]
    Compare(Box<Compare>),
    /// Temperatures of wheel and rail below a point, and along its row with the wake
    #[command(after_help = EXIT_CODES)]
    Temperature(Box<Temperature>),
    /// Long-term bulk temperature of the wheel, from its heat balance, in place of the case's
    #[command(after_help = EXIT_CODES)]
    Bulk(Box<Bulk>),
    /// Stiffnesses of the elastic layer: from the table, calibrated anew, or fitted to displacements
    #[command(after_help = EXIT_CODES)]
    Calibrate(Box<Calibrate>),
    /// Find constants of friction and contact law from measured creep forces
    #[command(after_help = EXIT_CODES)]
    Fit(Box<Fit>),
    /// Check a case file and say what it would solve
    Check(CaseArguments),
    /// Write a commented case file to start from
    Init(InitArguments),
    /// Print the JSON schema of a case file
    Schema,
    /// Print a completion script for a shell
    Completions {
        /// The shell
        shell: Shell,
    },
}

/// Which case.
#[derive(Debug, Clone, Args)]
pub struct CaseArguments {
    /// Case file (TOML); a steel wheel braking on a steel rail when none is named
    #[arg(value_hint = ValueHint::FilePath)]
    pub case: Option<PathBuf>,
    /// Set a field in place of the file, such as normal.load="60 kN"; an empty value takes it out
    #[arg(long = "set", value_name = "SECTION.FIELD=VALUE")]
    pub overrides: Vec<String>,
}

/// What stands for standard output.
const STANDARD_OUTPUT: &str = "-";

/// Where to write the results.
#[derive(Debug, Args)]
pub struct OutputArguments {
    /// Write the results as JSON; `-` is standard output, then without the summary
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub json: Option<PathBuf>,
    /// Write the table of the results as CSV, one row for each cell, point or method
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub csv: Option<PathBuf>,
    /// Draw the figures (PNG and SVG) into a directory, created if missing
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub figures: Option<PathBuf>,
    /// Print no summary
    #[arg(short, long)]
    pub quiet: bool,
}

impl OutputArguments {
    /// The file of the JSON, if it goes into one.
    pub fn json_file(&self) -> Option<&Path> {
        self.json.as_deref().filter(|path| *path != Path::new(STANDARD_OUTPUT))
    }

    /// Whether the JSON goes to standard output.
    pub fn prints_json(&self) -> bool {
        self.json.is_some() && self.json_file().is_none()
    }
}

/// Where to write a case file.
#[derive(Debug, Args)]
pub struct InitArguments {
    /// Where to; `-` is standard output
    #[arg(default_value = "case.toml", value_hint = ValueHint::FilePath)]
    pub file: PathBuf,
    /// Overwrite the file if there is one
    #[arg(long)]
    pub force: bool,
}

/// A number of threads that a machine can have.
fn number_of_threads(text: &str) -> Result<usize, String> {
    const MOST: usize = 1024;
    let count = text.parse().ok().filter(|count| (1..=MOST).contains(count));
    count.ok_or_else(|| format!("must be a whole number between 1 and {MOST}"))
}
