//! A wheel over time: its contacts go on from each other, step by step.
//!
//! In every step the wheel is lowered until it carries its load with the tractions at the end of
//! that step, from the contacts, the tractions and the depth of the step before. Cells lie on a
//! lattice that moves with the wheelset along the track and stays in place on the rail across it. A
//! contact goes on from the elements on its cells, whichever contacts of the step before left them
//! there: so contacts move across the rail, split and merge. Every part of a history ends with the
//! step whose end is nearest. Of a wheelset that rests on both rails both wheels go on.

use std::sync::Arc;

use super::creepage::Motion;
use super::patch::ContactPatch;
use super::pressing::Accuracy;
use super::resultant::instant;
use super::sliding::Tangential;
use super::time_step::{Left, Past, Step};
use super::wheel::{Position, Support, WheelOnRail, WheelSolution};
use crate::normal::PressureSource;
use crate::numerics::interpolation::mix;
use crate::problem::{Options, part_too_short};
use crate::reporting::{
    Error, Progress, Quantity, Requirement, Stage, Unconverged, Warning, Watch, WheelRailError,
    require, within,
};
use crate::solution::{Instant, Status};

/// A wheel at a time.
#[derive(Debug, Clone)]
pub struct WheelAt {
    /// The time, in s.
    pub time: f64,
    /// The wheel. If rolling follows a time that is that of the instant before, it begins with the
    /// motion of the next instant.
    pub wheel: WheelOnRail,
}

impl WheelAt {
    /// Whether the wheel is where that of another instant is, with the same load.
    fn is_in_place_of(&self, other: &Self) -> bool {
        let (own, other) = (&self.wheel, &other.wheel);
        own.position == other.position && own.support == other.support
    }
}

/// A wheel over time, linear between the instants.
#[derive(Debug, Clone)]
pub struct WheelOverTime {
    /// The instants, at least two, with ascending times.
    pub instants: Vec<WheelAt>,
    /// Whether the first is a state of steady rolling, not one without tangential tractions.
    pub starts_rolling: bool,
    /// Whether the roll angle is that at which both wheels rest on their rails.
    pub rests: bool,
    /// How long the motion of an instant acts whose time is that of the instant before, as a shift
    /// at rest; in s.
    pub shift_duration: f64,
}

impl WheelOverTime {
    /// The wheel at the last instant, and forces, load and motion of every step: those of the whole
    /// wheel in the track, with the creepages of the contact with the largest normal force.
    ///
    /// # Errors
    /// Fewer than two instants, times that do not ascend, those of [`WheelOnRail::solve`] and of
    /// [`march`](crate::solver::march), too many cells, and [`Error::Stopped`].
    pub fn march(
        &self,
        tangential: &Tangential,
        watch: Watch,
    ) -> Result<(WheelSolution, Vec<Instant>), Error> {
        let (quantity, count) = (Quantity::Time, self.instants.len());
        let Some(first) = self.instants.first().filter(|_| count >= 2) else {
            return Err(Error::TooFew { quantity, fewest: 2, count });
        };
        require(Quantity::ShiftDuration, Requirement::NotNegative, self.shift_duration)?;
        let mut pairs = self.instants.windows(2).map(|pair| [pair[0].time, pair[1].time]);
        if let Some([before, after]) = pairs.find(|[before, after]| after < before) {
            return Err(Error::NotAscending { quantity, axis: "", before, after });
        }
        let mut rolling = Rolling::new(self, tangential, watch)?;
        rolling.time = first.time;
        if self.starts_rolling {
            rolling.go_on(&first.wheel, Step::Settle)?;
        }
        let mut last = None;
        for part in self.instants.chunk_by(|before, after| before.time < after.time) {
            if let Some(before) = last.replace(&part[part.len() - 1]) {
                let changes = self.shift_duration > 0.0 || !before.is_in_place_of(&part[0]);
                if changes || rolling.wheels.is_empty() {
                    rolling.go_on(&part[0].wheel, Step::Shift(self.shift_duration))?;
                }
                rolling.roll(part, rolling.instants.last().is_some())?;
            } else {
                rolling.roll(part, false)?;
            }
        }
        rolling.told()
    }
}

