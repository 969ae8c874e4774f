//! Partition of heat between wheel and rail, and the resulting temperatures.

use std::fmt::Debug;
use std::sync::Arc;

use crate::bodies::{Body, Kinematics};

/// A law for the share of the wheel in the frictional heat. Extension point.
///
/// ```
/// use std::sync::Arc;
///
/// use schlupf::interface::heat::{Heat, Partition, PartitionLaw};
///
/// /// In proportion to the speeds at which the surfaces pass.
/// #[derive(Debug)]
/// struct BySpeed;
///
/// impl PartitionLaw for BySpeed {
///     fn share(&self, [wheel, rail]: [f64; 2]) -> f64 {
///         wheel / (wheel + rail)
///     }
/// }
///
/// let heat = Heat { partition: Partition::Law(Arc::new(BySpeed)), ..Heat::default() };
/// assert!(schlupf::Problem::builder().heat(heat).build().is_ok());
/// ```
pub trait PartitionLaw: Debug + Send + Sync {
    /// The share, dimensionless, between 0 and 1, at the speeds at which the surfaces of wheel
    /// and rail pass through the contact, in m/s.
    fn share(&self, speeds: [f64; 2]) -> f64;
}

/// Share of the wheel in the frictional heat.
#[derive(Debug, Clone)]
pub enum Partition {
    /// Prescribed, dimensionless, between 0 and 1 (0.5 in the paper). Both bodies then pass through
    /// the contact at the speed of its frame.
    Given(f64),
    /// From equal surface temperatures: β_w √(ωR) / (β_w √(ωR) + β_r √v0). Each body passes at its
    /// own speed.
    Velocity,
    /// By a law. Both bodies then pass through the contact at the speed of its frame. Where heat
    /// spreads sideways, derivatives with respect to creepages take the share as fixed.
    Law(Arc<dyn PartitionLaw>),
}

/// Laws are equal if they are the same.
impl PartialEq for Partition {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Given(one), Self::Given(other)) => one == other,
            (Self::Velocity, Self::Velocity) => true,
            (Self::Law(one), Self::Law(other)) => Arc::ptr_eq(one, other),
            _ => false,
        }
    }
}

impl Partition {
    /// The share at the speeds of a motion, where it does not follow from the materials.
    fn share(&self, kinematics: &Kinematics) -> Option<f64> {
        match self {
            Self::Given(share) => Some(*share),
            Self::Velocity => None,
            Self::Law(law) => Some(law.share(kinematics.surface_speeds())),
        }
    }

    /// Derivative of the share of a law with respect to ln(v0/(ωR)).
    fn share_by_time_ratio(&self, kinematics: &Kinematics) -> f64 {
        const STEP: f64 = 1e-5;
        let Self::Law(law) = self else { return 0.0 };
        let share =
            |step: f64| law.share(kinematics.with_contact_time_ratio(step).surface_speeds());
        (share(STEP) - share(-STEP)) / (2.0 * STEP)
    }
}

/// Response of a pair of bodies to heat, at given speeds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conduction {
    /// Temperature of both surfaces on entry, in degC: the mean of the bulk temperatures, weighted
    /// by β√v.
    pub entry_temperature: f64,
    /// Bulk temperatures of wheel and rail, in degC.
    bulk: [f64; 2],
    /// Ratio of the rises of wheel and rail to the rise times effusivity, in m² √s K/W.
    factor: [f64; 2],
    /// The same for a body that takes all the heat.
    rise_per_share: [f64; 2],
    /// Weight of the wheel's surface in the contact temperature, dimensionless.
    wheel_weight: f64,
    /// Whether the partition follows from the speeds.
    follows_speed: bool,
    share: f64,
    /// Its derivative with respect to ln(v0/(ωR)) by a law.
    share_by_time_ratio: f64,
    contact_times: [f64; 2],
    /// Derivatives of their logarithms with respect to ln(v0/(ωR)).
    contact_times_by_ratio: [f64; 2],
}

impl Conduction {
    /// Conduction in wheel and rail at the speeds of `kinematics`.
    pub fn new(partition: &Partition, wheel: &Body, rail: &Body, kinematics: &Kinematics) -> Self {
        let effusivity = [wheel.material.effusivity(), rail.material.effusivity()];
        let contact_times = match partition {
            Partition::Given(_) | Partition::Law(_) => [1.0; 2],
            // A ratio of speeds, also for bodies at rest.
            Partition::Velocity => {
                Kinematics { speed: 1.0, ..*kinematics }.surface_speeds().map(f64::recip)
            }
        };
        let drawn = [0, 1].map(|body| effusivity[body] / contact_times[body].sqrt());
        let wheel_weight = drawn[0] / (drawn[0] + drawn[1]);
        let share = partition.share(kinematics).unwrap_or(wheel_weight);
        let rise_per_share = drawn.map(f64::recip);
        // The same of both, also where one of them stands still.
        let factor = match partition {
            Partition::Velocity => [(drawn[0] + drawn[1]).recip(); 2],
            _ => [share * rise_per_share[0], (1.0 - share) * rise_per_share[1]],
        };
        let bulk = [wheel.bulk_temperature, rail.bulk_temperature];
        Self {
            entry_temperature: wheel_weight * bulk[0] + (1.0 - wheel_weight) * bulk[1],
            bulk,
            factor,
            rise_per_share,
            wheel_weight,
            follows_speed: *partition == Partition::Velocity,
            share,
            share_by_time_ratio: partition.share_by_time_ratio(kinematics),
            contact_times,
            contact_times_by_ratio: kinematics.contact_times_by_ratio(),
        }
    }

