//! A wheel of a wheelset on its rail: its contacts, their creepages and forces.

use std::sync::Arc;

use super::contact_force::{in_plane, parts};
use super::contact_plane::Joining;
use super::coupled::{self, Coupled};
use super::creepage::Motion;
use super::drive::Drive;
use super::equilibrium::{Guess, Lowered, Lowering, Tractions};
use super::gap::Gap;
use super::holes;
use super::opening::Opening;
use super::pair::Pair;
use super::pose::{Attitude, minus, plus};
use super::pressing::Accuracy;
use super::rows::{CONFORMAL, RowsMove};
use super::side::{Side, Sides};
use super::sliding::{Slid, Sliding, Tangential, turn, uneven_curvature};
use super::turning::Turning;
use super::virtual_penetration::NormalMethod;
use crate::interface::friction::Variation;
use crate::problem::{Options, Problem};
use crate::reporting::{
    Error, Quantity, Requirement, Warning, Watch, WheelRailError, require, require_finite,
    require_positive,
};
use crate::solution::{Solution, Status};
use crate::solver::Solver;

/// Position of a wheelset in the track: x forwards, y to the left, z up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Position {
    /// Lateral position of the middle of the axle, in m.
    pub lateral: f64,
    /// Yaw angle about z, in rad.
    pub yaw: f64,
    /// Roll angle about x, in rad.
    pub roll: f64,
}

/// What determines the height of a wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Support {
    /// The vertical force on the wheel, in N.
    Force(f64),
    /// The height of the middle of the axle above the nominal radius over z = 0 of the track, in
    /// m.
    Height(f64),
}

/// A wheel on a rail.
#[derive(Debug, Clone)]
pub struct WheelOnRail {
    /// Profiles and where they are, each as seen from the left.
    pub pairs: Sides<Arc<Pair>>,
    /// Which wheel.
    pub side: Side,
    /// Where the wheelset is.
    pub position: Position,
    /// How it moves.
    pub motion: Motion,
    /// Whether a wheel under a force follows surfaces that change along the way: its vertical
    /// velocity is then that with which they raise and lower it, in place of that of its motion.
    pub follows: bool,
    /// What turns it: with a force the angular velocity of its motion is found, and that given is
    /// not used.
    pub drive: Drive,
    /// What carries it.
    pub support: Support,
    /// Which contacts share a plane.
    pub joining: Joining,
    /// With what the rows of a contact move.
    pub rows: RowsMove,
    /// A factor of friction over the inclination of the rail's profile, if there is one.
    pub friction_variation: Option<Variation>,
    /// How the normal contacts are found.
    pub normal_method: NormalMethod,
    /// Number of cells across a contact each way on which its pressure is found.
    pub cells: usize,
}

/// A contact of a wheel on a rail. Its frame: x along the rail, y to the left along the surface,
/// and z along the outward normal of the rail, with the origin at the contact's position.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Where it is in the track, in m.
    pub position: [f64; 3],
    /// Angle of the plane in rad, positive where the rail's outward normal leans to the left.
    pub angle: f64,
    /// Angle by which the plane rises forwards, with the rail, in rad.
    pub rise: f64,
    /// Distance outwards from the origin of the rail's profile, in m.
    pub rail_position: f64,
    /// Arc length along the rail's profile, to the left, in m.
    pub rail_arc: f64,
    /// Distance outwards from the origin of the wheel's profile, in m.
    pub wheel_position: f64,
    /// Radius of the wheel there, in m.
    pub rolling_radius: f64,
    /// Angle by which the rail's surface turns over the contact, in rad.
    pub turn: f64,
    /// Its problem.
    pub problem: Problem,
    /// Its solution. Creepages and moment are those at the origin of the frame.
    pub solution: Solution,
}

impl Contact {
    /// Whether its rows move otherwise than its plane.
    fn has_rows(&self) -> bool {
        self.problem.normal.normal_contact(None).is_ok_and(|contact| contact.rows.is_some())
    }
}

