//! What `schlupf check` says and draws of the profiles of a case.

use std::path::{Path, PathBuf};

use schlupf_case::{CaseErrors, CaseFile, ProfileReading};
use schlupf_output::profiles;

use crate::arguments::CheckArguments;
use crate::failure::Failure;
use crate::outputs::{self, Directory, Input};
use crate::task::{figure_files, refuse_foreign};

const OPTION: &str = "--figures";

/// Checks where the figure goes to, before the work.
pub fn check(arguments: &CheckArguments, file: &CaseFile) -> Result<(), Failure> {
    let Some(path) = arguments.figures.as_deref() else { return Ok(()) };
    if file.profiles().is_empty() {
        let message = format!(
            "{OPTION} draws the profiles of a case, but normal.model is not \"wheel-rail\""
        );
        return Err(Failure::Arguments(message));
    }
    let names = figure_files(profiles::NAME).to_vec();
    let directory = Directory { option: OPTION, path, names };
    outputs::check(&[], Some(&directory))?;
    outputs::refuse_inputs(&[], Some(&directory), &Input::of_case(&arguments.case, file))?;
    files(path).iter().try_for_each(|path| refuse_foreign(path))
}

fn files(directory: &Path) -> [PathBuf; 2] {
    figure_files(profiles::NAME).map(|name| directory.join(name))
}

/// What was read of the profiles of a case.
pub fn text(file: &CaseFile) -> String {
    file.profiles().iter().map(ProfileReading::to_string).collect()
}

/// Draws the profiles with the wheelset at a height (in m) above the nominal one.
pub fn draw(arguments: &CheckArguments, file: &CaseFile, height: f64) -> Result<(), Failure> {
    let Some(directory) = arguments.figures.as_deref() else { return Ok(()) };
    let title = file.title().map_err(CaseErrors::from)?;
    let wheel = file.wheel().map_err(CaseErrors::from)?;
    let mut written = Vec::new();
    for figure in profiles::figure(&title, wheel, height)? {
        let [svg, png] = files(directory);
        written.extend([(svg, figure.svg.into_bytes()), (png, figure.png)]);
    }
    outputs::write(&written, Some(directory))
}
