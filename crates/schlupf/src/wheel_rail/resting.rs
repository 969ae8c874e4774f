//! The roll angle of a wheelset whose wheels both rest on their rails.

use std::sync::Arc;

use super::drive::Drive;
use super::gap::Gap;
use super::pair::Pair;
use super::pose::Attitude;
use super::pressing::Accuracy;
use super::side::{Side, Sides};
use super::sliding::Tangential;
use super::wheel::{Near, Position, Support, WheelOnRail, WheelSolution};
use crate::numerics::root::Bracket;
use crate::reporting::{Error, Quantity, Watch, WheelRailError, require_positive};
use crate::solver::Solver;

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
    place: [f64; 2],
    depths: [f64; 2],
) -> Result<f64, Error> {
    resting_roll_near(0.0, RIGID, pairs, place, depths)
}

/// The same, from an angle nearby until it changes by less than a tolerance, both in rad.
fn resting_roll_near(
    mut roll: f64,
    tolerance: f64,
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
    loop {
        let off = difference(roll)?;
        bracket.note(roll, off > 0.0);
        let next = bracket.next(roll - off / slope.through([roll, off]));
        if (next - roll).abs() < tolerance {
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

/// A wheel and the other one, and what has solved each contact of the first.
type FoundBoth = ([WheelSolution; 2], Vec<Box<dyn Solver>>);

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
        let roll = self.frictionless_roll(tangential, watch)?;
        let ([own, other], solvers) = self.solve_resting_near(roll, None, tangential, watch)?;
        Ok([own.completed(solvers, tangential, watch)?, other])
    }

    /// This wheel or the other one, at a roll angle in rad.
    pub(super) fn at_roll(&self, side: Side, roll: f64) -> Self {
        Self { side, position: Position { roll, ..self.position }, ..self.clone() }
    }

    /// The roll angle at which both wheels rest on their rails without friction, on coarse cells;
    /// in rad.
    pub(super) fn frictionless_roll(
        &self,
        tangential: &Tangential,
        watch: Watch,
    ) -> Result<f64, Error> {
        let place = [self.position.lateral, self.position.yaw];
        let roll = |from: f64, depths| resting_roll_near(from, SETTLED, &self.pairs, place, depths);
        let rigid = roll(0.0, [0.0; 2])?;
        let depth = |side: Side| -> Result<f64, Error> {
            let Support::Force(_) = self.support else { return Ok(0.0) };
            let wheel = self.at_roll(side, rigid);
            Ok(wheel.frictionless(Accuracy::Coarse, (tangential, watch))?.at.depth)
        };
        let depths = [depth(Side::Left)?, depth(Side::Right)?];
        roll(rigid, depths)
    }

    /// Both wheels, this one first with what has solved its contacts, from a roll angle (in rad)
    /// and from wheels nearby, likewise.
    pub(super) fn solve_resting_near(
        &self,
        mut roll: f64,
        mut near: Option<[Near; 2]>,
        tangential: &Tangential,
        watch: Watch,
    ) -> Result<FoundBoth, Error> {
        let mut bracket = Bracket::new([f64::NEG_INFINITY, f64::INFINITY]);
        let mut slope = Slope::new(&self.pairs);
        let mut step = f64::INFINITY;
        for _ in 0..MOST_ROUNDS {
            let [near_own, near_other] =
                near.as_ref().map_or([None; 2], |near| near.each_ref().map(Some));
            // Both are on one axle: the force on this wheel turns the other one, too.
            let (mut own, solvers) =
                self.at_roll(self.side, roll).solve_near(near_own, tangential, watch)?;
            let mut other = self.at_roll(self.side.other(), roll);
            other.drive = Drive::AngularVelocity;
            other.motion.angular_velocity = own.angular_velocity;
            let (mut other, _) = other.solve_near(near_other, tangential, watch)?;
            // What the left wheel is higher falls with the angle; it jumps where a contact does.
            let higher = own.height - other.height;
            let off = self.side.outwards() * higher;
            bracket.note(roll, off > 0.0);
            let next = bracket.next(roll - off / slope.through([roll, off]));
            step = (next - roll).abs();
            if step < SETTLED {
                (own.unevenness, other.unevenness) = (higher, -higher);
                return Ok(([own, other], solvers));
            }
            roll = next;
            near = Some([own.near, other.near]);
        }
        Err(WheelRailError::RollNotSettled { rounds: MOST_ROUNDS, step }.into())
    }
}
