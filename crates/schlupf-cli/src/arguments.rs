//! Arguments of the command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueHint};
use clap_complete::Shell;

const EXIT_CODES: &str = "\
Exit codes:
  0  converged
  1  the file system failed
  2  bad input
  3  not converged: the results are written and marked";

/// Rolling contact of wheel and rail: forces, stress, slip and temperature in the contact patch.
#[derive(Debug, Parser)]
#[command(name = "schlupf", version, after_help = EXIT_CODES)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Solve a case
    #[command(after_help = EXIT_CODES)]
    Solve(Box<SolveArguments>),
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
#[derive(Debug, Args)]
pub struct CaseArguments {
    /// Case file (TOML); a steel wheel braking on a steel rail when none is named
    #[arg(value_hint = ValueHint::FilePath)]
    pub case: Option<PathBuf>,
    /// Set a field in place of the file, such as normal.load="60 kN"; an empty value takes it out
    #[arg(long = "set", value_name = "SECTION.FIELD=VALUE")]
    pub overrides: Vec<String>,
}

/// What to solve and where to write it.
#[derive(Debug, Args)]
pub struct SolveArguments {
    /// Which case.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Write the results as JSON; `-` is standard output, then without the summary
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub json: Option<PathBuf>,
    /// Write the fields as CSV, one row for each cell in contact
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub csv: Option<PathBuf>,
    /// Write the fields for `ParaView` (VTK)
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub vtk: Option<PathBuf>,
    /// Draw all figures (PNG and SVG) into a directory, created if missing
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub figures: Option<PathBuf>,
    /// Start from the state that --final-state has written
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub initial_state: Option<PathBuf>,
    /// Write the state at the end, to go on from
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub final_state: Option<PathBuf>,
    /// Print no summary
    #[arg(short, long)]
    pub quiet: bool,
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
