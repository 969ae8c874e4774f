//! The tasks, and the composition of `cargo xtask ci`.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::step::Step;
use crate::{c, python, site, sources, web};

/// A part of the checks, or a task that takes too long to be one; each is a command.
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
    /// The rules for the sources.
    Sources,
    /// The examples of the library.
    Examples,
    /// The explorer in the browser.
    Web,
    /// The packages as they would be published.
    Package,
    /// The oldest supported Rust.
    Oldest,
    /// The C library, and programs with it.
    C,
    /// The Python package.
    Python,
    /// The documentation site.
    Site,
    /// The tests that take long.
    Long,
    /// The table of work and times.
    Bench,
}

impl Part {
    /// The parts of the checks, in the order in which they run.
    pub const CI: [Self; 11] = [
        Self::Fmt,
        Self::Clippy,
        Self::Test,
        Self::Web,
        Self::Doc,
        Self::Sources,
        Self::Examples,
        Self::Package,
        Self::C,
        Self::Python,
        Self::Site,
    ];

    /// Tasks that run only on request.
    pub const ASIDE: [Self; 3] = [Self::Oldest, Self::Long, Self::Bench];

    /// Name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fmt => "fmt",
            Self::Clippy => "clippy",
            Self::Test => "test",
            Self::Doc => "doc",
            Self::Sources => "sources",
            Self::Examples => "examples",
            Self::Web => "web",
            Self::Package => "package",
            Self::Oldest => "oldest",
            Self::C => "c",
            Self::Python => "python",
            Self::Site => "site",
            Self::Long => "long",
            Self::Bench => "bench",
        }
    }

    /// Line in the help.
    pub fn about(self) -> &'static str {
        match self {
            Self::Fmt => "is everything formatted? (`cargo fmt --all` formats it)",
            Self::Clippy => "lints of all targets, warnings denied",
            Self::Test => "tests of the workspace",
            Self::Doc => "documentation of the workspace, warnings denied",
            Self::Sources => "the rules of the sources (they are tests of xtask too)",
            Self::Examples => "runs the examples of the library",
            Self::Web => "builds the explorer, tests it in Chromium (needs Node.js 20)",
            Self::Package => "makes the packages that would be published",
            Self::Oldest => "checks the workspace with the oldest Rust of Cargo.toml",
            Self::C => "installs the C library, runs programs with it (needs gcc, valgrind, …)",
            Self::Python => "builds, installs and tests the Python package (needs Python 3.10)",
            Self::Site => "builds the documentation site, runs its notebooks (needs Python 3.11)",
            Self::Long => "what takes long: single features, oldest, ignored tests, built packages",
            Self::Bench => "prints the tables of docs/performance.md and docs/studies.md",
        }
    }

    /// The steps of the part, in order; sources, page, C, Python and the site have their own way.
    fn steps(self, workspace: &Path) -> Result<Vec<Step>, String> {
        Ok(match self {
            Self::Fmt => vec![Step::cargo("fmt --all --check")],
            Self::Clippy => vec![
                Step::cargo("clippy --workspace --all-targets -- -D warnings"),
                // Targets that are built only when asked for are not among all.
                Step::cargo(
                    "clippy --workspace --bench table --bench call --bench sweep -- -D warnings",
                ),
            ],
            Self::Test => vec![Step::cargo("test --workspace")],
            Self::Doc => vec![Step::documentation()],
            Self::Sources | Self::Web | Self::C | Self::Python | Self::Site => Vec::new(),
            // The build of the tests includes the examples; building them alone would be another
            // build.
            Self::Examples => {
                let names = sources::examples(workspace)?;
                let folder = workspace.join(target()).join("debug/examples");
                let run = |name: &String| Step::program(folder.join(name));
                let build = Step::cargo("test --workspace --no-run");
                std::iter::once(build).chain(names.iter().map(run)).collect()
            }
            Self::Package => {
                // Building them from their packages takes minutes and is part of the long tests.
                vec![Step::cargo("publish --workspace --dry-run --allow-dirty --no-verify")]
            }
            Self::Oldest => vec![check_with_oldest(workspace)?],
            Self::Long => {
                // The workspace builds with all features of the library and the command, users
                // with any of them.
                let alone = [
                    "schlupf",
                    "schlupf --features serde",
                    "schlupf --features rayon",
                    "schlupf-tasks",
                    "schlupf-wasm --target wasm32-unknown-unknown",
                    "schlupf-cli --no-default-features --all-targets",
                ];
                let alone = alone
                    .map(|which| Step::cargo(&format!("clippy --package {which} -- -D warnings")));
                let rest = [
                    check_with_oldest(workspace)?,
                    // The profile of tests is optimised; another one would take longer to build
                    // than to run.
                    Step::cargo("test --workspace -- --ignored"),
                    published(workspace)?,
                ];
                alone.into_iter().chain(rest).collect()
            }
            Self::Bench => vec![
                Step::cargo("bench --package schlupf --bench table"),
                Step::cargo("bench --package schlupf-c --bench call"),
                Step::cargo("bench --package schlupf-tasks --features parquet --bench sweep"),
            ],
        })
    }

    fn run(self, workspace: &Path) -> Result<(), String> {
        match self {
            Self::Sources => sources::report(workspace),
            Self::Web => web::run(workspace, &workspace.join(target())),
            Self::C => c::run(workspace, &target()),
            Self::Python => python::run(workspace, &workspace.join(target())),
            Self::Site => site::run(workspace, &workspace.join(target())),
            _ => self.steps(workspace)?.iter().try_for_each(|step| step.run(workspace)),
        }
    }
}

