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
///
/// ```
/// use schlupf::analysis::identification::{Component, Condition, CreepForceModel, DataPoint};
/// use schlupf::analysis::identification::{ForceRatio, Parameter, fit};
/// use schlupf::bodies::Kinematics;
/// use schlupf::interface::friction::FrictionConstant;
/// use schlupf::solution::Work;
/// use schlupf::{Error, Watch, unwatched};
///
/// /// −Fx/N = μ tanh(200 ξ).
/// struct Saturating(f64);
///
/// impl CreepForceModel for Saturating {
///     fn parameters(&self) -> &[Parameter] {
///         &[Parameter::Friction(FrictionConstant::ColdCoefficient)]
///     }
///
///     fn start(&self) -> Vec<f64> {
///         vec![self.0]
///     }
///
///     fn set(&mut self, values: &[f64]) -> Result<(), Error> {
///         self.0 = values[0];
///         Ok(())
///     }
///
///     fn force_ratio(&mut self, at: &Condition, _: Watch) -> Result<Option<ForceRatio>, Error> {
///         let part = (200.0 * at.kinematics.creepage_x).tanh();
///         let by_parameter = vec![[part, 0.0]];
///         Ok(Some(ForceRatio { value: [self.0 * part, 0.0], by_parameter }))
///     }
///
///     fn work(&self) -> Work {
///         Work::default()
///     }
/// }
///
/// let data = [[0.001, 0.06], [0.003, 0.16], [0.01, 0.29], [0.02, 0.3]].map(|[creepage_x, ratio]| {
///     let kinematics = Kinematics { creepage_x, ..Kinematics::free_rolling(20.0) };
///     DataPoint {
///         condition: Condition { kinematics, load: None },
///         component: Component::Longitudinal,
///         force_ratio: ratio,
///         standard_deviation: None,
///     }
/// });
/// let found = fit(&mut Saturating(0.5), &data, 20, &unwatched)?;
/// assert!((found.estimates[0].value - 0.3).abs() < 0.01);
/// # Ok::<(), Error>(())
/// ```
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
