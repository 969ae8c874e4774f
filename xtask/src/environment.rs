//! Virtual environments of Python with the package.

use std::fs;
use std::path::{Path, PathBuf};

use crate::step::Step;

/// A virtual environment with what a file of requirements names.
pub struct Environment {
    root: PathBuf,
}

impl Environment {
    /// That of a folder; it is made again where it was made with other requirements.
    pub fn prepare(workspace: &Path, root: PathBuf, requirements: &str) -> Result<Self, String> {
        let environment = Self { root };
        let root = &environment.root;
        let fail = |error: std::io::Error| format!("{}: {error}", root.display());
        let wanted = fs::read(workspace.join(requirements))
            .map_err(|error| format!("{requirements}: {error}"))?;
        let installed = root.join("requirements.txt");
        if fs::read(&installed).is_ok_and(|installed| installed == wanted) {
            return Ok(environment);
        }
        if root.exists() {
            fs::remove_dir_all(root).map_err(fail)?;
        }
        Step::new("python3".into(), &format!("-m venv {}", root.display())).run(workspace)?;
        let install = format!("pip install --quiet --requirement {requirements}");
        environment.python(&install).run(workspace)?;
        // Last: an environment that was not finished is made again.
        fs::write(installed, wanted).map_err(fail)?;
        Ok(environment)
    }

    /// A module of its Python with arguments.
    pub fn python(&self, module: &str) -> Step {
        let program = if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" };
        Step::new(self.root.join(program), &format!("-m {module}"))
    }

    /// Builds the wheel of the package with the profile of tests, and installs it.
    pub fn install_package(&self, workspace: &Path, target: &Path) -> Result<(), String> {
        let wheels = self.root.join("wheels");
        // Another version's wheel would be installed in place of this one.
        if wheels.exists() {
            fs::remove_dir_all(&wheels)
                .map_err(|error| format!("{}: {error}", wheels.display()))?;
        }
        let (target, wheels) = (target.display(), wheels.display());
        let steps = [
            format!("maturin build --profile dev --locked --target-dir {target} --out {wheels}"),
            format!(
                "pip install --quiet --force-reinstall --no-deps --no-index \
                 --find-links {wheels} schlupf"
            ),
        ];
        steps.iter().try_for_each(|module| self.python(module).run(workspace))
    }
}