/// A wheel near one that is sought.
#[derive(Debug, Clone)]
pub(super) struct Near {
    /// Where the wheelset is.
    pub position: Position,
    pub lowered: Lowered,
    /// Friction of its contacts as seen from the left.
    pub tractions: Vec<Tractions>,
    /// Angular velocity from which another one is sought, in rad/s.
    pub turned: Option<f64>,
}

/// A wheel with its contacts.
#[derive(Debug, Clone)]
pub struct WheelSolution {
    /// Which wheel.
    pub side: Side,
    /// Where the wheelset is.
    pub position: Position,
    /// Height of the middle of the axle above the nominal radius over z = 0 of the track, in m.
    pub height: f64,
    /// Its contacts, the one with the largest normal force first.
    pub contacts: Vec<Contact>,
    /// Angular velocity about the axle in rad/s, given or found.
    pub angular_velocity: f64,
    /// Force on the wheel in the track, in N.
    pub force: [f64; 3],
    /// Rounds between height and friction.
    pub rounds: usize,
    /// Vertical force over that asked for, minus one; dimensionless. It is not small where the
    /// force jumps over the load as the wheel is lowered.
    pub(super) residual: f64,
    /// Height of this wheel above the other one of the wheelset, in m: it is not small where the
    /// heights jump as the wheelset rolls.
    pub(super) unevenness: f64,
    rows: RowsMove,
    /// From which a wheel nearby is found.
    pub(super) near: Near,
    /// Whether its contacts are on the curved surface of the rail.
    is_conformal: bool,
    /// Whether one of the profiles was smoothed.
    is_smoothed: bool,
    /// About the profiles under its contacts.
    of_profiles: Vec<Warning>,
}

impl WheelSolution {
    /// Whether all contacts converged and carry the vertical force.
    pub fn status(&self) -> Status {
        let is = |contact: &Contact| contact.solution.status == Status::Converged;
        let is_carried = self.residual.abs() <= LARGEST_JUMP;
        if is_carried && self.contacts.iter().all(is) {
            Status::Converged
        } else {
            Status::NotConverged
        }
    }

    /// Depth below first touch, in m.
    pub fn depth(&self) -> f64 {
        self.near.lowered.at.depth
    }

    /// With what the options ask for beyond the motion, by what has solved each contact.
    pub(super) fn completed(
        mut self,
        solvers: Vec<Box<dyn Solver>>,
        tangential: &Tangential,
        watch: Watch,
    ) -> Result<Self, Error> {
        let options = tangential.options;
        for (Contact { problem, solution, .. }, mut solver) in self.contacts.iter_mut().zip(solvers)
        {
            let (earlier, status) = (solution.work, solution.status);
            let missed = solution.warnings.iter().find(|warning| warning.is_of_pressure()).cloned();
            if options.extrapolate {
                *solution = tangential.solver(options).solve(problem, watch)?;
            } else if options.sensitivity && earlier.steps == 0 {
                let found = solver.solve_given_with_derivatives(problem, watch)?;
                *solution = found.unwrap_or_else(|| solution.clone());
            } else {
                continue;
            }
            coupled::finish(problem, solution, None);
            if let Some(missed) = missed {
                solution.status = status;
                solution.warnings.insert(0, missed);
            }
            solution.work.newton_iterations += earlier.newton_iterations;
            solution.work.operator_products += earlier.operator_products;
        }
        Ok(self)
    }

    /// What to know of a result that is about the first contact only.
    pub fn other_contacts(&self) -> Option<Warning> {
        let loads = self.contacts.iter().map(|contact| contact.solution.normal.load);
        let share = loads.clone().next()? / loads.sum::<f64>();
        let contacts = self.contacts.len();
        (contacts > 1).then_some(Warning::OneContact { contacts, share })
    }