/// The wheel between two instants.
fn between([before, after]: [&WheelOnRail; 2], share: f64) -> WheelOnRail {
    let mixed = |one: f64, other: f64| mix([one, other], share);
    let (p, q) = (before.position, after.position);
    let (m, n) = (before.motion, after.motion);
    let support = match (before.support, after.support) {
        (Support::Force(one), Support::Force(other)) => Support::Force(mixed(one, other)),
        (Support::Height(one), Support::Height(other)) => Support::Height(mixed(one, other)),
        (_, other) => other,
    };
    WheelOnRail {
        position: Position {
            lateral: mixed(p.lateral, q.lateral),
            yaw: mixed(p.yaw, q.yaw),
            roll: mixed(p.roll, q.roll),
        },
        motion: Motion {
            speed: mixed(m.speed, n.speed),
            lateral_velocity: mixed(m.lateral_velocity, n.lateral_velocity),
            vertical_velocity: mixed(m.vertical_velocity, n.vertical_velocity),
            angular_velocity: mixed(m.angular_velocity, n.angular_velocity),
            roll_rate: mixed(m.roll_rate, n.roll_rate),
            yaw_rate: mixed(m.yaw_rate, n.yaw_rate),
            ..n
        },
        support,
        ..after.clone()
    }
}

/// Everything that changes from step to step.
struct Rolling<'a> {
    rests: bool,
    tangential: Tangential<'a>,
    watch: Watch<'a>,
    /// Sides of the cells, in m.
    spacing: [f64; 2],
    left: Vec<Left>,
    /// In rad, if it is sought.
    roll: f64,
    /// The wheel, and the other one of a wheelset, if it counts.
    wheels: Vec<WheelSolution>,
    /// In s.
    time: f64,
    /// Rolled since the start, in m.
    distance: f64,
    instants: Vec<Instant>,
    /// The largest residual of states that were not found, dimensionless.
    missed: f64,
    /// That of the vertical force with the largest magnitude, dimensionless.
    uncarried: f64,
}

impl<'a> Rolling<'a> {
    /// From bodies without tangential tractions; the cells are those of the smallest contact among
    /// the instants.
    fn new(
        history: &WheelOverTime,
        tangential: &Tangential<'a>,
        watch: Watch<'a>,
    ) -> Result<Self, Error> {
        let rests = history.rests;
        let mut start: Option<(f64, Vec<Left>)> = None;
        let mut last: Option<&WheelAt> = None;
        let mut size = [f64::INFINITY; 2];
        for at in &history.instants {
            let wheel = &at.wheel;
            wheel.check()?;
            tangential.check(wheel.motion.speed)?;
            if last.replace(at).is_some_and(|last| last.is_in_place_of(at)) {
                continue;
            }
            let (roll, left) = pressed(wheel, rests, (tangential, watch))?;
            let Some(main) = left.iter().find(|left| left.side == wheel.side) else {
                return Err(WheelRailError::Unsolved {}.into());
            };
            size = [0, 1].map(|k| size[k].min(main.size()[k]));
            start.get_or_insert((roll, left));
        }
        let (roll, left) = start.unwrap_or_default();
        let options = tangential.options;
        let spacing = [size[0] / options.cells_x as f64, size[1] / options.cells_y as f64];
        Ok(Self {
            rests,
            tangential: Tangential { past: None, ..*tangential },
            watch,
            spacing,
            left,
            roll,
            wheels: Vec::new(),
            time: 0.0,
            distance: 0.0,
            instants: Vec::new(),
            missed: 0.0,
            uncarried: 0.0,
        })
    }

    /// Rolls through a part of a history, between two shifts; after a shift all of the first
    /// interval has the motion of its end. The last step has the values of the end of the part.
    fn roll(&mut self, part: &[WheelAt], is_shifted: bool) -> Result<(), Error> {
        let ([first, next, ..], Some(last)) = (part, part.last()) else { return Ok(()) };
        let motion = if is_shifted { next.wheel.motion } else { first.wheel.motion };
        let from = WheelOnRail { motion, ..first.wheel.clone() };
        let at = |time: f64| {
            let after = part.partition_point(|at| at.time <= time).clamp(1, part.len() - 1);
            let (before, after) = (&part[after - 1], &part[after]);
            let share = ((time - before.time) / (after.time - before.time)).clamp(0.0, 1.0);
            let start = if before.time == first.time { &from } else { &before.wheel };
            between([start, &after.wheel], share)
        };
        let before = self.distance;
        loop {
            let duration = self.spacing[0] / at(self.time).motion.speed;
            let is_nearest = |time: f64| time + 0.5 * duration >= last.time;
            if is_nearest(self.time) {
                if self.distance > before {
                    return Ok(());
                }
                let cells = self.tangential.options.cells_x;
                return Err(part_too_short([first.time, last.time], (duration, cells)));
            }
            self.time += duration;
            self.distance += self.spacing[0];
            let place = if is_nearest(self.time) { last.time } else { self.time };
            let in_time = |error| match error {
                Error::WheelRail { error: WheelRailError::Lifted { .. } } => {
                    Error::AtTime { error: Box::new(error), time: place }
                }
                error => error,
            };
            self.go_on(&at(place), Step::Roll).map_err(in_time)?;
        }
    }

