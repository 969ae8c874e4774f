//! The fit, its intervals and its warnings.

use nalgebra::DMatrix;

use crate::numerics::least_squares::{self, Limits, Minimum, Residuals};
use crate::numerics::vector::root_mean_square;
use crate::reporting::{Error, FitCause, FitError, FitStop, Quantity, Unconverged, Warning, Watch};
use crate::solution::{Status, Work};

use super::confidence::students_t;
use super::data::{self, Condition, DataPoint, FittedPoint};
use super::determinacy::{self, LEAST_SCATTER};
use super::model::CreepForceModel;
use super::parameter::Parameter;
use super::residuals::{Failure, Weighted, order};
use super::statistics::{autocorrelation, r_squared};

/// A fit ends when no parameter would move by more than this fraction of itself,
const TOLERANCE: f64 = 1e-6;

/// or by more than this fraction of its standard error,
const OF_STANDARD_ERROR: f64 = 0.01;

/// or when forces divided by the load would change by less than this, which is the accuracy of
/// their computation.
const ROUNDING: f64 = 1e-6;

/// An estimated parameter.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Estimate {
    /// The parameter.
    pub parameter: Parameter,
    /// Initial value, in its SI unit, if it is not dimensionless.
    pub start: f64,
    /// Its value, in its SI unit, if it is not dimensionless.
    pub value: f64,
    /// Standard error, in its SI unit, if it is not dimensionless. `None`, like the interval, for a
    /// parameter at its bound about which the data say nothing.
    pub standard_error: Option<f64>,
    /// Half-width of its 95 % confidence interval, in its SI unit, if it is not dimensionless.
    pub half_width: Option<f64>,
}

/// A fit.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Fit {
    /// Whether the fit converged: `NotConverged` means that it is not at a minimum.
    pub status: Status,
    /// The parameters.
    pub estimates: Vec<Estimate>,
    /// Correlations of the parameters, row by row, dimensionless.
    pub correlation: Vec<Vec<f64>>,
    /// The points, in the order of the data.
    pub points: Vec<FittedPoint>,
    /// Root mean square residual of F/N, dimensionless.
    pub rms_residual: f64,
    /// R², the fraction of the variance of the data explained by the model; dimensionless, and
    /// `None` if all data are equal.
    pub r_squared: Option<f64>,
    /// χ² divided by the degrees of freedom, if standard deviations are given, dimensionless.
    pub reduced_chi_squared: Option<f64>,
    /// Number of points minus number of parameters.
    pub degrees_of_freedom: usize,
    /// Steps of the fit.
    pub iterations: usize,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Warning>,
    /// Total work of all solutions.
    pub work: Work,
}

/// Performs all checks possible before anything is computed.
///
/// # Errors
/// An invalid motion or load, forces that are not finite, standard deviations of only some points,
/// too few points.
pub fn check(model: &dyn CreepForceModel, data: &[DataPoint]) -> Result<(), Error> {
    data::check(data)?;
    determinacy::check_count(model.parameters(), data.len(), knows_scatter(data))?;
    for (parameter, start) in model.parameters().iter().zip(model.start()) {
        let [low, high] = parameter.bounds();
        if !(low..=high).contains(&start) {
            let (quantity, bounds) = (parameter.quantity(), [low, high]);
            return Err(FitError::StartOutOfRange { quantity, value: start, bounds }.into());
        }
    }
    Ok(())
}

fn knows_scatter(data: &[DataPoint]) -> bool {
    data.iter().all(|point| point.standard_deviation.is_some())
}

