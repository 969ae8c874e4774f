//! The roll angle of a wheelset whose wheels both rest on their rails.

use std::sync::Arc;

use super::driven::Drive;
use super::gap::Gap;
use super::pair::Pair;
use super::pose::Attitude;
use super::side::Side;
use super::sliding::Tangential;
use super::wheel::{Position, WheelOnRail, WheelSolution};
use crate::error::{Error, WheelRailError};
use crate::progress::Watch;

/// Change of the roll angle below which it is found, in rad: less than 0.2 µm at the rails.
const SETTLED: f64 = 2e-7;

/// The same with rigid bodies, in rad.
const RIGID: f64 = 1e-11;

/// Most rounds of roll and wheels, and most steps to a roll angle.
const MOST_ROUNDS: usize = 30;
const MOST_STEPS: usize = 60;

/// Largest roll angle, in rad.
const LARGEST: f64 = 0.2;

/// Roll angle (in rad) at which both wheels touch their rails, each sunk by a depth below first
/// touch (left and right, in m), at a lateral position (in m) and a yaw angle (in rad).
///
/// The height of the wheelset at which the left wheel touches falls with the roll angle, that of
/// the right one rises, so there is one such angle: by the secant within a bracket.
///
/// # Errors
/// A wheel beside its rail.
pub fn resting_roll(pair: &Pair, [lateral, yaw]: [f64; 2], depths: [f64; 2]) -> Result<f64, Error> {
    let height = |side: Side, roll: f64, depth: f64| -> Result<f64, Error> {
        let sign = side.outwards();
        let attitude = Attitude { lateral: sign * lateral, roll: sign * roll, yaw: sign * yaw };
        let least = Gap::new(pair, &attitude)?.least();
        Ok(least.map_or(0.0, |point| -point.gap) - depth)
    };
    let difference = |roll: f64| -> Result<f64, Error> {
        Ok(height(Side::Left, roll, depths[0])? - height(Side::Right, roll, depths[1])?)
    };
    let (mut low, mut high) = (-LARGEST, LARGEST);
    let mut roll = 0.0;
    let mut off = difference(roll)?;
    // Twice the distance of the contacts from the middle, about.
    let mut slope = -2.0 * pair.wheel_offset;
    for _ in 0..MOST_STEPS {
        if off > 0.0 {
            low = roll;
        } else {
            high = roll;
        }
        let secant = roll - off / slope;
        let next = if secant > low && secant < high { secant } else { 0.5 * (low + high) };
        let step = next - roll;
        if step.abs() < RIGID {
            return Ok(next);
        }
        let off_next = difference(next)?;
        let found = (off_next - off) / step;
        slope = if found < 0.2 * -pair.wheel_offset { found } else { -2.0 * pair.wheel_offset };
        (roll, off) = (next, off_next);
    }
    Ok(roll)
}

impl WheelOnRail {
    /// This wheel (first) and the one on the other side (second) under the same vertical force,
    /// with the roll angle at which both rest on their rails; that of the position is not used. A
    /// force is that on this wheel; the other one turns with it.
    ///
    /// # Errors
    /// As [`Self::solve`].
    pub fn solve_resting(
        &self,
        tangential: &Tangential,
        watch: Watch,
    ) -> Result<[WheelSolution; 2], Error> {
        self.check()?;
        let place = [self.position.lateral, self.position.yaw];
        let rigid = resting_roll(&self.pair, place, [0.0; 2])?;
        let depth = |side: Side| {
            let position = Position { roll: rigid, ..self.position };
            Self { side, position, ..self.clone() }.frictionless_depth(tangential, watch)
        };
        let depths = [depth(Side::Left)?, depth(Side::Right)?];
        let mut roll = resting_roll(&self.pair, place, depths)?;
        let mut bracket = Bracket::new(-2.0 * self.pair.wheel_offset);
        let mut step = f64::INFINITY;
        let mut before: Option<[WheelSolution; 2]> = None;
        for _ in 0..MOST_ROUNDS {
            let wheel = |side: Side, turned: Option<f64>| {
                let position = Position { roll, ..self.position };
                let mut wheel =
                    Self { pair: Arc::clone(&self.pair), side, position, ..self.clone() };
                if let Some(angular_velocity) = turned {
                    wheel.drive = Drive::AngularVelocity;
                    wheel.motion.angular_velocity = angular_velocity;
                }
                let near = before.as_ref().and_then(|both| both.iter().find(|it| it.side == side));
                wheel.solve_near(near, tangential, watch)
            };
            // Both are on one axle: the force on this wheel turns the other one, too.
            let own = wheel(self.side, None)?;
            let other = wheel(self.side.other(), Some(own.angular_velocity))?;
            let [left, right] = match self.side {
                Side::Left => [own, other],
                Side::Right => [other, own],
            };
            let next = bracket.next(roll, left.height - right.height);
            step = (next - roll).abs();
            if step < SETTLED {
                return Ok(match self.side {
                    Side::Left => [left, right],
                    Side::Right => [right, left],
                });
            }
            roll = next;
            before = Some([left, right]);
        }
        Err(WheelRailError::RollNotSettled { rounds: MOST_ROUNDS, step }.into())
    }
}

/// The search for the roll angle at which both wheels carry their forces at the same height of the
/// wheelset. What the left wheel is higher than the right one falls with the angle; it jumps where
/// a contact does.
struct Bracket {
    low: f64,
    high: f64,
    /// The last angle (in rad) and by how much the left wheel was higher (in m).
    last: Option<[f64; 2]>,
    /// The slope of bodies that touch at the nominal places, in m.
    usual_slope: f64,
    rounds: usize,
}

impl Bracket {
    fn new(usual_slope: f64) -> Self {
        let (low, high) = (f64::NEG_INFINITY, f64::INFINITY);
        Self { low, high, last: None, usual_slope, rounds: 0 }
    }

    /// The angle to try after one (in rad) at which the left wheel is `off` (in m) higher: by the
    /// secant, or in the middle of a bracket that this leaves or hardly narrows.
    fn next(&mut self, roll: f64, off: f64) -> f64 {
        self.rounds += 1;
        if off > 0.0 {
            self.low = roll;
        } else {
            self.high = roll;
        }
        let secant = self.last.map(|[before, off_before]| (off - off_before) / (roll - before));
        let is_usual = |slope: &f64| (FLATTEST..STEEPEST).contains(&(slope / self.usual_slope));
        let slope = secant.filter(is_usual).unwrap_or(self.usual_slope);
        self.last = Some([roll, off]);
        let next = roll - off / slope;
        let middle = 0.5 * (self.low + self.high);
        let is_inside = self.low <= next && next <= self.high;
        if middle.is_finite() && (!is_inside || self.rounds.is_multiple_of(4)) {
            middle
        } else {
            next
        }
    }
}

/// Slopes that are followed, over the usual one.
const FLATTEST: f64 = 0.01;
const STEEPEST: f64 = 20.0;
