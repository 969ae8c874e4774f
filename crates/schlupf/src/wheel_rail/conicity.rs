//! Rigid contact of a wheelset that rests on both rails, the rolling-radius difference over its
//! lateral position, and the equivalent conicity.
//!
//! A wheelset without mass and creepage follows y″ = −Δr(y)/(e r₀) along the track, with the
//! distance e of the contacts and the radius r₀ of the wheels (Klingel 1883). Its equivalent
//! conicity is that of the cones, Δr = 2 y tan γ, on which a motion of the same amplitude has the
//! same wavelength (EN 15302), or the same fundamental wave of Δr (harmonic linearisation); e and
//! r₀ cancel from both.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use super::gap::Gap;
use super::pair::Pair;
use super::pose::{Attitude, minus};
use super::resting::resting_roll;
use super::side::{Side, Sides};
use crate::numerics::interpolation::piecewise_linear;
use crate::numerics::root::bisection;
use crate::reporting::{
    Error, Progress, Quantity, Requirement, Stage, Watch, require, require_positive, tell,
};

/// Points of a period of the lateral motion.
const SAMPLES: usize = 8000;

/// Conicity that counts as none: what is left of rounding in the profile of a cylinder,
/// dimensionless.
const NONE: f64 = 1e-4;

/// Distance of a position from a turning point within which it is the same, over the amplitude.
const ROUNDING: f64 = 1e-8;

/// Halvings in which the middle of a motion is found.
const HALVINGS: u32 = 60;

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
    /// Height of the middle of the axle above the nominal radius over z = 0 of the track, in m.
    pub height: f64,
    /// Contacts of the left and of the right wheel.
    pub contacts: [RigidContact; 2],
}

/// Whether a wheelset rolls about x as it moves sideways.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Roll {
    /// It does not (EN 15302): each wheel touches at a height of its own.
    Neglected,
    /// Both wheels rest on their rails.
    Resting,
}

impl RigidContact {
    /// That of a wheel at an attitude as seen from the left, and the height at which it touches (in
    /// m).
    fn of(pair: &Pair, side: Side, attitude: &Attitude) -> Result<(Self, f64), Error> {
        let sign = side.outwards();
        let gap = Gap::new(pair, attitude)?;
        let least = gap.least().ok_or(Error::NoArea {})?;
        gap.refuse_end(pair, &least)?;
        let pose = pair.wheel_in(&attitude.at_height(pair.nominal_radius, -least.gap));
        let place = [least.wheel[0], least.y, least.rail[0]];
        let [x, y, z] = pose.in_body(minus(place, pose.centre));
        let contact = Self {
            position: [place[0], sign * place[1], place[2]],
            angle: -sign * least.inclination,
            rail_position: least.y - pair.rail_origin[0],
            wheel_position: y - pair.wheel_offset,
            rolling_radius: x.hypot(z),
        };
        Ok((contact, -least.gap))
    }
}

