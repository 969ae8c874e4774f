//! Nonlinear least squares (Levenberg 1944, Marquardt 1963): parameters that minimise a sum of
//! squared residuals, for calibration and identification.
//!
//! The search ends only where an *undamped* step of the parameters that are not at a bound would be
//! short, or would reduce the sum by next to nothing: a step shortened by damping proves nothing.
//! At a kink of the model, from which no step leads down, the promised reduction may be a hundred
//! times as large.

use nalgebra::{Cholesky, DMatrix, DVector};

use crate::numerics::vector::dot;
use crate::reporting::Error;

/// A fitting problem. Parameters and residuals are dimensionless: the caller scales them.
pub trait Residuals: Send + Sync {
    /// The residuals (dimensionless) for parameters within their bounds; `None` where the model
    /// cannot be evaluated, which makes the step shorter.
    ///
    /// # Errors
    /// Any error that ends the fit.
    fn residuals(&mut self, parameters: &[f64]) -> Result<Option<Vec<f64>>, Error>;

    /// Smallest and largest value of a parameter, dimensionless.
    fn bounds(&self, _parameter: usize) -> [f64; 2] {
        [f64::NEG_INFINITY, f64::INFINITY]
    }

    /// Derivatives of the residuals (rows) with respect to the parameters (columns), dimensionless;
    /// by default finite differences with [`Self::difference_step`].
    ///
    /// # Errors
    /// Any error that ends the fit.
    fn jacobian(
        &mut self,
        parameters: &[f64],
        residuals: &[f64],
    ) -> Result<Option<DMatrix<f64>>, Error> {
        let mut jacobian = DMatrix::zeros(residuals.len(), parameters.len());
        for column in 0..parameters.len() {
            let Some((step, changed)) = self.beside(parameters, column)? else { return Ok(None) };
            for (row, (changed, residual)) in changed.iter().zip(residuals).enumerate() {
                jacobian[(row, column)] = (changed - residual) / step;
            }
        }
        Ok(Some(jacobian))
    }

    /// The residuals (dimensionless) with one parameter moved by the finite-difference step
    /// (dimensionless), and the step: backwards if forwards is out of bounds.
    ///
    /// # Errors
    /// Any error that ends the fit.
    fn beside(
        &mut self,
        parameters: &[f64],
        column: usize,
    ) -> Result<Option<(f64, Vec<f64>)>, Error> {
        let mut moved = parameters.to_vec();
        let step = self.difference_step() * parameters[column].abs().max(1.0);
        let [low, high] = self.bounds(column);
        for step in [step, -step] {
            moved[column] = parameters[column] + step;
            if !(low..=high).contains(&moved[column]) {
                continue;
            }
            if let Some(changed) = self.residuals(&moved)? {
                return Ok(Some((step, changed)));
            }
        }
        Ok(None)
    }

    /// Finite-difference step, relative to the parameter or to one if that is larger;
    /// dimensionless.
    fn difference_step(&self) -> f64 {
        1e-4
    }
}

/// Stopping criteria; the first one met ends the fit. All concern the undamped Gauss–Newton step of
/// the parameters that are not at a bound; a step shortened by damping proves nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Largest change of a parameter, relative to the parameter or to one if that is larger;
    /// dimensionless.
    pub tolerance: f64,
    /// Fraction of the sum of squares that the step would still remove (the square of the relative
    /// offset of Bates and Watts 1981), dimensionless: parameters with little effect need not come
    /// to rest. Where no step leads down, however short, there is a kink (as where a cell begins to
    /// slide), and the fraction may be a hundred times as large.
    pub reducible: f64,
    /// Reduction of the sum of squares below which it is rounding error of the model,
    /// dimensionless.
    pub negligible: f64,
    /// Maximum number of steps.
    pub max_iterations: usize,
}

/// Result of a fit.
#[derive(Debug, Clone)]
pub struct Minimum {
    /// The parameters, dimensionless.
    pub parameters: Vec<f64>,
    /// The residuals there, dimensionless.
    pub residuals: Vec<f64>,
    /// Their derivatives (rows) with respect to the parameters (columns), dimensionless.
    pub jacobian: DMatrix<f64>,
    /// Whether one of the limits was reached.
    pub converged: bool,
    /// Whether the parameter is held by a bound: the sum of squares would fall beyond it.
    pub is_held: Vec<bool>,
    /// Steps tried.
    pub iterations: usize,
}