    /// Warnings about the wheel, and those of its contacts but the first, whose are those of its
    /// solution.
    pub fn further_warnings(&self) -> Vec<Warning> {
        let others = self.contacts.iter().skip(1);
        let others = others.flat_map(|contact| contact.solution.warnings.iter().cloned());
        self.warnings().into_iter().chain(others).collect()
    }

    /// Warnings about the contacts as parts of a wheel.
    pub fn warnings(&self) -> Vec<Warning> {
        let warning = |contact: &Contact| {
            let (turn, is_found) = (contact.turn, contact.has_rows());
            let is_missed = self.rows.share(turn) > 0.0 && !is_found;
            let has_rows = is_found && contact.solution.method.has_fields();
            (turn > CONFORMAL && !self.is_conformal || is_missed)
                .then_some(Warning::ConformalContact { turn, has_rows })
        };
        let turned = self.contacts.iter().filter_map(warning);
        let parts = self.contacts.iter().map(|contact| contact.solution.normal.parts);
        let rough = parts.max().filter(|parts| !self.is_smoothed && *parts >= MANY_PARTS);
        let jump = (self.residual.abs() > SETTLED)
            .then_some(Warning::JumpingForce { residual: self.residual });
        let uneven = (self.unevenness.abs() > UNEVEN)
            .then_some(Warning::JumpingHeight { difference: self.unevenness });
        let jump = jump.into_iter().chain(uneven);
        let rough = rough.map(|parts| Warning::RoughProfile { parts });
        turned.chain(rough).chain(jump).chain(self.of_profiles.iter().cloned()).collect()
    }
}

/// A wheel, and what has solved each of its contacts.
pub(super) type Found = (WheelSolution, Vec<Box<dyn Solver>>);

/// Parts of a patch that two smooth profiles hardly have.
const MANY_PARTS: usize = 3;

/// Error of the vertical force at which height and friction count as settled, dimensionless.
pub(super) const SETTLED: f64 = 1e-4;

/// The same while they are approached on coarse cells.
pub(super) const NEARLY_SETTLED: f64 = 3e-3;

/// Largest error where the force jumps over the load with which a wheel counts as converged,
/// dimensionless: what cells that come and go make of the force at a steep flange.
const LARGEST_JUMP: f64 = 3e-3;

/// Difference in height of the wheels of a wheelset above which it is told, in m.
const UNEVEN: f64 = 2e-6;

impl WheelOnRail {
    /// Checks position, motion and support.
    pub fn check(&self) -> Result<(), Error> {
        let Motion { speed, lateral_velocity, vertical_velocity, angular_velocity, .. } =
            self.motion;
        require_positive(Quantity::Speed, speed)?;
        require_finite(Quantity::LateralVelocity, lateral_velocity)?;
        require_finite(Quantity::VerticalVelocity, vertical_velocity)?;
        if !self.drive.is_force() {
            require_positive(Quantity::AngularVelocity, angular_velocity)?;
        }
        require_finite(Quantity::RollRate, self.motion.roll_rate)?;
        require_finite(Quantity::YawRate, self.motion.yaw_rate)?;
        let curve = Requirement::Radius(1.0, f64::INFINITY);
        let radius = self.motion.curve_radius;
        require(Quantity::CurveRadius, curve, radius)?;
        if radius.is_finite() && self.pair().roller.is_some() {
            return Err(WheelRailError::RollersInCurve { radius }.into());
        }
        self.drive.check()?;
        let angle = Requirement::Inside(-1.0, 1.0);
        require_finite(Quantity::LateralPosition, self.position.lateral)?;
        require(Quantity::WheelsetYaw, angle, self.position.yaw)?;
        require(Quantity::RollAngle, angle, self.position.roll)?;
        let cells = Requirement::Between(16.0, 512.0);
        require(Quantity::NormalCells, cells, self.cells as f64)?;
        match self.support {
            Support::Force(force) => require_positive(Quantity::Load, force),
            Support::Height(height) => require_finite(Quantity::WheelsetHeight, height),
        }
    }

