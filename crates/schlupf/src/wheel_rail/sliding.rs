//! The tangential problems of all contacts of a wheel, at a given angular velocity or under a given
//! force.

use super::creepage::{Motion, Moving, creepages};
use super::driven::{Along, Drive, Found, Point, SLOPE, Search};
use super::equilibrium::{Lowered, Lowering};
use super::pair::Pair;
use super::patch::ContactPatch;
use super::pose::{Pose, cross, dot, minus};
use super::pressed::Pressed;
use super::rows::{Passing, RowsMove};
use super::side::Side;
use crate::bodies::{Kinematics, ReferencePoint, RowMotion};
use crate::interface::Interface;
use crate::problem::{Options, PrescribedForces, Problem};
use crate::reporting::{Error, ForceError, Quantity, Watch};
use crate::solution::Solution;
use crate::solver::Solver;

/// Part of a wheel's normal force below which a contact is left out, dimensionless.
const NEGLIGIBLE: f64 = 1e-4;

/// How the tangential problem of each contact is posed and solved.
pub struct Tangential<'a> {
    /// Both bodies and all laws.
    pub interface: &'a Interface,
    /// A solver with given options.
    pub solver: &'a dyn Fn(&Options) -> Box<dyn Solver>,
    /// Options of the results.
    pub options: &'a Options,
}

impl Tangential<'_> {
    /// Options with which the motion is sought: derivatives and extrapolation are of the result.
    pub(super) fn searching(&self) -> Options {
        Options { sensitivity: false, extrapolate: false, ..self.options.clone() }
    }
}

/// A contact with its problem and its solution.
pub(super) type Slid = (Pressed, Problem, Solution);

/// A lowered wheel whose contacts are to be solved.
pub(super) struct Sliding<'a> {
    /// Which wheel.
    pub side: Side,
    /// How the wheelset moves, as seen from the left.
    pub motion: Motion,
    /// What turns it.
    pub drive: Drive,
    /// With what the rows of a contact move.
    pub rows: RowsMove,
    pub lowering: &'a Lowering<'a>,
    pub lowered: &'a Lowered,
    pub tangential: &'a Tangential<'a>,
    pub options: &'a Options,
    pub watch: Watch<'a>,
}

