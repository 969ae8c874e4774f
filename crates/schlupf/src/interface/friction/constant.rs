//! Constant friction.

use super::{FrictionLaw, FrictionResponse, FrictionState, require_coefficient};
use crate::error::Error;

/// μ = μ0 everywhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constant {
    coefficient: f64,
}

impl Constant {
    /// The coefficient μ0, dimensionless.
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
}
