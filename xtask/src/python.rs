//! The Python package: its wheel, installed in an environment of its own, and tested from there.

use std::path::Path;

use crate::environment::Environment;
use crate::step::Step;

/// What the tests of the package need.
const REQUIREMENTS: &str = "python/requirements-test.txt";

/// Builds, installs and tests it.
pub fn run(workspace: &Path, target: &Path) -> Result<(), String> {
    let environment = Environment::prepare(workspace, target.join("python"), REQUIREMENTS)?;
    environment.install_package(workspace, target)?;
    let steps = ["ruff check --quiet python", "ruff format --quiet --diff python"];
    steps.iter().try_for_each(|module| environment.python(module).run(workspace))?;
    Step::cargo("build --package schlupf-c").run(workspace)?;
    environment.python("pytest --quiet --numprocesses auto").run(workspace)?;
    // Times are compared with the machine for themselves.
    let variable = many_forces(target).map(|program| ("SCHLUPF_MANY_FORCES", program));
    let speed = "pytest --quiet python/tests/test_forces.py -k as_long_as_in_rust";
    Step { variable, ..environment.python(speed) }.run(workspace)?;
    let steps = [
        "pytest --quiet --doctest-modules --pyargs schlupf",
        "mypy",
        "mypy python/tests/typed.py",
        "pyright",
        "mypy.stubtest schlupf._core",
    ];
    steps.iter().try_for_each(|module| environment.python(module).run(workspace))
}

/// The program that computes many forces, with which those of Python are compared: an example,
/// which the build of the tests has made.
fn many_forces(target: &Path) -> Option<String> {
    let file = format!("many_forces{}", std::env::consts::EXE_SUFFIX);
    let program = target.join("debug/examples").join(file);
    program.exists().then(|| program.display().to_string())
}
