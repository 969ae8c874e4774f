//! Constant friction.

use super::{FrictionLaw, FrictionState, require_coefficient};
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
    fn coefficient(&self, _state: &FrictionState) -> f64 {
        self.coefficient
    }
}