    /// Its own profiles, and where they are.
    pub fn pair(&self) -> &Pair {
        self.pairs.of(self.side)
    }

    fn attitude(&self) -> Attitude {
        let Position { lateral, yaw, roll } = self.position;
        Attitude::of(self.side, [lateral, roll, yaw])
    }

    /// The contacts, and the height if the vertical force is given.
    ///
    /// # Errors
    /// A wheel beside the rail or lifted off it, jammed by friction, or in contact at the end of a
    /// profile; whatever the tangential problem rejects; [`Error::Stopped`].
    pub fn solve(&self, tangential: &Tangential, watch: Watch) -> Result<WheelSolution, Error> {
        let (wheel, solvers) = self.solve_near(None, tangential, watch)?;
        wheel.completed(solvers, tangential, watch)
    }

    /// The same from a wheel nearby.
    pub(super) fn solve_near(
        &self,
        near: Option<&Near>,
        tangential: &Tangential,
        watch: Watch,
    ) -> Result<Found, Error> {
        self.check()?;
        tangential.check(self.motion.speed)?;
        let is_conformal = self.normal_method == NormalMethod::Conformal;
        if is_conformal && tangential.interface.elasticity.curved(0.0).is_none() {
            return Err(WheelRailError::NoCurvedSurface {}.into());
        }
        if self.normal_method != NormalMethod::HalfSpaces && self.pair().relief.is_some() {
            return Err(WheelRailError::VaryingProfiles {}.into());
        }
        let gap = Gap::new(self.pair(), &self.attitude())?;
        let lowering = self.lowering(&gap, tangential, watch);
        match self.support {
            Support::Height(height) => self.solve_at(&lowering, (height, near), tangential, watch),
            Support::Force(force) => self.settle(&lowering, (force, near), tangential, watch),
        }
    }

