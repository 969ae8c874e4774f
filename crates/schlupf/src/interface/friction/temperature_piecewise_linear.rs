//! Friction that falls, or rises, linearly between two temperatures.

use std::sync::Arc;

use super::constants::{AdjustableFriction, Changes, FrictionConstant};
use super::{FrictionLaw, FrictionResponse, FrictionState, require_coefficient};
use crate::reporting::{Error, Quantity, Requirement, require, require_positive};

/// μ = μ0 up to the reference temperature, linear from there to μ_hot at ΔT above it, and μ_hot at
/// higher temperatures.
///
/// Source: Vollebregt, User guide for CONTACT, "Temperature dependent friction", L = 6, with T_ref
/// the reference temperature. Friction rises if μ_hot is larger than μ0, as on a drying rail.
///
/// ```
/// use schlupf::interface::friction::{FrictionLaw, FrictionState, TemperaturePiecewiseLinear};
///
/// let law = TemperaturePiecewiseLinear::new(0.4, 0.1, 500.0)?;
/// let state = FrictionState { temperature: 800.0, ..FrictionState::default() };
/// assert!((law.respond(&state).coefficient - 0.1).abs() < 1e-12);
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TemperaturePiecewiseLinear {
    coefficient: f64,
    hot_coefficient: f64,
    temperature_range: f64,
}

impl TemperaturePiecewiseLinear {
    /// The law with μ0 and μ_hot (dimensionless) and ΔT (in K).
    pub fn new(
        coefficient: f64,
        hot_coefficient: f64,
        temperature_range: f64,
    ) -> Result<Self, Error> {
        require_coefficient(coefficient)?;
        require(Quantity::HotCoefficient, Requirement::NotNegative, hot_coefficient)?;
        require_positive(Quantity::TemperatureRange, temperature_range)?;
        Ok(Self { coefficient, hot_coefficient, temperature_range })
    }
}

impl FrictionLaw for TemperaturePiecewiseLinear {
    fn respond(&self, state: &FrictionState) -> FrictionResponse {
        let share = (state.temperature / self.temperature_range).clamp(0.0, 1.0);
        let fall = self.coefficient - self.hot_coefficient;
        let is_falling = (0.0..self.temperature_range).contains(&state.temperature);
        FrictionResponse {
            coefficient: (1.0 - share) * self.coefficient + share * self.hot_coefficient,
            by_temperature: if is_falling { -fall / self.temperature_range } else { 0.0 },
            by_cold_coefficient: 1.0 - share,
            ..FrictionResponse::default()
        }
    }

    fn follows_slip_speed(&self) -> bool {
        false
    }

    fn temperature_limit(&self) -> f64 {
        if self.hot_coefficient > 0.0 { f64::INFINITY } else { self.temperature_range }
    }

    fn adjustable(&self) -> Option<&dyn AdjustableFriction> {
        Some(self)
    }
}

impl AdjustableFriction for TemperaturePiecewiseLinear {
    fn constants(&self) -> Vec<(FrictionConstant, f64)> {
        vec![
            (FrictionConstant::ColdCoefficient, self.coefficient),
            (FrictionConstant::HotCoefficient, self.hot_coefficient),
            (FrictionConstant::TemperatureRange, self.temperature_range),
        ]
    }

    fn with_constants(&self, changes: &Changes) -> Result<Arc<dyn FrictionLaw>, Error> {
        Ok(Arc::new(Self::new(
            changes.of(FrictionConstant::ColdCoefficient, self.coefficient),
            changes.of(FrictionConstant::HotCoefficient, self.hot_coefficient),
            changes.of(FrictionConstant::TemperatureRange, self.temperature_range),
        )?))
    }

    fn by_constant(&self, constant: FrictionConstant, state: &FrictionState) -> f64 {
        let share = (state.temperature / self.temperature_range).clamp(0.0, 1.0);
        match constant {
            FrictionConstant::ColdCoefficient => 1.0 - share,
            FrictionConstant::HotCoefficient => share,
            FrictionConstant::TemperatureRange if share < 1.0 => {
                (self.coefficient - self.hot_coefficient) * share / self.temperature_range
            }
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Vollebregt, CONTACT, default constants: from 0.3 by 0.1 over 800 K.
    #[test]
    fn vollebregt_temperature_range() {
        let law = TemperaturePiecewiseLinear::new(0.3, 0.2, 800.0).unwrap();
        for (temperature, expected) in
            [(-50.0, 0.3), (0.0, 0.3), (400.0, 0.25), (600.0, 0.225), (800.0, 0.2), (2e3, 0.2)]
        {
            let state = FrictionState { temperature, ..FrictionState::default() };
            assert_relative_eq!(law.respond(&state).coefficient, expected, max_relative = 1e-14);
        }
    }

    #[test]
    fn it_has_a_limit_only_where_friction_vanishes() {
        let limit =
            |hot| TemperaturePiecewiseLinear::new(0.3, hot, 800.0).unwrap().temperature_limit();
        assert_eq!([limit(0.0), limit(0.1)], [800.0, f64::INFINITY]);
    }

    #[test]
    fn impossible_constants_are_named() {
        let message = |m0, hot, range| {
            TemperaturePiecewiseLinear::new(m0, hot, range).unwrap_err().to_string()
        };
        assert!(message(0.0, 0.0, 800.0).starts_with("friction_coefficient"));
        assert!(message(0.3, -0.1, 800.0).starts_with("hot_coefficient"));
        assert!(message(0.3, 0.2, -5.0).starts_with("temperature_range"));
        assert!(message(0.3, 0.2, 0.0).contains("0 K"));
    }
}
