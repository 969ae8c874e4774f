//! The angular velocity of a wheel, given or that under a force or a torque.
//!
//! The share of a longitudinal force in the normal force, positive in braking, is that of the goal,
//! and the creepage of the whole wheel the free one. The share rises through free rolling up to its
//! peaks on both sides; of falling friction only the state on the rising branch is sought.

use nalgebra::{DMatrix, DVector};

use super::contact_force::{Part, parts};
use super::drive::{Along, Drive};
use super::pose::{dot, plus};
use super::pressed::Pressed;
use super::sliding::{ContactSolver, Slid, Sliding};
use crate::bodies::Kinematics;
use crate::problem::Direction;
use crate::reporting::{Error, ForceError, Quantity, WheelRailError};
use crate::solution::{Resultant, Solution};
use crate::solver::prescribed::{Responds, Response, Search, linear_share};
use crate::solver::simplified::EllipticContact;
use crate::solver::{Solver, settings};

/// A wheel that turns, with its contacts.
pub(super) struct Turning {
    /// About the axle, in rad/s.
    pub angular_velocity: f64,
    pub contacts: Vec<Slid>,
    /// What has solved each contact.
    pub solvers: Vec<Box<dyn Solver>>,
    /// Why it does not have the prescribed force, if so; it is then the nearest one found.
    pub missed: Option<ForceError>,
}

impl Turning {
    /// Its angular velocity (in rad/s) as a place from which another one is sought: only where
    /// friction does not fall, beyond whose peak the search would end.
    pub fn nearby(&self) -> Option<f64> {
        let rises =
            self.contacts.iter().all(|(_, problem, _)| problem.interface.has_constant_bound());
        (rises && self.missed.is_none()).then_some(self.angular_velocity)
    }
}

impl Sliding<'_> {
    /// The contacts at the angular velocity of the wheel's motion, or at the one (sought from
    /// `near`, in rad/s, if there is a solution nearby) that causes the prescribed force.
    pub fn solve(&self, near: Option<f64>) -> Result<Turning, Error> {
        let (quantity, value) = match self.drive {
            Drive::AngularVelocity => {
                let angular_velocity = self.motion.angular_velocity;
                let (mut contacts, mut solvers) = (Vec::new(), Vec::new());
                for (pressed, mut solver) in self.contacts() {
                    let problem = solver.problem(self, pressed, angular_velocity)?;
                    let solution = solver.solver.solve(&problem, self.watch)?;
                    contacts.push((pressed.clone(), problem, solution));
                    solvers.push(solver.solver);
                }
                return Ok(Turning { angular_velocity, contacts, solvers, missed: None });
            }
            Drive::Force { force, .. } => (Quantity::ForceX, force),
            Drive::OverLoad(coefficient) => (Quantity::ForceOverLoad, coefficient),
            Drive::Torque(torque) => (Quantity::WheelTorque, torque),
        };
        let mut states = States::new(self)?;
        let force_unit = states.force_unit;
        let target = DVector::from_element(1, value / force_unit);
        let near = near.map(|near| (1.0 - near / states.free) / states.creepage_unit);
        let share = target[0].abs();
        let guess = (share < 1.0).then(|| linear_share(share) * target[0].signum());
        let tolerance = settings::accuracy_of_forces() * self.options.tolerance;
        let mut search = Search::new(&mut states, (&target, tolerance));
        let mut found = match near.or(guess) {
            Some(guess) => search.near(DVector::from_element(1, guess))?,
            None => None,
        };
        found = found.filter(|state| !state.falls());
        let mut missed = None;
        if found.is_none() {
            let path = search.follow(true)?;
            found = path.states.into_iter().next();
            if let (None, Some(state)) = (&found, path.largest) {
                let largest = force_unit * state.forces[0];
                missed = Some(if path.is_complete {
                    let (limit, has_others) = (None, false);
                    ForceError::Unreachable { quantity, value, largest, limit, has_others }
                } else {
                    ForceError::NotFound { quantity, value, nearest: largest }
                });
                found = Some(state);
            }
        }
        let Some(found) = found else { return Err(WheelRailError::Unsolved {}.into()) };
        let creepage = found.creepages[0];
        let contacts = match states.last.take() {
            Some((place, contacts)) if place == creepage => contacts,
            _ => states.at(creepage)?.0,
        };
        let angular_velocity = states.angular_velocity(creepage);
        let solvers = states.contacts.into_iter().map(|(_, solver)| solver.solver).collect();
        Ok(Turning { angular_velocity, contacts, solvers, missed })
    }
}

/// The states of a wheel at one angular velocity after the other.
struct States<'a> {
    sliding: &'a Sliding<'a>,
    /// Angular velocity without creepage, in rad/s.
    free: f64,
    /// Braking with the friction of the normal force, in the unit of what is prescribed: negative
    /// where that is positive in driving.
    force_unit: f64,
    /// The creepage that would cause it if everything stuck, dimensionless.
    creepage_unit: f64,
    contacts: Vec<(&'a Pressed, ContactSolver)>,
    /// The last state, with its creepage.
    last: Option<(f64, Vec<Slid>)>,
    /// Newton steps and products of each contact so far.
    work: Vec<(usize, f64)>,
}