    fn lowering<'a>(
        &'a self,
        gap: &'a Gap,
        tangential: &Tangential,
        watch: Watch<'a>,
    ) -> Lowering<'a> {
        let (pair, joining, attitude) = (self.pair(), self.joining, self.attitude());
        let contact_modulus = tangential.interface.contact_modulus();
        let (method, poisson_ratio) = (self.normal_method, tangential.interface.poisson_ratio());
        Lowering { pair, gap, attitude, joining, contact_modulus, poisson_ratio, method, watch }
    }

    pub(super) fn sliding<'a>(
        &'a self,
        (lowering, lowered): (&'a Lowering<'a>, &'a Lowered),
        (tangential, options): (&'a Tangential<'a>, &'a Options),
        watch: Watch<'a>,
    ) -> Sliding<'a> {
        let (side, drive, rows) = (self.side, self.drive, self.rows);
        let motion = match side {
            Side::Left => self.motion,
            Side::Right => self.motion.mirrored(),
        };
        let variation = self.friction_variation.as_ref();
        let pair = self.pair();
        let is_varying = pair.wheel().is_varying() || pair.rail().is_varying();
        let follows = self.follows && is_varying && matches!(self.support, Support::Force(_));
        Sliding {
            side,
            motion,
            follows,
            drive,
            rows,
            variation,
            lowering,
            lowered,
            tangential,
            options,
            watch,
        }
    }

    /// The contacts without friction.
    pub(super) fn frictionless(
        &self,
        accuracy: Accuracy,
        (tangential, watch): (&Tangential, Watch),
    ) -> Result<Lowered, Error> {
        let gap = Gap::new(self.pair(), &self.attitude())?;
        let lowering = self.lowering(&gap, tangential, watch);
        match self.support {
            Support::Force(force) => {
                let guess = first_guess(&lowering, force);
                lowering.carrying(force, &[], guess, (accuracy, SETTLED))
            }
            Support::Height(height) => {
                lowering.lowered(Guess::smooth(lowering.depth(height)?), &[], accuracy)
            }
        }
    }

    /// What the tractions of contacts do.
    pub(super) fn tractions(&self, solved: &[Slid]) -> Result<Vec<Tractions>, Error> {
        let of = |slid: &Slid| {
            let (pressed, problem, solution) = slid;
            let force = in_plane(self.pair(), self.side, slid).map(|part| part / pressed.force);
            let opening = Opening::new((pressed, problem, solution), self.side)?.map(Arc::new);
            Ok(Tractions { origin: pressed.plane.origin, force, opening })
        };
        solved.iter().map(of).collect()
    }

    pub(super) fn found(
        &self,
        lowering: &Lowering,
        Coupled { lowered, turning, tractions }: Coupled,
        rounds: usize,
    ) -> Result<Found, Error> {
        if let Some(missed) = turning.missed {
            return Err(missed.into());
        }
        let turned = turning.nearby();
        let Turning { angular_velocity, contacts, solvers, .. } = turning;
        let mut with_solvers: Vec<_> = contacts.into_iter().zip(solvers).collect();
        with_solvers.sort_by(|(one, _), (two, _)| two.0.force.total_cmp(&one.0.force));
        let (solved, solvers): (Vec<Slid>, Vec<_>) = with_solvers.into_iter().unzip();
        let of_profiles = solved.iter().flat_map(|(pressed, ..)| {
            let holes = holes::under(self.pair(), pressed).into_iter();
            holes.chain(uneven_curvature(self.pair(), pressed))
        });
        let of_profiles = of_profiles.collect();
        let parts = solved.iter().flat_map(|slid| parts(self.pair(), self.side, slid));
        let [x, y, z] = parts.map(|part| part.force()).fold([0.0; 3], plus);
        let force = [x, self.side.outwards() * y, z];
        let contacts: Vec<Contact> =
            solved.into_iter().map(|solved| self.contact(lowering, &lowered, solved)).collect();
        let wheel = WheelSolution {
            side: self.side,
            position: self.position,
            height: lowering.touch() - lowered.at.depth,
            contacts,
            near: Near { position: self.position, lowered, tractions, turned },
            angular_velocity,
            force,
            residual: 0.0,
            unevenness: 0.0,
            rows: self.rows,
            rounds,
            is_conformal: self.normal_method == NormalMethod::Conformal,
            is_smoothed: self.pair().wheel.is_smoothed() || self.pair().rail.is_smoothed(),
            of_profiles,
        };
        Ok((wheel, solvers))
    }

    fn contact(
        &self,
        lowering: &Lowering,
        lowered: &Lowered,
        (pressed, problem, solution): Slid,
    ) -> Contact {
        let pair = self.pair();
        let pose = pair.wheel_in(&lowering.pose(lowered.at.depth));
        let plane = &pressed.plane;
        let sign = self.side.outwards();
        let [x, y, z] = plane.origin;
        let on_wheel = pose.in_body(minus(plane.origin, pose.centre));
        Contact {
            position: [x, sign * y, z],
            angle: -sign * plane.inclination,
            rise: plane.rise,
            rail_position: y - pair.rail_origin[0],
            rail_arc: sign * plane.arcs[0],
            wheel_position: on_wheel[1] - pair.wheel_offset,
            rolling_radius: on_wheel[0].hypot(on_wheel[2]),
            turn: turn(pair, &pressed),
            problem,
            solution,
        }
    }
}

/// A first guess of the depth: 20 µm under 10 kN, growing as by Hertz.
pub(super) fn first_guess(lowering: &Lowering, force: f64) -> Guess {
    let slope = lowering.gap.least().map_or(1.0, |point| point.inclination.cos());
    Guess::smooth(2e-5 * (force / 1e4).powf(2.0 / 3.0) / slope.max(0.2))
}
