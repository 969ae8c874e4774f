//! The tasks, and what `cargo xtask ci` consists of.

use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use crate::sources;

/// A part of the checks, or what takes too long to be one; a command of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The formatting.
    Fmt,
    /// The lints.
    Clippy,
    /// The tests.
    Test,
    /// The documentation of the crates.
    Doc,
    /// The rules that the sources keep.
    Sources,
    /// The tests that take long.
    Long,
    /// The table of work and times.
    Bench,
}

impl Part {
    /// The parts of the checks, in the order in which they run.
    pub const CI: [Self; 5] = [Self::Fmt, Self::Clippy, Self::Test, Self::Doc, Self::Sources];

    /// What runs only when it is asked for.
    pub const ASIDE: [Self; 2] = [Self::Long, Self::Bench];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fmt => "fmt",
            Self::Clippy => "clippy",
            Self::Test => "test",
            Self::Doc => "doc",
            Self::Sources => "sources",
            Self::Long => "long",
            Self::Bench => "bench",
        }
    }

    /// Its line in the help.
    pub fn about(self) -> &'static str {
        match self {
            Self::Fmt => "is everything formatted? (`cargo fmt --all` formats it)",
            Self::Clippy => "lints of all targets, warnings denied",
            Self::Test => "tests of the workspace",
            Self::Doc => "documentation of the workspace, warnings denied",
            Self::Sources => "the rules of the sources (they are tests of xtask too)",
            Self::Long => "the tests that take long, with optimisation",
            Self::Bench => "prints the table of work and times of docs/performance.md",
        }
    }

    /// The arguments for cargo and the flags of rustdoc; the sources are read here, without cargo.
    fn cargo(self) -> (&'static [&'static str], Option<&'static str>) {
        match self {
            Self::Fmt => (&["fmt", "--all", "--check"], None),
            Self::Clippy => {
                (&["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"], None)
            }
            Self::Test => (&["test", "--workspace"], None),
            Self::Doc => (&["doc", "--workspace", "--no-deps"], Some("-D warnings")),
            Self::Sources => (&[], None),
            Self::Long => (&["test", "--workspace", "--release", "--", "--ignored"], None),
            Self::Bench => (&["bench", "--package", "schlupf", "--bench", "table"], None),
        }
    }

    /// What it runs, as one would type it.
    fn command_line(self) -> String {
        match self.cargo() {
            ([], _) => format!("cargo xtask {}", self.name()),
            (arguments, None) => format!("cargo {}", arguments.join(" ")),
            (arguments, Some(flags)) => {
                format!("RUSTDOCFLAGS=\"{flags}\" cargo {}", arguments.join(" "))
            }
        }
    }

    fn run(self, workspace: &Path) -> Result<(), String> {
        let (arguments, flags) = self.cargo();
        if arguments.is_empty() {
            return sources::report(workspace);
        }
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let mut command = Command::new(cargo);
        command.args(arguments).current_dir(workspace);
        if let Some(flags) = flags {
            command.env("RUSTDOCFLAGS", flags);
        }
        match command.status() {
            Ok(status) if status.success() => Ok(()),
            Ok(status) => Err(status.to_string()),
            Err(error) => Err(format!("cargo does not start: {error}")),
        }
    }
}

/// Runs every part, also after one has failed, so that one run shows all there is to mend. Whether
/// all passed.
pub fn run(parts: &[Part], workspace: &Path) -> bool {
    let results: Vec<_> = parts.iter().map(|&part| timed(part, workspace)).collect();
    if parts.len() > 1 {
        eprintln!("\nsummary");
        for (part, (outcome, time)) in parts.iter().zip(&results) {
            let word = if outcome.is_ok() { "passed" } else { "FAILED" };
            eprintln!("  {:<9}{word} {:8.1} s", part.name(), time.as_secs_f64());
        }
    }
    results.iter().all(|(outcome, _)| outcome.is_ok())
}

fn timed(part: Part, workspace: &Path) -> (Result<(), String>, Duration) {
    eprintln!("\n==> {}: {}", part.name(), part.command_line());
    let start = Instant::now();
    let outcome = part.run(workspace);
    let time = start.elapsed();
    match &outcome {
        Ok(()) => eprintln!("==> {}: passed in {:.1} s", part.name(), time.as_secs_f64()),
        Err(why) => {
            eprintln!("==> {}: FAILED in {:.1} s: {why}", part.name(), time.as_secs_f64());
        }
    }
    (outcome, time)
}
