//! Checks whether the data determine the parameters.

use nalgebra::DMatrix;

use crate::interface::friction::FrictionConstant;
use crate::numerics::least_squares::{Minimum, column_norms};
use crate::reporting::{Error, FitError};

use super::data::FittedPoint;
use super::parameter::Parameter;

/// Forces are never measured more accurately than this fraction of the largest one: for data
/// without scatter the intervals are judged with it (but not computed with it).
pub(super) const LEAST_SCATTER: f64 = 1e-3;

/// Half-width of a 95 % interval, relative to the size of the parameter, above which the parameter
/// is considered undetermined.
const WIDEST: f64 = 1.0;

/// Correlation above which two parameters are inseparable.
const INSEPARABLE: f64 = 0.999;

/// Correlation above which another parameter is named as a reason.
const RELATED: f64 = 0.9;

/// Contribution of a parameter to a combination on which no force depends, above which it is named.
const TAKES_PART: f64 = 0.1;

/// The parameters and their values at the end of a fit, in SI units.
pub(super) type Values<'a> = &'a [(Parameter, f64)];

/// Checks that there are enough points.
pub(super) fn check_count(
    parameters: &[Parameter],
    points: usize,
    knows_scatter: bool,
) -> Result<(), Error> {
    if parameters.is_empty() {
        return Err(FitError::NothingToFit {}.into());
    }
    let needed = parameters.len() + usize::from(!knows_scatter);
    if points >= needed {
        return Ok(());
    }
    let parameters = parameters.iter().map(|parameter| parameter.quantity()).collect();
    Err(FitError::TooFewPoints { parameters, points }.into())
}

/// (JᵀJ)⁻¹ of a minimum, or the parameters that no force distinguishes.
pub(super) fn covariance(minimum: &Minimum, values: Values) -> Result<DMatrix<f64>, Error> {
    let jacobian = &minimum.jacobian;
    let norms = column_norms(jacobian);
    if let Some(k) = norms.iter().position(|norm| *norm == 0.0 || !norm.is_finite()) {
        let (parameter, value) = values[k];
        return Err(FitError::NoInfluence { quantity: parameter.quantity(), value }.into());
    }
    minimum.covariance().ok_or_else(|| inseparable(&least_determined(jacobian, &norms), values))
}

/// The combination of parameters, of length one, on which the forces depend least.
fn least_determined(jacobian: &DMatrix<f64>, norms: &[f64]) -> Vec<f64> {
    let normal = jacobian.tr_mul(jacobian);
    let n = norms.len();
    let scaled = DMatrix::from_fn(n, n, |i, j| normal[(i, j)] / (norms[i] * norms[j]));
    let eigen = scaled.symmetric_eigen();
    eigen.eigenvectors.column(eigen.eigenvalues.imin()).iter().copied().collect()
}

fn inseparable(combination: &[f64], values: Values) -> Error {
    let pairs = values.iter().zip(combination);
    let parameters = pairs
        .filter(|(_, part)| part.abs() > TAKES_PART)
        .map(|((parameter, _), _)| parameter.quantity())
        .collect();
    FitError::Inseparable { parameters }.into()
}

/// Forces up to this fraction of μ0 N, and proportional to the creepage within this factor, are in
/// the linear range.
const LINEAR_RANGE: (f64, f64) = (0.5, 1.1);

/// Checks that μ0, if it is fitted, is not inferred from the initial slope: there it is a factor of
/// the bristle stiffness μ0 k_c pₙ, and friction itself has no effect.
pub(super) fn check_range(values: Values, points: &[FittedPoint]) -> Result<(), Error> {
    let cold = Parameter::Friction(FrictionConstant::ColdCoefficient);
    let Some((_, coefficient)) = values.iter().find(|(parameter, _)| *parameter == cold) else {
        return Ok(());
    };
    let share = |point: &FittedPoint| point.fitted.abs() / coefficient;
    let largest = points.iter().map(share).fold(0.0, f64::max);
    let slope = |point: &FittedPoint| {
        let motion = &point.data.condition.kinematics;
        let creepage = [motion.creepage_x, motion.creepage_y][point.data.component.index()];
        (point.fitted / creepage).abs()
    };
    let steepest = points.iter().map(slope).fold(0.0, f64::max);
    let flattest = points.iter().map(slope).fold(f64::INFINITY, f64::min);
    let (part, factor) = LINEAR_RANGE;
    // Without creepage, where the force is due to spin, the slope is infinite or NaN.
    let is_linear = largest < part && steepest < factor * flattest && steepest.is_finite();
    if !is_linear {
        return Ok(());
    }
    Err(FitError::LinearRange { largest }.into())
}