/// Fits the parameters of a model to measured points, in at most so many steps. The model has the
/// fitted values at the end.
///
/// The parameters θ minimise Σ ((F/N)_computed − (F/N)_measured)²/σ², in terms of the logarithms of
/// those that are positive. Their covariance is s² (JᵀJ)⁻¹ with the variance of the residuals s² =
/// Σr²/(n − p), and intervals use Student's t with n − p degrees of freedom. With given standard
/// deviations s is one, and intervals are normal, unless the residuals are larger than such
/// deviations explain: then s is computed from the residuals, and a warning says so. Intervals
/// account for scatter only: a model that cannot follow the data has other errors, and a warning
/// says so.
///
/// A constant may end at a natural bound, for example a coefficient at zero: a warning says so, and
/// its interval is one-sided.
///
/// ```
/// use schlupf::analysis::identification::{Component, Condition, DataPoint, Parameter};
/// use schlupf::analysis::identification::{PolachModel, fit};
/// use schlupf::interface::friction::{Constant, FrictionConstant};
/// use schlupf::bodies::Kinematics;
/// use schlupf::problem::AreaReduction;
/// use schlupf::{Problem, unwatched};
///
/// let problem = Problem::builder().friction(Constant::new(0.4)?).build()?;
/// let data = [0.02, 0.05, 0.1, 0.2].map(|creepage_x| {
///     let kinematics = Kinematics { creepage_x, ..problem.kinematics };
///     let condition = Condition { kinematics, load: None };
///     let component = Component::Longitudinal;
///     DataPoint { condition, component, force_ratio: 0.3, standard_deviation: None }
/// });
/// let unknown = [Parameter::Friction(FrictionConstant::ColdCoefficient)];
/// let mut model = PolachModel::new(&problem, AreaReduction::DRY, &unknown)?;
/// let found = fit(&mut model, &data, 50, &unwatched)?;
/// assert!((found.estimates[0].value - 0.3).abs() < 0.02);
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// [`Error::Stopped`]; whatever [`check`] rejects; initial values without a solution; forces of the
/// wrong sign; and data that do not determine a parameter: no force depends on it, μ0 is fitted to
/// forces that are proportional to the creepage, its 95 % interval extends on each side by more
/// than its value (for a parameter that may be zero, at least 0.1), or its correlation with another
/// one is above 0.999. For this, scatter that the data do not give is taken to be at least 10⁻³ of
/// the largest force.
pub fn fit(
    model: &mut dyn CreepForceModel,
    data: &[DataPoint],
    max_iterations: usize,
    watch: Watch,
) -> Result<Fit, Error> {
    check(model, data)?;
    let mut weighted = Weighted::new(model, data, watch);
    let start = vec![0.0; weighted.coordinates.len()];
    let Some(residuals) = weighted.residuals(&start)? else { return Err(no_start(&weighted)) };
    data::check_signs(data, &computed(data, &residuals))?;
    let limits = limits(data, start.len(), max_iterations);
    let Some(minimum) = least_squares::minimise(&mut weighted, &start, &limits)? else {
        return Err(no_start(&weighted));
    };
    let values = weighted.values(&minimum.parameters);
    let (coordinates, failure) = (weighted.coordinates.clone(), weighted.failure.clone());
    model.set(&values)?;
    let parameters: Vec<(Parameter, f64)> =
        coordinates.iter().map(|coordinate| coordinate.parameter).zip(values).collect();
    let found = Found { data, minimum, parameters };
    let slopes = coordinates.iter().zip(&found.parameters);
    let slopes: Vec<f64> = slopes.map(|(c, (_, value))| c.scale.slope(*value)).collect();
    let unscaled = match found.determined(&slopes) {
        // Values that do not come from the data say nothing about them.
        Err(_) if !found.minimum.converged && found.is_far() => {
            return Err(found.no_end(failure.as_ref()));
        }
        determined => determined?,
    };
    let correlation = correlation(&unscaled);
    let errors = standard_errors(&unscaled, &slopes, found.scatter());
    let quantile = found.quantile();
    let points = found.points();
    let converged = found.minimum.converged && found.ran_out().is_none();
    let mut warnings = found.warnings(&correlation);
    if !converged {
        let stop = found.stop(failure.as_ref());
        warnings.insert(0, Warning::of(Unconverged::Fit { stop }));
    }
    let known = |number: f64| number.is_finite().then_some(number);
    let estimates = (0..coordinates.len()).map(|k| Estimate {
        parameter: coordinates[k].parameter,
        start: coordinates[k].start,
        value: found.parameters[k].1,
        standard_error: known(errors[k]),
        half_width: known(quantile * errors[k]),
    });
    let estimates = estimates.collect();
    let residuals: Vec<f64> = points.iter().map(FittedPoint::residual).collect();
    let measured: Vec<f64> = data.iter().map(|point| point.force_ratio).collect();
    Ok(Fit {
        status: if converged { Status::Converged } else { Status::NotConverged },
        estimates,
        correlation,
        rms_residual: root_mean_square(&residuals),
        r_squared: r_squared(&measured, &residuals),
        reduced_chi_squared: found.reduced_chi_squared(),
        degrees_of_freedom: found.degrees_of_freedom(),
        iterations: found.minimum.iterations,
        points,
        warnings,
        work: model.work(),
    })
}

