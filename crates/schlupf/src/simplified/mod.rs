//! Fast methods for the forces of steady rolling, with the problems and solutions of the full solver: for
//! multibody codes, and to compare with.
//!
//! | method | gives | cost |
//! |---|---|---|
//! | Kalker's linear theory | forces, moment | a tenth of a microsecond |
//! | [`shen_hedrick_elkins`] | forces, moment | the same |
//! | [`polach`] | forces | the same |
//! | FASTSIM, modified FASTSIM | forces, moment, fields, temperatures | microseconds |
//!
//! All rest on Kalker's coefficients for the ellipse of the contact, which come from a table. A
//! [`FastContact`] is set up once; forces for other motions and loads then allocate nothing.

mod elliptic_contact;
mod fastsim;
pub mod polach;
pub mod shen_hedrick_elkins;
mod warnings;

use std::f64::consts::PI;
use std::sync::Arc;

use crate::error::Error;
use crate::grid::Grid;
use crate::heat::peclet::semi_axes;
use crate::kinematics::{Kinematics, ReferencePoint};
use crate::method::Method;
use crate::normal::NormalContact;
use crate::problem::{Options, Problem};
use crate::quantity::Quantity;
use crate::reference_point::{self, Moved};
use crate::solution::{
    Area, Fields, Instant, Power, Resultant, Solution, Status, Temperature, Work,
};
use crate::state::State;
use crate::summary;

pub use elliptic_contact::{EllipticContact, friction_state};

use elliptic_contact::friction_limit;
use fastsim::Fastsim;

/// What a method does not give.
const UNKNOWN: f64 = f64::NAN;

/// A contact that is set up for one of the fast methods.
#[derive(Debug)]
pub struct FastContact {
    problem: Problem,
    options: Options,
    contact: EllipticContact,
    fastsim: Option<Fastsim>,
    /// Where the reference point lies in the contact frame (x and y in m), if it is another one
    /// than that frame's origin, at which the problem above has its creepages.
    place: Option<[f64; 2]>,
}

impl FastContact {
    /// Sets up a problem for the method of the options.
    ///
    /// # Errors
    /// The full method, a history or an initial state, and whatever [`Problem::check`] and
    /// [`Options::check`] refuse.
    pub fn new(problem: &Problem, options: &Options) -> Result<Self, Error> {
        options.check()?;
        check(problem, options)?;
        match Moved::from(problem)? {
            None => Self::at_patch(problem, options),
            Some(Moved { problem, place }) => {
                Ok(Self { place: Some(place), ..Self::at_patch(&problem, options)? })
            }
        }
    }

    /// The same of a problem with its creepages at the middle of the patch.
    fn at_patch(problem: &Problem, options: &Options) -> Result<Self, Error> {
        let fastsim = match options.method {
            Method::Fastsim(brush) => Some((brush, None)),
            Method::ModifiedFastsim(brush, reduction) => Some((brush, Some(reduction))),
            _ => None,
        };
        let normal = problem.normal.normal_contact(None)?;
        let set_up = |kind| Fastsim::new(problem, options, kind, &normal);
        let fastsim = fastsim.map(set_up).transpose()?;
        let contact = EllipticContact::of(problem, normal.summary)?;
        Ok(Self {
            problem: problem.clone(),
            options: options.clone(),
            contact,
            fastsim,
            place: None,
        })
    }

    /// The contact as the method sees it.
    pub fn contact(&self) -> &EllipticContact {
        &self.contact
    }

    /// Takes over another problem; the set-up stays where the bodies and the normal contact do.
    pub fn set_problem(&mut self, problem: &Problem) -> Result<(), Error> {
        let bodies = |problem: &Problem| [problem.wheel.material, problem.rail.material];
        let fits = Arc::ptr_eq(&self.problem.normal, &problem.normal)
            && bodies(&self.problem) == bodies(problem);
        if !fits {
            *self = Self::new(problem, &self.options)?;
            return Ok(());
        }
        check(problem, &self.options)?;
        if let Some(Moved { problem, place }) = Moved::from(problem)? {
            (self.problem, self.place) = (problem, Some(place));
        } else {
            self.problem.clone_from(problem);
            self.place = None;
        }
        if let Some(fastsim) = &mut self.fastsim {
            fastsim.set_friction(&self.problem);
        }
        Ok(())
    }

    /// Takes over another load (in N); the patch grows as its source says. Allocates nothing, unless that
    /// changes its shape.
    pub fn set_load(&mut self, load: f64) -> Result<(), Error> {
        let contact = self.problem.normal.normal_contact(Some(load))?;
        if self.problem.normal.growth().is_none() {
            return self.set_contact(&contact);
        }
        let (normal, before) = (contact.summary, self.contact.normal);
        if let Some(fastsim) = &mut self.fastsim {
            fastsim.rescale(
                normal.semi_axis_x / before.semi_axis_x,
                normal.peak_pressure / before.peak_pressure,
            );
        }
        self.contact.normal = normal;
        Ok(())
    }

    /// Takes over a normal contact of another shape.
    fn set_contact(&mut self, contact: &NormalContact) -> Result<(), Error> {
        self.contact = EllipticContact::of(&self.problem, contact.summary)?;
        if let Some(fastsim) = &mut self.fastsim {
            *fastsim = Fastsim::new(&self.problem, &self.options, fastsim.kind(), contact)?;
        }
        Ok(())
    }

