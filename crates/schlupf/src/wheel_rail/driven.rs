//! The angular velocity of a wheel under a force or a torque.
//!
//! With the share h of a longitudinal force in the normal force, positive in braking, and a
//! creepage x of the whole wheel, h(x) rises through free rolling up to its peaks on both sides.
//! The search goes from free rolling, or from a solution nearby, by secants until it has a bracket,
//! and closes it. Where h falls on the way, the peak between the last three points is looked for:
//! it is part of a bracket, or it is the largest share there is.

use crate::numerics::root::GOLDEN;
use crate::reporting::{Error, Quantity, require_finite};

/// What turns a wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Drive {
    /// The angular velocity of its motion.
    AngularVelocity,
    /// Longitudinal force F_x on the wheel, of all contacts together, in N: negative in braking.
    Force {
        /// F_x, in N.
        force: f64,
        /// Along which axis.
        along: Along,
    },
    /// −F_x over the vertical force on the wheel, both in the track; dimensionless, positive in
    /// braking.
    OverLoad(f64),
    /// Torque T on the wheel about its axle (in N m), positive where it drives: that of the
    /// tangential tractions of all contacts balances it.
    Torque(f64),
}

/// The axis of a longitudinal force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Along {
    /// That of the track.
    #[default]
    Track,
    /// That of the wheelset, across its axle: it turns with roll and yaw.
    Wheelset,
}

impl Drive {
    /// Whether the angular velocity is to be found.
    pub fn is_force(self) -> bool {
        self != Self::AngularVelocity
    }

    /// Checks that what is given is finite.
    pub(super) fn check(self) -> Result<(), Error> {
        match self {
            Self::AngularVelocity => Ok(()),
            Self::Force { force, .. } => require_finite(Quantity::ForceX, force),
            Self::OverLoad(coefficient) => require_finite(Quantity::ForceOverLoad, coefficient),
            Self::Torque(torque) => require_finite(Quantity::WheelTorque, torque),
        }
    }
}

/// What was solved at a creepage.
#[derive(Debug)]
pub(super) struct Point<T> {
    /// Creepage of the wheel, dimensionless.
    pub x: f64,
    /// Share of the force, dimensionless.
    pub share: f64,
    /// The solution.
    pub state: T,
}

/// What a search ends with.
#[derive(Debug)]
pub(super) enum Found<T> {
    /// The state with the share that was asked for.
    At(Point<T>),
    /// No state has it: the one with the nearest share.
    Beyond(Point<T>),
    /// The search did not end: the last state.
    Lost(Point<T>),
}

/// Slope of the share at free rolling where nothing is known of it: a wheel of steel under some
/// 50 kN (Kalker 1967), dimensionless.
pub(super) const SLOPE: f64 = 200.0;

/// Largest creepages: of a wheel that turns at 0.34 times its free angular velocity (over the mean
/// of both speeds, to which creepages of contacts refer, 0.985; contacts slide with less than one),
/// and of one that turns eleven times as fast as it rolls.
const LOCKED: f64 = 0.66;
const SPINNING: f64 = -10.0;

/// Most evaluations on the way to a bracket, in it, and around a peak.
const MOST: usize = 40;
/// Largest first step, and by how much later ones may be longer than the way so far.
const STEP: f64 = 1e-3;
const GROWTH: f64 = 3.0;
/// Part of the first slope below which a secant does not count.
const FLATTEST: f64 = 1e-6;
/// Width of a bracket, relative to its place, below which rounding decides.
const ROUNDING: f64 = 1e-12;
/// Factor of the tolerance within which a bracket that cannot be narrowed counts as found.
const NEARLY: f64 = 100.0;
/// Width of a peak, relative to its place, below which it is known.
const NARROW: f64 = 1e-3;

/// A search for the creepage at which a share is `target`.
pub(super) struct Search {
    /// Share, dimensionless.
    pub target: f64,
    /// Error of it that does not matter, dimensionless.
    pub tolerance: f64,
    /// Where it begins, dimensionless.
    pub start: f64,
    /// Slope of the share at free rolling, dimensionless.
    pub slope: f64,
}

impl Search {
    /// Searches, given what solves at a creepage and tells the share there.
    ///
    /// # Errors
    /// Those of `solve`.
    pub fn run<T>(
        &self,
        mut solve: impl FnMut(f64) -> Result<(f64, T), Error>,
    ) -> Result<Found<T>, Error> {
        let mut at = |x: f64| solve(x).map(|(share, state)| Point { x, share, state });
        let mut last = at(self.start)?;
        let way = (self.target - last.share).signum();
        let mut before: Option<Point<T>> = None;
        let mut slope = self.slope;
        for _ in 0..MOST {
            if self.is_met(&last) {
                return Ok(Found::At(last));
            }
            let most = match &before {
                Some(_) => GROWTH * (last.x - self.start).abs(),
                None => STEP,
            };
            let step = ((self.target - last.share) / slope).abs().min(most);
            let x = (last.x + way * step).clamp(SPINNING, LOCKED);
            if x == last.x {
                return Ok(Found::Beyond(last));
            }
            let next = at(x)?;
            if way * (next.share - self.target) > 0.0 {
                return self.close([last, next], at);
            }
            let secant = (next.share - last.share) / (next.x - last.x);
            if secant < 0.0 {
                let from = before.map_or(self.start, |before| before.x);
                return self.around_peak((from, next.x), last, (way, &mut at));
            }
            slope = secant.max(FLATTEST * self.slope);
            before = Some(std::mem::replace(&mut last, next));
        }
        Ok(Found::Lost(last))
    }

    fn is_met<T>(&self, point: &Point<T>) -> bool {
        (point.share - self.target).abs() <= self.tolerance
    }

