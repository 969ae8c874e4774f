//! The documentation site, with notebooks that run and a validation report that is computed.

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
use std::path::Path;
use std::process::Command;

use crate::environment::Environment;
use crate::step::Step;

/// What building the site needs.
const REQUIREMENTS: &str = "docs/requirements.txt";

/// The oldest Python that has the Sphinx of the requirements; the package needs 3.10.
const OLDEST_PYTHON: (u32, u32) = (3, 11);

/// Builds it in `site` of the target directory, with the documentation of the crates; warnings
/// are errors. Results of notebooks are kept for the next time, as long as package and data stay
/// the same.
pub fn run(workspace: &Path, target: &Path) -> Result<(), String> {
    check_python()?;
    let environment =
        Environment::prepare(workspace, target.join("site-environment"), REQUIREMENTS)?;
    environment.install_package(workspace, target)?;
    Step::documentation().run(workspace)?;
    // Pages call the C library, too.
    Step::cargo("build --package schlupf-c").run(workspace)?;
    let library = target.join(format!("debug/{DLL_PREFIX}schlupf_c{DLL_SUFFIX}"));
    let variable = Some(("SCHLUPF_LIBRARY", library.display().to_string()));
    let target = target.display();
    let build = format!(
        "sphinx --builder html --quiet --fail-on-warning --keep-going --jobs auto \
         --doctree-dir {target}/site-doctrees docs {target}/site"
    );
    Step { variable, ..environment.python(&build) }.run(workspace)
}

/// Fails where `python3`, of which the environment is made, is too old.
fn check_python() -> Result<(), String> {
    let output = Command::new("python3")
        .arg("--version")
        .output()
        .map_err(|error| format!("python3 does not start: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout);
    let (major, minor) = OLDEST_PYTHON;
    match version(&text) {
        Some(found) if found >= OLDEST_PYTHON => Ok(()),
        _ => Err(format!(
            "the site needs Python {major}.{minor} or newer for Sphinx, but python3 is {}",
            text.trim()
        )),
    }
}

/// Major and minor version in a text such as `Python 3.11.2`.
fn version(text: &str) -> Option<(u32, u32)> {
    let mut numbers = text.trim().strip_prefix("Python ")?.split('.');
    Some((numbers.next()?.parse().ok()?, numbers.next()?.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::{OLDEST_PYTHON, version};

    /// Goal: versions are compared as numbers. Set-up: what `python3 --version` prints.
    #[test]
    fn versions_of_python_are_numbers() {
        assert_eq!(version("Python 3.11.2\n"), Some((3, 11)));
        assert!(version("Python 3.9.18\n").is_some_and(|found| found < OLDEST_PYTHON));
        assert!(version("Python 3.14.0rc1\n").is_some_and(|found| found > OLDEST_PYTHON));
        assert_eq!(version(""), None);
    }
}
