//! The tangential problems of all contacts of a wheel at an angular velocity.

use std::sync::Arc;

use super::creepage::{Motion, Moving, creepages};
use super::distance::PlaneView;
use super::drive::Drive;
use super::equilibrium::{Lowered, Lowering};
use super::pair::Pair;
use super::patch::ContactPatch;
use super::pose::{Pose, dot};
use super::pressed::Pressed;
use super::rows::{Passing, RowsMove};
use super::side::Side;
use super::time_step::{Past, TimeStep};
use crate::bodies::{Kinematics, ReferencePoint, RowMotion};
use crate::interface::Interface;
use crate::interface::friction::{Across, Friction, Variation};
use crate::normal::PressureSource;
use crate::problem::{Branch, Driver, Method, Options, PrescribedForces, Problem};
use crate::reporting::{Error, Warning, Watch};
use crate::solution::Solution;
use crate::solver::Solver;

/// Part of a wheel's normal force below which a contact is left out, dimensionless.
const NEGLIGIBLE: f64 = 1e-4;

/// How the tangential problem of each contact is posed and solved.
pub struct Tangential<'a> {
    /// Both bodies and all laws.
    pub interface: &'a Interface,
    /// Which of several steady states.
    pub branch: Branch,
    /// All equations, or a fast method.
    pub method: &'a Method,
    /// How the steady state is computed.
    pub driver: Driver,
    /// Options of the results.
    pub options: &'a Options,
    /// What contacts go on from in a step of time; none in steady rolling.
    pub past: Option<Arc<Past>>,
}

impl<'a> Tangential<'a> {
    /// All equations, directly, on the branch from low slip.
    pub fn new(interface: &'a Interface, options: &'a Options) -> Self {
        let (branch, driver) = (Branch::LowSlip, Driver::Steady);
        Self { interface, branch, method: &Method::Full, driver, options, past: None }
    }

    pub(super) fn solver(&self, options: &Options) -> Box<dyn Solver> {
        self.method.solver_by(self.driver, options)
    }

    pub(super) fn check(&self, speed: f64) -> Result<(), Error> {
        self.options.check()?;
        self.interface.check(&Kinematics::free_rolling(speed))
    }

    /// Options with which the motion is sought: derivatives and extrapolation are of the result.
    pub(super) fn searching(&self) -> Options {
        Options { sensitivity: false, extrapolate: false, ..self.options.clone() }
    }
}

/// Angle between the directions of the rail and of the mean curvature above which it is told, in
/// rad: the largest pressure and the approach are then off by 1 or 2 %
/// ([`Warning::UnevenCurvature`]).
const UNEVEN_CURVATURE: f64 = 0.1;

/// A contact with its problem and its solution.
pub(super) type Slid = (Pressed, Problem, Solution);

/// A lowered wheel whose contacts are to be solved.
pub(super) struct Sliding<'a> {
    /// Which wheel.
    pub side: Side,
    /// How the wheelset moves, as seen from the left.
    pub motion: Motion,
    /// Whether it follows the surfaces vertically, in place of the vertical velocity of its motion.
    pub follows: bool,
    /// What turns it.
    pub drive: Drive,
    /// With what the rows of a contact move.
    pub rows: RowsMove,
    /// A factor of friction over the inclination of the rail's profile.
    pub variation: Option<&'a Variation>,
    pub lowering: &'a Lowering<'a>,
    pub lowered: &'a Lowered,
    pub tangential: &'a Tangential<'a>,
    pub options: &'a Options,
    pub watch: Watch<'a>,
}

/// What solves a contact at one angular velocity after the other.
pub(super) struct ContactSolver {
    pub solver: Box<dyn Solver>,
    /// Friction under the contact, once it is known.
    friction: Option<Friction>,
    /// The problem of the last one, if only its motion is another one now.
    problem: Option<Problem>,
}

