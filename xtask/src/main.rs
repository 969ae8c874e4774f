//! Development tasks: `cargo xtask ci` and its parts, and tasks that take longer.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod c;
mod environment;
mod install_c;
mod parts;
mod python;
mod site;
mod sources;
mod step;
mod web;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use parts::Part;

/// Exit code for a wrong command line; 1 is that of a failed part.
const USAGE_ERROR: u8 = 2;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments.iter().any(|argument| matches!(argument.as_str(), "-h" | "--help" | "help")) {
        println!("{}", help());
        return ExitCode::SUCCESS;
    }
    if let Some(prefix) = prefix(&arguments) {
        let target = workspace().join(parts::target());
        return match install_c::install(&workspace(), &target, prefix, "dist") {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                eprintln!("error: {error}");
                ExitCode::FAILURE
            }
        };
    }
    match requested(&arguments) {
        Ok(requested) => {
            if parts::run(&requested, &workspace()) {
                ExitCode::SUCCESS
            } else {
                ExitCode::FAILURE
            }
        }
        Err(error) => {
            eprintln!("error: {error}\n\n{}", help());
            ExitCode::from(USAGE_ERROR)
        }
    }
}

/// Where a command line asks to install the C library.
fn prefix(arguments: &[String]) -> Option<&Path> {
    match arguments {
        [task, option, prefix] if task == "install-c" && option == "--prefix" => {
            Some(Path::new(prefix))
        }
        _ => None,
    }
}

/// The parts requested by a command line.
fn requested(arguments: &[String]) -> Result<Vec<Part>, String> {
    match arguments {
        [] => Err("no task named".to_owned()),
        [task] if task == "ci" => Ok(Part::CI.to_vec()),
        [task] => match all().find(|part| part.name() == task) {
            Some(part) => Ok(vec![part]),
            None => Err(format!("unknown task `{task}`")),
        },
        [_, rest @ ..] => Err(format!("unexpected argument `{}`", rest.join(" "))),
    }
}

fn all() -> impl Iterator<Item = Part> {
    Part::CI.into_iter().chain(Part::ASIDE)
}

fn help() -> String {
    let line = |name, about| format!("  {name:<11}{about}");
    let mut lines = vec![
        "Development tasks of schlupf\n\nUsage: cargo xtask <TASK>\n\nTasks:".to_owned(),
        line("ci", "fmt to site, in this order; fails if one fails"),
    ];
    lines.extend(all().map(|part| line(part.name(), part.about())));
    lines.push(line("install-c", "--prefix DIR: the C library with headers, pkg-config, CMake"));
    lines.push("\nOptions:\n  -h, --help  print this".to_owned());
    lines.join("\n")
}

/// The root of the workspace. The package directory that cargo sets at run time is right even after
/// the checkout has moved.
fn workspace() -> PathBuf {
    let package = std::env::var_os("CARGO_MANIFEST_DIR")
        .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from);
    package.parent().map_or_else(|| package.clone(), PathBuf::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(line: &str) -> Result<Vec<Part>, String> {
        requested(&line.split_whitespace().map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn ci_is_every_part_in_order() {
        let names: Vec<_> = parse("ci").unwrap().iter().map(|part| part.name()).collect();
        assert_eq!(
            names,
            [
                "fmt", "clippy", "test", "web", "doc", "sources", "examples", "package", "c",
                "python", "site"
            ]
        );
    }

    #[test]
    fn every_part_runs_alone_and_is_in_the_help() {
        for part in all() {
            assert_eq!(parse(part.name()).unwrap(), [part]);
            assert!(help().contains(&format!("  {} ", part.name())));
        }
    }

    #[test]
    fn the_c_library_is_installed_where_it_is_said() {
        let arguments = ["install-c", "--prefix", "a/b"].map(str::to_owned);
        assert_eq!(prefix(&arguments), Some(Path::new("a/b")));
        assert_eq!(prefix(&arguments[..1]), None);
        assert!(help().contains("  install-c  --prefix DIR"));
    }

    #[test]
    fn what_takes_long_is_not_part_of_ci() {
        let ci = parse("ci").unwrap();
        assert!(Part::ASIDE.iter().all(|part| !ci.contains(part)));
    }

    #[test]
    fn wrong_command_lines_are_refused() {
        assert_eq!(parse("").unwrap_err(), "no task named");
        assert_eq!(parse("lint").unwrap_err(), "unknown task `lint`");
        assert_eq!(parse("test --all").unwrap_err(), "unexpected argument `--all`");
    }
}
