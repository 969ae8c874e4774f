//! The documentation site, with notebooks that run and a validation report that is computed.

use std::path::Path;

use crate::environment::Environment;
use crate::step::Step;

/// What building the site needs.
const REQUIREMENTS: &str = "docs/requirements.txt";

/// Builds it in `site` of the target directory, with the documentation of the libraries; warnings are errors. Results of notebooks are kept
/// for the next time, as long as package and data stay the same.
pub fn run(workspace: &Path, target: &Path, libraries: &[&str]) -> Result<(), String> {
    let environment =
        Environment::prepare(workspace, target.join("site-environment"), REQUIREMENTS)?;
    environment.install_package(workspace, target)?;
    // Not the extension module: maturin and cargo compile what it needs in turns.
    let packages = libraries.join(" --package ");
    Step::cargo(&format!("doc --no-deps --package {packages}")).run(workspace)?;
    let target = target.display();
    let build = format!(
        "sphinx --builder html --quiet --fail-on-warning --keep-going \
         --doctree-dir {target}/site-doctrees docs {target}/site"
    );
    environment.python(&build).run(workspace)
}
