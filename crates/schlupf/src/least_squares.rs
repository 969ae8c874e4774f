//! Nonlinear least squares (Levenberg 1944, Marquardt 1963): parameters that make a sum of squared
//! residuals smallest, for calibration and identification.

use faer::Mat;
use faer::linalg::solvers::{DenseSolveCore, Solve};

/// What is to be fitted. Parameters and residuals are dimensionless: the caller scales them.
pub trait Residuals {
    /// The residuals at some parameters; `None` where the model cannot be evaluated, or outside the
    /// parameters' range: a step there is shortened.
    fn residuals(&mut self, parameters: &[f64]) -> Option<Vec<f64>>;

    /// Derivatives of the residuals (rows) with respect to the parameters (columns); by default by
    /// forward differences.
    fn jacobian(&mut self, parameters: &[f64], residuals: &[f64]) -> Option<Mat<f64>> {
        let mut jacobian = Mat::zeros(residuals.len(), parameters.len());
        let mut moved = parameters.to_vec();
        for column in 0..parameters.len() {
            // Backwards where forwards is outside.
            let step = DIFFERENCE * parameters[column].abs().max(1.0);
            let (step, changed) = [step, -step].into_iter().find_map(|step| {
                moved[column] = parameters[column] + step;
                self.residuals(&moved).map(|changed| (step, changed))
            })?;
            for (row, (changed, residual)) in changed.iter().zip(residuals).enumerate() {
                jacobian[(row, column)] = (changed - residual) / step;
            }
            moved[column] = parameters[column];
        }
        Some(jacobian)
    }
}

/// Step of a forward difference, relative to a parameter of at least one.
const DIFFERENCE: f64 = 1e-4;

/// When to stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Largest change of a parameter in a last step, relative to a parameter of at least one;
    /// dimensionless.
    pub tolerance: f64,
    /// Most steps.
    pub max_iterations: usize,
}

/// Where a fit ended.
#[derive(Debug, Clone)]
pub struct Minimum {
    /// The parameters.
    pub parameters: Vec<f64>,
    /// The residuals there.
    pub residuals: Vec<f64>,
    /// Their derivatives (rows) with respect to the parameters (columns).
    pub jacobian: Mat<f64>,
    /// Whether the tolerance was reached.
    pub converged: bool,
    /// Steps tried.
    pub iterations: usize,
}

impl Minimum {
    /// Sum of the squared residuals, dimensionless.
    pub fn sum_of_squares(&self) -> f64 {
        sum_of_squares(&self.residuals)
    }

    /// (JᵀJ)⁻¹: with residuals of unit variance the covariance of the parameters. `None` where it is
    /// singular to rounding: some combination of the parameters changes no residual.
    pub fn covariance(&self) -> Option<Mat<f64>> {
        let scale = column_norms(&self.jacobian);
        if scale.iter().any(|norm| *norm == 0.0 || !norm.is_finite()) {
            return None;
        }
        let n = scale.len();
        let normal = self.jacobian.transpose() * &self.jacobian;
        let scaled = Mat::from_fn(n, n, |i, j| normal[(i, j)] / (scale[i] * scale[j]));
        let smallest = scaled.self_adjoint_eigenvalues(faer::Side::Lower).ok()?.first().copied()?;
        if smallest <= SINGULAR {
            return None;
        }
        let inverse = scaled.llt(faer::Side::Lower).ok()?.inverse();
        Some(Mat::from_fn(n, n, |i, j| inverse[(i, j)] / (scale[i] * scale[j])))
    }
}

/// Smallest eigenvalue of JᵀJ, its columns of length one, from which on it counts as regular.
const SINGULAR: f64 = 1e-12;

/// Damping at the start, and its bounds; relative to the diagonal of JᵀJ.
const FIRST_DAMPING: f64 = 1e-3;
const LEAST_DAMPING: f64 = 1e-12;
const LARGEST_DAMPING: f64 = 1e10;

/// Fits the parameters from a start. `None` where the model cannot be evaluated there.
pub fn minimise(model: &mut impl Residuals, start: &[f64], limits: &Limits) -> Option<Minimum> {
    let residuals = model.residuals(start)?;
    let jacobian = model.jacobian(start, &residuals)?;
    let parameters = start.to_vec();
    let mut here = Minimum { parameters, residuals, jacobian, converged: false, iterations: 0 };
    let mut damping = FIRST_DAMPING;
    while here.iterations < limits.max_iterations && damping < LARGEST_DAMPING {
        here.iterations += 1;
        let Some(step) = damped_step(&here, damping) else {
            damping *= 10.0;
            continue;
        };
        let is_short = step
            .iter()
            .zip(&here.parameters)
            .all(|(step, p)| step.abs() <= limits.tolerance * p.abs().max(1.0));
        let tried: Vec<f64> = here.parameters.iter().zip(&step).map(|(p, s)| p + s).collect();
        let found = model.residuals(&tried);
        match found.filter(|found| sum_of_squares(found) <= here.sum_of_squares()) {
            Some(found) => {
                here.jacobian = model.jacobian(&tried, &found)?;
                (here.parameters, here.residuals) = (tried, found);
                damping = (0.2 * damping).max(LEAST_DAMPING);
            }
            None => damping *= 5.0,
        }
        if is_short {
            here.converged = true;
            break;
        }
    }
    Some(here)
}

