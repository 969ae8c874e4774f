//! The command `schlupf`, for the binary of that name and for the Python package, which has it too.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod arguments;
mod command_line;
mod commands;
mod explore;
mod failure;
mod import;
mod figures;
mod fmu;
mod interrupt;
mod kept_states;
mod notice;
mod outputs;
mod profiles;
mod progress;
mod read_case;
mod report;
mod stdout;
mod sweep;
mod contact_table;
mod table;
mod task;

use std::ffi::OsString;

use clap::{ArgMatches, FromArgMatches};
use rayon::ThreadPoolBuilder;

use command_line::{Other, THREADS, command, completions};
use failure::Failure;

/// Runs the command with its name and its arguments, and returns its exit code. It ends the process
/// by itself where it is interrupted, or where the arguments are wrong or ask for help.
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    run(&command().get_matches_from(arguments)).unwrap_or_else(|failure| {
        report::print(&failure);
        failure.exit_code()
    })
}

fn run(matches: &ArgMatches) -> Result<u8, Failure> {
    interrupt::listen();
    // Zero is one for each core.
    let threads = matches.get_one::<usize>(THREADS).copied().unwrap_or(0);
    let no_threads = |error| Failure::Arguments(format!("--threads: {error}"));
    ThreadPoolBuilder::new().num_threads(threads).build_global().map_err(no_threads)?;
    if let Some((name, matches)) = matches.subcommand()
        && let Some(task) = schlupf_tasks::find(name)
    {
        return task::run(task, matches);
    }
    let other = Other::from_arg_matches(matches);
    match other.map_err(|error| Failure::Arguments(error.to_string()))? {
        Other::Sweep(arguments) => sweep::sweep(&arguments),
        Other::Merge(arguments) => sweep::merge(&arguments),
        Other::Table(arguments) => table::table(&arguments),
        Other::Fmu(arguments) => fmu::fmu(&arguments),
        Other::Explore(arguments) => explore::explore(&arguments),
        Other::Check(arguments) => commands::check(&arguments),
        Other::Import(arguments) => import::import(&arguments),
        Other::Init(arguments) => commands::init(&arguments),
        Other::Schema => commands::schema(),
        Other::Completions { shell } => completions(shell),
    }
}
