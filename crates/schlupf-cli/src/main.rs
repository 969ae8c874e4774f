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

use arguments::{Arguments, Command};

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let result = match arguments.command {
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
    };
    result.unwrap_or_else(|failure| {
        report::print(&failure);
        ExitCode::from(failure.exit_code())
    })
}
