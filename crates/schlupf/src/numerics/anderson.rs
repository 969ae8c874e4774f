//! Fixed points by Anderson mixing (Anderson 1965; Walker and Ni, SIAM J. Numer. Anal. 49 (2011)).

use nalgebra::{DMatrix, DVector};

/// Differences of earlier steps that are mixed.
const DEPTH: usize = 5;

/// Singular values below this part of the largest one are rounding error.
const NEGLIGIBLE: f64 = 1e-10;

/// The last steps of an iteration x → g(x).
#[derive(Debug, Default)]
pub(crate) struct Anderson {
    /// x and the residual g(x) − x of each, in the unit of x.
    steps: Vec<[DVector<f64>; 2]>,
}

impl Anderson {
    /// The next x, in the unit of x: the combination of the last steps with the least residual.
    /// Where a residual is larger than the one before, it is g(x), and earlier steps are forgotten.
    pub fn next(&mut self, x: &[f64], g: &[f64]) -> Vec<f64> {
        let (x, g) = (DVector::from_column_slice(x), DVector::from_column_slice(g));
        let residual = &g - &x;
        if self.steps.last().is_some_and(|[_, before]| residual.norm() > before.norm()) {
            self.steps.clear();
        }
        self.steps.push([x, residual.clone()]);
        if self.steps.len() > DEPTH + 1 {
            self.steps.remove(0);
        }
        let differences = |k: usize| -> Option<DMatrix<f64>> {
            let pairs = self.steps.windows(2).map(|pair| &pair[1][k] - &pair[0][k]);
            let columns: Vec<_> = pairs.collect();
            (!columns.is_empty()).then(|| DMatrix::from_columns(&columns))
        };
        let Some((by_x, by_residual)) = differences(0).zip(differences(1)) else {
            return g.as_slice().to_vec();
        };
        let decomposed = by_residual.clone().svd(true, true);
        let least = NEGLIGIBLE * decomposed.singular_values.max();
        let mixed =
            decomposed.solve(&residual, least).map(|shares| &g - (by_x + by_residual) * shares);
        mixed.unwrap_or(g).as_slice().to_vec()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A linear map of three unknowns is solved by three differences, whatever its rate.
    #[test]
    fn a_linear_map_takes_as_many_steps_as_unknowns() {
        let g = |x: &[f64]| vec![1.0 - 0.99 * x[1], 2.0 + 0.99 * x[0], 3.0 + 0.99 * x[2]];
        let (mut mixing, mut x) = (Anderson::default(), vec![0.0; 3]);
        for _ in 0..5 {
            x = mixing.next(&x, &g(&x));
        }
        let error = x.iter().zip(g(&x)).map(|(x, g)| (x - g).abs()).fold(0.0, f64::max);
        assert!(error < 1e-8, "{error}");
    }
}
