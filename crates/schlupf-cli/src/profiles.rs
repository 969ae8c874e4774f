//! What `schlupf check` says and draws of the profiles of a case.

use std::path::Path;

use schlupf_case::{CaseErrors, CaseFile, ProfileReading};
use schlupf_tasks::output::profiles;

use crate::arguments::CheckArguments;
use crate::failure::Failure;
use crate::figures::{Figures, MANIFEST, figure_files};
use crate::outputs::{self, Directory, Input};

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
    let directory = directory(path);
    outputs::check(&[], Some(&directory))?;
    outputs::refuse_inputs(&[], Some(&directory), &Input::of_case(&arguments.case, file))?;
    let known = Figures::of(path)?;
    figure_files(profiles::NAME).iter().try_for_each(|name| known.refuse_foreign(name))
}

fn directory(path: &Path) -> Directory<'_> {
    let names = figure_files(profiles::NAME).into_iter().chain([MANIFEST.to_owned()]).collect();
    Directory { option: OPTION, path, names }
}

/// What was read of the profiles of a case.
pub fn text(file: &CaseFile) -> String {
    file.profiles().iter().map(ProfileReading::to_string).collect()
}

/// Draws the profiles with the wheelset at a height (in m) above the nominal one.
pub fn draw(arguments: &CheckArguments, file: &CaseFile, height: f64) -> Result<(), Failure> {
    let Some(path) = arguments.figures.as_deref() else { return Ok(()) };
    let title = file.title().map_err(CaseErrors::from)?;
    let wheel = file.wheel().map_err(CaseErrors::from)?;
    let reserved = outputs::reserve(&[], Some(&directory(path)))?;
    let names = figure_files(profiles::NAME);
    let mut drawn = Vec::new();
    for figure in profiles::figure(&title, wheel, height)? {
        drawn.extend(figure.files().into_iter().map(|(name, bytes)| (path.join(name), bytes)));
    }
    let figures = Figures::of(path)?.renewed(&names, drawn);
    outputs::write(&figures.files, Some(path))?;
    outputs::remove(&figures.stale);
    drop(reserved);
    Ok(())
}
