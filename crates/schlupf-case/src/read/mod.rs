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
mod layer;
mod normal;
mod options;
mod roughness;
mod subsurface;
mod wheel_rail;
mod wheel_solver;

use std::sync::Arc;

use schlupf::bodies::{Kinematics, Material};
use schlupf::normal::NormalContact;
use schlupf::problem::{History, PrescribedForces};
use schlupf::solver::ForceSolver;
use schlupf::solver::MarchingSolver;
use schlupf::wheel_rail::{WheelOnRail, WheelSolution};
use schlupf::{Error, Method, Options, Problem, Solver, Watch};

pub use cooling::{cooling, missing as missing_cooling};
pub use damage::damage;
pub use history::unusual as unusual_history;
pub use options::{driver, method};
pub use subsurface::subsurface;

use crate::error::CaseError;
use crate::fields::choice::{Driver, NormalModel};
use crate::law_stiffness::{LawStiffness, MicroContact};
use crate::laws::Laws;
use crate::notice::Notice;
use crate::profiles::ProfileReading;
use crate::settings::Settings;
use elasticity::Deformation;
use roughness::OfRoughness;
pub use roughness::{MicroCase, explain as explain_roughness, load as load_roughness};
use wheel_rail::WheelRequest;
pub use wheel_solver::WheelSolver;

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
    /// The wheel whose contacts are still to be found, if the case has profiles.
    wheel: Option<WheelRequest>,
}

/// A problem with what was found on the way to it.
#[derive(Debug, Clone)]
pub struct Posed {
    /// The problem; that of the contact with the largest normal force where there are several.
    pub problem: Problem,
    /// k_c and where it comes from.
    pub stiffness: LawStiffness,
    /// Speed and creepages that the case gives: of a wheel with profiles those of its nominal
    /// radius.
    pub motion: Kinematics,
    /// The wheel with all its contacts, if the case has profiles, and what finds its states.
    pub wheel: Option<(Arc<WheelSolution>, WheelSolver)>,
}

impl Parts {
    /// Reads and checks them.
    pub fn read(settings: &Settings) -> Result<Self, CaseError> {
        let wheel = bodies::body(settings, &bodies::WHEEL)?;
        let rail = bodies::body(settings, &bodies::RAIL)?;
        let materials = [&wheel.material, &rail.material];
        let stiffness = interface::stiffness(settings, materials)?;
        let deformation = elasticity::deformation(settings, materials)?;
        let mut draft = Problem {
            kinematics: kinematics::kinematics(settings)?,
            prescribed: kinematics::prescribed(settings)?,
            reference: kinematics::reference(settings)?,
            elasticity: deformation.provisional(),
            layer: layer::layer(settings)?,
            normal: normal::source(settings, materials[0], materials[1])?,
            contact_law: interface::contact_law(settings, stiffness.provisional())?,
            friction: friction::friction(settings)?,
            heat: heat::heat(settings)?,
            wheel,
            rail,
        };
        let history = history::history(settings)?;
        let wheel = wheel_rail::request(settings)?;
        if wheel.is_some() {
            wheel_rail::refuse_others(settings, &stiffness, history.is_some())?;
            // A force turns the whole wheel.
            draft.prescribed = PrescribedForces::default();
        }
        let explain = |error| settings.explain(&error);
        draft.check().map_err(explain)?;
        if let Some(history) = &history {
            history.check_forces(&draft.prescribed).map_err(explain)?;
            history.check(&draft.kinematics).map_err(explain)?;
        }
        Ok(Self { draft, deformation, stiffness, history, wheel })
    }

    /// Puts laws of the caller in place of those of the case.
    pub fn apply(&mut self, laws: &Laws) -> Result<(), Error> {
        if laws.pressure.is_some() {
            self.wheel = None;
        }
        laws.apply(&mut self.draft)
    }

    /// Whether the contacts are those of a wheel with profiles.
    pub fn has_wheel(&self) -> bool {
        self.wheel.is_some()
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
        if self.wheel.is_some() {
            let problem = self.pose(settings, None, watch)?.problem;
            return problem.normal.normal_contact(None).map_err(|error| settings.explain(&error));
        }
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
    ) -> Result<Posed, CaseError> {
        if let Some(wheel) = &self.wheel {
            return self.pose_wheel(wheel, settings, watch);
        }
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
        let problem = Problem { elasticity, contact_law, ..self.draft.clone() };
        let motion = problem.kinematics;
        Ok(Posed { problem, stiffness, motion, wheel: None })
    }

