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

/// A coefficient of friction and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrictionResponse {
    /// Coefficient of friction μ ≥ 0, dimensionless.
    pub coefficient: f64,
    /// ∂μ/∂T, in 1/K.
    pub by_temperature: f64,
    /// Derivative with respect to the slip speed, in s/m.
    pub by_slip_speed: f64,
    /// ∂μ/∂μ0, dimensionless.
    pub by_cold_coefficient: f64,
}

/// A law for the coefficient of friction. Extension point.
pub trait FrictionLaw: Debug + Send + Sync {
    /// The coefficient of friction; at the default state (no slip, reference temperature, y = 0) it
    /// is μ0. Where the law has a kink, the derivatives are those of one of its sides.
    fn respond(&self, state: &FrictionState) -> FrictionResponse;

    /// Whether the coefficient depends on neither temperature nor slip speed.
    fn is_constant(&self) -> bool {
        false
    }

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
        self.law.respond(&FrictionState::default()).coefficient
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
