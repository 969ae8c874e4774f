//! Friction that falls with both temperature and slip speed.

use std::sync::Arc;

use super::constants::{AdjustableFriction, Changes, FrictionConstant};
use super::{FrictionLaw, FrictionResponse, FrictionState};
use crate::reporting::Error;

/// Relative tolerance for the equality of the two μ0.
const ROUNDING: f64 = 1e-12;

/// μ = μ_T(T) μ_s(s)/μ0: a temperature law times the relative decrease of a slip-speed law, both
/// with the same μ0.
///
/// Limits: a floor of one law is not a floor of the product, as the other law continues to fall;
/// the product is positive where both are.
///
/// ```
/// use schlupf::interface::friction::{FrictionLaw, FrictionState, Constant, Product};
///
/// let law = Product::new(
///     std::sync::Arc::new(Constant::new(0.3)?),
///     std::sync::Arc::new(Constant::new(0.3)?),
/// )?;
/// let state = FrictionState { slip_speed: 2.0, ..FrictionState::default() };
/// assert!((law.respond(&state).coefficient - 0.3).abs() < 1e-12);
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Product {
    coefficient: f64,
    temperature: Arc<dyn FrictionLaw>,
    slip_speed: Arc<dyn FrictionLaw>,
}

impl Product {
    /// The product of a temperature law and a slip-speed law.
    pub fn new(
        temperature: Arc<dyn FrictionLaw>,
        slip_speed: Arc<dyn FrictionLaw>,
    ) -> Result<Self, Error> {
        let cold = |law: &dyn FrictionLaw| law.respond(&FrictionState::default()).coefficient;
        let (coefficient, other) = (cold(&*temperature), cold(&*slip_speed));
        if (coefficient - other).abs() <= ROUNDING * coefficient {
            return Ok(Self { coefficient, temperature, slip_speed });
        }
        Err(Error::UnequalFriction { one: coefficient, other })
    }
}

impl FrictionLaw for Product {
    fn respond(&self, state: &FrictionState) -> FrictionResponse {
        let (a, b) = (self.temperature.respond(state), self.slip_speed.respond(state));
        let coefficient = a.coefficient * b.coefficient / self.coefficient;
        let rule =
            |by_a: f64, by_b: f64| (by_a * b.coefficient + a.coefficient * by_b) / self.coefficient;
        FrictionResponse {
            coefficient,
            by_temperature: rule(a.by_temperature, b.by_temperature),
            by_slip_speed: rule(a.by_slip_speed, b.by_slip_speed),
            by_y: rule(a.by_y, b.by_y),
            by_cold_coefficient: rule(a.by_cold_coefficient, b.by_cold_coefficient)
                - coefficient / self.coefficient,
        }
    }

    fn is_constant(&self) -> bool {
        self.temperature.is_constant() && self.slip_speed.is_constant()
    }

    fn follows_slip_speed(&self) -> bool {
        self.temperature.follows_slip_speed() || self.slip_speed.follows_slip_speed()
    }

    fn temperature_limit(&self) -> f64 {
        self.temperature.temperature_limit().min(self.slip_speed.temperature_limit())
    }

    fn adjustable(&self) -> Option<&dyn AdjustableFriction> {
        self.factors().map(|_| self as &dyn AdjustableFriction)
    }
}

impl Product {
    /// Both laws, if their constants can be changed.
    fn factors(&self) -> Option<[&dyn AdjustableFriction; 2]> {
        Some([self.temperature.adjustable()?, self.slip_speed.adjustable()?])
    }
}

impl AdjustableFriction for Product {
    fn constants(&self) -> Vec<(FrictionConstant, f64)> {
        let Some([temperature, slip_speed]) = self.factors() else { return Vec::new() };
        let mut constants = temperature.constants();
        let own = slip_speed.constants().into_iter();
        constants.extend(own.filter(|(name, _)| *name != FrictionConstant::ColdCoefficient));
        constants
    }

    fn with_constants(&self, changes: &Changes) -> Result<Arc<dyn FrictionLaw>, Error> {
        let Some([temperature, slip_speed]) = self.factors() else {
            return Ok(Arc::new(self.clone()));
        };
        let laws = [temperature.with_constants(changes)?, slip_speed.with_constants(changes)?];
        let [temperature, slip_speed] = laws;
        Ok(Arc::new(Self::new(temperature, slip_speed)?))
    }

    fn by_constant(&self, constant: FrictionConstant, state: &FrictionState) -> f64 {
        let Some([temperature, slip_speed]) = self.factors() else { return 0.0 };
        let [a, b] =
            [&self.temperature, &self.slip_speed].map(|law| law.respond(state).coefficient);
        let by = |law: &dyn AdjustableFriction| law.by_constant(constant, state);
        let by_factors = (by(temperature) * b + a * by(slip_speed)) / self.coefficient;
        if constant == FrictionConstant::ColdCoefficient {
            by_factors - a * b / self.coefficient.powi(2)
        } else {
            by_factors
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::constant::Constant;
    use super::super::polach::Polach;
    use super::super::temperature_linear::TemperatureLinear;
    use super::*;
    use approx::assert_relative_eq;

    /// At half T_E and far beyond 1/B both factors, of Eq. (23) and of Polach 2005, are known: ½
    /// and A.
    #[test]
    fn relative_falls_are_multiplied() {
        let falling: Arc<dyn FrictionLaw> =
            Arc::new(TemperatureLinear::new(0.55, 700.0, 0.0).unwrap());
        let law = Product::new(falling, Arc::new(Polach::new(0.55, 0.4, 0.6).unwrap())).unwrap();
        let at = |temperature, slip_speed| {
            law.respond(&FrictionState { temperature, slip_speed, y: 0.0 }).coefficient
        };
        assert_relative_eq!(at(0.0, 0.0), 0.55, max_relative = 1e-14);
        assert_relative_eq!(at(350.0, 0.0), 0.275, max_relative = 1e-14);
        assert_relative_eq!(at(0.0, 1e3), 0.22, max_relative = 1e-14);
        assert_relative_eq!(at(350.0, 1e3), 0.11, max_relative = 1e-14);
        assert!(!law.is_constant());
        assert_eq!(law.temperature_limit(), 700.0);
    }

    #[test]
    fn both_laws_have_the_same_cold_coefficient() {
        let constant = |m0| -> Arc<dyn FrictionLaw> { Arc::new(Constant::new(m0).unwrap()) };
        assert!(Product::new(constant(0.4), constant(0.4)).unwrap().is_constant());
        let message = Product::new(constant(0.4), constant(0.3)).unwrap_err().to_string();
        assert!(message.contains("one has 0.4 and the other 0.3"), "{message}");
    }
}