    /// Goes on to a wheel, whose contacts do in a step.
    fn go_on(&mut self, wheel: &WheelOnRail, step: Step) -> Result<(), Error> {
        let left = std::mem::take(&mut self.left);
        let past = Some(Arc::new(Past { left, spacing: self.spacing, step }));
        let options = Options { keeps_state: true, ..self.tangential.searching() };
        let how = Tangential { past, options: &options, ..self.tangential };
        let watch = within(self.watch, Progress::count(Stage::Marching, self.instants.len()));
        let near = |wheel: &WheelSolution| wheel.near.clone();
        self.wheels = if self.rests {
            let near = match &self.wheels[..] {
                [own, other] => Some([near(own), near(other)]),
                _ => None,
            };
            let (wheels, _) = wheel.solve_resting_near(self.roll, near, &how, &watch)?;
            Vec::from(wheels)
        } else {
            let near = self.wheels.first().map(near);
            vec![wheel.solve_near(near.as_ref(), &how, &watch)?.0]
        };
        for wheel in &self.wheels {
            self.roll = wheel.position.roll;
            if wheel.residual.abs() > self.uncarried.abs() {
                self.uncarried = wheel.residual;
            }
            for contact in &wheel.contacts {
                let (normal, solution) =
                    (contact.problem.normal.normal_contact(None)?, &contact.solution);
                if solution.status != Status::Converged {
                    self.missed = self.missed.max(solution.residual);
                }
                let place = [contact.position[0], contact.rail_arc];
                self.left.push(Left::of(wheel.side, place, (normal, solution), self.spacing));
            }
        }
        let main = self.wheels.first();
        self.instants.extend(main.and_then(|wheel| instant(wheel, [self.time, self.distance])));
        Ok(())
    }

    /// The last wheel, with what is to be said of all steps, and the steps.
    fn told(self) -> Result<(WheelSolution, Vec<Instant>), Error> {
        let Some(mut wheel) = self.wheels.into_iter().next() else {
            return Err(WheelRailError::Unsolved {}.into());
        };
        wheel.residual = self.uncarried;
        if let Some(contact) = wheel.contacts.first_mut().filter(|_| self.missed > 0.0) {
            let solution = &mut contact.solution;
            let (residual, tolerance) = (self.missed, self.tangential.options.tolerance);
            if solution.status == Status::Converged {
                let missed = Unconverged::TimeStep { residual, tolerance };
                solution.warnings.insert(0, Warning::of(missed));
            }
            solution.status = Status::NotConverged;
            solution.residual = solution.residual.max(residual);
        }
        Ok((wheel, self.instants))
    }
}

/// The roll angle of a wheel (in rad), and its contacts without friction, with those of the other
/// wheel if both rest on their rails.
fn pressed(
    wheel: &WheelOnRail,
    rests: bool,
    (tangential, watch): (&Tangential, Watch),
) -> Result<(f64, Vec<Left>), Error> {
    let (roll, sides) = if rests {
        let roll = wheel.frictionless_roll(tangential, watch)?;
        (roll, vec![wheel.side, wheel.side.other()])
    } else {
        (wheel.position.roll, vec![wheel.side])
    };
    let mut left = Vec::new();
    for side in sides {
        let wheel = wheel.at_roll(side, roll);
        let mut contacts =
            wheel.frictionless(Accuracy::Cells(wheel.cells), (tangential, watch))?.contacts;
        contacts.sort_by(|one, two| two.force.total_cmp(&one.force));
        for contact in contacts {
            let normal = ContactPatch::new(&contact, None, side)?.normal_contact(None)?;
            let place = [contact.plane.origin[0], side.outwards() * contact.plane.arcs[0]];
            left.push(Left::pressed(side, place, normal));
        }
    }
    Ok((roll, left))
}
