//! Coefficient of friction.

pub mod constant;
pub mod temperature_linear;

use std::fmt::Debug;
use std::sync::Arc;

use crate::error::{Error, require_finite};

/// What a coefficient of friction may depend on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrictionState {
    /// Contact temperature over the reference temperature, in K.
    pub temperature: f64,
    /// Slip speed, in m/s.
    pub slip_speed: f64,
    /// Position across rolling, in m.
    pub y: f64,
}

/// A law for the coefficient of friction. Extension point.
pub trait FrictionLaw: Debug + Send + Sync {
    /// Coefficient of friction μ ≥ 0, dimensionless. At the default state (no slip, reference
    /// temperature, y = 0) it is μ0.
    fn coefficient(&self, state: &FrictionState) -> f64;

    /// Temperature over the reference (in K) from which on the law does not hold for material that
    /// enters the contact.
    fn temperature_limit(&self) -> f64 {
        f64::INFINITY
    }
}

/// A friction law and the temperature it counts from.
#[derive(Debug, Clone)]
pub struct Friction {
    /// The law.
    pub law: Arc<dyn FrictionLaw>,
    /// Temperature from which the law's temperature is measured, in degC.
    pub reference_temperature: f64,
}

impl Friction {
    /// Cold coefficient μ0, dimensionless.
    pub fn cold_coefficient(&self) -> f64 {
        self.law.coefficient(&FrictionState::default())
    }

    /// Checks the law for material that enters at `entry_temperature`, in degC.
    pub fn check(&self, entry_temperature: f64) -> Result<(), Error> {
        require_finite("friction.reference_temperature", self.reference_temperature, "degC")?;
        let limit = self.law.temperature_limit();
        if entry_temperature - self.reference_temperature < limit {
            return Ok(());
        }
        Err(Error::Contradiction {
            quantity: "friction.temperature_at_zero_friction",
            reason: format!(
                "the material enters the contact at {entry_temperature} degC, but friction \
                 vanishes at reference_temperature + temperature_at_zero_friction = {} + {limit} = \
                 {} degC",
                self.reference_temperature,
                self.reference_temperature + limit
            ),
        })
    }
}

/// A cold coefficient of friction must be positive and finite.
fn require_coefficient(value: f64) -> Result<(), Error> {
    crate::error::require_positive("friction.coefficient", value, "")
}