impl Minimum {
    /// Sum of the squared residuals, dimensionless.
    pub fn sum_of_squares(&self) -> f64 {
        dot(&self.residuals, &self.residuals)
    }

    /// (JᵀJ)⁻¹, dimensionless: with residuals of unit variance the covariance of the parameters.
    /// `None` if it is numerically singular: some combination of the parameters changes no
    /// residual.
    pub fn covariance(&self) -> Option<DMatrix<f64>> {
        let scale = column_norms(&self.jacobian);
        if scale.iter().any(|norm| *norm == 0.0 || !norm.is_finite()) {
            return None;
        }
        let n = scale.len();
        let normal = self.jacobian.tr_mul(&self.jacobian);
        let scaled = DMatrix::from_fn(n, n, |i, j| normal[(i, j)] / (scale[i] * scale[j]));
        if scaled.symmetric_eigenvalues().min() <= SINGULAR {
            return None;
        }
        let inverse = Cholesky::new(scaled)?.inverse();
        Some(DMatrix::from_fn(n, n, |i, j| inverse[(i, j)] / (scale[i] * scale[j])))
    }
}

/// Smallest eigenvalue of JᵀJ, with columns normalised to length one, that counts as regular.
const SINGULAR: f64 = 1e-12;

/// Initial damping and its bounds, relative to the diagonal of JᵀJ.
const FIRST_DAMPING: f64 = 1e-3;
const LEAST_DAMPING: f64 = 1e-12;
const LARGEST_DAMPING: f64 = 1e10;

/// Multiple of [`Limits::reducible`] that is left in a kink of the model.
const IN_A_KINK: f64 = 100.0;

/// Fits the parameters from a start within the bounds. Returns `None` if the model cannot be
/// evaluated there.
///
/// Steps beyond a bound are projected onto it (Kanzow, Yamashita and Fukushima 2004), and a
/// parameter at a bound beyond which the sum would fall is excluded from the next step.
///
/// # Errors
/// Any error with which the model ends the fit.
pub fn minimise(
    model: &mut impl Residuals,
    start: &[f64],
    limits: &Limits,
) -> Result<Option<Minimum>, Error> {
    let Some((residuals, jacobian)) = evaluate(model, start, None)? else {
        return Ok(None);
    };
    let (parameters, is_held) = (start.to_vec(), vec![false; start.len()]);
    let mut here =
        Minimum { parameters, residuals, jacobian, converged: false, is_held, iterations: 0 };
    here.hold(model);
    let mut damping = FIRST_DAMPING;
    while !here.is_minimum(limits) {
        let is_kink = damping > LARGEST_DAMPING;
        if here.iterations == limits.max_iterations || is_kink {
            let reducible = IN_A_KINK * limits.reducible;
            here.converged = is_kink && here.is_minimum(&Limits { reducible, ..*limits });
            return Ok(Some(here));
        }
        here.iterations += 1;
        let tried = here.damped_step(damping).map(|step| {
            let moved = here.parameters.iter().zip(&step).enumerate();
            moved.map(|(k, (p, step))| bounded(p + step, model.bounds(k))).collect::<Vec<f64>>()
        });
        let found = match tried {
            Some(tried) => {
                let found = evaluate(model, &tried, Some(here.sum_of_squares()))?;
                found.map(|(residuals, jacobian)| (tried, residuals, jacobian))
            }
            None => None,
        };
        match found {
            Some((tried, found, jacobian)) => {
                (here.parameters, here.residuals, here.jacobian) = (tried, found, jacobian);
                here.hold(model);
                damping = (0.2 * damping).max(LEAST_DAMPING);
            }
            None => damping *= 5.0,
        }
    }
    here.converged = true;
    Ok(Some(here))
}

/// Residuals and their derivatives.
type Evaluated = (Vec<f64>, DMatrix<f64>);

/// Residuals with their derivatives; if a limit is given, only if their sum of squares is below it.
fn evaluate(
    model: &mut impl Residuals,
    parameters: &[f64],
    limit: Option<f64>,
) -> Result<Option<Evaluated>, Error> {
    let Some(residuals) = model.residuals(parameters)? else { return Ok(None) };
    let is_less = limit.is_none_or(|limit| dot(&residuals, &residuals) < limit);
    if !is_less {
        return Ok(None);
    }
    let jacobian = model.jacobian(parameters, &residuals)?;
    Ok(jacobian.map(|jacobian| (residuals, jacobian)))
}