/// Stopping criteria of a fit with so many parameters.
fn limits(data: &[DataPoint], parameters: usize, max_iterations: usize) -> Limits {
    let freedom = (data.len() - parameters).max(1) as f64;
    let weights = data.iter().map(|point| point.standard_deviation.map_or(1.0, f64::recip));
    Limits {
        tolerance: TOLERANCE,
        reducible: OF_STANDARD_ERROR.powi(2) / freedom,
        negligible: weights.map(|weight| (weight * ROUNDING).powi(2)).sum(),
        max_iterations,
    }
}

/// Forces divided by the load, from the residuals.
fn computed(data: &[DataPoint], residuals: &[f64]) -> Vec<f64> {
    let pairs = data.iter().zip(residuals);
    let of = |(point, residual): (&DataPoint, &f64)| {
        point.force_ratio + residual * point.standard_deviation.unwrap_or(1.0)
    };
    pairs.map(of).collect()
}

/// The error when there is nothing to start from.
fn no_start(weighted: &Weighted) -> Error {
    let first = weighted.coordinates.first().map(|first| first.parameter.quantity());
    let quantity = first.unwrap_or(Quantity::FitParameters);
    match &weighted.failure {
        Some(Failure::Refused(error)) => error.clone(),
        Some(Failure::NotFound(condition)) => {
            FitError::NoStart { quantity, at: Some(motion(condition)) }.into()
        }
        None => FitError::NoStart { quantity, at: None }.into(),
    }
}

/// The motion of a condition, number by number.
fn motion(condition: &Condition) -> Vec<(Quantity, f64)> {
    let motion = &condition.kinematics;
    vec![
        (Quantity::CreepageX, motion.creepage_x),
        (Quantity::CreepageY, motion.creepage_y),
        (Quantity::Spin, motion.spin),
        (Quantity::Speed, motion.speed),
    ]
}

/// Correlations from a covariance.
fn correlation(covariance: &DMatrix<f64>) -> Vec<Vec<f64>> {
    let n = covariance.nrows();
    let root = |k: usize| covariance[(k, k)].sqrt();
    let entry = |i: usize, j: usize| match covariance[(i, j)] {
        _ if i == j => 1.0,
        0.0 => 0.0,
        together => together / (root(i) * root(j)),
    };
    (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
}

/// Standard errors (in SI units, or dimensionless) for weighted residuals with this standard
/// deviation.
fn standard_errors(unscaled: &DMatrix<f64>, slopes: &[f64], scatter: f64) -> Vec<f64> {
    let of = |(k, slope): (usize, &f64)| scatter * slope * unscaled[(k, k)].sqrt();
    slopes.iter().enumerate().map(of).collect()
}

/// The result of the least-squares fit.
struct Found<'a> {
    data: &'a [DataPoint],
    minimum: Minimum,
    parameters: Vec<(Parameter, f64)>,
}