    /// Shares of wheel and rail in the frictional heat, dimensionless.
    pub fn shares(&self) -> [f64; 2] {
        [self.share, 1.0 - self.share]
    }

    /// Bulk temperatures of wheel and rail, in degC.
    pub fn bulk_temperatures(&self) -> [f64; 2] {
        self.bulk
    }

    /// Whether both surfaces are equally hot wherever they touch.
    pub fn has_equal_surfaces(&self) -> bool {
        self.follows_speed
    }

    /// Weight of the wheel's bulk temperature in the entry temperature, dimensionless.
    pub fn wheel_weight(&self) -> f64 {
        self.wheel_weight
    }

    /// Times in which the materials of wheel and rail pass through the contact over that of its
    /// frame, dimensionless.
    pub fn contact_times(&self) -> [f64; 2] {
        self.contact_times
    }

    /// Surface temperatures of wheel and rail (in degC) for a rise times effusivity, in W √s/m².
    pub fn surface_temperatures(&self, rise_times_effusivity: f64) -> [f64; 2] {
        self.factor.map(|factor| self.entry_temperature + factor * rise_times_effusivity)
    }

    /// Rises of the surfaces of wheel and rail above their own bulk temperatures, in K.
    pub fn rises(&self, rise_times_effusivity: f64) -> [f64; 2] {
        let surface = self.surface_temperatures(rise_times_effusivity);
        [surface[0] - self.bulk[0], surface[1] - self.bulk[1]]
    }

    /// Derivative of the contact temperature (in K) with respect to ln(v0/(ωR)), at constant rise
    /// times effusivity in W √s/m².
    pub fn contact_temperature_by_time_ratio(&self, rise_times_effusivity: f64) -> f64 {
        if !self.follows_speed {
            let [wheel, rail] = self.rise_per_share;
            let of_share = self.wheel_weight * wheel - (1.0 - self.wheel_weight) * rail;
            return self.share_by_time_ratio * of_share * rise_times_effusivity;
        }
        // With D = β/√t of each body the wheel's weight is D_w/(D_w + D_r), both factors are
        // 1/(D_w + D_r), and d ln D = −½ d ln t.
        let [wheel, rail] = self.contact_times_by_ratio;
        let weight = self.wheel_weight;
        let entry = weight * (1.0 - weight) * (self.bulk[0] - self.bulk[1]) * (rail - wheel);
        let rise = (weight * wheel + (1.0 - weight) * rail) * self.contact_factor();
        0.5 * (entry + rise * rise_times_effusivity)
    }

    /// Derivative of [`Self::contact_temperature`], in m² √s K/W.
    pub fn contact_factor(&self) -> f64 {
        self.wheel_weight * self.factor[0] + (1.0 - self.wheel_weight) * self.factor[1]
    }

    /// The temperature on which friction depends, in degC: the mean of the two surfaces, weighted
    /// by β√v.
    pub fn contact_temperature(&self, rise_times_effusivity: f64) -> f64 {
        let surface = self.surface_temperatures(rise_times_effusivity);
        self.wheel_weight * surface[0] + (1.0 - self.wheel_weight) * surface[1]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::bodies::Material;

    fn kinematics(creepage_x: f64) -> Kinematics {
        Kinematics { creepage_x, ..Kinematics::free_rolling(30.0) }
    }

    /// With the partition from the velocities both surfaces are equally hot, whatever their
    /// materials, and a hot wheel on a cold rail of the same steel enters at the mean.
    #[test]
    fn velocity_partition_makes_equal_surfaces() {
        let mut wheel = Body { bulk_temperature: 150.0, ..Body::STEEL };
        let rail = Body { bulk_temperature: 0.0, ..Body::STEEL };
        let equal = Conduction::new(&Partition::Velocity, &wheel, &rail, &kinematics(0.0));
        assert_relative_eq!(equal.entry_temperature, 75.0, max_relative = 1e-14);
        wheel.material = Material { conductivity: 20.0, ..Material::STEEL };
        let conduction = Conduction::new(&Partition::Velocity, &wheel, &rail, &kinematics(0.1));
        let [hot, cold] = conduction.surface_temperatures(2e6);
        assert_relative_eq!(hot, cold, max_relative = 1e-14);
        assert_relative_eq!(conduction.contact_temperature(2e6), hot, max_relative = 1e-14);
    }

    /// With a prescribed partition each body takes its share, at the speed v0.
    #[test]
    fn given_partition_is_taken_as_it_is() {
        let conduction =
            Conduction::new(&Partition::Given(0.3), &Body::STEEL, &Body::STEEL, &kinematics(0.1));
        let [wheel, rail] = conduction.rises(1e6);
        assert_relative_eq!(wheel / rail, 3.0 / 7.0, max_relative = 1e-12);
        let effusivity = Material::STEEL.effusivity();
        assert_relative_eq!(wheel + rail, 1e6 / effusivity, max_relative = 1e-12);
    }
}
