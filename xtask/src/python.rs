//! The Python package: its wheel, installed in an environment of its own, and tested from there.

use std::path::Path;

use crate::environment::Environment;

/// What the tests of the package need.
const REQUIREMENTS: &str = "python/requirements-test.txt";

/// Builds, installs and tests it.
pub fn run(workspace: &Path, target: &Path) -> Result<(), String> {
    let environment = Environment::prepare(workspace, target.join("python"), REQUIREMENTS)?;
    environment.install_package(workspace, target)?;
    let steps = [
        "ruff check --quiet python",
        "ruff format --quiet --diff python",
        "pytest --quiet",
        "pytest --quiet --doctest-modules --pyargs schlupf",
        "mypy",
        "mypy.stubtest schlupf._core",
    ];
    steps.iter().try_for_each(|module| environment.python(module).run(workspace))
}