/// Builds the packages that would be published, in a new directory: cargo takes packages of the
/// same version that it has built before for unchanged.
fn published(workspace: &Path) -> Result<Step, String> {
    const DIRECTORY: &str = "target/published";
    let directory = workspace.join(DIRECTORY);
    if directory.exists() {
        fs::remove_dir_all(&directory).map_err(|e| format!("{}: {e}", directory.display()))?;
    }
    Ok(Step {
        variable: Some(("CARGO_TARGET_DIR", DIRECTORY.to_owned())),
        ..Step::cargo("publish --workspace --dry-run --allow-dirty")
    })
}

fn check_with_oldest(workspace: &Path) -> Result<Step, String> {
    Ok(Step {
        program: "rustup".into(),
        arguments: format!("run {} cargo check --workspace", oldest(workspace)?),
        variable: Some(("CARGO_TARGET_DIR", "target/oldest".to_owned())),
    })
}

/// The `rust-version` of the workspace.
fn oldest(workspace: &Path) -> Result<String, String> {
    let manifest = fs::read_to_string(workspace.join("Cargo.toml"))
        .map_err(|error| format!("Cargo.toml: {error}"))?;
    let version =
        |line: &str| Some(line.strip_prefix("rust-version = \"")?.trim_end_matches('"').to_owned());
    manifest.lines().find_map(version).ok_or_else(|| "Cargo.toml has no rust-version".to_owned())
}

/// The target directory of cargo, from the root of the workspace.
pub fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| "target".into(), PathBuf::from)
}

/// Runs every part, even after one has failed, so that one run shows everything that needs fixing:
/// one after the other, but the explorer beside those up to the site, which takes it in, because
/// neither keeps two cores busy. Returns whether all passed.
pub fn run(parts: &[Part], workspace: &Path) -> bool {
    let mut results = Vec::new();
    let mut beside = None;
    for &part in parts {
        match part {
            Part::Web if parts.contains(&Part::Site) => {
                beside = Some(Beside::start(part, workspace));
            }
            _ => {
                if part == Part::Site {
                    results.extend(beside.take().map(Beside::result));
                }
                let (outcome, time) = timed(part, workspace);
                results.push((part, outcome, time));
            }
        }
    }
    if parts.len() > 1 {
        eprintln!("\nsummary");
        for (part, outcome, time) in &results {
            let word = if outcome.is_ok() { "passed" } else { "FAILED" };
            eprintln!("  {:<9}{word} {:8.1} s", part.name(), time.as_secs_f64());
        }
    }
    results.iter().all(|(_, outcome, _)| outcome.is_ok())
}

/// What came of a part, and how long it took.
type Outcome = (Part, Result<(), String>, Duration);

/// A part that runs beside others, as a process that writes to a file.
struct Beside {
    part: Part,
    log: PathBuf,
    child: Result<Child, String>,
    start: Instant,
}

impl Beside {
    fn start(part: Part, workspace: &Path) -> Self {
        let log = workspace.join(target()).join(format!("{}.log", part.name()));
        let child = File::create(&log).and_then(|file| {
            let both = [file.try_clone()?, file];
            let [output, errors] = both.map(Stdio::from);
            let mut command = Command::new(std::env::current_exe()?);
            command.arg(part.name()).current_dir(workspace);
            command.stdout(output).stderr(errors).spawn()
        });
        eprintln!("\n==> {}: begins, beside what follows", part.name());
        let child = child.map_err(|error| format!("{}: {error}", log.display()));
        Self { part, log, child, start: Instant::now() }
    }

    /// Waits for its end, and prints what it has written, its own time included.
    fn result(self) -> Outcome {
        let Self { part, log, child, start } = self;
        let outcome = child.and_then(|mut child| {
            let status = child.wait().map_err(|error| error.to_string())?;
            eprint!("{}", fs::read_to_string(&log).unwrap_or_default());
            if status.success() { Ok(()) } else { Err(status.to_string()) }
        });
        (part, outcome, start.elapsed())
    }
}

fn timed(part: Part, workspace: &Path) -> (Result<(), String>, Duration) {
    eprintln!("\n==> {}: {}", part.name(), part.about());
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