/// (JᵀJ + damping · diag JᵀJ) step = −Jᵀ r.
fn damped_step(here: &Minimum, damping: f64) -> Option<Vec<f64>> {
    let jacobian = &here.jacobian;
    let mut normal = jacobian.transpose() * jacobian;
    let n = normal.nrows();
    let largest = (0..n).map(|i| normal[(i, i)]).fold(0.0, f64::max);
    for i in 0..n {
        // A parameter without any effect stays where it is.
        normal[(i, i)] += damping * normal[(i, i)].max(f64::EPSILON * largest);
    }
    let residuals = Mat::from_fn(here.residuals.len(), 1, |row, _| -here.residuals[row]);
    let right = jacobian.transpose() * residuals;
    let step = normal.llt(faer::Side::Lower).ok()?.solve(&right);
    let step: Vec<f64> = (0..n).map(|i| step[(i, 0)]).collect();
    step.iter().all(|s| s.is_finite()).then_some(step)
}

fn sum_of_squares(residuals: &[f64]) -> f64 {
    residuals.iter().map(|r| r * r).sum()
}

fn column_norms(matrix: &Mat<f64>) -> Vec<f64> {
    (0..matrix.ncols())
        .map(|j| (0..matrix.nrows()).map(|i| matrix[(i, j)].powi(2)).sum::<f64>().sqrt())
        .collect()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const LIMITS: Limits = Limits { tolerance: 1e-10, max_iterations: 200 };

    struct Rosenbrock;

    impl Residuals for Rosenbrock {
        fn residuals(&mut self, p: &[f64]) -> Option<Vec<f64>> {
            Some(vec![10.0 * (p[1] - p[0] * p[0]), 1.0 - p[0]])
        }
    }

    /// Rosenbrock 1960: a bent valley with its lowest point at (1, 1).
    #[test]
    fn rosenbrock_1960() {
        let found = minimise(&mut Rosenbrock, &[-1.2, 1.0], &LIMITS).unwrap();
        assert!(found.converged && found.iterations < 60, "{found:?}");
        assert_relative_eq!(found.parameters[0], 1.0, epsilon = 1e-7);
        assert_relative_eq!(found.parameters[1], 1.0, epsilon = 1e-7);
    }

    /// A straight line through points of unit scatter, whose covariance is known in closed form.
    struct Line(Vec<[f64; 2]>);

    impl Residuals for Line {
        fn residuals(&mut self, p: &[f64]) -> Option<Vec<f64>> {
            (p[1] >= 0.0).then(|| self.0.iter().map(|[x, y]| p[0] + p[1] * x - y).collect())
        }
    }

    #[test]
    fn covariance_of_a_straight_line() {
        let points: Vec<[f64; 2]> =
            (0..5).map(|k| [f64::from(k), 2.0 + 3.0 * f64::from(k)]).collect();
        let found = minimise(&mut Line(points), &[0.0, 0.0], &LIMITS).unwrap();
        assert_relative_eq!(found.parameters[1], 3.0, epsilon = 1e-8);
        // 1/Σ(x − x̄)², and 1/n + x̄²/Σ(x − x̄)².
        let covariance = found.covariance().unwrap();
        assert_relative_eq!(covariance[(1, 1)], 0.1, max_relative = 1e-6);
        assert_relative_eq!(covariance[(0, 0)], 0.2 + 4.0 / 10.0, max_relative = 1e-6);
    }

    /// Parameters that only occur as a sum have no covariance, and a range that is left is no end.
    #[test]
    fn what_cannot_be_determined() {
        struct Sum;
        impl Residuals for Sum {
            fn residuals(&mut self, p: &[f64]) -> Option<Vec<f64>> {
                Some(vec![p[0] + p[1] - 1.0, 2.0 * (p[0] + p[1]) - 2.0])
            }
        }
        assert!(minimise(&mut Sum, &[0.0, 0.0], &LIMITS).unwrap().covariance().is_none());
        let falling = vec![[0.0, 1.0], [1.0, 0.0], [2.0, -1.0]];
        let found = minimise(&mut Line(falling), &[0.0, 1.0], &LIMITS).unwrap();
        assert!(found.parameters[1] >= 0.0, "{found:?}");
    }
}