/// A wheel that turns, with its contacts.
pub(super) struct Turning {
    /// About the axle, in rad/s.
    pub angular_velocity: f64,
    pub contacts: Vec<Slid>,
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
        let mut solvers = Vec::new();
        let drive = self.drive;
        let (quantity, value) = match drive {
            Drive::AngularVelocity => {
                let angular_velocity = self.motion.angular_velocity;
                let contacts = self.at(angular_velocity, &mut solvers)?;
                return Ok(Turning { angular_velocity, contacts, missed: None });
            }
            Drive::Force { force, .. } => (Quantity::ForceX, force),
            Drive::OverLoad(coefficient) => (Quantity::ForceOverLoad, coefficient),
            Drive::Torque(torque) => (Quantity::WheelTorque, torque),
        };
        let free = self.free_turning();
        let scale = self.scale();
        let search = Search {
            target: value / scale,
            tolerance: self.options.tolerance,
            start: near.map_or(0.0, |near| 1.0 - near / free),
            slope: SLOPE,
        };
        let mut work = Vec::new();
        let found = search.run(|x| {
            let mut contacts = self.at(free * (1.0 - x), &mut solvers)?;
            count_together(&mut contacts, &mut work);
            Ok((self.value(&contacts) / scale, contacts))
        })?;
        let nearest = |point: &Point<Vec<Slid>>| scale * point.share;
        let (point, missed) = match found {
            Found::At(point) => (point, None),
            Found::Beyond(point) => {
                let (largest, limit, has_others) = (nearest(&point), None, false);
                let missed =
                    ForceError::Unreachable { quantity, value, largest, limit, has_others };
                (point, Some(missed))
            }
            Found::Lost(point) => {
                let missed = ForceError::NotFound { quantity, value, nearest: nearest(&point) };
                (point, Some(missed))
            }
        };
        let angular_velocity = free * (1.0 - point.x);
        Ok(Turning { angular_velocity, contacts: point.state, missed })
    }

    /// Solves all contacts at an angular velocity (in rad/s).
    fn at(
        &self,
        angular_velocity: f64,
        solvers: &mut Vec<Box<dyn Solver>>,
    ) -> Result<Vec<Slid>, Error> {
        let pose = self.pose();
        let largest = self.lowered.contacts.iter().map(|contact| contact.force).fold(0.0, f64::max);
        let sign = self.side.outwards();
        let motion = Motion { angular_velocity, ..self.motion };
        let contacts =
            self.lowered.contacts.iter().filter(|contact| contact.force > NEGLIGIBLE * largest);
        let mut solved = Vec::new();
        for (k, pressed) in contacts.enumerate() {
            let moving = Moving::new(&pose, &pressed.plane, pressed.approach, &motion);
            let here = creepages(&pressed.plane, &moving);
            let rows = self.rows_of(&pose, pressed, (&moving, &here))?;
            let kinematics =
                Kinematics { creepage_y: sign * here.creepage_y, spin: sign * here.spin, ..here };
            let patch = ContactPatch::new(pressed, rows.as_ref(), self.side)?;
            let problem = Problem {
                kinematics,
                prescribed: PrescribedForces::default(),
                reference: ReferencePoint::File,
                normal: patch,
                interface: self.tangential.interface.clone(),
            };
            problem.check()?;
            if k == solvers.len() {
                solvers.push((self.tangential.solver)(self.options));
            }
            let solution = solvers[k].solve(&problem, self.watch)?;
            solved.push((pressed.clone(), problem, solution));
        }
        Ok(solved)
    }

    /// The motion of the rows of a contact beyond that of its plane, if they have any.
    fn rows_of(
        &self,
        pose: &Pose,
        pressed: &Pressed,
        (moving, motion): (&Moving, &Kinematics),
    ) -> Result<Option<RowMotion>, Error> {
        let share = self.rows.share(turn(self.lowering.pair, pressed));
        if share == 0.0 {
            return Ok(None);
        }
        let passing = Passing { pair: self.lowering.pair, pose, plane: &pressed.plane };
        let rows = passing.rows(&touched(pressed), moving, motion)?;
        Ok(rows.map(|rows| if share == 1.0 { rows } else { rows.scaled(share) }))
    }

    fn pose(&self) -> Pose {
        self.lowering.pose(self.lowered.at.depth)
    }

    /// Angular velocity at which the largest contact has no longitudinal creepage, in rad/s.
    fn free_turning(&self) -> f64 {
        let largest = self.lowered.contacts.iter().max_by(|a, b| a.force.total_cmp(&b.force));
        let nominal = self.motion.speed / self.lowering.pair.nominal_radius;
        let motion = Motion { angular_velocity: nominal, ..self.motion };
        largest.map_or(nominal, |pressed| {
            let moving = Moving::new(&self.pose(), &pressed.plane, pressed.approach, &motion);
            nominal * moving.free_rolling()
        })
    }

    /// Braking with the normal force, in the unit of what is prescribed: negative where that is
    /// positive in driving.
    fn scale(&self) -> f64 {
        let normal: f64 = self.lowered.contacts.iter().map(|contact| contact.force).sum();
        match self.drive {
            Drive::AngularVelocity | Drive::OverLoad(_) => 1.0,
            Drive::Force { .. } => -normal,
            Drive::Torque(_) => -normal * self.lowering.pair.nominal_radius,
        }
    }

    /// What is prescribed, as the contacts have it.
    fn value(&self, contacts: &[Slid]) -> f64 {
        let pose = self.pose();
        let sign = self.side.outwards();
        let (mut force, mut torque) = ([0.0; 3], 0.0);
        for (pressed, _, solution) in contacts {
            let plane = &pressed.plane;
            let (normal, across) = (plane.normal(), plane.across());
            let Seen { x, y, moment } = Seen::of(solution, sign);
            let tangential = [0, 1, 2].map(|k| if k == 0 { x } else { y * across[k] });
            for k in 0..3 {
                force[k] += tangential[k] + solution.normal.load * normal[k];
            }
            let arm = minus(plane.origin, pose.centre);
            let turning = cross(arm, tangential);
            let axle = pose.turned([0.0, 1.0, 0.0]);
            // Pressure on a surface of revolution has no moment about its axis.
            torque += dot(turning, axle) + moment * dot(normal, axle);
        }
        match self.drive {
            Drive::AngularVelocity => 0.0,
            Drive::Force { along: Along::Track, .. } => force[0],
            Drive::Force { along: Along::Wheelset, .. } => dot(force, pose.turned([1.0, 0.0, 0.0])),
            Drive::OverLoad(_) => -force[0] / force[2],
            Drive::Torque(_) => -torque,
        }
    }
}

/// Adds the work that contacts took at earlier places of a search to that of theirs, and notes the
/// sum for the next ones.
fn count_together(contacts: &mut [Slid], earlier: &mut Vec<(usize, f64)>) {
    earlier.resize(contacts.len(), (0, 0.0));
    for ((_, _, Solution { work, .. }), earlier) in contacts.iter_mut().zip(earlier) {
        work.newton_iterations += earlier.0;
        work.operator_products += earlier.1;
        *earlier = (work.newton_iterations, work.operator_products);
    }
}

/// Tangential forces (in N) and moment (in N m) of a contact as seen from the left.
struct Seen {
    x: f64,
    y: f64,
    moment: f64,
}

impl Seen {
    fn of(solution: &Solution, sign: f64) -> Self {
        let force = solution.force;
        Self { x: force.x, y: sign * force.y, moment: sign * force.moment_z.unwrap_or(0.0) }
    }
}

/// Angle by which the rail turns between the outmost rows in contact, in rad.
pub(super) fn turn(pair: &Pair, pressed: &Pressed) -> f64 {
    let touched = touched(pressed);
    let (Some(first), Some(last)) = (touched.first(), touched.last()) else { return 0.0 };
    let inclination = |s: &f64| pair.rail.at(pressed.plane.arcs[0] + s).inclination();
    (inclination(last) - inclination(first)).abs()
}

/// Positions s of the rows in contact, in m.
fn touched(pressed: &Pressed) -> Vec<f64> {
    let rows = pressed.pressure.chunks(pressed.x.len());
    let loaded = |row: &[f64]| row.iter().any(|p| *p > 0.0);
    rows.zip(&pressed.s).filter(|(row, _)| loaded(row)).map(|(_, s)| *s).collect()
}
