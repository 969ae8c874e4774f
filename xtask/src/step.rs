//! Programs that the tasks run.

use std::fmt;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A program to be run.
pub struct Step {
    /// Its path.
    pub program: PathBuf,
    /// Separated by blanks.
    pub arguments: String,
    /// A variable of its environment.
    pub variable: Option<(&'static str, String)>,
}

impl Step {
    /// Cargo with arguments separated by blanks.
    pub fn cargo(arguments: &str) -> Self {
        let program = std::env::var_os("CARGO").map_or_else(|| "cargo".into(), PathBuf::from);
        Self { program, arguments: arguments.to_owned(), variable: None }
    }

    /// Builds the documentation of all crates.
    pub fn documentation() -> Self {
        let variable = Some(("RUSTDOCFLAGS", "-D warnings".to_owned()));
        Self { variable, ..Self::cargo("doc --workspace --no-deps") }
    }

    /// A program with arguments separated by blanks.
    pub fn new(program: PathBuf, arguments: &str) -> Self {
        Self { program, arguments: arguments.to_owned(), variable: None }
    }

    /// A program without arguments.
    pub fn program(path: PathBuf) -> Self {
        Self::new(path, "")
    }

    /// Runs it in the root of the workspace.
    pub fn run(&self, workspace: &Path) -> Result<(), String> {
        eprintln!("  > {self}");
        let mut command = Command::new(&self.program);
        command.args(self.arguments.split_whitespace()).current_dir(workspace);
        command.envs(self.variable.clone());
        match command.status() {
            Ok(status) if status.success() => Ok(()),
            Ok(status) => Err(format!("{self}: {status}")),
            Err(error) => Err(format!("{self} does not start: {error}")),
        }
    }
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((name, value)) = &self.variable {
            write!(f, "{name}=\"{value}\" ")?;
        }
        let program = self.program.file_stem().unwrap_or_default().to_string_lossy();
        write!(f, "{program} {}", self.arguments)
    }
}