    /// The problem of the main contact of a wheel on a rail, and all its contacts.
    fn pose_wheel(
        &self,
        wheel: &WheelRequest,
        settings: &Settings,
        watch: Watch,
    ) -> Result<Posed, CaseError> {
        let OfRoughness::Known(stiffness) = &self.stiffness else {
            return Err(wheel_rail::refuse_micro_model(settings));
        };
        let mut solver = self.wheel_solver(wheel, settings)?;
        let found = solver.find_one(watch).map_err(|error| settings.explain(&error))?;
        let main = found.contacts.first().ok_or_else(|| wheel_rail::no_contact(settings))?;
        let (problem, stiffness) = (main.problem.clone(), stiffness.clone());
        let speed = solver.draft.kinematics.speed;
        let creepage_x = found.creepage(solver.radius, speed);
        let motion = Kinematics { creepage_x, ..Kinematics::free_rolling(speed) };
        solver.known = found.resultant(motion).map(Box::new);
        Ok(Posed { problem, stiffness, motion, wheel: Some((Arc::new(found), solver)) })
    }

    fn wheel_solver(
        &self,
        wheel: &WheelRequest,
        settings: &Settings,
    ) -> Result<WheelSolver, CaseError> {
        Ok(WheelSolver {
            request: wheel.clone(),
            draft: self.draft.clone(),
            deformation: self.deformation.clone(),
            contact_law: interface::contact_law(settings, self.stiffness.provisional())?,
            method: method(settings)?,
            driver: driver(settings)?,
            options: Options { sensitivity: false, extrapolate: false, ..options(settings)? },
            radius: settings.number(field!("kinematics.wheel_radius"))?,
            known: None,
        })
    }

    /// Whether another load scales the pressure or the patch, and nothing else is to be found anew.
    pub fn scales_with_load(&self, settings: &Settings) -> Result<bool, CaseError> {
        let is_known = matches!(self.stiffness, OfRoughness::Known(_))
            && matches!(self.deformation, Deformation::Known(_));
        Ok(is_known
            && match settings.chosen(field!("normal.model"))? {
                NormalModel::Hertz | NormalModel::Tabulated => true,
                NormalModel::Ellipse => settings.is_given(field!("normal.load")),
                NormalModel::Profile | NormalModel::WheelRail => false,
            })
    }

    /// The wheel of a case of two profiles.
    pub fn wheel(&self, settings: &Settings) -> Result<&WheelOnRail, CaseError> {
        let request = self.wheel.as_ref();
        request.map(WheelRequest::wheel).ok_or_else(|| wheel_rail::no_profiles(settings))
    }

    /// What was read of the profiles of the wheel and of the rail, if the case has profiles.
    pub fn profiles(&self) -> &[ProfileReading] {
        self.wheel.as_ref().map_or(&[], |wheel| wheel.readings())
    }

    /// What users should know of what was read.
    pub fn notices(&self) -> &[Notice] {
        self.wheel.as_ref().map_or(&[], WheelRequest::notices)
    }

    /// The left and the right wheel at another lateral position (in m), resting on both rails.
    pub fn wheels_at(
        &self,
        settings: &Settings,
        lateral: f64,
        watch: Watch,
    ) -> Result<Vec<WheelSolution>, CaseError> {
        let request = self.wheel.as_ref().ok_or_else(|| wheel_rail::no_profiles(settings))?;
        let found = self.wheel_solver(request, settings)?.find(Some(lateral), watch);
        found.map_err(|error| settings.explain(&error))
    }
}

/// What finds steady states by a method, and by a driver that was asked for.
pub fn any_solver(method: Method, driver: Option<Driver>, options: &Options) -> Box<dyn Solver> {
    match (method, driver) {
        (Method::Full, Some(Driver::Marching)) => {
            Box::new(ForceSolver::new(Box::new(MarchingSolver::new(options))))
        }
        (method, _) => Box::new(ForceSolver::new(method.solver(options))),
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