    /// Narrows a bracket: by inverse quadratic interpolation where its curve is monotone, otherwise
    /// by halving (Chandrupatla 1997).
    fn close<T>(
        &self,
        [mut here, mut there]: [Point<T>; 2],
        mut at: impl FnMut(f64) -> Result<Point<T>, Error>,
    ) -> Result<Found<T>, Error> {
        let off = |point: &Point<T>| point.share - self.target;
        let mut part = off(&here) / (off(&here) - off(&there));
        for _ in 0..MOST {
            if (there.x - here.x).abs() <= ROUNDING * (1.0 + here.x.abs()) {
                break;
            }
            let next = at(here.x + part * (there.x - here.x))?;
            if self.is_met(&next) {
                return Ok(Found::At(next));
            }
            let is_same_side = off(&next) * off(&here) > 0.0;
            let before = std::mem::replace(&mut here, next);
            let third = if is_same_side {
                [before.x, off(&before)]
            } else {
                let third = [there.x, off(&there)];
                there = before;
                third
            };
            part = interpolated([[here.x, off(&here)], [there.x, off(&there)], third]);
        }
        let size = |point: &Point<T>| off(point).abs();
        let best = if size(&here) < size(&there) { here } else { there };
        let is_near = size(&best) <= NEARLY * self.tolerance;
        Ok(if is_near { Found::At(best) } else { Found::Lost(best) })
    }

    /// The largest share between two creepages, or the target on the way to it, from a creepage
    /// before the peak, where the share is `best`.
    fn around_peak<T>(
        &self,
        (mut low, mut high): (f64, f64),
        mut best: Point<T>,
        (way, at): (f64, &mut impl FnMut(f64) -> Result<Point<T>, Error>),
    ) -> Result<Found<T>, Error> {
        for _ in 0..MOST {
            if (high - low).abs() <= NARROW * best.x.abs() {
                break;
            }
            let is_upper = (high - best.x).abs() > (best.x - low).abs();
            let end = if is_upper { high } else { low };
            let next = at(best.x + (1.0 - GOLDEN) * (end - best.x))?;
            if self.is_met(&next) {
                return Ok(Found::At(next));
            }
            if way * (next.share - self.target) > 0.0 {
                // The rising side is before the peak.
                let from = if is_upper { best } else { at(low)? };
                return self.close([from, next], at);
            }
            let is_better = way * (next.share - best.share) > 0.0;
            match (is_better, is_upper) {
                (true, true) => low = best.x,
                (true, false) => high = best.x,
                (false, true) => high = next.x,
                (false, false) => low = next.x,
            }
            if is_better {
                best = next;
            }
        }
        Ok(Found::Beyond(best))
    }
}

/// Where between the first two of three points, each with its value, the value vanishes, as a part
/// of the way: a half where the inverse of the parabola through them is not monotone.
fn interpolated([[a, fa], [b, fb], [c, fc]]: [[f64; 2]; 3]) -> f64 {
    let (xi, phi) = ((a - b) / (c - b), (fa - fb) / (fc - fb));
    let is_monotone = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
    if !is_monotone {
        return 0.5;
    }
    let part =
        fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
    part.clamp(1e-3, 1.0 - 1e-3)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(target: f64, start: f64, curve: impl Fn(f64) -> f64) -> (Found<()>, usize) {
        let search = Search { target, tolerance: 1e-9, start, slope: SLOPE };
        let mut count = 0;
        let found = search.run(|x| {
            count += 1;
            Ok((curve(x), ()))
        });
        (found.unwrap(), count)
    }

    /// μ tanh(k (x − x0)/μ): its inverse is known, in braking and in driving, near rest and near
    /// the friction limit.
    #[test]
    fn creepages_of_a_curve_that_saturates() {
        for free in [0.0, 0.004, -0.01] {
            for share in [-0.299_999, -0.2, -1e-5, 0.0, 0.05, 0.25, 0.299_9] {
                let curve = |x: f64| 0.3 * (300.0 * (x - free) / 0.3).tanh();
                let (found, count) = run(share, 0.0, curve);
                let Found::At(point) = found else { panic!("{share}: {found:?}") };
                let expected = free + (share / 0.3_f64).atanh() * 0.3 / 300.0;
                assert!((point.x - expected).abs() < 1e-5, "{share}: {} {expected}", point.x);
                assert!(count < 24, "{share}: {count}");
            }
            let (found, _) = run(0.31, 0.0, |x| 0.3 * (300.0 * (x - free) / 0.3).tanh());
            assert!(matches!(found, Found::Beyond(ref point) if (point.share - 0.3).abs() < 1e-9));
        }
    }

    /// 2 h x c/(x² + c²) has its peak h at c: below it the rising side, above it the peak itself.
    #[test]
    fn creepages_of_a_curve_with_a_peak() {
        let (peak, place) = (0.3, 0.01_f64);
        let curve = |x: f64| 2.0 * peak * x * place / (x * x + place * place);
        for sign in [1.0, -1.0] {
            for part in [0.1, 0.5, 0.9, 0.99, 0.999, 0.999_9] {
                let (found, count) = run(sign * part * peak, 0.0, curve);
                let Found::At(point) = found else { panic!("{part}: {found:?}") };
                // The smaller root of x² − 2 c x/part + c².
                let expected = sign * place * (1.0 - (1.0 - part * part).sqrt()) / part;
                assert!((point.x - expected).abs() < 1e-5, "{part}: {} {expected}", point.x);
                assert!(count < 36, "{part}: {count}");
            }
            let (found, _) = run(sign * 1.001 * peak, 0.0, curve);
            let Found::Beyond(point) = found else { panic!("{found:?}") };
            assert!((point.share.abs() - peak).abs() < 1e-5 * peak, "{}", point.share);
        }
    }
}
