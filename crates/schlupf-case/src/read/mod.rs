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
mod roughness;

use std::path::Path;
use std::sync::Arc;

use schlupf::history::History;
use schlupf::{Options, Problem};

pub use cooling::{cooling, missing as missing_cooling};
pub use options::{driver, method};

use crate::error::CaseError;
use crate::law_stiffness::{LawStiffness, MicroContact};
use crate::settings::Settings;
use roughness::Circumstances;
pub use roughness::{MicroRequest, explain as explain_roughness, load as load_roughness};

/// The problem of a case, its history, and where its k_c comes from; `folder` is where relative
/// paths start, `solved` a micro model of a like case.
pub fn problem(
    settings: &Settings,
    folder: &Path,
    solved: Option<&Arc<MicroContact>>,
) -> Result<(Problem, Option<History>, LawStiffness), CaseError> {
    let wheel = bodies::body(settings, &bodies::WHEEL)?;
    let rail = bodies::body(settings, &bodies::RAIL)?;
    let kinematics = kinematics::kinematics(settings)?;
    let materials = [&wheel.material, &rail.material];
    let normal = normal::source(settings, folder, materials[0], materials[1])?;
    let history = history::history(settings, folder)?;
    let circumstances = Circumstances { folder, materials, normal: &*normal, solved };
    let (contact_law, stiffness) = interface::contact_law(settings, &circumstances)?;
    let problem = Problem {
        kinematics,
        reference: kinematics::reference(settings)?,
        elasticity: elasticity::model(settings, materials, &*normal, history.as_ref())?,
        normal,
        contact_law,
        friction: friction::friction(settings, folder)?,
        heat: heat::heat(settings)?,
        wheel,
        rail,
    };
    let explain = |error| settings.explain(&error);
    problem.check().map_err(explain)?;
    if let Some(history) = &history {
        history.check(&problem.kinematics).map_err(explain)?;
    }
    Ok((problem, history, stiffness))
}

/// What the micro model of a case's roughness needs; `None` where no surface is given.
pub fn micro_request(
    settings: &Settings,
    folder: &Path,
) -> Result<Option<MicroRequest>, CaseError> {
    let wheel = bodies::body(settings, &bodies::WHEEL)?;
    let rail = bodies::body(settings, &bodies::RAIL)?;
    let materials = [&wheel.material, &rail.material];
    let normal = normal::source(settings, folder, materials[0], materials[1])?;
    let circumstances = Circumstances { folder, materials, normal: &*normal, solved: None };
    roughness::request(settings, &circumstances)
}

/// The numerical options of a case.
pub fn options(settings: &Settings) -> Result<Options, CaseError> {
    let options = options::options(settings)?;
    options.check().map_err(|error| settings.explain(&error))?;
    Ok(options)
}
