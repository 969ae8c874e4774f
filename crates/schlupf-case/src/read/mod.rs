//! From settings to the parts of a problem; one file for each section of the case file.

mod bodies;
mod cooling;
mod elasticity;
mod friction;
mod heat;
mod history;
mod interface;
mod kinematics;
mod normal;
mod options;

use std::path::Path;

use schlupf::{Options, Problem};

pub use cooling::{cooling, missing as missing_cooling};

use crate::error::CaseError;
use crate::settings::Settings;

/// The problem of a case; `folder` is where relative paths start.
pub fn problem(settings: &Settings, folder: &Path) -> Result<Problem, CaseError> {
    let wheel = bodies::body(settings, &bodies::WHEEL)?;
    let rail = bodies::body(settings, &bodies::RAIL)?;
    let problem = Problem {
        kinematics: kinematics::kinematics(settings)?,
        normal: normal::source(settings, folder, &wheel.material, &rail.material)?,
        elasticity: elasticity::model(settings, [&wheel.material, &rail.material])?,
        contact_law: interface::contact_law(settings)?,
        friction: friction::friction(settings, folder)?,
        heat: heat::heat(settings)?,
        history: history::history(settings, folder)?,
        initial_state: None,
        wheel,
        rail,
    };
    problem.check().map_err(|error| settings.explain(&error))?;
    Ok(problem)
}

/// The numerical options of a case.
pub fn options(settings: &Settings) -> Result<Options, CaseError> {
    let options = options::options(settings)?;
    options.check().map_err(|error| settings.explain(&error))?;
    Ok(options)
}
