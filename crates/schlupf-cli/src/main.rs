//! The command `schlupf`.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

use std::process::ExitCode;

fn main() -> ExitCode {
    schlupf_cli::main(std::env::args_os()).into()
}
