//! From settings to the parts of a problem; one file for each section of the case file.

mod bodies;
mod cooling;
mod damage;
mod elasticity;
mod friction;
mod heat;
mod history;
mod interface;
mod kinematics;
mod normal;
mod options;
mod roughness;

use std::sync::Arc;

use schlupf::history::History;
use schlupf::material::Material;
use schlupf::normal::NormalContact;
use schlupf::{Error, Options, Problem, Watch};

pub use cooling::{cooling, missing as missing_cooling};
pub use damage::damage;
pub use options::{driver, method};

use crate::error::CaseError;
use crate::law_stiffness::{LawStiffness, MicroContact};
use crate::laws::Laws;
use crate::settings::Settings;
use elasticity::Deformation;
use roughness::OfRoughness;
pub use roughness::{MicroCase, explain as explain_roughness, load as load_roughness};

/// What a case says of its problem: all that is known without solving anything.
#[derive(Debug, Clone)]
pub struct Parts {
    /// The problem, with a contact law and an elasticity that stand for those that are still to be
    /// found.
    draft: Problem,
    deformation: Deformation,
    stiffness: OfRoughness,
    /// Values over time, where there are some.
    pub history: Option<History>,
}

impl Parts {
    /// Reads and checks them.
    pub fn read(settings: &Settings) -> Result<Self, CaseError> {
        let wheel = bodies::body(settings, &bodies::WHEEL)?;
        let rail = bodies::body(settings, &bodies::RAIL)?;
        let materials = [&wheel.material, &rail.material];
        let stiffness = interface::stiffness(settings, materials)?;
        let deformation = elasticity::deformation(settings, materials)?;
        let draft = Problem {
            kinematics: kinematics::kinematics(settings)?,
            reference: kinematics::reference(settings)?,
            elasticity: deformation.provisional(),
            normal: normal::source(settings, materials[0], materials[1])?,
            contact_law: interface::contact_law(settings, stiffness.provisional())?,
            friction: friction::friction(settings)?,
            heat: heat::heat(settings)?,
            wheel,
            rail,
        };
        let history = history::history(settings)?;
        let explain = |error| settings.explain(&error);
        draft.check().map_err(explain)?;
        if let Some(history) = &history {
            history.check(&draft.kinematics).map_err(explain)?;
        }
        Ok(Self { draft, deformation, stiffness, history })
    }

    /// Puts laws of the caller in place of those of the case.
    pub fn apply(&mut self, laws: &Laws) -> Result<(), Error> {
        laws.apply(&mut self.draft)
    }

    /// Those of wheel and rail.
    pub fn materials(&self) -> [Material; 2] {
        [&self.draft.wheel, &self.draft.rail].map(|body| body.material)
    }

    /// The normal contact, of a history that with the largest load.
    pub fn normal_contact(
        &self,
        settings: &Settings,
        watch: Watch,
    ) -> Result<NormalContact, CaseError> {
        let load = self.history.as_ref().and_then(History::largest_load);
        let contact = || {
            self.draft.normal.prepare(load, watch)?;
            self.draft.normal.normal_contact(load)
        };
        contact().map_err(|error| settings.explain(&error))
    }

    /// The problem, and where its k_c comes from: solves the normal contact and the micro model
    /// where the case has such. `solved` is a micro model of a like case.
    pub fn pose(
        &self,
        settings: &Settings,
        solved: Option<&Arc<MicroContact>>,
        watch: Watch,
    ) -> Result<(Problem, LawStiffness), CaseError> {
        let explain = |error: Error| settings.explain(&error);
        let normal = &*self.draft.normal;
        let load = self.history.as_ref().and_then(History::largest_load);
        for load in [None, load] {
            normal.prepare(load, watch).map_err(explain)?;
        }
        let elasticity = self.deformation.model(normal, self.history.as_ref()).map_err(explain)?;
        let stiffness = match &self.stiffness {
            OfRoughness::Known(stiffness) => stiffness.clone(),
            OfRoughness::MicroModel(request) => {
                roughness::solve(settings, request.on(settings, normal)?, solved, watch)?
            }
        };
        let contact_law = interface::contact_law(settings, stiffness.stiffness)?;
        Ok((Problem { elasticity, contact_law, ..self.draft.clone() }, stiffness))
    }
}

/// What the micro model of a case's roughness needs; `None` where no surface is given.
pub fn micro_case(settings: &Settings, watch: Watch) -> Result<Option<MicroCase>, CaseError> {
    let wheel = bodies::body(settings, &bodies::WHEEL)?;
    let rail = bodies::body(settings, &bodies::RAIL)?;
    let materials = [&wheel.material, &rail.material];
    let normal = normal::source(settings, materials[0], materials[1])?;
    let Some(request) = roughness::request(settings, materials)? else { return Ok(None) };
    if !request.has_pressures() {
        normal.prepare(None, watch).map_err(|error| settings.explain(&error))?;
    }
    request.on(settings, &*normal).map(Some)
}

/// The numerical options of a case.
pub fn options(settings: &Settings) -> Result<Options, CaseError> {
    let options = options::options(settings)?;
    options.check().map_err(|error| settings.explain(&error))?;
    Ok(options)
}
