//! What a fit needs of a model.

use crate::error::Error;
use crate::solution::Work;

use super::data::Condition;
use super::parameter::Parameter;

/// Forces under a condition, as measurements give them, with derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceRatio {
    /// (−Fx/N, −Fy/N), dimensionless.
    pub value: [f64; 2],
    /// Their derivatives by each parameter of the model, over its SI unit if it is not dimensionless.
    pub by_parameter: Vec<[f64; 2]>,
}

/// A model of creep forces with parameters to find. Extension point.
pub trait CreepForceModel {
    /// The parameters to find.
    fn parameters(&self) -> &[Parameter];

    /// Where to start, one value for each parameter, in its SI unit, if it is not dimensionless.
    fn start(&self) -> Vec<f64>;

    /// Takes over other values (in SI units). What comes next may be anywhere on the curve.
    ///
    /// # Errors
    /// Values that cannot be.
    fn set(&mut self, values: &[f64]) -> Result<(), Error>;

    /// The force; `None` where it was not found.
    ///
    /// # Errors
    /// A condition that cannot be.
    fn force_ratio(&mut self, condition: &Condition) -> Result<Option<ForceRatio>, Error>;

    /// All work so far.
    fn work(&self) -> Work;
}

/// How far a fit has got.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Forces computed so far.
    pub solved: usize,
}