fn bounded(value: f64, [low, high]: [f64; 2]) -> f64 {
    value.max(low).min(high)
}

impl Minimum {
    /// Indices of the parameters that are not held by a bound.
    fn free(&self) -> Vec<usize> {
        (0..self.is_held.len()).filter(|k| !self.is_held[*k]).collect()
    }

    /// The same minimum for some of the parameters, the others being fixed.
    pub fn of(&self, parameters: &[usize]) -> Self {
        let jacobian = &self.jacobian;
        let columns = DMatrix::from_fn(jacobian.nrows(), parameters.len(), |i, j| {
            jacobian[(i, parameters[j])]
        });
        Self {
            parameters: parameters.iter().map(|k| self.parameters[*k]).collect(),
            is_held: parameters.iter().map(|k| self.is_held[*k]).collect(),
            jacobian: columns,
            ..self.clone()
        }
    }

    /// Determines which parameters the bounds hold: −Jᵀr points out of the range.
    fn hold(&mut self, model: &impl Residuals) {
        let right = self.descent();
        for (k, is_held) in self.is_held.iter_mut().enumerate() {
            let [low, high] = model.bounds(k);
            let (value, along) = (self.parameters[k], right[k]);
            *is_held = value <= low && along < 0.0 || value >= high && along > 0.0;
        }
    }

    /// −Jᵀr.
    fn descent(&self) -> Vec<f64> {
        let of = |column| {
            let rows = self.residuals.iter().enumerate();
            rows.map(|(row, r)| -self.jacobian[(row, column)] * r).sum()
        };
        (0..self.parameters.len()).map(of).collect()
    }

    fn is_minimum(&self, limits: &Limits) -> bool {
        let Some(step) = self.damped_step(LEAST_DAMPING) else { return false };
        let gain = dot(&step, &self.descent());
        let mut moves = step.iter().zip(&self.parameters);
        gain <= limits.negligible
            || gain <= limits.reducible * self.sum_of_squares()
            || moves.all(|(step, p)| step.abs() <= limits.tolerance * p.abs().max(1.0))
    }

    /// Solves (JᵀJ + damping · diag JᵀJ) step = −Jᵀr for the parameters not held by a bound.
    fn damped_step(&self, damping: f64) -> Option<Vec<f64>> {
        let free = self.free();
        let mut step = vec![0.0; self.is_held.len()];
        if free.is_empty() {
            return Some(step);
        }
        let normal = self.jacobian.tr_mul(&self.jacobian);
        let mut normal =
            DMatrix::from_fn(free.len(), free.len(), |i, j| normal[(free[i], free[j])]);
        let largest = (0..free.len()).map(|i| normal[(i, i)]).fold(0.0, f64::max);
        for i in 0..free.len() {
            // A parameter without any effect does not move.
            normal[(i, i)] += damping * normal[(i, i)].max(f64::EPSILON * largest);
        }
        let descent = self.descent();
        let right = DVector::from_iterator(free.len(), free.iter().map(|k| descent[*k]));
        let found = Cholesky::new(normal)?.solve(&right);
        for (row, k) in free.into_iter().enumerate() {
            step[k] = found[row];
        }
        step.iter().all(|s| s.is_finite()).then_some(step)
    }
}