impl<'a> States<'a> {
    fn new(sliding: &'a Sliding<'a>) -> Result<Self, Error> {
        let (free, mut contacts) = (sliding.free_turning(), sliding.contacts());
        let (mut normal, mut friction, mut stiffness) = (0.0, 0.0, 0.0);
        for (pressed, solver) in &mut contacts {
            let problem = solver.problem(sliding, pressed, free)?;
            let contact = EllipticContact::new(&problem)?;
            normal += pressed.force;
            friction += pressed.force * problem.interface.friction.cold_coefficient();
            stiffness += contact.linear_force(&Direction::X.unit()).x.abs();
        }
        let limit = if friction > 0.0 { friction } else { normal };
        let force_unit = match sliding.drive {
            Drive::AngularVelocity | Drive::OverLoad(_) => limit / normal,
            Drive::Force { .. } => -limit,
            Drive::Torque(_) => -limit * sliding.lowering.pair.nominal_radius,
        };
        let (creepage_unit, last, work) = (limit / stiffness, None, Vec::new());
        Ok(Self { sliding, free, force_unit, creepage_unit, contacts, last, work })
    }

    fn angular_velocity(&self, creepage: f64) -> f64 {
        self.free * (1.0 - creepage * self.creepage_unit)
    }

    /// The contacts at a creepage, and how their forces change with it, if all are known.
    fn at(&mut self, creepage: f64) -> Result<(Vec<Slid>, Option<Vec<Resultant>>), Error> {
        let (sliding, step) = (self.sliding, settings::difference());
        let [here, more, less] =
            [0.0, step, -step].map(|step| self.angular_velocity(creepage + step));
        let (mut solved, mut slopes) = (Vec::new(), Some(Vec::new()));
        for (pressed, solver) in &mut self.contacts {
            let problem = solver.problem(sliding, pressed, here)?;
            // Creepages are a closed expression of the angular velocity.
            let [more, less] = [more, less].map(|end| sliding.kinematics(pressed, end));
            let change = more.changed(-1.0, &less);
            let change = Kinematics::free_rolling(0.0).changed(0.5 / step, &change);
            let solver = &mut solver.solver;
            let found = solver.solve_with_slopes(&problem, &[change], sliding.watch)?;
            let (solution, slope) = match found {
                Some((solution, slope)) => (solution, slope.into_iter().next()),
                None => (solver.solve(&problem, sliding.watch)?, None),
            };
            slopes = slopes.zip(slope).map(|(before, slope)| [before, vec![slope]].concat());
            solved.push((pressed.clone(), problem, solution));
        }
        count_together(&mut solved, &mut self.work);
        Ok((solved, slopes))
    }
}

impl Responds for States<'_> {
    fn respond(&mut self, creepages: DVector<f64>) -> Result<Option<Response>, Error> {
        let (sliding, creepage) = (self.sliding, creepages[0]);
        let (contacts, slopes) = self.at(creepage)?;
        let parts = |slid: &Slid| parts(sliding.lowering.pair, sliding.side, slid);
        let together = sliding.together(contacts.iter().flat_map(parts));
        let forces = DVector::from_element(1, sliding.value(&together) / self.force_unit);
        // Where a state is found without slopes, that of small creepages.
        let slope = slopes.map_or(1.0, |slopes| {
            let along = contacts.iter().zip(&slopes).map(|((pressed, ..), slope)| {
                Part::whole(&pressed.plane, sliding.side, slope, 0.0)
            });
            sliding.value_along(&together, &sliding.together(along)) / self.force_unit
        });
        let jacobian = DMatrix::from_element(1, 1, slope);
        self.last = Some((creepage, contacts));
        Ok(Some(Response { creepages, forces, jacobian }))
    }

    fn rolls(&self, creepages: &DVector<f64>) -> bool {
        let angular_velocity = self.angular_velocity(creepages[0]);
        let rolls =
            |pressed: &Pressed| self.sliding.kinematics(pressed, angular_velocity).check().is_ok();
        let is_fast = creepages[0] * self.creepage_unit < -settings::spinning();
        angular_velocity > 0.0 && !is_fast && self.sliding.lowered.contacts.iter().all(rolls)
    }
}

/// Force (in N) and torque about the axle (in N m) of all contacts, as seen from the left.
struct Together {
    force: [f64; 3],
    torque: f64,
}

impl Sliding<'_> {
    fn together(&self, parts: impl Iterator<Item = Part>) -> Together {
        let pose = self.pose();
        let none = Together { force: [0.0; 3], torque: 0.0 };
        parts.fold(none, |sum, part| Together {
            force: plus(sum.force, part.force()),
            torque: sum.torque + part.torque(self.lowering.pair, &pose),
        })
    }

    /// What is prescribed, in its unit.
    fn value(&self, Together { force, torque }: &Together) -> f64 {
        match self.drive {
            Drive::AngularVelocity => 0.0,
            Drive::Force { along: Along::Track, .. } => force[0],
            Drive::Force { along: Along::Wheelset, .. } => {
                dot(*force, self.pose().turned([1.0, 0.0, 0.0]))
            }
            Drive::OverLoad(_) => -force[0] / force[2],
            Drive::Torque(_) => -torque,
        }
    }

    /// How it changes.
    fn value_along(&self, at: &Together, change: &Together) -> f64 {
        match self.drive {
            Drive::OverLoad(_) => {
                -(change.force[0] + self.value(at) * change.force[2]) / at.force[2]
            }
            _ => self.value(change),
        }
    }
}

/// Adds the work that contacts took at earlier places of a search to that of theirs, and notes the
/// sum for the next ones.
fn count_together(contacts: &mut [Slid], earlier: &mut Vec<(usize, f64)>) {
    earlier.resize(contacts.len(), (0, 0.0));
    for ((_, _, Solution { work, .. }), earlier) in contacts.iter_mut().zip(earlier) {
        work.newton_iterations += earlier.0;
        work.operator_products += earlier.1 + work.sensitivity_products as f64;
        *earlier = (work.newton_iterations, work.operator_products);
    }
}
