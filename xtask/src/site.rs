//! The documentation site, with notebooks that run and a validation report that is computed.

use std::path::Path;

use crate::environment::Environment;
use crate::step::Step;

/// What building the site needs.
const REQUIREMENTS: &str = "docs/requirements.txt";

/// Builds it in `site` of the target directory; warnings are errors. Results of notebooks are kept
/// for the next time, as long as package and data stay the same.
pub fn run(workspace: &Path, target: &Path) -> Result<(), String> {
    let environment =
        Environment::prepare(workspace, target.join("site-environment"), REQUIREMENTS)?;
    environment.install_package(workspace, target)?;
    Step::cargo("doc --workspace --no-deps").run(workspace)?;
    let target = target.display();
    let build = format!(
        "sphinx --builder html --quiet --fail-on-warning --keep-going \
         --doctree-dir {target}/site-doctrees docs {target}/site"
    );
    environment.python(&build).run(workspace)
}
