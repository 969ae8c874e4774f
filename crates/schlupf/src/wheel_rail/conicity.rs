//! Rigid contact of a wheelset that rests on both rails, the rolling-radius difference over its
//! lateral position, and the equivalent conicity.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::gap::Gap;
use super::pair::Pair;
use super::pose::{Attitude, minus};
use super::resting::resting_roll;
use super::side::Side;
use crate::error::{Error, require, require_positive};
use crate::numerics::interpolation::piecewise_linear;
use crate::progress::{Progress, Stage, Watch, tell};
use crate::quantity::Quantity;
use crate::requirement::Requirement;

/// Points of a quarter of the lateral motion.
const SAMPLES: usize = 2000;

/// The point at which a rigid wheel touches its rail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidContact {
    /// Where it is in the track, in m.
    pub position: [f64; 3],
    /// Angle of the contact plane in rad, positive where the rail's outward normal leans to the
    /// left.
    pub angle: f64,
    /// Distance outwards from the origin of the rail's profile, in m.
    pub rail_position: f64,
    /// Distance outwards from the origin of the wheel's profile, in m.
    pub wheel_position: f64,
    /// Radius of the wheel there, in m.
    pub rolling_radius: f64,
}

/// A rigid wheelset that rests on both rails.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestingWheelset {
    /// Lateral position of the middle of the axle, to the left, in m.
    pub lateral: f64,
    /// Roll angle, in rad.
    pub roll: f64,
    /// Height of the middle of the axle above the nominal radius over the tops of the rails, in m.
    pub height: f64,
    /// Contacts of the left and of the right wheel.
    pub contacts: [RigidContact; 2],
}

impl RestingWheelset {
    /// At a lateral position (in m, to the left) and a yaw angle (in rad).
    ///
    /// # Errors
    /// A wheel beside its rail.
    pub fn new(pair: &Pair, lateral: f64, yaw: f64) -> Result<Self, Error> {
        let roll = resting_roll(pair, [lateral, yaw], [0.0; 2])?;
        let contact = |side: Side| -> Result<(RigidContact, f64), Error> {
            let sign = side.outwards();
            let attitude = Attitude { lateral: sign * lateral, roll: sign * roll, yaw: sign * yaw };
            let least = Gap::new(pair, &attitude)?.least().ok_or(Error::NoArea {})?;
            let pose = attitude.at_height(pair.nominal_radius, -least.gap);
            let place = [least.wheel[0], least.y, least.rail[0]];
            let [x, y, z] = pose.in_wheelset(minus(place, pose.centre));
            let contact = RigidContact {
                position: [place[0], sign * place[1], place[2]],
                angle: -sign * least.inclination,
                rail_position: least.y - pair.rail_origin[0],
                wheel_position: y - pair.wheel_offset,
                rolling_radius: x.hypot(z),
            };
            Ok((contact, -least.gap))
        };
        let [(left, height), (right, _)] = [contact(Side::Left)?, contact(Side::Right)?];
        Ok(Self { lateral, roll, height, contacts: [left, right] })
    }

    /// Δr, the rolling radius of the wheel towards which the wheelset has moved minus that of the
    /// other one for a positive lateral position: left minus right, in m.
    pub fn rolling_radius_difference(&self) -> f64 {
        self.contacts[0].rolling_radius - self.contacts[1].rolling_radius
    }
}

/// Δr over the lateral position, of a wheelset whose wheels and rails are mirror images of each
/// other: Δr(−y) = −Δr(y).
#[derive(Debug, Clone, PartialEq)]
pub struct RollingRadiusDifference {
    /// Lateral positions from zero upwards, in m, at equal steps.
    pub lateral: Vec<f64>,
    /// Δr there, in m; zero at zero.
    pub difference: Vec<f64>,
}

impl RollingRadiusDifference {
    /// Up to a lateral position (in m), at `intervals` equal steps.
    ///
    /// # Errors
    /// A position that is not positive, or at which a wheel is beside its rail, and
    /// [`Error::Stopped`].
    pub fn new(pair: &Pair, largest: f64, intervals: usize, watch: Watch) -> Result<Self, Error> {
        require_positive(Quantity::LateralPosition, largest)?;
        let intervals = intervals.max(1);
        let lateral: Vec<f64> =
            (0..=intervals).map(|k| largest * k as f64 / intervals as f64).collect();
        let mut difference = vec![0.0];
        for (k, y) in lateral.iter().enumerate().skip(1) {
            tell(watch, Progress::count(Stage::NormalContact, k))?;
            difference.push(RestingWheelset::new(pair, *y, 0.0)?.rolling_radius_difference());
        }
        Ok(Self { lateral, difference })
    }

    /// Δr at a lateral position (in m) of either sign, in m; linear in between.
    pub fn at(&self, lateral: f64) -> f64 {
        let [value, _] = piecewise_linear(&self.lateral, &self.difference, lateral.abs());
        if lateral < 0.0 { -value } else { value }
    }

    /// Equivalent conicity for a lateral motion of an amplitude ŷ (in m, within the positions),
    /// dimensionless: that of the cones with the same fundamental wave of Δr,
    ///
    /// tan γ = 1/(2π ŷ) ∫ Δr(ŷ sin φ) sin φ dφ over a period,
    ///
    /// the harmonic linearisation of EN 15302.
    ///
    /// # Errors
    /// An amplitude that is not within the positions.
    pub fn equivalent_conicity(&self, amplitude: f64) -> Result<f64, Error> {
        let largest = self.lateral[self.lateral.len() - 1];
        require(Quantity::Amplitude, Requirement::AboveUpTo(0.0, largest), amplitude)?;
        // The midpoint rule over a quarter of the period, which for an odd Δr is all of it.
        let step = FRAC_PI_2 / SAMPLES as f64;
        let wave = |k: usize| {
            let sine = ((k as f64 + 0.5) * step).sin();
            self.at(amplitude * sine) * sine
        };
        let quarter: f64 = (0..SAMPLES).map(wave).sum::<f64>() * step;
        Ok(4.0 * quarter / (TAU * amplitude))
    }
}
