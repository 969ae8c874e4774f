//! The command `schlupf`.

#![forbid(unsafe_code)]

use std::process::ExitCode;

fn main() -> ExitCode {
    schlupf_cli::main(std::env::args_os()).into()
}