impl Found<'_> {
    fn degrees_of_freedom(&self) -> usize {
        self.data.len() - self.free().len()
    }

    /// Indices of the parameters determined by the data; the others are at a natural bound.
    fn free(&self) -> Vec<usize> {
        let is_given = |k: usize| {
            let (parameter, value) = self.parameters[k];
            self.minimum.is_held[k] && parameter.may_end_at(value)
        };
        (0..self.parameters.len()).filter(|k| !is_given(*k)).collect()
    }

    fn points(&self) -> Vec<FittedPoint> {
        let fitted = computed(self.data, &self.minimum.residuals);
        let pairs = self.data.iter().zip(fitted);
        pairs.map(|(data, fitted)| FittedPoint { data: *data, fitted }).collect()
    }

    /// Covariance of the scaled coordinates for residuals of unit variance, after a check that the
    /// data determine the parameters. A parameter held by a bound is fixed for the others; its own
    /// variance is that without the bound, for its one-sided interval.
    fn determined(&self, slopes: &[f64]) -> Result<DMatrix<f64>, Error> {
        let free = self.free();
        let values: Vec<(Parameter, f64)> = free.iter().map(|k| self.parameters[*k]).collect();
        determinacy::check_range(&self.parameters, &self.points())?;
        let (minimum, count) = (self.minimum.of(&free), self.parameters.len());
        let mut unscaled = DMatrix::zeros(count, count);
        if let Some(unbounded) = self.minimum.covariance() {
            for k in (0..count).filter(|k| !free.contains(k)) {
                unscaled[(k, k)] = unbounded[(k, k)];
            }
        } else {
            for k in (0..count).filter(|k| !free.contains(k)) {
                unscaled[(k, k)] = f64::NAN;
            }
        }
        if free.is_empty() {
            return Ok(unscaled);
        }
        let of_free = determinacy::covariance(&minimum, &values)?;
        for (i, row) in free.iter().enumerate() {
            for (j, column) in free.iter().enumerate() {
                unscaled[(*row, *column)] = of_free[(i, j)];
            }
        }
        let errors = standard_errors(&unscaled, slopes, self.judged_scatter());
        let half_widths: Vec<f64> = free.iter().map(|k| self.quantile() * errors[*k]).collect();
        determinacy::check(&values, &half_widths, &correlation(&of_free))?;
        Ok(unscaled)
    }

    /// Number of standard errors in half a 95 % interval.
    fn quantile(&self) -> f64 {
        let is_given = knows_scatter(self.data) && self.excess().is_none();
        students_t((!is_given).then_some(self.degrees_of_freedom()))
    }

    /// Standard deviation of the weighted residuals.
    fn scatter(&self) -> f64 {
        if knows_scatter(self.data) {
            return self.excess().unwrap_or(1.0);
        }
        (self.minimum.sum_of_squares() / self.degrees_of_freedom() as f64).sqrt()
    }

    /// The same, but at least the scatter assumed for measurements if none is given.
    fn judged_scatter(&self) -> f64 {
        if knows_scatter(self.data) {
            return self.scatter();
        }
        self.scatter().max(LEAST_SCATTER * self.largest_force())
    }

    fn reduced_chi_squared(&self) -> Option<f64> {
        let freedom = self.degrees_of_freedom();
        (knows_scatter(self.data) && freedom > 0)
            .then(|| self.minimum.sum_of_squares() / freedom as f64)
    }

    /// A parameter at an end of the admissible range that is not a natural bound.
    fn ran_out(&self) -> Option<(Parameter, f64)> {
        self.held().find(|(parameter, value)| !parameter.may_end_at(*value))
    }

    /// Parameters held by a bound.
    fn held(&self) -> impl Iterator<Item = (Parameter, f64)> {
        let pairs = self.parameters.iter().zip(&self.minimum.is_held);
        pairs.filter_map(|(parameter, is_held)| is_held.then_some(*parameter))
    }

    /// Whether the forces are far from the measured ones.
    fn is_far(&self) -> bool {
        /// Root mean square of the residuals relative to the largest force.
        const FAR: f64 = 0.05;
        let residuals: Vec<f64> = self.points().iter().map(FittedPoint::residual).collect();
        root_mean_square(&residuals) > FAR * self.largest_force()
    }

    /// Largest measured force divided by the load, dimensionless.
    fn largest_force(&self) -> f64 {
        self.data.iter().map(|point| point.force_ratio.abs()).fold(0.0, f64::max)
    }

    /// The error for a fit that got stuck, whose parameters mean nothing.
    fn no_end(&self, failure: Option<&Failure>) -> Error {
        let (quantity, stop) = (self.parameters[0].0.quantity(), self.stop(failure));
        FitError::FitStuck { quantity, stop }.into()
    }

    fn stop(&self, failure: Option<&Failure>) -> FitStop {
        let cause = match (self.ran_out(), failure) {
            (Some((parameter, value)), _) => {
                FitCause::RanOut { quantity: parameter.quantity(), value }
            }
            (None, Some(Failure::NotFound(condition))) => FitCause::NotFound(motion(condition)),
            (None, Some(Failure::Refused(error))) => FitCause::Refused(Box::new(error.clone())),
            _ => FitCause::Steps,
        };
        FitStop { steps: self.minimum.iterations, cause }
    }

    fn warnings(&self, correlation: &[Vec<f64>]) -> Vec<Warning> {
        /// Correlation above which two parameters are hard to distinguish.
        const STRONG: f64 = 0.95;
        let mut warnings = Vec::new();
        for (i, row) in correlation.iter().enumerate() {
            for (j, r) in row.iter().enumerate().take(i).filter(|(_, r)| r.abs() > STRONG) {
                let [one, other] = [j, i].map(|k| self.parameters[k].0.quantity());
                warnings.push(Warning::Correlated { one, other, correlation: *r });
            }
        }
        let ended = self.held().filter(|(parameter, value)| parameter.may_end_at(*value));
        warnings.extend(ended.map(|(parameter, value)| {
            let parameter = parameter.quantity();
            Warning::AtEndOfRange { parameter, value }
        }));
        warnings.extend(self.no_reduction());
        warnings.extend(self.misfit());
        warnings.extend(self.unexplained());
        warnings.extend(self.excess().map(|factor| Warning::ExcessScatter { factor }));
        warnings
    }

    /// A warning of reductions in Polach's method that no case can have.
    fn no_reduction(&self) -> Option<Warning> {
        let of = |wanted| self.parameters.iter().find(|(parameter, _)| *parameter == wanted);
        let (adhesion, slip) = (of(Parameter::AreaAdhesion)?.1, of(Parameter::AreaSlip)?.1);
        (slip > adhesion).then_some(Warning::ImpossibleReduction { slip, adhesion })
    }

    /// A warning of data that have little to do with the model.
    fn unexplained(&self) -> Option<Warning> {
        /// R² below which this warning is given.
        const LITTLE: f64 = 0.8;
        let points = self.points();
        let residuals: Vec<f64> = points.iter().map(FittedPoint::residual).collect();
        let measured: Vec<f64> = self.data.iter().map(|point| point.force_ratio).collect();
        let r_squared = r_squared(&measured, &residuals)?;
        (r_squared < LITTLE).then_some(Warning::Unexplained { r_squared })
    }

    /// A warning of residuals that are not random.
    fn misfit(&self) -> Option<Warning> {
        /// Correlation of neighbours, and number of points needed to detect it.
        const SYSTEMATIC: f64 = 0.5;
        const ENOUGH: usize = 8;
        /// Residuals below this fraction of the largest force are ignored.
        const SMALL: f64 = 1e-4;
        let points = self.points();
        let order = order(self.data);
        let sorted: Vec<DataPoint> = order.iter().map(|k| self.data[*k]).collect();
        let series: Vec<Vec<f64>> = data::series(&sorted)
            .into_iter()
            .map(|series| series.into_iter().map(|k| points[order[k]].residual()).collect())
            .collect();
        let residuals = series.concat();
        let limit = SMALL * self.largest_force();
        let is_seen = self.degrees_of_freedom() >= ENOUGH && root_mean_square(&residuals) > limit;
        let is_systematic = || autocorrelation(series.iter().map(Vec::as_slice)) > SYSTEMATIC;
        (is_seen && is_systematic()).then_some(Warning::SystematicResiduals {})
    }

    /// The ratio of the residuals to the standard deviations of the data, if it is larger than
    /// chance explains.
    fn excess(&self) -> Option<f64> {
        /// Number of standard deviations of χ² above which it is too large.
        const FAR: f64 = 3.0;
        let reduced = self.reduced_chi_squared()?;
        let limit = 1.0 + FAR * (2.0 / self.degrees_of_freedom() as f64).sqrt();
        (reduced > limit).then(|| reduced.sqrt())
    }
}