impl ContactSolver {
    /// The problem of its contact at an angular velocity, in rad/s.
    pub fn problem(
        &mut self,
        sliding: &Sliding,
        pressed: &Pressed,
        angular_velocity: f64,
    ) -> Result<Problem, Error> {
        let kinematics = sliding.kinematics(pressed, angular_velocity);
        let problem = if let Some(problem) = self.problem.take() {
            Problem { kinematics, ..problem }
        } else {
            let rows = sliding.rows_of(pressed, angular_velocity)?;
            let normal = ContactPatch::new(pressed, rows.as_ref(), sliding.side)?;
            let interface = sliding.tangential.interface.clone();
            let friction = match self.friction.take() {
                Some(friction) => friction,
                None => sliding.friction(pressed, &normal, interface.friction)?,
            };
            self.friction = Some(friction.clone());
            let curved =
                pressed.plane.is_curved.then(|| interface.elasticity.curved(pressed.curvature));
            let elasticity = curved.flatten().unwrap_or(interface.elasticity);
            Problem {
                kinematics,
                prescribed: PrescribedForces::default(),
                reference: ReferencePoint::File,
                branch: sliding.tangential.branch,
                normal,
                interface: Interface { elasticity, friction, ..interface },
            }
        };
        problem.check()?;
        self.problem = (sliding.share_of_rows(pressed) == 0.0).then(|| problem.clone());
        Ok(problem)
    }
}

impl Sliding<'_> {
    /// The contacts that are not left out, each with its solver.
    pub fn contacts(&self) -> Vec<(&Pressed, ContactSolver)> {
        let largest = self.lowered.contacts.iter().map(|contact| contact.force).fold(0.0, f64::max);
        let counts = |contact: &&Pressed| contact.force > NEGLIGIBLE * largest;
        let with_solver = |contact| {
            let solver: Box<dyn Solver> = match &self.tangential.past {
                Some(past) => Box::new(TimeStep::new(past, (contact, self.side), self.options)),
                None => self.tangential.solver(self.options),
            };
            (contact, ContactSolver { solver, friction: None, problem: None })
        };
        self.lowered.contacts.iter().filter(counts).map(with_solver).collect()
    }

    /// Creepages of a contact at an angular velocity, in rad/s.
    pub fn kinematics(&self, pressed: &Pressed, angular_velocity: f64) -> Kinematics {
        let here = creepages(&pressed.plane, &self.moving(pressed, angular_velocity));
        let sign = self.side.outwards();
        Kinematics { creepage_y: sign * here.creepage_y, spin: sign * here.spin, ..here }
    }

    fn moving(&self, pressed: &Pressed, angular_velocity: f64) -> Moving {
        let mut motion = Motion { angular_velocity, ..self.motion };
        if self.follows {
            motion.vertical_velocity = self.following(motion);
        }
        self.moving_by(pressed, &motion)
    }

    fn moving_by(&self, pressed: &Pressed, motion: &Motion) -> Moving {
        let bodies = (self.lowering.pair, &self.pose());
        Moving::new(bodies, (&pressed.plane, pressed.approach), motion)
    }

    /// The vertical velocity (in m/s) at which surfaces that change along the way leave the sum of
    /// the vertical forces what it is: contacts are springs of a stiffness in proportion to force
    /// over approach.
    fn following(&self, motion: Motion) -> f64 {
        let Motion { speed, angular_velocity, curve_radius, .. } = motion;
        let along = Motion { curve_radius, ..Motion::straight(speed, angular_velocity) };
        let mut sums = [0.0; 2];
        for contact in self.lowered.contacts.iter().filter(|contact| contact.approach > 0.0) {
            let normal = contact.plane.normal();
            let stiffness = contact.force / contact.approach * normal[2];
            let opening = dot(self.moving_by(contact, &along).velocity([0.0; 3]), normal);
            sums = [sums[0] + stiffness * opening, sums[1] + stiffness * normal[2]];
        }
        if sums[1] > 0.0 { -sums[0] / sums[1] } else { 0.0 }
    }

    /// How much of the motion of its rows a contact takes.
    fn share_of_rows(&self, pressed: &Pressed) -> f64 {
        if pressed.plane.is_curved {
            return 1.0;
        }
        self.rows.share(turn(self.lowering.pair, pressed))
    }

    /// The motion of the rows of a contact beyond that of its plane, if they have any.
    fn rows_of(
        &self,
        pressed: &Pressed,
        angular_velocity: f64,
    ) -> Result<Option<RowMotion>, Error> {
        let share = self.share_of_rows(pressed);
        if share == 0.0 {
            return Ok(None);
        }
        let moving = self.moving(pressed, angular_velocity);
        let motion = creepages(&pressed.plane, &moving);
        let pose = &self.lowering.pair.wheel_in(&self.pose());
        let passing = Passing { pair: self.lowering.pair, pose, plane: &pressed.plane };
        let rows = passing.rows(&touched(pressed), &moving, &motion)?;
        Ok(rows.map(|rows| if share == 1.0 { rows } else { rows.scaled(share) }))
    }

    /// Friction in the contact frame of a patch, which varies with the inclination of the rail.
    fn friction(
        &self,
        pressed: &Pressed,
        patch: &ContactPatch,
        friction: Friction,
    ) -> Result<Friction, Error> {
        let Some(variation) = self.variation else { return Ok(friction) };
        let (pair, plane, sign) = (self.lowering.pair, &pressed.plane, self.side.outwards());
        let [_, middle] = patch.normal_contact(None)?.summary.origin.unwrap_or_default();
        let pose = self.pose();
        let view = PlaneView::new(pair, &pose, plane);
        let inclination = |y: f64| {
            let s = sign * (y + middle);
            let near = plane.arcs[0] + s;
            let arc = view.rail_point(s, near).map_or(near, |point| point.arc);
            let point = pair.rail_profile.point(plane.origin[0], arc);
            point.map_or(0.0, |point| -point.inclination())
        };
        let mut y: Vec<f64> = pressed.s.iter().map(|s| sign * s - middle).collect();
        y.sort_unstable_by(f64::total_cmp);
        let law = Arc::new(Across::new(friction.law, variation.mapped(y, inclination)));
        Ok(Friction { law, ..friction })
    }

    /// That of the wheelset.
    pub fn pose(&self) -> Pose {
        self.lowering.pose(self.lowered.at.depth)
    }

    /// Angular velocity at which the largest contact has no longitudinal creepage, in rad/s.
    pub fn free_turning(&self) -> f64 {
        let largest = self.lowered.contacts.iter().max_by(|a, b| a.force.total_cmp(&b.force));
        let nominal = self.motion.speed / self.lowering.pair.nominal_radius;
        largest.map_or(nominal, |pressed| nominal * self.moving(pressed, nominal).free_rolling())
    }
}

