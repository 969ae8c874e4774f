//! The command `schlupf`.

#![forbid(unsafe_code)]

mod arguments;
mod bulk;
mod calibrate;
mod command_line;
mod commands;
mod compare;
mod curve;
mod failure;
mod fit;
mod interrupt;
mod notice;
mod outputs;
mod progress;
mod report;
mod roughness;
mod solve;
mod stdout;
mod task;
mod temperature;

use std::process::ExitCode;

use clap::Parser;
use rayon::ThreadPoolBuilder;

use command_line::{Arguments, Command, completions};
use failure::Failure;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    run(arguments).unwrap_or_else(|failure| {
        report::print(&failure);
        ExitCode::from(failure.exit_code())
    })
}

fn run(arguments: Arguments) -> Result<ExitCode, Failure> {
    interrupt::listen();
    // Zero is one for each core.
    let threads = ThreadPoolBuilder::new().num_threads(arguments.threads.unwrap_or(0));
    let no_threads = |error| Failure::Arguments(format!("--threads: {error}"));
    threads.build_global().map_err(no_threads)?;
    match arguments.command {
        Command::Solve(arguments) => task::run(&*arguments),
        Command::Curve(arguments) => task::run(&*arguments),
        Command::Temperature(arguments) => task::run(&*arguments),
        Command::Bulk(arguments) => task::run(&*arguments),
        Command::Calibrate(arguments) => task::run(&*arguments),
        Command::Roughness(arguments) => task::run(&*arguments),
        Command::Compare(arguments) => task::run(&*arguments),
        Command::Fit(arguments) => task::run(&*arguments),
        Command::Check(arguments) => commands::check(&arguments),
        Command::Init(arguments) => commands::init(&arguments),
        Command::Schema => commands::schema(),
        Command::Completions { shell } => completions(shell),
    }
}
