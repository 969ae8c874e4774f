//! Constant friction.

use std::sync::Arc;

use super::constants::{AdjustableFriction, Changes, FrictionConstant};
use super::{FrictionLaw, FrictionResponse, FrictionState, require_coefficient};
use crate::reporting::Error;

/// μ = μ0 everywhere.
///
/// ```
/// use schlupf::interface::friction::{FrictionLaw, FrictionState, Constant};
///
/// let law = Constant::new(0.3)?;
/// let state = FrictionState { slip_speed: 2.0, ..FrictionState::default() };
/// assert!((law.respond(&state).coefficient - 0.3).abs() < 1e-12);
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constant {
    coefficient: f64,
}

impl Constant {
    /// Constant friction with the coefficient μ0, dimensionless.
    pub fn new(coefficient: f64) -> Result<Self, Error> {
        require_coefficient(coefficient)?;
        Ok(Self { coefficient })
    }
}

impl FrictionLaw for Constant {
    fn respond(&self, _state: &FrictionState) -> FrictionResponse {
        FrictionResponse {
            coefficient: self.coefficient,
            by_cold_coefficient: 1.0,
            ..FrictionResponse::default()
        }
    }

    fn is_constant(&self) -> bool {
        true
    }

    fn adjustable(&self) -> Option<&dyn AdjustableFriction> {
        Some(self)
    }
}

impl AdjustableFriction for Constant {
    fn constants(&self) -> Vec<(FrictionConstant, f64)> {
        vec![(FrictionConstant::ColdCoefficient, self.coefficient)]
    }

    fn with_constants(&self, changes: &Changes) -> Result<Arc<dyn FrictionLaw>, Error> {
        let coefficient = changes.of(FrictionConstant::ColdCoefficient, self.coefficient);
        Ok(Arc::new(Self::new(coefficient)?))
    }

    fn by_constant(&self, constant: FrictionConstant, _state: &FrictionState) -> f64 {
        if constant == FrictionConstant::ColdCoefficient { 1.0 } else { 0.0 }
    }
}
