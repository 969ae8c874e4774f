//! What finds the contacts of a wheel on a rail.

use schlupf::bodies::Kinematics;
use schlupf::interface::Interface;
use schlupf::problem::{Branch, Driver, LongitudinalForce, PrescribedForces};
use schlupf::reporting::WheelRailError;
use schlupf::solution::{Resultant, Status, Work};
use schlupf::wheel_rail::{Along, Drive, Tangential, WheelSolution};
use schlupf::{Error, Method, Options, Problem, Solution, Solver, Watch};

use super::wheel_rail::WheelRequest;

/// A wheel on a rail with all laws. As a [`Solver`] it finds states of the whole wheel
/// ([`WheelSolution::resultant`]) for creepages of its nominal radius, or for a longitudinal force;
/// of the problem nothing else matters.
#[derive(Debug, Clone)]
pub struct WheelSolver {
    /// The wheel.
    pub request: WheelRequest,
    /// Both bodies and all laws.
    pub interface: Interface,
    /// Which of several steady states.
    pub branch: Branch,
    /// All equations, or a fast method.
    pub method: Method,
    /// The driver that was asked for.
    pub driver: Option<Driver>,
    /// How accurately.
    pub options: Options,
    /// The rolling radius that goes with creepages, in m.
    pub radius: f64,
    /// A state of the wheel in place of one that is not found.
    pub known: Option<Box<Solution>>,
}

impl WheelSolver {
    /// The contacts of the wheel, or with another lateral position as `place` (in m) those of the
    /// left and of the right wheel resting on both rails.
    pub fn find(&self, place: Option<f64>, watch: Watch) -> Result<Vec<WheelSolution>, Error> {
        let tangential = Tangential {
            branch: self.branch,
            method: &self.method,
            driver: self.driver.unwrap_or_default(),
            ..Tangential::new(&self.interface, &self.options)
        };
        self.request.solve(place, &tangential, watch)
    }

    /// The wheel of the case.
    pub fn find_one(&self, watch: Watch) -> Result<WheelSolution, Error> {
        let found = self.find(None, watch)?.into_iter().next();
        found.ok_or_else(|| WheelRailError::Unsolved {}.into())
    }

    /// The same for forces alone.
    pub fn of_forces(&self) -> Self {
        let options = &self.options;
        let options = Options {
            sensitivity: false,
            extrapolate: false,
            keeps_state: false,
            ..options.clone()
        };
        Self { options, ..self.clone() }
    }

    /// Makes the wheel turn with a creepage of its nominal radius, or as a force makes it.
    fn turn(&mut self, kinematics: &Kinematics, forces: &PrescribedForces) {
        let wheel = self.request.wheel_mut();
        wheel.motion.speed = kinematics.speed;
        wheel.motion.angular_velocity =
            (1.0 - kinematics.creepage_x) * kinematics.speed / self.radius;
        let along = match wheel.drive {
            Drive::Force { along, .. } => along,
            _ => Along::default(),
        };
        wheel.drive = match forces.x {
            None => Drive::AngularVelocity,
            Some(LongitudinalForce::Force(force)) => Drive::Force { force, along },
            Some(LongitudinalForce::OverLoad(coefficient)) => Drive::OverLoad(coefficient),
            Some(LongitudinalForce::Torque { torque, .. }) => Drive::Torque(torque),
        };
    }
}

impl Solver for WheelSolver {
    fn method(&self) -> Method {
        self.method.clone()
    }

    fn options(&self) -> &Options {
        &self.options
    }

    /// The wheel itself finds how it turns under a force.
    fn solve(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error> {
        self.solve_given(problem, watch)
    }

    fn solve_given(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error> {
        self.turn(&problem.kinematics, &problem.prescribed);
        let speed = problem.kinematics.speed;
        let wheel = match (self.find_one(watch), &self.known) {
            (Ok(wheel), _) => wheel,
            (Err(Error::WheelRail { .. }), Some(known)) => {
                return Ok(unknown(&problem.kinematics, known));
            }
            (Err(error), _) => return Err(error),
        };
        let creepage_x = wheel.creepage(self.radius, speed);
        let kinematics = Kinematics { creepage_x, ..Kinematics::free_rolling(speed) };
        wheel.resultant(kinematics).ok_or_else(|| WheelRailError::Unsolved {}.into())
    }

    fn is_of_wheel(&self) -> bool {
        true
    }
}

/// A state that was not found, such as one in which friction holds the wheel: without forces.
fn unknown(kinematics: &Kinematics, known: &Solution) -> Solution {
    let none = Resultant { x: f64::NAN, y: f64::NAN, moment_z: None };
    Solution {
        status: Status::NotConverged,
        residual: f64::NAN,
        kinematics: *kinematics,
        force: none,
        normalised: none,
        traction_coefficient: f64::NAN,
        power: None,
        temperature: None,
        warnings: Vec::new(),
        work: Work::default(),
        ..known.clone()
    }
}
