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
mod pairs;
mod roughness;
mod subsurface;
mod wheel_rail;
mod wheel_solver;

use std::sync::Arc;

use schlupf::bodies::{Kinematics, Material, ReferencePoint};
use schlupf::interface::heat::Partition;
use schlupf::interface::{ContactLaw, Interface};
use schlupf::normal::{NormalContact, PressureSource};
use schlupf::problem::{Branch, History, PrescribedForces};
use schlupf::solver::viscoelastic_rolling;
use schlupf::wheel_rail::{WheelOnRail, WheelSolution};
use schlupf::{Error, Options, Problem, Watch};

pub use cooling::{cooling, missing as missing_cooling};
pub use damage::damage;
pub use history::unusual as unusual_history;
pub use kinematics::rolling_radius;
pub use options::{driver, element, method};
pub use subsurface::subsurface;

use crate::error::CaseError;
use crate::fields::choice::NormalModel;
use crate::law_stiffness::{LawStiffness, MicroContact};
use crate::laws::Laws;
use crate::notice::Notice;
use crate::profiles::ProfileReading;
use crate::settings::Settings;
use roughness::OfRoughness;
pub use roughness::{MicroCase, explain as explain_roughness, load as load_roughness};
use wheel_rail::WheelRequest;
pub use wheel_solver::WheelSolver;

/// What a case says of its problem: all that is known without solving anything.
#[derive(Debug, Clone)]
pub struct Parts {
    /// Both bodies and all laws; with a contact law that sticks firmly where a micro model is to
    /// find k_c.
    interface: Interface,
    kinematics: Kinematics,
    prescribed: PrescribedForces,
    reference: ReferencePoint,
    branch: Branch,
    contact: Contact,
    stiffness: OfRoughness,
    /// Values over time, where there are some.
    pub history: Option<History>,
}

