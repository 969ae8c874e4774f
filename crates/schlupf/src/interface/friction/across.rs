//! Friction that varies across the patch.

use std::sync::Arc;

use super::constants::{AdjustableFriction, Changes, FrictionConstant};
use super::variation::Variation;
use super::{FrictionLaw, FrictionResponse, FrictionState};
use crate::reporting::Error;

/// μ = f(y) μ(T, s): any law times a factor that depends on y.
///
/// Source: Vollebregt, User guide for CONTACT, "Friction variation", with one factor for all
/// constants of the law. Limits: μ0, by which forces are normalised, is that at y = 0.
///
/// ```
/// use schlupf::interface::friction::{
///     Across, Constant, FrictionLaw, FrictionState, Variation,
/// };
///
/// let variation = Variation::over_y(vec![0.0, 4e-3], vec![1.0, 0.5])?;
/// let law = Across::new(std::sync::Arc::new(Constant::new(0.4)?), variation);
/// let state = FrictionState { y: 2e-3, ..FrictionState::default() };
/// assert!((law.respond(&state).coefficient - 0.3).abs() < 1e-12);
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Across {
    law: Arc<dyn FrictionLaw>,
    variation: Variation,
}

impl Across {
    /// The product of a law and a factor over y.
    pub fn new(law: Arc<dyn FrictionLaw>, variation: Variation) -> Self {
        Self { law, variation }
    }
}

impl FrictionLaw for Across {
    fn respond(&self, state: &FrictionState) -> FrictionResponse {
        let [factor, slope] = self.variation.at(state.y);
        let law = self.law.respond(state);
        FrictionResponse {
            coefficient: factor * law.coefficient,
            by_temperature: factor * law.by_temperature,
            by_slip_speed: factor * law.by_slip_speed,
            by_y: slope * law.coefficient + factor * law.by_y,
            by_cold_coefficient: factor / self.variation.at(0.0)[0] * law.by_cold_coefficient,
        }
    }

    fn is_constant(&self) -> bool {
        self.law.is_constant()
    }

    fn follows_slip_speed(&self) -> bool {
        self.law.follows_slip_speed()
    }

    fn temperature_limit(&self) -> f64 {
        self.law.temperature_limit()
    }

    fn adjustable(&self) -> Option<&dyn AdjustableFriction> {
        self.law.adjustable().map(|_| self as &dyn AdjustableFriction)
    }
}

impl AdjustableFriction for Across {
    fn constants(&self) -> Vec<(FrictionConstant, f64)> {
        self.law.adjustable().map_or_else(Vec::new, AdjustableFriction::constants)
    }

    fn with_constants(&self, changes: &Changes) -> Result<Arc<dyn FrictionLaw>, Error> {
        let law = match self.law.adjustable() {
            Some(law) => law.with_constants(changes)?,
            None => Arc::clone(&self.law),
        };
        Ok(Arc::new(Self { law, ..self.clone() }))
    }

    fn by_constant(&self, constant: FrictionConstant, state: &FrictionState) -> f64 {
        let [factor, _] = self.variation.at(state.y);
        self.law.adjustable().map_or(0.0, |law| factor * law.by_constant(constant, state))
    }
}

#[cfg(test)]
mod tests {
    use super::super::constant::Constant;
    use super::super::temperature_linear::TemperatureLinear;
    use super::*;
    use approx::assert_relative_eq;

    fn across(y: &[f64], factor: &[f64]) -> Result<Across, Error> {
        let variation = Variation::over_y(y.to_vec(), factor.to_vec())?;
        Ok(Across::new(Arc::new(Constant::new(0.4).unwrap()), variation))
    }

    /// Linear interpolation by hand, constant beyond the ends.
    #[test]
    fn the_table_is_piecewise_linear() {
        let law = across(&[-4e-3, 0.0, 2e-3], &[0.5, 1.0, 0.8]).unwrap();
        let at = |y| law.respond(&FrictionState { y, ..FrictionState::default() });
        for (y, factor, slope) in [
            (-1.0, 0.5, 0.0),
            (-4e-3, 0.5, 125.0),
            (-2e-3, 0.75, 125.0),
            (0.0, 1.0, -100.0),
            (1e-3, 0.9, -100.0),
            (2e-3, 0.8, 0.0),
            (1.0, 0.8, 0.0),
        ] {
            assert_relative_eq!(at(y).coefficient, 0.4 * factor, max_relative = 1e-14);
            assert_relative_eq!(at(y).by_y, 0.4 * slope, max_relative = 1e-12);
            assert_relative_eq!(at(y).by_cold_coefficient, factor, max_relative = 1e-14);
        }
    }

    #[test]
    fn the_law_decides_whether_friction_changes_with_temperature() {
        assert!(across(&[-1e-3, 1e-3], &[1.2, 0.8]).unwrap().is_constant());
        let falling = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
        let variation = Variation::over_y(vec![-1e-3, 1e-3], vec![1.2, 0.8]).unwrap();
        let law = Across::new(falling, variation);
        assert!(!law.is_constant());
        assert_eq!(law.temperature_limit(), 700.0);
    }

    #[test]
    fn impossible_tables_are_named() {
        let message = |y: &[f64], factor: &[f64]| across(y, factor).unwrap_err().to_string();
        assert!(message(&[0.0], &[1.0]).starts_with("variation_y needs at least 2"));
        assert!(message(&[0.0, 1.0], &[1.0]).contains("variation_factor needs 2 values, got 1"));
        assert!(message(&[0.0, f64::NAN], &[1.0; 2]).contains("but is NaN m in place 2"));
        assert!(message(&[0.0, 1e-3, 1e-3], &[1.0; 3]).contains("0.001 m comes after 0.001 m"));
        assert!(message(&[0.0, 1e-3], &[1.0, -0.1]).contains("but is -0.1 in place 2"));
        assert!(message(&[0.0, 1e-3], &[1.0, f64::INFINITY]).contains("is inf"));
        let centre = message(&[-1e-3, 1e-3], &[0.5, 1.0]);
        assert!(centre.contains("must be 1 at y = 0") && centre.contains("is 0.75 there"));
    }
}
