//! The roll angle of a wheelset whose wheels both rest on their rails.

use std::sync::Arc;

use super::drive::Drive;
use super::gap::Gap;
use super::pair::Pair;
use super::pose::Attitude;
use super::side::{Side, Sides};
use super::sliding::Tangential;
use super::wheel::{Position, WheelOnRail, WheelSolution};
use crate::numerics::root::Bracket;
use crate::reporting::{Error, Quantity, Watch, WheelRailError, require_positive};

/// Change of the roll angle below which it is found, in rad: less than 0.2 µm at the rails.
const SETTLED: f64 = 2e-7;

/// The same with rigid bodies, in rad.
const RIGID: f64 = 1e-11;

/// Most rounds of roll and wheels: more than a bracket of a tenth of a radian needs to close.
const MOST_ROUNDS: usize = 100;

/// Roll angle (in rad) at which both wheels touch their rails, each sunk by a depth below first
/// touch (left and right, in m), at a lateral position (in m) and a yaw angle (in rad).
///
/// The height of the wheelset at which the left wheel touches falls with the roll angle, that of
/// the right one rises, so there is one such angle: by the secant within a bracket.
///
/// # Errors
/// A wheel beside its rail.
pub fn resting_roll(
    pairs: &Sides<Arc<Pair>>,
    [lateral, yaw]: [f64; 2],
    depths: [f64; 2],
) -> Result<f64, Error> {
    let height = |side: Side, roll: f64, depth: f64| -> Result<f64, Error> {
        let attitude = Attitude::of(side, [lateral, roll, yaw]);
        let least = Gap::new(pairs.of(side), &attitude)?.least();
        Ok(least.map_or(0.0, |point| -point.gap) - depth)
    };
    let difference = |roll: f64| -> Result<f64, Error> {
        Ok(height(Side::Left, roll, depths[0])? - height(Side::Right, roll, depths[1])?)
    };
    let offset = 0.5 * (pairs.left.wheel_offset + pairs.right.wheel_offset);
    require_positive(Quantity::FlangeBackDistance, offset)?;
    let mut bracket = Bracket::new([f64::NEG_INFINITY, f64::INFINITY]);
    let mut slope = Slope::new(pairs);
    let mut roll = 0.0;
    loop {
        let off = difference(roll)?;
        bracket.note(roll, off > 0.0);
        let next = bracket.next(roll - off / slope.through([roll, off]));
        if (next - roll).abs() < RIGID {
            return Ok(next);
        }
        roll = next;
    }
}

/// How fast the height at which the left wheel rests falls below that of the right one as the
/// wheelset rolls, in m: through the last two angles, or that of contacts at the nominal places.
struct Slope {
    usual: f64,
    /// The last angle (in rad), and by how much the left wheel was higher (in m).
    last: Option<[f64; 2]>,
}

impl Slope {
    fn new(Sides { left, right }: &Sides<Arc<Pair>>) -> Self {
        Self { usual: -(left.wheel_offset + right.wheel_offset), last: None }
    }

    /// The slope through the last point and this one.
    fn through(&mut self, [roll, off]: [f64; 2]) -> f64 {
        let secant = self.last.map(|[before, off_before]| (off - off_before) / (roll - before));
        self.last = Some([roll, off]);
        let is_usual = |slope: &f64| (FLATTEST..STEEPEST).contains(&(slope / self.usual));
        secant.filter(is_usual).unwrap_or(self.usual)
    }
}

/// Slopes that are followed, over the usual one.
const FLATTEST: f64 = 0.01;
const STEEPEST: f64 = 20.0;

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
        tangential.check(self.motion.speed)?;
        let place = [self.position.lateral, self.position.yaw];
        let rigid = resting_roll(&self.pairs, place, [0.0; 2])?;
        let depth = |side: Side| {
            let position = Position { roll: rigid, ..self.position };
            Self { side, position, ..self.clone() }.frictionless_depth(tangential, watch)
        };
        let depths = [depth(Side::Left)?, depth(Side::Right)?];
        let mut roll = resting_roll(&self.pairs, place, depths)?;
        let mut bracket = Bracket::new([f64::NEG_INFINITY, f64::INFINITY]);
        let mut slope = Slope::new(&self.pairs);
        let mut step = f64::INFINITY;
        let mut before: Option<[WheelSolution; 2]> = None;
        for _ in 0..MOST_ROUNDS {
            let wheel = |side: Side, turned: Option<f64>| {
                let position = Position { roll, ..self.position };
                let mut wheel = Self { side, position, ..self.clone() };
                if let Some(angular_velocity) = turned {
                    wheel.drive = Drive::AngularVelocity;
                    wheel.motion.angular_velocity = angular_velocity;
                }
                let near = before.as_ref().and_then(|both| both.iter().find(|it| it.side == side));
                wheel.solve_near(near, tangential, watch)
            };
            // Both are on one axle: the force on this wheel turns the other one, too.
            let (own, solvers) = wheel(self.side, None)?;
            let (other, _) = wheel(self.side.other(), Some(own.angular_velocity))?;
            let [mut left, mut right] = match self.side {
                Side::Left => [own, other],
                Side::Right => [other, own],
            };
            // What the left wheel is higher falls with the angle; it jumps where a contact does.
            let off = left.height - right.height;
            bracket.note(roll, off > 0.0);
            let next = bracket.next(roll - off / slope.through([roll, off]));
            step = (next - roll).abs();
            if step < SETTLED {
                (left.unevenness, right.unevenness) = (off, -off);
                let [own, other] = match self.side {
                    Side::Left => [left, right],
                    Side::Right => [right, left],
                };
                return Ok([own.completed(solvers, tangential, watch)?, other]);
            }
            roll = next;
            before = Some([left, right]);
        }
        Err(WheelRailError::RollNotSettled { rounds: MOST_ROUNDS, step }.into())
    }
}