pub(crate) fn column_norms(matrix: &DMatrix<f64>) -> Vec<f64> {
    matrix.column_iter().map(|column| column.norm()).collect()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const LIMITS: Limits =
        Limits { tolerance: 1e-10, reducible: 0.0, negligible: 0.0, max_iterations: 200 };

    struct Rosenbrock;

    impl Residuals for Rosenbrock {
        fn residuals(&mut self, p: &[f64]) -> Result<Option<Vec<f64>>, Error> {
            Ok(Some(vec![10.0 * (p[1] - p[0] * p[0]), 1.0 - p[0]]))
        }
    }

    /// Rosenbrock 1960: a curved valley with its minimum at (1, 1).
    #[test]
    fn rosenbrock_1960() {
        let found = minimise(&mut Rosenbrock, &[-1.2, 1.0], &LIMITS).unwrap().unwrap();
        assert!(found.converged && found.iterations < 60, "{found:?}");
        assert_relative_eq!(found.parameters[0], 1.0, epsilon = 1e-7);
        assert_relative_eq!(found.parameters[1], 1.0, epsilon = 1e-7);
    }

    /// A straight line through points of unit scatter, whose covariance is known in closed form.
    struct Line(Vec<[f64; 2]>);

    impl Residuals for Line {
        fn residuals(&mut self, p: &[f64]) -> Result<Option<Vec<f64>>, Error> {
            Ok(Some(self.0.iter().map(|[x, y]| p[0] + p[1] * x - y).collect()))
        }

        fn bounds(&self, parameter: usize) -> [f64; 2] {
            if parameter == 1 { [0.0, 10.0] } else { [f64::NEG_INFINITY, f64::INFINITY] }
        }
    }

    #[test]
    fn covariance_of_a_straight_line() {
        let points: Vec<[f64; 2]> =
            (0..5).map(|k| [f64::from(k), 2.0 + 3.0 * f64::from(k)]).collect();
        let found = minimise(&mut Line(points), &[0.0, 0.0], &LIMITS).unwrap().unwrap();
        assert_relative_eq!(found.parameters[1], 3.0, epsilon = 1e-8);
        // 1/Σ(x − x̄)², and 1/n + x̄²/Σ(x − x̄)².
        let covariance = found.covariance().unwrap();
        assert_relative_eq!(covariance[(1, 1)], 0.1, max_relative = 1e-6);
        assert_relative_eq!(covariance[(0, 0)], 0.2 + 4.0 / 10.0, max_relative = 1e-6);
    }

    /// Parameters that only occur as a sum have no covariance.
    #[test]
    fn what_cannot_be_determined() {
        struct Sum;
        impl Residuals for Sum {
            fn residuals(&mut self, p: &[f64]) -> Result<Option<Vec<f64>>, Error> {
                Ok(Some(vec![p[0] + p[1] - 1.0, 2.0 * (p[0] + p[1]) - 2.0]))
            }
        }
        assert!(minimise(&mut Sum, &[0.0, 0.0], &LIMITS).unwrap().unwrap().covariance().is_none());
    }

    /// For a falling line whose slope must not be negative the optimum is the mean; the bound holds
    /// the slope, and releases it where the line rises.
    #[test]
    fn a_bound_holds_a_parameter() {
        let falling = vec![[0.0, 1.0], [1.0, 0.0], [2.0, -1.0]];
        let found = minimise(&mut Line(falling), &[5.0, 1.0], &LIMITS).unwrap().unwrap();
        assert!(found.converged && found.is_held == [false, true], "{found:?}");
        assert_eq!(found.parameters[1], 0.0);
        assert_relative_eq!(found.parameters[0], 0.0, epsilon = 1e-9);
        let rising = vec![[0.0, 1.0], [1.0, 2.0], [2.0, 3.0]];
        let found = minimise(&mut Line(rising), &[5.0, 0.0], &LIMITS).unwrap().unwrap();
        assert!(found.converged && found.is_held == [false, false], "{found:?}");
        assert_relative_eq!(found.parameters[1], 1.0, epsilon = 1e-8);
    }

    /// Where the model cannot be evaluated between start and minimum, damping makes the steps
    /// short. That is no minimum and is not reported as one.
    #[test]
    fn a_short_step_is_no_minimum() {
        struct Walled;
        impl Residuals for Walled {
            fn residuals(&mut self, p: &[f64]) -> Result<Option<Vec<f64>>, Error> {
                Ok((p[0] < 2.0).then(|| vec![p[0] - 5.0]))
            }
        }
        let found = minimise(&mut Walled, &[0.0], &LIMITS).unwrap().unwrap();
        assert!(!found.converged && found.parameters[0] > 1.9, "{found:?}");
    }

    /// From the kink of |p| no step leads down, while either slope promises a little less. It is a
    /// minimum if that is little enough.
    #[test]
    fn a_kink_may_be_a_minimum() {
        struct Kink;
        impl Residuals for Kink {
            fn residuals(&mut self, p: &[f64]) -> Result<Option<Vec<f64>>, Error> {
                Ok(Some(vec![1.0, 0.05 + 0.02 * p[0].abs()]))
            }
        }
        for (reducible, is_found) in [(1e-4, true), (1e-6, false)] {
            let found = minimise(&mut Kink, &[-1.0], &Limits { reducible, ..LIMITS });
            let found = found.unwrap().unwrap();
            assert_eq!(found.converged, is_found, "{found:?}");
            assert!(found.parameters[0].abs() < 1e-3, "{found:?}");
        }
    }
}
