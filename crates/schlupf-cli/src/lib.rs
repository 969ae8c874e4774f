//! The command `schlupf`, for the binary of that name and for the Python package, which has it too.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod arguments;
mod bulk;
mod calibrate;
mod command_line;
mod commands;
mod compare;
mod curve;
mod damage;
mod failure;
mod fit;
mod import;
mod figures;
mod interrupt;
mod kept_states;
mod notice;
mod outputs;
mod profiles;
mod progress;
mod read_case;
mod report;
mod roughness;
mod solve;
mod stdout;
mod sweep;
mod table;
mod task;
mod subsurface;
mod temperature;
mod wear;
mod wheelset;

use std::ffi::OsString;

use clap::Parser;
use rayon::ThreadPoolBuilder;

use command_line::{Arguments, Command, completions};
use failure::Failure;

/// Runs the command with its name and its arguments, and returns its exit code. It ends the process
/// by itself where it is interrupted, or where the arguments are wrong or ask for help.
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    run(Arguments::parse_from(arguments)).unwrap_or_else(|failure| {
        report::print(&failure);
        failure.exit_code()
    })
}

fn run(arguments: Arguments) -> Result<u8, Failure> {
    interrupt::listen();
    // Zero is one for each core.
    let threads = ThreadPoolBuilder::new().num_threads(arguments.threads.unwrap_or(0));
    let no_threads = |error| Failure::Arguments(format!("--threads: {error}"));
    threads.build_global().map_err(no_threads)?;
    match arguments.command {
        Command::Solve(arguments) => task::run(&*arguments),
        Command::Curve(arguments) => task::run(&*arguments),
        Command::Subsurface(arguments) => task::run(&*arguments),
        Command::Temperature(arguments) => task::run(&*arguments),
        Command::Wheelset(arguments) => task::run(&*arguments),
        Command::Bulk(arguments) => task::run(&*arguments),
        Command::Calibrate(arguments) => task::run(&*arguments),
        Command::Roughness(arguments) => task::run(&*arguments),
        Command::Compare(arguments) => task::run(&*arguments),
        Command::Fit(arguments) => task::run(&*arguments),
        Command::Sweep(arguments) => sweep::sweep(&arguments),
        Command::Damage(arguments) => task::run(&*arguments),
        Command::Wear(arguments) => task::run(&*arguments),
        Command::Merge(arguments) => sweep::merge(&arguments),
        Command::Table(arguments) => table::table(&arguments),
        Command::Check(arguments) => commands::check(&arguments),
        Command::Import(arguments) => import::import(&arguments),
        Command::Init(arguments) => commands::init(&arguments),
        Command::Schema => commands::schema(),
        Command::Completions { shell } => completions(shell),
    }
}
