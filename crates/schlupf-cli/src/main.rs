//! The command `schlupf`.

#![forbid(unsafe_code)]

mod arguments;
mod bulk;
mod calibrate;
mod command_line;
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
mod task;
mod temperature;

use std::process::ExitCode;

use clap::Parser;

use command_line::{Arguments, Command, completions};

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let result = match arguments.command {
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
    };
    result.unwrap_or_else(|failure| {
        report::print(&failure);
        ExitCode::from(failure.exit_code())
    })
}
