//! The interface between a fit and a model.

use crate::reporting::{Error, Watch};
use crate::solution::Work;

use super::data::Condition;
use super::parameter::Parameter;

/// Forces under a condition, in the form in which they are measured, with derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceRatio {
    /// (−Fx/N, −Fy/N), dimensionless.
    pub value: [f64; 2],
    /// Derivatives with respect to each parameter of the model, per SI unit if it is not
    /// dimensionless.
    pub by_parameter: Vec<[f64; 2]>,
}

/// A model of creep forces with parameters to be fitted. Extension point.
pub trait CreepForceModel: Send + Sync {
    /// The parameters to be fitted.
    fn parameters(&self) -> &[Parameter];

    /// Initial values, one for each parameter, in its SI unit, if it is not dimensionless.
    fn start(&self) -> Vec<f64>;

    /// Switches to other values (in SI units). The next condition may be anywhere on the curve.
    ///
    /// # Errors
    /// Invalid values.
    fn set(&mut self, values: &[f64]) -> Result<(), Error>;

    /// The force; `None` if it was not found.
    ///
    /// # Errors
    /// An invalid condition, and [`Error::Stopped`].
    fn force_ratio(
        &mut self,
        condition: &Condition,
        watch: Watch,
    ) -> Result<Option<ForceRatio>, Error>;

    /// The forces under several conditions, in their order. Those under one load may end with the
    /// first that is not found; those under different loads may be computed in parallel.
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
