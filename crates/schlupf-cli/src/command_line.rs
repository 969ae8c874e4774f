//! The command line: all commands with their arguments.

use clap::{CommandFactory, Parser, Subcommand};
use clap_complete::Shell;

use crate::arguments::{CheckArguments, InitArguments};
use crate::bulk::Bulk;
use crate::calibrate::Calibrate;
use crate::compare::Compare;
use crate::curve::Curve;
use crate::damage::Damage;
use crate::failure::{Failure, SUCCESS};
use crate::fit::Fit;
use crate::import::ImportArguments;
use crate::roughness::Roughness;
use crate::solve::Solve;
use crate::stdout;
use crate::subsurface::Subsurface;
use crate::sweep::{Merge, Sweep};
use crate::table::Table;
use crate::temperature::Temperature;
use crate::wear::Wear;
use crate::wheelset::Wheelset;

const EXIT_CODES: &str = "\
Exit codes:
  0  converged
  1  I/O error
  2  bad input
  3  not converged; results are written and marked, unless the normal contact was not found
130  interrupted; standard error reports whether the files were written";

/// Rolling contact of wheel and rail: forces, stress, slip and temperature in the contact patch.
#[derive(Debug, Parser)]
#[command(name = "schlupf", version, after_help = EXIT_CODES)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Number of threads for independent solutions [default: all cores]
    #[arg(long, global = true, value_name = "N", value_parser = number_of_threads)]
    pub threads: Option<usize>,
}

/// A number of threads that a machine can have.
fn number_of_threads(text: &str) -> Result<usize, String> {
    const MOST: usize = 1024;
    let count = text.parse().ok().filter(|count| (1..=MOST).contains(count));
    count.ok_or_else(|| format!("must be a whole number between 1 and {MOST}"))
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Solve a case
    #[command(after_help = EXIT_CODES)]
    Solve(Box<Solve>),
    /// Compute creep curves: forces against creepage
    #[command(after_help = EXIT_CODES)]
    Curve(Box<Curve>),
    /// Compute k_c from rough surfaces, with statistics, contact area and tangential curves
    #[command(after_help = EXIT_CODES)]
    Roughness(Box<Roughness>),
    /// Solve a case by all methods and compare forces, temperatures and times
    #[command(after_help = EXIT_CODES)]
    Compare(Box<Compare>),
    /// Compute temperatures below a point and along its row, including the wake
    #[command(after_help = EXIT_CODES)]
    Temperature(Box<Temperature>),
    /// Compute the stresses below the surface of wheel or rail
    #[command(after_help = EXIT_CODES)]
    Subsurface(Box<Subsurface>),
    /// Compute wear, fatigue and melting of one passage of the wheel
    #[command(after_help = EXIT_CODES)]
    Wear(Box<Wear>),
    /// Compute the long-term bulk temperature of the wheel from its heat balance
    #[command(after_help = EXIT_CODES)]
    Bulk(Box<Bulk>),
    /// Determine the stiffnesses of the elastic layer: tabulated, recalibrated, or fitted to
    /// displacements
    #[command(after_help = EXIT_CODES)]
    Calibrate(Box<Calibrate>),
    /// Fit constants of friction and contact law to measured creep forces
    #[command(after_help = EXIT_CODES)]
    Fit(Box<Fit>),
    /// Find the contacts of a wheelset over its lateral position, and its equivalent conicity
    #[command(after_help = EXIT_CODES)]
    Wheelset(Box<Wheelset>),
    /// Solve a study: many states of a case, a row of results each
    #[command(after_help = EXIT_CODES)]
    Sweep(Sweep),
    /// Put the tables of all shards of a study together
    #[command(after_help = EXIT_CODES)]
    Merge(Merge),
    /// Compute the damage over a run: energy, fatigue and wear across the profile
    #[command(after_help = EXIT_CODES)]
    Damage(Box<Damage>),
    /// Make a look-up table of creep forces, for multibody codes
    #[command(after_help = EXIT_CODES)]
    Table(Table),
    /// Validate a case file and show what would be solved
    Check(CheckArguments),
    /// Write the cases of an input file of CONTACT as case files
    #[command(after_help = EXIT_CODES)]
    Import(ImportArguments),
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

/// `schlupf completions`: prints a completion script.
pub fn completions(shell: Shell) -> Result<u8, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "schlupf", &mut script);
    stdout::write(&String::from_utf8_lossy(&script))?;
    Ok(SUCCESS)
}