    /// Forces and moment on the wheel that moves like this; a moment that the method does not give is
    /// NaN. Allocates nothing.
    ///
    /// # Errors
    /// Whatever [`Kinematics::check`] refuses.
    pub fn force(&mut self, motion: &Kinematics) -> Result<Resultant, Error> {
        motion.check()?;
        let Some(place) = self.place else {
            self.problem.kinematics = *motion;
            return Ok(self.present_force());
        };
        self.problem.kinematics = reference_point::at_patch(motion, place);
        Ok(self.present_force().about(place))
    }

    fn present_force(&mut self) -> Resultant {
        let (problem, contact) = (&self.problem, &self.contact);
        let motion = &problem.kinematics;
        let limit = || friction_limit(problem, contact.normal.load);
        match (self.options.method, &mut self.fastsim) {
            (_, Some(fastsim)) => fastsim.force(problem, contact),
            (Method::ShenHedrickElkins, _) => shen_hedrick_elkins::force(contact, motion, limit()),
            (Method::Polach(reduction), _) => polach::force(contact, motion, limit(), reduction),
            _ => contact.linear_force(motion),
        }
    }

    /// The solution of the problem. Where the method has no fields there are no cells, and temperatures,
    /// areas of stick and slip, and whatever else it does not know are NaN.
    pub fn solution(&mut self) -> Solution {
        let solution = self.solution_at_patch();
        match self.place {
            None => solution,
            Some(place) => reference_point::back(solution, &self.problem, place),
        }
    }

    /// The same with the middle of the patch as its reference point.
    fn solution_at_patch(&mut self) -> Solution {
        let force = self.present_force();
        let (problem, normal) = (&self.problem, &self.contact.normal);
        let limit = friction_limit(problem, normal.load);
        let warnings = warnings::of(problem, normal, self.options.method, &force, limit);
        let mut account = summary::Account {
            method: self.options.method,
            status: Status::Converged,
            residual: 0.0,
            history: Vec::new(),
            warnings,
            sensitivity: None,
            work: Work::default(),
            state: State { grid: Grid::default(), time: 0.0, elements: Vec::new() },
        };
        // What is dissipated in steady rolling is what the creep forces put in.
        let creep_power = summary::creep_power(&problem.kinematics, &force);
        let mut instant = Instant {
            time: 0.0,
            distance: 0.0,
            kinematics: problem.kinematics,
            load: normal.load,
            force,
            friction_power: creep_power,
            creep_power,
            stored_energy: UNKNOWN,
            max_rise: f64::NAN,
            newton_iterations: 0,
            residual: 0.0,
        };
        if let Some(fastsim) = &mut self.fastsim {
            let now = fastsim.snapshot(problem);
            instant.max_rise = summary::temperature(&fastsim.patch, &now).max_rise;
            instant.friction_power = summary::power(&fastsim.patch, &now, &force).friction;
            account.history = vec![instant];
            let seen = (normal, &fastsim.patch, &now);
            account.warnings.extend(summary::caveats::of_temperatures(problem, seen));
            account.work.cells = fastsim.patch.len();
            let patch = (normal, &fastsim.patch, &now);
            let mut solution = summary::solution(problem, &self.options, patch, account);
            if problem.heat.model.is_some() {
                solution.warnings.extend(warnings::of_power(&solution.power));
            }
            return solution;
        }
        account.history = vec![instant];
        self.without_fields(force, account)
    }

    fn without_fields(&self, force: Resultant, account: summary::Account) -> Solution {
        let (problem, normal) = (&self.problem, self.contact.normal);
        let motion = problem.kinematics;
        let contact_area = PI * normal.semi_axis_x * normal.semi_axis_y;
        // What is dissipated in steady rolling is what the creep forces put in.
        let creep = summary::creep_power(&motion, &force);
        let shares = problem.conduction(&motion).shares();
        let [into_wheel, into_rail] = shares.map(|share| share * creep);
        Solution {
            method: account.method,
            status: account.status,
            residual: account.residual,
            normal,
            reference: ReferencePoint::Patch,
            kinematics: motion,
            force,
            normalised: summary::normalised(problem, &normal, &force),
            traction_coefficient: force.x.hypot(force.y) / normal.load,
            power: Power {
                friction: creep,
                creep,
                returned: 0.0,
                into_wheel,
                into_rail,
                exchanged: UNKNOWN,
            },
            t_gamma: summary::t_gamma(&motion, &force),
            temperature: Temperature {
                max_rise: UNKNOWN,
                max_rise_wheel: UNKNOWN,
                max_rise_rail: UNKNOWN,
                max_wheel: UNKNOWN,
                max_rail: UNKNOWN,
                x: UNKNOWN,
                y: UNKNOWN,
            },
            peclet: problem.peclet(&motion, semi_axes(&normal)).numbers,
            area: Area { contact: contact_area, stick: UNKNOWN, slip: UNKNOWN },
            fields: Fields::default(),
            history: account.history,
            warnings: account.warnings,
            sensitivity: None,
            work: account.work,
            state: account.state,
        }
    }
}

/// Checks what can be checked before the set-up.
fn check(problem: &Problem, options: &Options) -> Result<(), Error> {
    problem.check()?;
    if options.method == Method::Full {
        return Err(Error::OtherMethod { reason: "a fast method is needed", method: "full" });
    }
    let what = "a fast method is for";
    if problem.history.is_some() {
        return Err(Error::NotSteady { quantity: Quantity::Time, what });
    }
    if problem.initial_state.is_some() {
        return Err(Error::NotSteady { quantity: Quantity::InitialState, what });
    }
    Ok(())
}