impl RestingWheelset {
    /// At a lateral position (in m, to the left) and a yaw angle (in rad).
    ///
    /// # Errors
    /// A wheel beside its rail, or that touches at the end of a profile.
    pub fn new(pairs: &Sides<Arc<Pair>>, lateral: f64, yaw: f64) -> Result<Self, Error> {
        let roll = resting_roll(pairs, [lateral, yaw], [0.0; 2])?;
        let contact = |side: Side| {
            let attitude = Attitude::of(side, [lateral, roll, yaw]);
            RigidContact::of(pairs.of(side), side, &attitude)
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

/// Δr over the lateral position, linear between the positions given.
#[derive(Debug, Clone, PartialEq)]
pub struct RollingRadiusDifference {
    /// Ascending lateral positions to the left, in m.
    pub lateral: Vec<f64>,
    /// Δr there, left minus right, in m.
    pub difference: Vec<f64>,
    /// Why there are no positions beyond, if they were asked for.
    pub end: Option<Error>,
}

impl RollingRadiusDifference {
    /// Of a wheelset in the middle of the track and on both sides of it: up to a lateral position
    /// (in m), at `intervals` equal steps, or as far as the wheels touch their rails.
    ///
    /// # Errors
    /// A position that is not positive, wheels that do not touch their rails in the middle, and
    /// [`Error::Stopped`].
    pub fn new(
        pairs: &Sides<Arc<Pair>>,
        (largest, intervals): (f64, usize),
        roll: Roll,
        watch: Watch,
    ) -> Result<Self, Error> {
        require_positive(Quantity::LateralPosition, largest)?;
        let intervals = intervals.max(1);
        let mut end = None;
        let mut towards = |sign: f64| -> Result<Vec<[f64; 2]>, Error> {
            let mut found = Vec::with_capacity(intervals + 1);
            for k in 0..=intervals {
                tell(watch, Progress::count(Stage::NormalContact, k))?;
                let lateral = sign * largest * k as f64 / intervals as f64;
                match difference(pairs, lateral, roll) {
                    Ok(difference) => found.push([lateral, difference]),
                    Err(error) if k == 0 => return Err(error),
                    Err(error) => {
                        end = Some(error);
                        break;
                    }
                }
            }
            Ok(found)
        };
        let left = towards(1.0)?;
        let right = if pairs.are_one() {
            left.iter().map(|point| point.map(|part| -part)).collect()
        } else {
            towards(-1.0)?
        };
        let all: Vec<[f64; 2]> = right.into_iter().skip(1).rev().chain(left).collect();
        let [lateral, difference] = [0, 1].map(|c| all.iter().map(|point| point[c]).collect());
        Ok(Self { lateral, difference, end })
    }

    /// The first and the last lateral position, in m.
    pub fn ends(&self) -> [f64; 2] {
        [self.lateral[0], self.lateral[self.lateral.len() - 1]]
    }

    /// The largest amplitude of a motion within the positions, in m.
    pub fn reach(&self) -> f64 {
        let [first, last] = self.ends();
        0.5 * (last - first)
    }

    /// Δr at a lateral position (in m), in m; unknown beyond the ends.
    pub fn at(&self, lateral: f64) -> Option<f64> {
        let [first, last] = self.ends();
        let is_known = (first..=last).contains(&lateral);
        is_known.then(|| piecewise_linear(&self.lateral, &self.difference, lateral)[0])
    }

    /// Equivalent conicity for a lateral motion of an amplitude ŷ (in m), dimensionless: that of
    /// the cones with the wavelength λ of the nonlinear motion y″ = −Δr(y)/(e r₀) between the
    /// turning points c ± ŷ (EN 15302),
    ///
    /// tan γ = (2π/λ)² e r₀/2.
    ///
    /// c is where ∫ Δr dy from one turning point to the other vanishes: zero for an odd Δr. Zero
    /// where no Δr brings the wheelset back; unknown where Δr turns it back or away before, so that
    /// no motion has this amplitude.
    ///
    /// # Errors
    /// An amplitude that is not within the positions.
    pub fn equivalent_conicity(&self, amplitude: f64) -> Result<Option<f64>, Error> {
        self.require_amplitude(amplitude)?;
        let energies = self.energies();
        let rise =
            |c: f64| self.energy(&energies, c + amplitude) - self.energy(&energies, c - amplitude);
        let Some(middle) = self.middle(amplitude, rise) else { return Ok(None) };
        let ends = [middle - amplitude, middle + amplitude];
        // What is next to a turning point, where the speed is lost in rounding, is part of it.
        let near = ROUNDING * amplitude;
        let inside = self.lateral.iter().copied();
        let inside = inside.filter(|y| ends[0] + near < *y && *y < ends[1] - near);
        let places: Vec<f64> = std::iter::once(ends[0]).chain(inside).chain([ends[1]]).collect();
        let top = self.energy(&energies, ends[1]);
        let mut half_period = 0.0;
        let mut before: Option<Passing> = None;
        for (k, y) in places.iter().enumerate() {
            let is_end = k == 0 || k + 1 == places.len();
            let square = if is_end { 0.0 } else { 2.0 * (top - self.energy(&energies, *y)) };
            if square < -2.0 * NONE * amplitude * amplitude {
                return Ok(None);
            }
            let difference = piecewise_linear(&self.lateral, &self.difference, *y)[0];
            let here = Passing { y: *y, difference, speed: square.max(0.0).sqrt() };
            half_period += before.map_or(0.0, |before| before.time_to(&here));
            before = Some(here);
        }
        Ok(Some(0.5 * (PI / half_period).powi(2)))
    }

    /// Equivalent conicity by harmonic linearisation for a lateral motion of an amplitude ŷ (in m),
    /// dimensionless: that of the cones with the same fundamental wave of Δr,
    ///
    /// tan γ = 1/(2π ŷ) ∫ Δr(c + ŷ sin φ) sin φ dφ over a period,
    ///
    /// about the middle c at which the mean of Δr over the period vanishes; unknown where there is
    /// none.
    ///
    /// # Errors
    /// An amplitude that is not within the positions.
    pub fn harmonic_conicity(&self, amplitude: f64) -> Result<Option<f64>, Error> {
        self.require_amplitude(amplitude)?;
        let sines: Vec<f64> =
            (0..SAMPLES).map(|k| (TAU * (k as f64 + 0.5) / SAMPLES as f64).sin()).collect();
        let at = |y: f64| piecewise_linear(&self.lateral, &self.difference, y)[0];
        let sum = |c: f64| sines.iter().map(|sine| at(c + amplitude * sine)).sum::<f64>();
        let Some(middle) = self.middle(amplitude, |c| sum(c) / SAMPLES as f64 * amplitude) else {
            return Ok(None);
        };
        let wave = |sine: &f64| at(middle + amplitude * sine) * sine;
        let mean = sines.iter().map(wave).sum::<f64>() / SAMPLES as f64;
        Ok(Some(mean / amplitude))
    }

    fn require_amplitude(&self, amplitude: f64) -> Result<(), Error> {
        let requirement = Requirement::AboveUpTo(0.0, self.reach());
        require(Quantity::Amplitude, requirement, amplitude)
    }

    /// The middle c of a motion of an amplitude (in m): where a function of it (in m²) vanishes,
    /// that grows with c where Δr does. In m; unknown where it does not change its sign.
    fn middle(&self, amplitude: f64, off: impl Fn(f64) -> f64) -> Option<f64> {
        let [first, last] = self.ends();
        let reach = [first + amplitude, last - amplitude];
        let centre = 0.5 * (reach[0] + reach[1]);
        let negligible = NONE * NONE * amplitude * amplitude;
        if off(centre).abs() <= negligible {
            return Some(centre);
        }
        let is_inside = off(reach[0]) <= negligible && off(reach[1]) >= -negligible;
        is_inside.then(|| bisection(reach, HALVINGS, |c| off(c) < 0.0)[1])
    }

    /// ∫ Δr dy from the first position to each, in m².
    fn energies(&self) -> Vec<f64> {
        let mut energy = 0.0;
        let pieces = self.lateral.windows(2).zip(self.difference.windows(2));
        let rest = pieces.map(|(y, difference)| {
            energy += 0.5 * (difference[0] + difference[1]) * (y[1] - y[0]);
            energy
        });
        std::iter::once(0.0).chain(rest).collect()
    }

    /// ∫ Δr dy from the first position to a lateral position (in m), in m².
    fn energy(&self, energies: &[f64], lateral: f64) -> f64 {
        let after =
            self.lateral.partition_point(|y| *y <= lateral).clamp(1, self.lateral.len() - 1);
        let k = after - 1;
        let difference = piecewise_linear(&self.lateral, &self.difference, lateral)[0];
        energies[k] + 0.5 * (self.difference[k] + difference) * (lateral - self.lateral[k])
    }
}

/// Δr at a lateral position (in m), in m.
fn difference(pairs: &Sides<Arc<Pair>>, lateral: f64, roll: Roll) -> Result<f64, Error> {
    if roll == Roll::Resting {
        return Ok(RestingWheelset::new(pairs, lateral, 0.0)?.rolling_radius_difference());
    }
    let radius = |side: Side| -> Result<f64, Error> {
        let attitude = Attitude::of(side, [lateral, 0.0, 0.0]);
        Ok(RigidContact::of(pairs.of(side), side, &attitude)?.0.rolling_radius)
    };
    Ok(radius(Side::Left)? - radius(Side::Right)?)
}

/// A wheelset that passes a lateral position, where e r₀ = 1.
#[derive(Debug, Clone, Copy)]
struct Passing {
    /// Lateral position, in m.
    y: f64,
    /// Δr = −y″, in m.
    difference: f64,
    /// |y′|, in m.
    speed: f64,
}

impl Passing {
    /// How long it takes to a position between which and this one Δr is linear, with the slope b:
    /// with q = Δy/(v₀ + v₁) it is 2 arctan(√b q)/√b, exactly; dimensionless.
    fn time_to(&self, next: &Self) -> f64 {
        let way = next.y - self.y;
        let slope = (next.difference - self.difference) / way;
        let q = way / (self.speed + next.speed);
        let square = slope * q * q;
        if square.abs() < 1e-8 {
            2.0 * q * (1.0 - square / 3.0)
        } else if slope > 0.0 {
            2.0 * (slope.sqrt() * q).atan() / slope.sqrt()
        } else if square > -1.0 {
            2.0 * ((-slope).sqrt() * q).atanh() / (-slope).sqrt()
        } else {
            f64::INFINITY
        }
    }
}
