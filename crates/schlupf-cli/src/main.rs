//! The command `schlupf`.

#![forbid(unsafe_code)]

mod arguments;
mod bulk;
mod calibrate;
mod commands;
mod compare;
mod contact_law;
mod curve;
mod failure;
mod fit;
mod outputs;
mod progress;
mod report;
mod roughness;
mod solve;
mod stdout;
mod temperature;

use std::process::ExitCode;

use clap::Parser;
use rayon::ThreadPoolBuilder;

use arguments::{Arguments, Command};
use failure::Failure;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    run(arguments).unwrap_or_else(|failure| {
        report::print(&failure);
        ExitCode::from(failure.exit_code())
    })
}

fn run(arguments: Arguments) -> Result<ExitCode, Failure> {
    // Zero is one for each core.
    let threads = ThreadPoolBuilder::new().num_threads(arguments.threads.unwrap_or(0));
    let no_threads = |error| Failure::Arguments(format!("--threads: {error}"));
    threads.build_global().map_err(no_threads)?;
    match arguments.command {
        Command::Solve(arguments) => solve::run(&arguments),
        Command::Curve(arguments) => curve::run(&arguments),
        Command::Temperature(arguments) => temperature::run(&arguments),
        Command::Bulk(arguments) => bulk::run(&arguments),
        Command::Calibrate(arguments) => calibrate::run(&arguments),
        Command::Roughness(arguments) => roughness::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Fit(arguments) => fit::run(&arguments),
        Command::Check(arguments) => commands::check(&arguments),
        Command::Init(arguments) => commands::init(&arguments),
        Command::Schema => commands::schema(),
        Command::Completions { shell } => commands::completions(shell),
    }
}
