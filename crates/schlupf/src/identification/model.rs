//! What a fit needs of a model.

use crate::error::Error;
use crate::progress::Watch;
use crate::solution::Work;

use super::data::Condition;
use super::parameter::Parameter;

/// Forces under a condition, as measurements give them, with derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceRatio {
    /// (−Fx/N, −Fy/N), dimensionless.
    pub value: [f64; 2],
    /// Their derivatives by each parameter of the model, over its SI unit if it is not
    /// dimensionless.
    pub by_parameter: Vec<[f64; 2]>,
}

/// A model of creep forces with parameters to find. Extension point.
pub trait CreepForceModel: Send + Sync {
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
    /// A condition that cannot be, and [`Error::Stopped`].
    fn force_ratio(
        &mut self,
        condition: &Condition,
        watch: Watch,
    ) -> Result<Option<ForceRatio>, Error>;

    /// The forces under several conditions, in their order. Those under one load may end with the
    /// first that is not found; those under different loads may be computed at the same time.
    ///
    /// # Errors
    /// As [`Self::force_ratio`].
    fn force_ratios(
        &mut self,
        conditions: &[Condition],
        watch: Watch,
    ) -> Result<Vec<Option<ForceRatio>>, Error> {
        conditions.iter().map(|condition| self.force_ratio(condition, watch)).collect()
    }

    /// All work so far.
    fn work(&self) -> Work;
}
