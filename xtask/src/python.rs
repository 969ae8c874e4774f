//! The Python package: its wheel, installed in an environment of its own, and tested from there.

use std::fs;
use std::path::{Path, PathBuf};

use crate::step::Step;

/// What the tests of the package need.
const REQUIREMENTS: &str = "python/requirements-test.txt";

/// Builds, installs and tests it.
pub fn run(workspace: &Path, target: &Path) -> Result<(), String> {
    let environment = Environment { root: target.join("python") };
    environment.prepare(workspace)?;
    let wheels = environment.root.join("wheels");
    // Another version's wheel would be installed in place of this one.
    if wheels.exists() {
        fs::remove_dir_all(&wheels).map_err(|error| format!("{}: {error}", wheels.display()))?;
    }
    let (target, wheels) = (target.display(), wheels.display());
    let steps = [
        format!("maturin build --profile dev --locked --target-dir {target} --out {wheels}"),
        format!("pip install --quiet --force-reinstall --no-deps --no-index {}", find(&wheels)),
        "ruff check --quiet python".to_owned(),
        "ruff format --quiet --diff python".to_owned(),
        "pytest --quiet".to_owned(),
        "pytest --quiet --doctest-modules --pyargs schlupf".to_owned(),
        "mypy".to_owned(),
        "mypy.stubtest schlupf._core".to_owned(),
    ];
    steps.iter().try_for_each(|module| environment.python(module).run(workspace))
}

fn find(wheels: &impl std::fmt::Display) -> String {
    format!("--find-links {wheels} schlupf")
}

/// A virtual environment.
struct Environment {
    root: PathBuf,
}

impl Environment {
    /// A module of its Python with arguments.
    fn python(&self, module: &str) -> Step {
        let program = if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" };
        Step::new(self.root.join(program), &format!("-m {module}"))
    }

    /// Makes it, unless it is there with the same requirements.
    fn prepare(&self, workspace: &Path) -> Result<(), String> {
        let fail = |error: std::io::Error| format!("{}: {error}", self.root.display());
        let wanted = workspace.join(REQUIREMENTS);
        let wanted = fs::read(wanted).map_err(|error| format!("{REQUIREMENTS}: {error}"))?;
        let installed = self.root.join("requirements.txt");
        if fs::read(&installed).is_ok_and(|installed| installed == wanted) {
            return Ok(());
        }
        if self.root.exists() {
            fs::remove_dir_all(&self.root).map_err(fail)?;
        }
        let venv = format!("-m venv {}", self.root.display());
        Step::new("python3".into(), &venv).run(workspace)?;
        self.python(&format!("pip install --quiet --requirement {REQUIREMENTS}")).run(workspace)?;
        // Last: an environment that was not finished is made again.
        fs::write(installed, wanted).map_err(fail)
    }
}
