//! The command line: the commands of tasks, and all others with their arguments.

use clap::{Arg, Command, Subcommand};
use clap_complete::Shell;

use crate::arguments::{CheckArguments, InitArguments};
use crate::explore::Explore;
use crate::failure::{Failure, SUCCESS};
use crate::fmu::Fmu;
use crate::import::ImportArguments;
use crate::sweep::{Merge, Sweep};
use crate::table::Table;
use crate::{stdout, task};

const EXIT_CODES: &str = "\
Exit codes:
  0  converged
  1  I/O error
  2  bad input
  3  not converged; results are written and marked, unless the normal contact was not found
130  interrupted; standard error reports whether the files were written";

/// The name of the option of threads.
pub const THREADS: &str = "threads";

/// The command with all others below it.
pub fn command() -> Command {
    let threads = Arg::new(THREADS)
        .long(THREADS)
        .global(true)
        .value_name("N")
        .value_parser(number_of_threads)
        .help("Number of threads for independent solutions [default: all cores]");
    let command = Command::new("schlupf")
        .version(env!("CARGO_PKG_VERSION"))
        .subcommand_required(true)
        .arg_required_else_help(true)
        .arg(threads)
        .subcommands(schlupf_tasks::TASKS.iter().map(task::command));
    let command = Other::augment_subcommands(command).about(ABOUT).after_help(EXIT_CODES);
    command.mut_subcommands(|command| {
        if PRINTS_ONLY.contains(&command.get_name()) {
            command
        } else {
            command.after_help(EXIT_CODES)
        }
    })
}

const ABOUT: &str =
    "Rolling contact of wheel and rail: forces, stress, slip and temperature in the contact patch";

/// Commands whose exit codes say nothing else than those of any other program.
const PRINTS_ONLY: [&str; 4] = ["check", "init", "schema", "completions"];

/// A number of threads that a machine can have.
fn number_of_threads(text: &str) -> Result<usize, String> {
    const MOST: usize = 1024;
    let count = text.parse().ok().filter(|count| (1..=MOST).contains(count));
    count.ok_or_else(|| format!("must be a whole number between 1 and {MOST}"))
}

/// The commands that are no tasks.
#[derive(Debug, Subcommand)]
pub enum Other {
    /// Solve a study: many states of a case, a row of results each
    Sweep(Sweep),
    /// Put the tables of all shards of a study together
    Merge(Merge),
    /// Make a look-up table of creep forces, or of the contacts of a wheel, for multibody codes
    Table(Table),
    /// Write the force element of a case as an FMU, for simulators
    Fmu(Fmu),
    /// Open the explorer in a browser: sliders, fields, curves, wheel on rail
    Explore(Explore),
    /// Validate a case file and show what would be solved
    Check(CheckArguments),
    /// Write the cases of an input file of CONTACT as case files
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
    clap_complete::generate(shell, &mut command(), "schlupf", &mut script);
    stdout::write(&String::from_utf8_lossy(&script))?;
    Ok(SUCCESS)
}