/// Checks intervals and correlations. `half_widths` are those of the parameters' 95 % intervals, in
/// their SI units.
pub(super) fn check(
    values: Values,
    half_widths: &[f64],
    correlation: &[Vec<f64>],
) -> Result<(), Error> {
    let relative = |k: usize| half_widths[k] / values[k].0.size(values[k].1);
    let by_width = |i: &usize, j: &usize| relative(*i).total_cmp(&relative(*j));
    let Some(widest) = (0..values.len()).max_by(by_width) else { return Ok(()) };
    if relative(widest) > WIDEST {
        return Err(open(values, widest, relative(widest), correlation));
    }
    for (i, row) in correlation.iter().enumerate() {
        if let Some(j) = (0..i).find(|j| row[*j].abs() > INSEPARABLE) {
            let mut combination = vec![0.0; values.len()];
            (combination[i], combination[j]) = (1.0, 1.0);
            return Err(inseparable(&combination, values));
        }
    }
    Ok(())
}

/// The error for a parameter whose interval is too wide.
fn open(values: Values, k: usize, relative: f64, correlation: &[Vec<f64>]) -> Error {
    let (parameter, value) = values[k];
    let others = (0..values.len()).filter(|other| *other != k);
    let related = others
        .filter(|other| correlation[k][*other].abs() > RELATED)
        .map(|other| (values[other].0.quantity(), correlation[k][other]))
        .collect();
    FitError::Undetermined { quantity: parameter.quantity(), value, relative, related }.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLD: Parameter = Parameter::Friction(FrictionConstant::ColdCoefficient);

    fn minimum(jacobian: DMatrix<f64>) -> Minimum {
        let rows = jacobian.nrows();
        Minimum {
            parameters: vec![0.0; jacobian.ncols()],
            residuals: vec![0.0; rows],
            jacobian,
            converged: true,
            is_held: vec![false; 2],
            iterations: 1,
        }
    }

    #[test]
    fn what_is_open_is_named_with_its_reason() {
        let values = [(COLD, 0.4), (Parameter::ContactStiffness, 5e6)];
        let nothing = DMatrix::from_fn(3, 2, |i, j| if j == 0 { 0.0 } else { i as f64 });
        let message = covariance(&minimum(nothing), &values).unwrap_err().to_string();
        assert!(message.starts_with("friction_coefficient: "), "{message}");
        assert!(message.contains("near 0.4 no measured force depends on it"), "{message}");
        let alike = DMatrix::from_fn(3, 2, |i, _| 1.0 + i as f64);
        let message = covariance(&minimum(alike), &values).unwrap_err().to_string();
        let both = "distinguish friction_coefficient and contact_stiffness";
        assert!(message.contains(both), "{message}");
        let correlation = vec![vec![1.0, -0.97], vec![-0.97, 1.0]];
        let message = check(&values, &[0.1, 1e7], &correlation).unwrap_err().to_string();
        assert!(message.starts_with("contact_stiffness: "), "{message}");
        assert!(message.contains("friction_coefficient (correlation -0.970)"), "{message}");
        assert!(message.contains("at 5e6 1/m its 95 % interval is ±200 %;"), "{message}");
        check(&values, &[0.1, 1e6], &correlation).unwrap();
        let correlation = vec![vec![1.0, 0.9995], vec![0.9995, 1.0]];
        let message = check(&values, &[0.1, 1e6], &correlation).unwrap_err().to_string();
        assert!(message.contains(both), "{message}");
    }

    #[test]
    fn there_must_be_more_points_than_parameters() {
        let parameters = [COLD, Parameter::ContactStiffness];
        let message = |points, known| check_count(&parameters, points, known).unwrap_err();
        assert!(message(1, true).to_string().contains("2 parameters (friction_coefficient, "));
        assert!(message(1, true).to_string().contains("from 1 measured force"));
        assert!(message(2, false).to_string().contains("unless the data have standard deviations"));
        check_count(&parameters, 2, true).unwrap();
        check_count(&parameters, 3, false).unwrap();
        assert!(check_count(&[], 3, false).is_err());
    }
}
