//! Friction that falls linearly with the contact temperature; Eq. (23).

use std::sync::Arc;

use super::constants::{AdjustableFriction, Changes, FrictionConstant};
use super::{FrictionLaw, FrictionResponse, FrictionState, require_below, require_coefficient};
use crate::reporting::{Error, Quantity, require_positive};

/// μ = μ0 (1 − T/T_E), bounded below by a floor (Neuhaus and Sextro 2014, Eq. 23; there the floor
/// is zero).
///
/// ```
/// use schlupf::interface::friction::{FrictionLaw, FrictionState, TemperatureLinear};
///
/// let law = TemperatureLinear::new(0.4, 700.0, 0.0)?;
/// let state = FrictionState { temperature: 350.0, ..FrictionState::default() };
/// assert!((law.respond(&state).coefficient - 0.2).abs() < 1e-12);
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TemperatureLinear {
    coefficient: f64,
    temperature_at_zero_friction: f64,
    minimum_coefficient: f64,
}

impl Default for TemperatureLinear {
    /// μ0 = 0.4, vanishing 700 K above the reference.
    fn default() -> Self {
        Self { coefficient: 0.4, temperature_at_zero_friction: 700.0, minimum_coefficient: 0.0 }
    }
}

impl TemperatureLinear {
    /// The law with μ0 (dimensionless), T_E relative to the reference (in K), and a floor
    /// (dimensionless).
    pub fn new(
        coefficient: f64,
        temperature_at_zero_friction: f64,
        minimum_coefficient: f64,
    ) -> Result<Self, Error> {
        require_coefficient(coefficient)?;
        require_positive(Quantity::TemperatureAtZeroFriction, temperature_at_zero_friction)?;
        require_below(Quantity::MinimumCoefficient, minimum_coefficient, coefficient)?;
        Ok(Self { coefficient, temperature_at_zero_friction, minimum_coefficient })
    }
}

impl FrictionLaw for TemperatureLinear {
    fn respond(&self, state: &FrictionState) -> FrictionResponse {
        let falling = 1.0 - state.temperature / self.temperature_at_zero_friction;
        let coefficient = self.coefficient * falling;
        if coefficient < self.minimum_coefficient {
            let coefficient = self.minimum_coefficient;
            return FrictionResponse { coefficient, ..FrictionResponse::default() };
        }
        FrictionResponse {
            coefficient,
            by_temperature: -self.coefficient / self.temperature_at_zero_friction,
            by_cold_coefficient: falling,
            ..FrictionResponse::default()
        }
    }

    fn follows_slip_speed(&self) -> bool {
        false
    }

    fn temperature_limit(&self) -> f64 {
        let vanishes = self.minimum_coefficient == 0.0;
        if vanishes { self.temperature_at_zero_friction } else { f64::INFINITY }
    }

    fn adjustable(&self) -> Option<&dyn AdjustableFriction> {
        Some(self)
    }
}

impl AdjustableFriction for TemperatureLinear {
    fn constants(&self) -> Vec<(FrictionConstant, f64)> {
        vec![
            (FrictionConstant::ColdCoefficient, self.coefficient),
            (FrictionConstant::TemperatureAtZeroFriction, self.temperature_at_zero_friction),
            (FrictionConstant::MinimumCoefficient, self.minimum_coefficient),
        ]
    }

    fn with_constants(&self, changes: &Changes) -> Result<Arc<dyn FrictionLaw>, Error> {
        let vanishes = FrictionConstant::TemperatureAtZeroFriction;
        Ok(Arc::new(Self::new(
            changes.of(FrictionConstant::ColdCoefficient, self.coefficient),
            changes.of(vanishes, self.temperature_at_zero_friction),
            changes.of(FrictionConstant::MinimumCoefficient, self.minimum_coefficient),
        )?))
    }

    fn by_constant(&self, constant: FrictionConstant, state: &FrictionState) -> f64 {
        let part = state.temperature / self.temperature_at_zero_friction;
        let is_at_floor = self.coefficient * (1.0 - part) < self.minimum_coefficient;
        match constant {
            FrictionConstant::MinimumCoefficient if is_at_floor => 1.0,
            _ if is_at_floor => 0.0,
            FrictionConstant::ColdCoefficient => 1.0 - part,
            FrictionConstant::TemperatureAtZeroFriction => {
                self.coefficient * part / self.temperature_at_zero_friction
            }
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Neuhaus and Sextro 2014, Eq. (23), with a floor.
    #[test]
    fn neuhaus_sextro_2014_linear_fall() {
        let law = TemperatureLinear::new(0.4, 700.0, 0.1).unwrap();
        let at = |temperature| {
            law.respond(&FrictionState { temperature, ..FrictionState::default() }).coefficient
        };
        assert_eq!(at(0.0), 0.4);
        assert_relative_eq!(at(350.0), 0.2, max_relative = 1e-14);
        assert_eq!(at(690.0), 0.1);
        assert_eq!(at(2000.0), 0.1);
    }

    #[test]
    fn impossible_constants_are_named() {
        let message =
            |m0, te, floor| TemperatureLinear::new(m0, te, floor).unwrap_err().to_string();
        assert!(message(0.4, 0.0, 0.0).starts_with("temperature_at_zero_friction"));
        assert!(message(0.4, -5.0, 0.0).contains("-5 K"));
        assert!(message(0.4, 700.0, 0.5).starts_with("minimum_coefficient"));
        assert!(message(f64::NAN, 700.0, 0.0).starts_with("friction_coefficient"));
    }
}