/// Where wheel and rail touch.
#[derive(Debug, Clone)]
enum Contact {
    /// In one patch under this pressure.
    Pressure(Arc<dyn PressureSource>),
    /// Where the profiles of a wheel and a rail do.
    Wheel(Box<WheelRequest>),
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
        let kinematics = kinematics::kinematics(settings)?;
        let reference = kinematics::reference(settings)?;
        let contact_law = match &stiffness {
            OfRoughness::Known(known) => interface::contact_law(settings, known.stiffness)?,
            OfRoughness::MicroModel(_) => ContactLaw::Coulomb,
        };
        let elasticity = elasticity::elasticity(settings, materials)?;
        let contact = match wheel_rail::request(settings)? {
            Some(wheel) => Contact::Wheel(Box::new(wheel)),
            None => Contact::Pressure(normal::source(settings, materials)?),
        };
        let prescribed = match contact {
            Contact::Pressure(_) => kinematics::prescribed(settings)?,
            // A force turns the whole wheel.
            Contact::Wheel(_) => PrescribedForces::default(),
        };
        let parts = Self {
            interface: Interface {
                elasticity,
                layer: layer::layer(settings)?,
                contact_law,
                friction: friction::friction(settings)?,
                heat: heat::heat(settings)?,
                wheel,
                rail,
            },
            kinematics,
            prescribed,
            reference,
            branch: options::branch(settings)?,
            contact,
            stiffness,
            history: None,
        };
        let parts = if parts.has_wheel() {
            wheel_rail::refuse_others(settings, &parts.stiffness)?;
            parts
        } else {
            Self { history: history::history(settings)?, ..parts }
        };
        parts.check().map_err(|error| settings.explain(&error))?;
        Ok(parts)
    }

    fn check(&self) -> Result<(), Error> {
        self.kinematics.check()?;
        self.prescribed.check()?;
        self.interface.check(&self.kinematics)?;
        if let Some(history) = &self.history {
            history.check_forces(&self.prescribed)?;
            history.check(&self.kinematics)?;
        }
        Ok(())
    }

    /// Puts laws of the caller in place of those of the case.
    pub fn apply(&mut self, laws: &Laws) -> Result<(), Error> {
        let Laws { friction, pressure, partition } = laws.clone();
        if let Some(law) = friction {
            self.interface.friction.law = law;
        }
        if let Some(pressure) = pressure {
            self.contact = Contact::Pressure(pressure);
        }
        if let Some(law) = partition {
            self.interface.heat.partition = Partition::Law(law);
        }
        self.interface.check(&self.kinematics)
    }

    /// Whether the contacts are those of a wheel with profiles.
    pub fn has_wheel(&self) -> bool {
        self.wheel_request().is_some()
    }

    fn wheel_request(&self) -> Option<&WheelRequest> {
        match &self.contact {
            Contact::Pressure(_) => None,
            Contact::Wheel(wheel) => Some(wheel),
        }
    }

    /// Those of wheel and rail.
    pub fn materials(&self) -> [Material; 2] {
        [self.interface.wheel.material, self.interface.rail.material]
    }

    /// The normal contact, of a history that with the largest load.
    pub fn normal_contact(
        &self,
        settings: &Settings,
        watch: Watch,
    ) -> Result<NormalContact, CaseError> {
        let explain = |error: Error| settings.explain(&error);
        match &self.contact {
            Contact::Wheel(wheel) => {
                let problem = self.pose_wheel(wheel, settings, watch)?.problem;
                problem.normal.normal_contact(None).map_err(explain)
            }
            Contact::Pressure(normal) => {
                let problem = self.problem(normal, self.interface.clone());
                if let Some(rolling) = viscoelastic_rolling(&problem, watch).map_err(explain)? {
                    return rolling.normal.normal_contact(None).map_err(explain);
                }
                let load = self.history.as_ref().and_then(History::largest_load);
                normal.prepare(load, watch).map_err(explain)?;
                normal.normal_contact(load).map_err(explain)
            }
        }
    }

    fn problem(&self, normal: &Arc<dyn PressureSource>, interface: Interface) -> Problem {
        Problem {
            kinematics: self.kinematics,
            prescribed: self.prescribed,
            reference: self.reference,
            branch: self.branch,
            normal: Arc::clone(normal),
            interface,
        }
    }

    /// The problem, and where its k_c comes from: solves the normal contact and the micro model
    /// where the case has such. `solved` is a micro model of a like case.
    pub fn pose(
        &self,
        settings: &Settings,
        solved: Option<&Arc<MicroContact>>,
        watch: Watch,
    ) -> Result<Posed, CaseError> {
        let normal = match &self.contact {
            Contact::Pressure(normal) => normal,
            Contact::Wheel(wheel) => return self.pose_wheel(wheel, settings, watch),
        };
        let load = self.history.as_ref().and_then(History::largest_load);
        for load in [None, load] {
            normal.prepare(load, watch).map_err(|error| settings.explain(&error))?;
        }
        let mut interface = self.interface.clone();
        let stiffness = match &self.stiffness {
            OfRoughness::Known(stiffness) => stiffness.clone(),
            OfRoughness::MicroModel(request) => {
                let patch =
                    || normal.normal_contact(None).map_err(|error| settings.explain(&error));
                let request = request.on(settings, patch)?;
                let found = roughness::solve(settings, request, solved, watch)?;
                interface.contact_law = interface::contact_law(settings, found.stiffness)?;
                found
            }
        };
        let problem = self.problem(normal, interface);
        Ok(Posed { problem, stiffness, motion: self.kinematics, wheel: None })
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
        let speed = self.kinematics.speed;
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
            interface: self.interface.clone(),
            branch: self.branch,
            method: method(settings)?,
            driver: driver(settings)?,
            options: options(settings)?,
            radius: rolling_radius(settings)?,
            known: None,
        })
    }

    /// Whether another load scales the pressure or the patch, and nothing else is to be found anew.
    pub fn scales_with_load(&self, settings: &Settings) -> Result<bool, CaseError> {
        let is_known = matches!(self.stiffness, OfRoughness::Known(_));
        Ok(is_known
            && match settings.chosen(field!("normal.model"))? {
                NormalModel::Hertz | NormalModel::Line | NormalModel::Tabulated => true,
                NormalModel::Ellipse => settings.is_given(field!("normal.load")),
                NormalModel::Profile | NormalModel::WheelRail => false,
            })
    }

    /// The wheel of a case of two profiles.
    pub fn wheel(&self, settings: &Settings) -> Result<&WheelOnRail, CaseError> {
        let request = self.wheel_request();
        request.map(WheelRequest::wheel).ok_or_else(|| wheel_rail::no_profiles(settings))
    }

    /// What was read of the profiles of the wheel and of the rail, if the case has profiles.
    pub fn profiles(&self) -> &[ProfileReading] {
        self.wheel_request().map_or(&[], |wheel| wheel.readings())
    }

    /// What users should know of what was read.
    pub fn notices(&self) -> &[Notice] {
        self.wheel_request().map_or(&[], WheelRequest::notices)
    }

    /// The left and the right wheel at another lateral position (in m), resting on both rails.
    pub fn wheels_at(
        &self,
        settings: &Settings,
        lateral: f64,
        watch: Watch,
    ) -> Result<Vec<WheelSolution>, CaseError> {
        let request = self.wheel_request().ok_or_else(|| wheel_rail::no_profiles(settings))?;
        let solver = self.wheel_solver(request, settings)?.of_forces();
        let found = solver.find(Some(lateral), watch);
        found.map_err(|error| settings.explain(&error))
    }
}

/// What the micro model of a case's roughness needs; `None` where no surface is given.
pub fn micro_case(settings: &Settings, watch: Watch) -> Result<Option<MicroCase>, CaseError> {
    let wheel = bodies::body(settings, &bodies::WHEEL)?;
    let rail = bodies::body(settings, &bodies::RAIL)?;
    let materials = [&wheel.material, &rail.material];
    let Some(request) = roughness::request(settings, materials)? else { return Ok(None) };
    let patch = || {
        let normal = normal::source(settings, materials)?;
        normal.prepare(None, watch).map_err(|error| settings.explain(&error))?;
        normal.normal_contact(None).map_err(|error| settings.explain(&error))
    };
    request.on(settings, patch).map(Some)
}

/// The numerical options of a case.
pub fn options(settings: &Settings) -> Result<Options, CaseError> {
    let options = options::options(settings)?;
    options.check().map_err(|error| settings.explain(&error))?;
    Ok(options)
}