/// Angle by which the rail turns between the outmost rows in contact, in rad.
pub(super) fn turn(pair: &Pair, pressed: &Pressed) -> f64 {
    let touched = touched(pressed);
    let (Some(first), Some(last)) = (touched.first(), touched.last()) else { return 0.0 };
    let inclination = |s: &f64| {
        let point = pair.rail.point(pressed.plane.origin[0], pressed.plane.arcs[0] + s);
        point.map_or(pressed.plane.inclination, |point| point.inclination())
    };
    (inclination(last) - inclination(first)).abs()
}

/// A warning where the direction of the rail over a curved contact differs from that of the
/// curvature with which the half-spaces are bent.
pub(super) fn uneven_curvature(pair: &Pair, pressed: &Pressed) -> Option<Warning> {
    let curvature = pressed.curvature;
    let off = touched(pressed).into_iter().map(|s| pressed.plane.turn(pair, s) + curvature * s);
    let [low, high] = off
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], off| [low.min(off), high.max(off)]);
    let angle = 0.5 * (high - low);
    let is_told = pressed.plane.is_curved && angle > UNEVEN_CURVATURE;
    is_told.then_some(Warning::UnevenCurvature { angle, curvature })
}

/// Positions s of the rows in contact, in m.
fn touched(pressed: &Pressed) -> Vec<f64> {
    let rows = pressed.pressure.chunks(pressed.x.len());
    let loaded = |row: &[f64]| row.iter().any(|p| *p > 0.0);
    rows.zip(&pressed.s).filter(|(row, _)| loaded(row)).map(|(_, s)| *s).collect()
}
